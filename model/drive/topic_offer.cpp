#include "model/drive/topic_offer.h"

#include <algorithm>

namespace remount::drive {
namespace {

bool has(const std::vector<std::string>& roles, std::string_view role) {
  return std::find(roles.begin(), roles.end(), role) != roles.end();
}

}  // namespace

const TopicUse* OfferedTopic::use(std::string_view role) const {
  const auto found = std::find_if(uses.begin(), uses.end(), [&](const TopicUse& use) { return use.role == role; });
  return found == uses.end() ? nullptr : &*found;
}

bool is_ambiguous(const std::vector<OfferedTopic>& topics) {
  const auto user = [&](std::string_view role) {
    return std::find_if(topics.begin(), topics.end(),
                        [&](const OfferedTopic& offered) { return has(offered.topic.used_as, role); });
  };
  const auto ins = user("ins");
  const bool needs_position = ins != topics.end() && ins->use("ins") && ins->use("ins")->needs_position;
  for (const std::string_view role : kTopicRoles) {
    if (role == "ins-position" && !needs_position) continue;  // fixes have nothing to go with
    std::size_t unasked = 0, asked = 0;
    for (const OfferedTopic& offered : topics)
      if (const TopicUse* use = offered.use(role)) ++(use->unasked ? unasked : asked);
    const bool missed = (role == "lidar" || role == "ins") && user(role) == topics.end();
    if (unasked > 1 || (missed && asked > 0)) return true;
  }
  return false;
}

TopicChoice choice_in_use(const std::vector<SessionTopic>& topics) {
  TopicChoice choice;
  for (const std::string_view role : kTopicRoles) {
    bool possible = false;
    for (const SessionTopic& topic : topics) {
      possible = possible || has(topic.can_be, role);
      if (has(topic.used_as, role)) choice.emplace(role, topic.name);
    }
    // Fixes without a use have no orientation to go with.
    if (possible && role != "ins-position") choice.emplace(role, kNoTopic);
  }
  return choice;
}

}  // namespace remount::drive
