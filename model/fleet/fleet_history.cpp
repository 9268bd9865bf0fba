#include "model/fleet/fleet_history.h"

#include <algorithm>
#include <set>

#include "algorithms/core/error.h"
#include "messages/fleet.h"

namespace remount::fleet {
namespace {

Message has_no_such(const std::string& file, const results::VehicleFile& vehicle, const std::string& lidar) {
  const std::vector<std::string> names = results::lidar_names(vehicle);
  if (lidar.empty()) return say::fleet_has_several_lidars(file, names);
  return names.front().empty() ? say::fleet_has_one_lidar(file, lidar)
                               : say::fleet_has_no_such_lidar(file, lidar, names);
}

void explain_by_ins(const std::string& lidar, const report::ComparedVehicles& compared, const report::NamedVehicle& now,
                    const report::NamedVehicle& earlier, FleetChange& change) {
  change.together = say::fleet_together_since(earlier.name, report::words_of_ins(compared));
  const auto found = std::ranges::find(compared.lidars, lidar, &report::ComparedLidar::name);
  change.with_ins = found != compared.lidars.end() && compared.moved_with_ins(*found);
  if (change.with_ins) change.words = report::words_of_most(found->results, now.name, earlier.name);
}

/// Where LiDARs have drifted since one earlier calibration of the vehicle, whether it was the INS that moved. `since`
/// is that calibration for each LiDAR of `now`.
void tell_of_ins(const report::NamedVehicle& now, const std::vector<const report::NamedVehicle*>& since,
                 FleetChange LidarChange::*which, std::vector<LidarChange>& changes) {
  for (const report::NamedVehicle* earlier : std::set(since.begin(), since.end())) {
    bool any_drift = false;
    for (std::size_t l = 0; l < since.size(); ++l)
      any_drift = any_drift || (since[l] == earlier && !(changes[l].*which).drift.empty());
    if (earlier == nullptr || !any_drift || std::ranges::count(since, earlier) < 2) continue;
    const report::ComparedVehicles compared = report::compare_vehicles(now, *earlier);
    const Message words = report::words_of_ins(compared);
    if (words.empty()) continue;
    for (std::size_t l = 0; l < since.size(); ++l)
      if (since[l] == earlier) explain_by_ins(now.file.lidars[l].name, compared, now, *earlier, changes[l].*which);
  }
}

}  // namespace

const VehicleHistory::NamedFile& VehicleHistory::load(const std::filesystem::path& path) {
  const auto [entry, is_new] = files_.try_emplace(path);
  NamedFile& file = entry->second;
  if (!is_new) return file;
  try {
    file.vehicle = std::make_shared<report::NamedVehicle>(
        report::NamedVehicle{path.filename().string(), results::load_any_result(path)});
  } catch (const Error& error) {
    file.problem = error.message();
  }
  return file;
}

/// @param stays where the file knows no such LiDAR
Earlier VehicleHistory::find(const EarlierFiles& files, const std::string& lidar, bool stays) {
  const std::filesystem::path& path = files.of(lidar);
  if (path.empty()) return {};
  const NamedFile& file = load(path);
  if (!file.problem.empty()) return {nullptr, nullptr, file.problem, true};
  const results::VehicleFile& vehicle = file.vehicle->file;
  const results::LidarResult* found = results::find_lidar(vehicle, lidar);
  // The result of one LiDAR has no name, but the fleet may say whose it is.
  if (!found && files.of_lidars.contains(lidar)) found = results::find_lidar(vehicle, "");
  if (!found) return {nullptr, nullptr, has_no_such(path.string(), vehicle, lidar), stays};
  if (!calibration::is_usable(found->file.result))
    return {nullptr, nullptr, say::fleet_nothing_to_use(path.string()), true};
  return {file.vehicle, &found->file, {}, false};
}

VehicleHistory::LidarHistory& VehicleHistory::history_of(const std::string& lidar) {
  const auto [entry, is_new] = lidars_.try_emplace(lidar);
  LidarHistory& history = entry->second;
  if (!is_new) return history;
  const std::filesystem::path& reference = vehicle_.reference.of(lidar);
  history.reference_is_last = reference.empty() || reference == vehicle_.last.of(lidar);
  history.last = find(vehicle_.last, lidar, false);
  history.reference = history.reference_is_last ? history.last : find(vehicle_.reference, lidar, true);
  return history;
}

FleetChange VehicleHistory::change_since(const Earlier& earlier, const std::string& name,
                                         const results::ResultFile& now) const {
  FleetChange change = not_compared();
  if (!earlier.problem.empty()) change.words = say::fleet_not_compared(earlier.problem);
  if (!earlier.file || !calibration::is_usable(now.result)) return change;
  const report::ComparedResults compared =
      report::compare_results({{name, now}, {earlier.vehicle->name, *earlier.file}}).front();
  change.since = earlier.vehicle->name;
  change.words = compared.words;
  change.change = compared.difference;
  change.drift = drift_in_words(change.change, limits_);
  if (!change.drift.empty()) change.drift = say::fleet_drift_since(std::move(change.drift), change.since);
  return change;
}

std::vector<LidarChange> VehicleHistory::changes_of(const report::NamedVehicle& now) {
  std::vector<LidarChange> changes;
  std::vector<const report::NamedVehicle*> since_last, since_reference;
  for (const results::LidarResult& lidar : now.file.lidars) {
    const LidarHistory& history = history_of(lidar.name);
    changes.push_back({change_since(history.last, now.name, lidar.file),
                       change_since(history.reference, now.name, lidar.file), !history.reference_is_last});
    since_last.push_back(history.last.vehicle.get());
    since_reference.push_back(history.reference.vehicle.get());
  }
  tell_of_ins(now, since_last, &LidarChange::last, changes);
  tell_of_ins(now, since_reference, &LidarChange::reference, changes);
  return changes;
}

void VehicleHistory::add(const std::shared_ptr<const report::NamedVehicle>& vehicle) {
  for (const results::LidarResult& lidar : vehicle->file.lidars) {
    LidarHistory& history = history_of(lidar.name);
    if (!calibration::is_usable(lidar.file.result)) continue;
    history.last = {vehicle, &lidar.file, {}, false};
    // One that is named and cannot be read is not replaced in silence.
    history.reference_is_last = !history.reference.file && !history.reference.stays;
    if (history.reference_is_last) history.reference = history.last;
  }
}

}  // namespace remount::fleet
