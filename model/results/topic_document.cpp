#include "model/results/topic_document.h"

#include "messages/projects.h"

namespace remount::results {

formats::DocumentNode topic_choice_document(const drive::TopicChoice& choice) {
  formats::DocumentNode node = formats::DocumentNode::map();
  node.on_one_line = true;
  for (const auto& [role, topic] : choice) node.add(role, formats::DocumentNode::string(topic));
  return node;
}

drive::TopicChoice topic_choice_from_document(const formats::DocumentView& view, drive::TopicChoice changed) {
  view.allow_only({drive::kTopicRoles.begin(), drive::kTopicRoles.end()});
  for (const auto& [role, topic] : view.entries()) {
    changed.erase(role);
    if (topic.is_null()) continue;
    const std::string name = topic.string();
    if (name.empty()) topic.fail(say::topic_choice_empty());
    changed.emplace(role, name);
  }
  return changed;
}

}  // namespace remount::results
