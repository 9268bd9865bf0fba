// Which LiDARs a vehicle has, as recordings come and go.
#include <algorithm>

#include "app/gui/workbench/vehicle.h"

namespace remount::gui {
namespace {

constexpr std::size_t kMostBefore = 20;  // states of other sessions that are kept for undo
constexpr auto kPathOf = &VehicleRecording::path;

bool holds_all(const std::vector<VehicleRecording>& recordings, const std::vector<SessionPtr>& sessions) {
  return std::ranges::all_of(sessions, [&](const SessionPtr& session) {
    return std::ranges::find(recordings, session->path, kPathOf) != recordings.end();
  });
}

/// What stays of a LiDAR where recordings come and go: its result where all that it was made from is still there.
void move_to(const std::vector<VehicleRecording>& from, const std::vector<VehicleRecording>& to, VehicleLidar& lidar) {
  VehicleLidar moved = lidar;
  moved.recorded.recordings.clear();
  moved.sessions.clear();
  lidar.sessions.resize(lidar.recorded.recordings.size());
  for (std::size_t r = 0; r < lidar.recorded.recordings.size(); ++r) {
    rig::RecordedLidar::Recording recording = lidar.recorded.recordings[r];
    const auto place = std::ranges::find(to, from.at(recording.place).path, kPathOf);
    if (place == to.end()) continue;
    recording.place = static_cast<std::size_t>(place - to.begin());
    moved.recorded.recordings.push_back(std::move(recording));
    moved.sessions.push_back(lidar.sessions[r]);
  }
  if (moved.calibrated && !holds_all(to, moved.calibrated->result.input.sessions))
    moved.calibrated = std::make_shared<const Calibrated>(Calibrated{{}, lidar.calibrated->decisions, {}});
  if (moved.saved && !std::ranges::all_of(moved.saved->lidar.job.sessions, [&](const auto& path) {
        return std::ranges::find(to, path, kPathOf) != to.end();
      }))
    moved.saved = nullptr;
  lidar = std::move(moved);
}

}  // namespace

void Vehicle::follow_sessions() {
  if (swapping_) return;
  const std::vector<SessionPtr>& open = parts_.sessions.all();
  const auto path_of = [](const SessionPtr& session) { return session->path; };
  if (std::ranges::equal(known_, open, {}, path_of, path_of)) {  // of other topics, perhaps
    known_ = open;
    for (const SessionPtr& session : open)
      if (const auto of = std::ranges::find(recordings_, session->path, kPathOf); of != recordings_.end())
        of->topics = without_lidar(session->topic_choice);
    return emit changed();
  }
  if (!lidars_.empty()) before_.emplace_back(known_, state());
  if (before_.size() > kMostBefore) before_.pop_front();
  const auto known = std::ranges::find(before_, open, [](const auto& one) { return one.first; });
  // Recordings that the LiDAR that was shown has not stay; of the others, what is open now.
  std::vector<VehicleRecording> recordings = recordings_;
  std::erase_if(recordings, [&](const VehicleRecording& recording) {
    return std::ranges::find(known_, recording.path, path_of) != known_.end();
  });
  for (const SessionPtr& session : open)
    if (std::ranges::find(recordings, session->path, kPathOf) == recordings.end())
      recordings.push_back({session->path, session->name, without_lidar(session->topic_choice)});
  if (open.empty()) recordings.clear();
  known_ = open;
  if (known != before_.end()) {
    const VehicleState state = known->second;
    recordings_ = state.recordings;
    lidars_ = state.lidars;
    common_ = state.common;
    return emit changed();
  }
  take_recordings(std::move(recordings));
  look();
}

void Vehicle::take_recordings(std::vector<VehicleRecording> recordings) {
  lidars_ = state().lidars;
  for (VehicleLidar& lidar : lidars_) move_to(recordings_, recordings, lidar);
  std::erase_if(lidars_, [](const VehicleLidar& lidar) { return lidar.recorded.recordings.empty(); });
  if (common_ && !std::ranges::all_of(common_->lidars, [&](const SolvedLidar& lidar) {
        return holds_all(recordings, lidar.job.input.sessions);
      }))
    common_ = nullptr;
  recordings_ = std::move(recordings);
  emit changed();
}

void Vehicle::look() {
  desk_.jobs.cancel(look_);
  look_ = 0;
  if (!desk_.engine.find_lidars || recordings_.empty()) return;
  std::vector<std::filesystem::path> paths;
  for (const VehicleRecording& recording : recordings_) paths.push_back(recording.path);
  auto job = std::make_shared<int>(0);
  look_ = desk_.jobs.start(
      [this, job, paths, sessions = parts_.sessions.all(), find = desk_.engine.find_lidars](Progress& progress) {
        std::vector<rig::RecordedLidar> found = find(sessions, paths, progress);
        return JobRunner::Deliver([this, job, found = std::move(found)] {
          if (*job == look_) take_lidars(found);
        });
      },
      [](const JobFailure&) {});  // the sessions are open; that they hold one LiDAR each is what is shown then
  *job = look_;
}

void Vehicle::take_lidars(const std::vector<rig::RecordedLidar>& found) {
  if (found.size() < 2) {
    if (lidars_.size() < 2) lidars_.clear();
    return emit changed();
  }
  const bool first = lidars_.empty();
  for (const rig::RecordedLidar& lidar : found) {
    auto entry = std::ranges::find(lidars_, lidar.name, &VehicleLidar::name);
    if (entry == lidars_.end()) entry = lidars_.insert(lidars_.end(), VehicleLidar{{lidar.name, {}}, true, {}});
    std::vector<SessionPtr> sessions;
    for (const rig::RecordedLidar::Recording& recording : lidar.recordings) {
      const auto before =
          std::ranges::find(entry->recorded.recordings, recording.place, &rig::RecordedLidar::Recording::place);
      const auto at = static_cast<std::size_t>(before - entry->recorded.recordings.begin());
      sessions.push_back(at < entry->sessions.size() ? entry->sessions[at] : nullptr);
    }
    entry->recorded = lidar;
    entry->sessions = std::move(sessions);
  }
  if (first)
    desk_.notices.say(
        drive::Severity::Note, {},
        tr("%1 LiDARs are in these recordings. They can be calibrated together: see LiDARs.").arg(lidars_.size()));
  emit changed();
  warn_of_mixture();
}

void Vehicle::warn_of_mixture() {
  QStringList names;
  for (const SessionPtr& session : parts_.sessions.all()) {
    const QString name = QString::fromStdString(lidar_of(*session));
    if (std::ranges::find(lidars_, name.toStdString(), &VehicleLidar::name) != lidars_.end() && !names.contains(name))
      names << name;
  }
  if (names.size() > 1)
    desk_.notices.say(drive::Severity::Warning, names.join(QStringLiteral(", ")),
                      tr("The sessions that are open are of different LiDARs, which no calibration of one may mix. "
                         "Double click one of them in LiDARs."));
}

}  // namespace remount::gui
