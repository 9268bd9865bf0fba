#include "app/cli/lidar_choice.h"

#include <algorithm>

#include "algorithms/core/error.h"
#include "app/cli/arguments.h"
#include "messages/rig.h"
#include "model/formats/files/input_file.h"
#include "model/formats/session_readers.h"

namespace remount::cli {
namespace {

constexpr const char* kAll = "all";

/// A recording whose only LiDAR has no name.
std::string name_of(const drive::LidarOffer& offer) { return offer.name.empty() ? "lidar" : offer.name; }

void add_recording(std::vector<ChosenLidar>& lidars, const drive::LidarOffer& offer, std::size_t place,
                   const drive::TopicChoice& topics) {
  const std::string name = name_of(offer);
  auto lidar = std::ranges::find(lidars, name, &ChosenLidar::name);
  if (lidar == lidars.end()) lidar = lidars.insert(lidars.end(), ChosenLidar{name, {}});
  drive::TopicChoice choice = topics;
  for (const auto& [role, topic] : offer.choice) choice[role] = topic;
  lidar->recordings.push_back({place, std::move(choice)});
}

std::vector<ChosenLidar> named_ones(const std::vector<ChosenLidar>& all, const std::string& wanted) {
  const std::string where = "--lidars " + wanted;
  std::vector<ChosenLidar> chosen;
  for (const std::string& part : split(wanted, ',')) {
    const std::string name(formats::trim(part));
    if (name.empty()) throw Error(ErrorCode::Contract, where, say::rig_lidars_expected());
    const auto lidar = std::ranges::find(all, name, &ChosenLidar::name);
    if (lidar == all.end()) {
      std::vector<std::string> names;
      for (const ChosenLidar& one : all) names.push_back(one.name);
      throw Error(ErrorCode::Contract, name, say::rig_no_such_lidar(std::move(names)));
    }
    if (std::ranges::find(chosen, name, &ChosenLidar::name) != chosen.end())
      throw Error(ErrorCode::Contract, where, say::rig_named_twice());
    chosen.push_back(*lidar);
  }
  return chosen;
}

}  // namespace

std::vector<ChosenLidar> choose_lidars(const std::vector<std::filesystem::path>& recordings,
                                       const drive::TopicChoice& topics, const std::string& wanted, Console& console) {
  if (topics.contains("lidar")) throw Error(ErrorCode::Contract, "--lidars " + wanted, say::cli_rig_lidars_or_topic());
  std::vector<ChosenLidar> all, sensors;
  for (std::size_t r = 0; r < recordings.size(); ++r)
    for (const drive::LidarOffer& offer : formats::offer_lidars(recordings[r], console.progress())) {
      add_recording(all, offer, r, topics);
      if (!offer.rare) add_recording(sensors, offer, r, topics);
    }
  if (wanted != kAll) return named_ones(all, wanted);
  return sensors.empty() ? all : sensors;
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

}  // namespace remount::cli
