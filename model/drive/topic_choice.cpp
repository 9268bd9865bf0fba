#include "model/drive/topic_choice.h"

#include <algorithm>

#include "algorithms/core/error.h"
#include "messages/projects.h"

namespace remount::drive {

void add_topic_choice(TopicChoice& choice, std::string_view text) {
  const std::size_t equals = text.find('=');
  const std::string role(text.substr(0, equals));
  const bool known = std::find(kTopicRoles.begin(), kTopicRoles.end(), role) != kTopicRoles.end();
  if (equals == std::string_view::npos || equals + 1 == text.size() || !known) {
    throw Error(ErrorCode::Contract, std::string(text.substr(0, 80)),
                say::topic_choice_expected({kTopicRoles.begin(), kTopicRoles.end()}));
  }
  if (!choice.emplace(role, text.substr(equals + 1)).second)
    throw Error(ErrorCode::Contract, std::string(text.substr(0, 80)), say::topic_chosen_twice(role));
}

}  // namespace remount::drive
