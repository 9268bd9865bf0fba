#include "model/results/topic_document.h"

#include "messages/projects.h"

namespace remount {

DocumentNode topic_choice_document(const TopicChoice& choice) {
  DocumentNode node = DocumentNode::map();
  node.on_one_line = true;
  for (const auto& [role, topic] : choice) node.add(role, DocumentNode::string(topic));
  return node;
}

TopicChoice topic_choice_from_document(const DocumentView& view, TopicChoice changed) {
  view.allow_only({kTopicRoles.begin(), kTopicRoles.end()});
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
