#include "model/topic_choice.h"

#include <algorithm>

#include "algorithms/core/error.h"

namespace remount {

void add_topic_choice(TopicChoice& choice, std::string_view text) {
  const std::size_t equals = text.find('=');
  const std::string role(text.substr(0, equals));
  const bool known = std::find(kTopicRoles.begin(), kTopicRoles.end(), role) != kTopicRoles.end();
  if (equals == std::string_view::npos || equals + 1 == text.size() || !known) {
    std::string roles;
    for (const std::string_view name : kTopicRoles) roles += (roles.empty() ? "" : ", ") + std::string(name);
    throw Error(ErrorCode::Contract, std::string(text.substr(0, 80)),
                "expected ROLE=TOPIC with a role of " + roles + "; the topic none leaves a role out");
  }
  if (!choice.emplace(role, text.substr(equals + 1)).second)
    throw Error(ErrorCode::Contract, std::string(text.substr(0, 80)), role + " has a topic already");
}

}  // namespace remount
