// What a project holds of a vehicle.
#include <algorithm>

#include "app/gui/workbench/vehicle.h"

namespace remount::gui {

std::vector<SavedLidar> Vehicle::others_to_save() const {
  std::vector<SavedLidar> others;
  const std::optional<motion::LidarIndex> on_bench = shown();
  const VehicleState now = state();
  for (motion::LidarIndex l; l < now.lidars.size(); ++l) {
    // The LiDAR that is shown is saved as the project itself. Where sessions are of several LiDARs, none of them is
    // shown, and all are saved here.
    if (l == on_bench) continue;
    const VehicleLidar& lidar = now.lidars[l];
    others.push_back(lidar.saved ? *lidar.saved
                                 : saved_of(lidar, paths_of(lidar), topics_of(lidar), parts_.setup.settings()));
    others.back().lidar.ticked = lidar.ticked;
    if (lidar.nominal_ins_from_lidar)  // given since the project was opened
      others.back().lidar.job.nominal_ins_from_lidar = lidar.nominal_ins_from_lidar;
  }
  return others;
}

void Vehicle::restore(const project::Project& project, std::vector<SavedLidar> others) {
  desk_.jobs.cancel(look_);
  look_ = 0;
  before_.clear();
  lidars_.clear();
  recordings_.clear();
  known_.clear();
  common_ = nullptr;
  if (others.empty()) return;  // they are looked for, as after opening sessions
  known_ = parts_.sessions.all();
  for (const SessionPtr& session : known_)
    recordings_.push_back({session->path, session->name, without_lidar(session->topic_choice)});
  const auto is_other = [&](const SessionPtr& session) {
    return std::ranges::any_of(others, [&](const SavedLidar& saved) { return saved.lidar.name == lidar_of(*session); });
  };
  if (std::ranges::none_of(known_, is_other)) restore_bench();
  for (SavedLidar& saved : others) restore_lidar(std::move(saved));
  if (project.together) restore_common(*project.together);
}

void Vehicle::restore_bench() {
  VehicleLidar lidar{{lidar_of(*known_.front()), {}}, true, known_};
  for (std::size_t s = 0; s < known_.size(); ++s) {
    const drive::TopicChoice used = drive::choice_in_use(known_[s]->topics);
    const auto topic = used.find("lidar");
    lidar.recorded.recordings.push_back({s, topic == used.end() ? drive::TopicChoice() : drive::TopicChoice{*topic}});
  }
  lidars_.push_back(std::move(lidar));
}

void Vehicle::restore_lidar(SavedLidar saved) {
  const project::Project& job = saved.lidar.job;
  VehicleLidar lidar{{saved.lidar.name, {}}, saved.lidar.ticked, {}};
  lidar.nominal_ins_from_lidar = job.nominal_ins_from_lidar;
  for (std::size_t s = 0; s < job.sessions.size(); ++s) {
    auto of = std::ranges::find(recordings_, job.sessions[s], &VehicleRecording::path);
    if (of == recordings_.end())
      of = recordings_.insert(of,
                              {job.sessions[s], job.sessions[s].filename().string(), without_lidar(job.topics_of(s))});
    lidar.recorded.recordings.push_back({static_cast<std::size_t>(of - recordings_.begin()), job.topics_of(s)});
  }
  lidar.sessions.resize(job.sessions.size());
  lidar.saved = std::make_shared<const SavedLidar>(std::move(saved));
  lidars_.push_back(std::move(lidar));
}

void Vehicle::restore_common(const results::VehicleFile& file) {
  std::ranges::stable_sort(lidars_, {}, [&](const VehicleLidar& lidar) {
    return std::ranges::find(file.lidars, lidar.name(), &results::LidarResult::name);
  });
  std::vector<KeptVerdicts> decisions;
  for (const results::LidarResult& solved : file.lidars) {
    const auto lidar = std::ranges::find(lidars_, solved.name, &VehicleLidar::name);
    decisions.push_back(lidar == lidars_.end() ? KeptVerdicts()
                        : lidar->saved
                            ? kept_verdicts(lidar->saved->lidar.job.sessions, lidar->saved->lidar.job.verdicts)
                            : parts_.decisions.made());
  }
  common_ = common_of_project(file, decisions);
}

}  // namespace remount::gui
