#include "model/fleet/fleet_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include "algorithms/core/error.h"
#include "algorithms/core/index.h"
#include "messages/fleet.h"
#include "model/fleet/failed_job.h"
#include "model/fleet/fleet_history.h"
#include "model/fleet/job_state.h"
#include "model/formats/files/input_file.h"
#include "model/results/display_units.h"

namespace remount::fleet {
namespace {

/// What is there of one job; its result, usable or not. Of LiDARs that have none the row is of the job.
std::optional<results::VehicleFile> examine(const Fleet& fleet, const FleetJob& job,
                                            const WhyOutOfDate& why_out_of_date, FleetRow& row) {
  try {
    Message old_failure;
    if (formats::is_file(job.failure)) {
      Message failure = failure_message(job);
      Message changed = why_failure_is_old(fleet, job);
      if (changed.empty()) {
        row.state = JobState::Failed;
        row.message = std::move(failure);
        return std::nullopt;
      }
      old_failure = say::fleet_failed_before(std::move(changed), std::move(failure));
    }
    if (!formats::is_file(job.result)) {
      row.message = old_failure;
      return std::nullopt;
    }
    results::VehicleFile vehicle = results::load_any_result(job.result);
    row.message = why_other_job(job, fleet.vehicles[job.vehicle], vehicle,
                                [](const results::LidarResult& lidar) { return lidar.file.nominal_ins_from_lidar; });
    if (row.message.empty() && why_out_of_date) row.message = why_out_of_date(job, vehicle);
    row.state = row.message.empty() ? JobState::Done : JobState::OutOfDate;
    return vehicle;
  } catch (const Error& error) {
    row.state = JobState::Failed;
    row.message = error.message();
    return std::nullopt;
  }
}

/// @param of_job what is alike for all of its LiDARs
FleetRow row_of(const results::VehicleFile& vehicle, const results::LidarResult& lidar, FleetRow of_job) {
  FleetRow row = std::move(of_job);
  row.lidar = lidar.name;
  row.result = lidar.file.result;
  row.warnings = warnings_of(vehicle, lidar);
  if (!lidar.name.empty()) row.joined = lidar.joined;
  if (row.state != JobState::Done) return row;
  row.message = results::why_not_joined(vehicle, lidar);
  if (row.message.empty()) row.message = lidar.file.result.message;
  return row;
}

void add_rows(const std::shared_ptr<const report::NamedVehicle>& now, const FleetRow& of_job, VehicleHistory& history,
              std::vector<FleetRow>& rows) {
  std::vector<LidarChange> changes = history.changes_of(*now);
  for (std::size_t l = 0; l < changes.size(); ++l) {
    FleetRow& row = rows.emplace_back(row_of(now->file, now->file.lidars[l], of_job));
    row.last = std::move(changes[l].last);
    row.reference = std::move(changes[l].reference);
    row.has_reference_of_its_own = changes[l].has_reference_of_its_own;
  }
  history.add(now);
}

}  // namespace

std::string_view to_string(JobState state) {
  constexpr std::array<std::string_view, 4> kNames{"waiting", "failed", "out of date", "done"};
  return kNames.at(index_of(state));
}

Message state_word(JobState state) {
  constexpr std::array<Message (*)(), 4> kWords{say::fleet_waiting, say::fleet_failed, say::fleet_out_of_date,
                                                say::fleet_done};
  return kWords.at(index_of(state))();
}

Message drift_in_words(const calibration::ResultDifference& change, const DriftLimits& limits) {
  Message words;
  for (const calibration::Parameter i : calibration::kParameters) {
    const double by = results::on_screen(i, change.difference[i]), sigma = results::on_screen(i, change.sigma[i]);
    const double limit = calibration::is_angle(i) ? limits.rotation_deg : limits.translation_m;
    if (!(std::abs(by) > limits.sigmas * sigma && std::abs(by) > limit)) continue;  // NaN: not observed by both
    const double sigmas = std::abs(by) / sigma;
    Message drift = calibration::is_angle(i)
                        ? say::fleet_drift_of_angle(calibration::parameter_word(i), Angle{change.difference[i]}, sigmas,
                                                    Angle{degrees_to_radians(limit)})
                        : say::fleet_drift_of_length(calibration::parameter_word(i), Length{change.difference[i]},
                                                     sigmas, Length{limit});
    words = words.empty() ? std::move(drift) : say::fleet_and(std::move(words), std::move(drift));
  }
  return words;
}

namespace {

Message drift_of(const Message& since_last, const Message& since_reference) {
  if (since_reference.empty()) return since_last;
  Message by_reference = say::fleet_drift_from_reference(since_reference);
  return since_last.empty() ? by_reference : say::fleet_and(since_last, std::move(by_reference));
}

}  // namespace

Message FleetRow::drift() const { return drift_of(last.drift, has_reference_of_its_own ? reference.drift : Message()); }

Message FleetRow::own_drift() const {
  const bool by_reference = has_reference_of_its_own && !reference.with_ins;
  return drift_of(last.with_ins ? Message() : last.drift, by_reference ? reference.drift : Message());
}

std::vector<Message> FleetRow::together() const {
  std::vector<Message> words;
  if (!last.together.empty()) words.push_back(last.together);
  if (has_reference_of_its_own && !reference.together.empty()) words.push_back(reference.together);
  return words;
}

FleetChange not_compared() {
  FleetChange change;
  change.change.difference.fill(std::nan(""));
  change.change.sigma.fill(std::nan(""));
  return change;
}

std::string title_of(const Fleet& fleet, const FleetRow& row) {
  return title_of(fleet, fleet.jobs.at(row.job)) + (row.lidar.empty() ? "" : ", " + row.lidar);
}

std::vector<std::span<const FleetRow>> rows_of_jobs(const std::vector<FleetRow>& rows) {
  std::vector<std::span<const FleetRow>> jobs;
  for (auto first = rows.begin(); first != rows.end();) {
    const auto end = std::find_if(first, rows.end(), [&](const FleetRow& row) { return row.job != first->job; });
    jobs.emplace_back(first, end);
    first = end;
  }
  return jobs;
}

std::vector<FleetAlarm> fleet_alarms(const Fleet& fleet, const std::vector<FleetRow>& rows) {
  std::vector<FleetAlarm> alarms;
  for (const std::span<const FleetRow> job : rows_of_jobs(rows)) {
    for (const FleetRow& row : job)
      if (Message drift = row.own_drift(); !drift.empty()) alarms.push_back({title_of(fleet, row), std::move(drift)});
    for (Message& words : together_of(job))
      alarms.push_back({title_of(fleet, fleet.jobs[job.front().job]), std::move(words)});
  }
  return alarms;
}

std::vector<Message> together_of(std::span<const FleetRow> job) {
  std::vector<Message> all;
  for (const FleetRow& row : job)
    for (Message& words : row.together())
      if (std::ranges::find(all, words) == all.end()) all.push_back(std::move(words));
  return all;
}

std::vector<FleetRow> fleet_rows(const Fleet& fleet, const WhyOutOfDate& why_out_of_date) {
  std::vector<FleetRow> rows;
  std::optional<VehicleHistory> history;
  for (std::size_t i = 0; i < fleet.jobs.size(); ++i) {
    const FleetJob& job = fleet.jobs[i];
    if (i == 0 || job.vehicle != fleet.jobs[i - 1].vehicle) history.emplace(fleet.vehicles[job.vehicle], fleet.drift);
    FleetRow row;
    row.job = i;
    row.last = row.reference = not_compared();
    std::optional<results::VehicleFile> vehicle = examine(fleet, job, why_out_of_date, row);
    if (vehicle)
      add_rows(std::make_shared<report::NamedVehicle>(report::NamedVehicle{job.name, std::move(*vehicle)}), row,
               *history, rows);
    else
      rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace remount::fleet
