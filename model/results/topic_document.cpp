#include "model/results/topic_document.h"

#include "messages/projects.h"

namespace remount {

TopicChoice topic_choice_from_document(const DocumentView& view, TopicChoice changed) {
  static_assert(kTopicRoles.size() == 5);
  view.allow_only({kTopicRoles[0], kTopicRoles[1], kTopicRoles[2], kTopicRoles[3], kTopicRoles[4]});
  for (const auto& [role, topic] : view.entries()) {
    changed.erase(role);
    if (topic.is_null()) continue;
    const std::string name = topic.string();
    if (name.empty()) topic.fail(say::topic_choice_empty());
    changed.emplace(role, name);
  }
  return changed;
}

}  // namespace remount
