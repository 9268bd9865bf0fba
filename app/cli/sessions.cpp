#include "app/cli/sessions.h"

#include "messages/general.h"
#include "model/drive/session_frames.h"
#include "model/formats/session_readers.h"

namespace remount::cli {

Sessions open_sessions(const std::vector<std::filesystem::path>& paths, const std::vector<drive::TopicChoice>& topics,
                       Console& console) {
  Sessions sessions;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const drive::TopicChoice chosen = i < topics.size() ? topics[i] : drive::TopicChoice{};
    sessions.push_back(
        std::make_shared<const drive::Session>(formats::open_session(paths[i], chosen, console.progress())));
  }
  return sessions;
}

RigidTransform nominal_in_axes(const results::ReadMounting& mounting, const std::string& text, const Sessions& sessions,
                               Console& console) {
  std::vector<Message> doubts;
  const RigidTransform nominal = results::in_axes_of(mounting, drive::common_axes(sessions), doubts);
  for (const Message& doubt : doubts) console.warn(say::of_file(text, doubt));
  return nominal;
}

}  // namespace remount::cli
