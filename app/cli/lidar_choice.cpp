#include "app/cli/lidar_choice.h"

#include <algorithm>

#include "algorithms/core/error.h"
#include "app/cli/arguments.h"
#include "messages/rig.h"
#include "model/formats/files/input_file.h"
#include "model/formats/session_readers.h"
#include "model/results/lidar_names.h"
#include "model/results/vehicle_file.h"

namespace remount::cli {
namespace {

constexpr const char* kAll = "all";

std::vector<std::string> names_of(const std::vector<ChosenLidar>& lidars) {
  std::vector<std::string> names;
  for (const ChosenLidar& lidar : lidars) names.push_back(lidar.name);
  return names;
}

std::vector<ChosenLidar> named_ones(const std::vector<ChosenLidar>& all, const std::string& wanted) {
  const std::string where = "--lidars " + wanted;
  const std::vector<std::string> names = names_of(all);
  std::vector<ChosenLidar> chosen;
  for (const std::string& part : split(wanted, ',')) {
    const std::string name(formats::trim(part));
    if (name.empty()) throw Error(ErrorCode::Contract, where, say::rig_lidars_expected());
    const auto lidar = std::ranges::find(all, results::lidar_meant_by(name, names), &ChosenLidar::name);
    if (lidar == all.end()) throw Error(ErrorCode::Contract, name, say::rig_no_such_lidar(names));
    if (std::ranges::find(chosen, lidar->name, &ChosenLidar::name) != chosen.end())
      throw Error(ErrorCode::Contract, where, say::rig_named_twice());
    chosen.push_back(*lidar);
  }
  return chosen;
}

void tell_left_out(const rig::RecordedLidars& found, Console& console) {
  std::vector<std::string> rare = names_of(found.all);
  std::erase_if(rare, [&](const std::string& name) {
    return std::ranges::find(found.sensors, name, &ChosenLidar::name) != found.sensors.end();
  });
  if (!rare.empty()) console.complain(say::cli_rig_rare_left_out(std::move(rare)));
}

void tell_unused(const std::vector<std::filesystem::path>& recordings, const std::vector<ChosenLidar>& chosen,
                 Console& console) {
  for (std::size_t r = 0; r < recordings.size(); ++r) {
    const auto holds = [&](const ChosenLidar& lidar) {
      return std::ranges::find(lidar.recordings, r, &ChosenLidar::Recording::place) != lidar.recordings.end();
    };
    if (std::ranges::none_of(chosen, holds)) console.complain(say::cli_rig_recording_unused(recordings[r].string()));
  }
}

}  // namespace

std::vector<ChosenLidar> choose_lidars(const std::vector<std::filesystem::path>& recordings,
                                       const drive::TopicChoice& topics, const std::string& wanted, Console& console) {
  if (topics.contains("lidar")) throw Error(ErrorCode::Contract, "--lidars " + wanted, say::cli_rig_lidars_or_topic());
  rig::RecordedLidars found = rig::find_lidars(recordings, topics, console.progress());
  if (wanted == kAll) tell_left_out(found, console);
  std::vector<ChosenLidar> chosen = wanted == kAll ? std::move(found.sensors) : named_ones(found.all, wanted);
  tell_unused(recordings, chosen, console);
  return chosen;
}

drive::Session open_with_lidar(const std::filesystem::path& recording, drive::TopicChoice topics,
                               const std::string& lidar, Console& console) {
  if (!lidar.empty() && !topics.contains("lidar"))
    topics = choose_lidars({recording}, topics, lidar, console).front().recordings.front().topics;
  return formats::open_session(recording, topics, console.progress());
}

std::optional<results::LidarResult> result_of_lidar(const std::filesystem::path& path, const std::string& lidar) {
  if (!results::is_vehicle_file(path)) {
    if (lidar.empty()) return {};
    (void)formats::read_file_head(path, 1);  // or one that is missing would be called the result of one
    throw Error(ErrorCode::Contract, "--lidar", say::export_of_vehicle());
  }
  const results::VehicleFile vehicle = results::load_vehicle(path);
  if (lidar.empty())
    throw Error(ErrorCode::Contract, path.string(), say::cli_lidar_of_several(results::lidar_names(vehicle)));
  return results::lidar_of(vehicle, lidar, path.string());
}

}  // namespace remount::cli
