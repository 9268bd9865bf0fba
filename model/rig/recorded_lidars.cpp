#include "model/rig/recorded_lidars.h"

#include <algorithm>

#include "algorithms/core/error.h"
#include "model/formats/session_readers.h"

namespace remount::rig {
namespace {

/// A recording whose only LiDAR has no name.
std::string name_of(const drive::LidarOffer& offer) { return offer.name.empty() ? "lidar" : offer.name; }

void add_recording(std::vector<RecordedLidar>& lidars, const drive::LidarOffer& offer, std::size_t place,
                   const drive::TopicChoice& topics) {
  const std::string name = name_of(offer);
  auto lidar = std::ranges::find(lidars, name, &RecordedLidar::name);
  if (lidar == lidars.end()) lidar = lidars.insert(lidars.end(), RecordedLidar{name, {}});
  drive::TopicChoice choice = topics;
  for (const auto& [role, topic] : offer.choice) choice[role] = topic;
  lidar->recordings.push_back({place, std::move(choice)});
}

}  // namespace

RecordedLidars find_lidars(const std::vector<std::filesystem::path>& recordings, const drive::TopicChoice& topics,
                           Progress& progress) {
  RecordedLidars found;
  for (std::size_t r = 0; r < recordings.size(); ++r)
    for (const drive::LidarOffer& offer : formats::offer_lidars(recordings[r], progress)) {
      add_recording(found.all, offer, r, topics);
      if (!offer.rare) add_recording(found.sensors, offer, r, topics);
    }
  if (found.sensors.empty()) found.sensors = found.all;
  return found;
}

std::vector<drive::LidarOffer> lidars_of_several(const drive::Session& session, Progress& progress) {
  const auto can_be_lidar = [](const drive::SessionTopic& topic) {
    return std::ranges::find(topic.can_be, "lidar") != topic.can_be.end();
  };
  // Bags are not looked through again for one.
  if (!session.topics.empty() && std::ranges::count_if(session.topics, can_be_lidar) < 2) return {};
  try {
    std::vector<drive::LidarOffer> offers = formats::offer_lidars(session.path, progress);
    if (offers.size() < 2) offers.clear();
    return offers;
  } catch (const Error&) {
    return {};  // the session is open, and what is said of it besides must not end the work
  }
}

}  // namespace remount::rig
