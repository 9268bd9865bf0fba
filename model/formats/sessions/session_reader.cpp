#include "model/formats/sessions/session_reader.h"

#include "algorithms/core/error.h"
#include "messages/sessions.h"

namespace remount::formats {

drive::Session SessionReader::open_topics(const std::filesystem::path& path, const drive::TopicChoice& topics,
                                          Progress& progress) const {
  if (!topics.empty()) throw Error(ErrorCode::Contract, path.string(), say::session_no_topics(std::string(id())));
  return open(path, progress);
}

std::optional<drive::TopicOffer> SessionReader::offer_topics(const std::filesystem::path&, Progress&) const {
  return std::nullopt;
}

std::vector<drive::LidarOffer> SessionReader::offer_lidars(const std::filesystem::path&, Progress&) const {
  return {drive::LidarOffer{}};
}

}  // namespace remount::formats
