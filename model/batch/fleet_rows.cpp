#include "model/batch/fleet_rows.h"

#include <array>
#include <cmath>
#include <cstdio>

#include "algorithms/core/error.h"
#include "model/batch/failed_job.h"
#include "model/batch/job_state.h"
#include "model/display_units.h"
#include "model/io/input_file.h"
#include "model/report/comparison.h"

namespace remount {
namespace {

/// An earlier calibration of a vehicle.
struct Earlier {
  std::optional<NamedResult> result;
  std::string problem;  ///< why the one that the fleet names cannot be had
};

Earlier named(const std::filesystem::path& path) {
  Earlier earlier;
  if (path.empty()) return earlier;
  try {
    earlier.result = NamedResult{path.filename().string(), load_result(path)};
    if (!is_usable(earlier.result->file.result)) earlier = {std::nullopt, path.string() + " has nothing to use"};
  } catch (const Error& error) {
    earlier.problem = error.what();
  }
  return earlier;
}

FleetChange not_compared() {
  FleetChange change;
  change.change.difference.fill(std::nan(""));
  change.change.sigma.fill(std::nan(""));
  return change;
}

FleetChange change_since(const Earlier& earlier, const NamedResult& now, const DriftLimits& limits) {
  FleetChange change = not_compared();
  if (!earlier.problem.empty()) change.words = "Not compared: " + earlier.problem + ".";
  if (!earlier.result || !is_usable(now.file.result)) return change;
  const ComparedResults compared = compare_results({now, *earlier.result}).front();
  change.since = earlier.result->name;
  change.words = compared.words;
  change.change = compared.difference;
  change.drift = drift_in_words(change.change, limits);
  if (!change.drift.empty()) change.drift += "; since " + change.since;
  return change;
}

/// What a vehicle's calibrations are compared with, from its first job to its last.
struct VehicleHistory {
  Earlier last, reference;
  bool reference_is_last;  ///< names do not tell: files of different folders may have one

  explicit VehicleHistory(const FleetVehicle& vehicle)
      : last(named(vehicle.last)),
        reference(named(vehicle.reference)),
        reference_is_last(vehicle.reference.empty() || vehicle.reference == vehicle.last) {
    if (reference_is_last) reference = last;
  }
  void add(const NamedResult& calibration) {
    last = {calibration, ""};
    // One that is named and cannot be read is not replaced in silence.
    reference_is_last = !reference.result && reference.problem.empty();
    if (reference_is_last) reference = last;
  }
};

/// What is there of one job; its result, usable or not.
std::optional<ResultFile> examined(const Fleet& fleet, const FleetJob& job, const WhyOutOfDate& why_out_of_date,
                                   FleetRow& row) {
  try {
    std::string old_failure;
    if (is_file(job.failure)) {
      const std::string message = failure_message(job), changed = why_failure_is_old(fleet, job);
      if (changed.empty()) {
        row.state = JobState::Failed;
        row.message = message;
        return std::nullopt;
      }
      old_failure = changed + "; before that it failed: " + message;
    }
    if (!is_file(job.result)) {
      row.message = old_failure;
      return std::nullopt;
    }
    ResultFile file = load_result(job.result);
    const FleetVehicle& vehicle = fleet.vehicles[job.vehicle];
    row.message = why_other_job(file, vehicle.settings, file.nominal_ins_from_lidar, vehicle.topics);
    if (row.message.empty() && why_out_of_date) row.message = why_out_of_date(job, file);
    row.state = row.message.empty() ? JobState::Done : JobState::OutOfDate;
    if (row.message.empty()) row.message = file.result.message;
    row.result = file.result;
    return file;
  } catch (const Error& error) {
    row.state = JobState::Failed;
    row.message = error.what();
    return std::nullopt;
  }
}

}  // namespace

std::string_view to_string(JobState state) {
  constexpr std::array<std::string_view, 4> kNames{"waiting", "failed", "out of date", "done"};
  return kNames.at(static_cast<std::size_t>(state));
}

std::string drift_in_words(const ResultDifference& change, const DriftLimits& limits) {
  std::string words;
  for (std::size_t i = 0; i < kParameterNames.size(); ++i) {
    const double by = on_screen(i, change.difference[i]), sigma = on_screen(i, change.sigma[i]);
    const double limit = is_angle(i) ? limits.rotation_deg : limits.translation_m;
    if (!(std::abs(by) > limits.sigmas * sigma && std::abs(by) > limit)) continue;  // NaN: not observed by both
    char text[200];
    std::snprintf(text, sizeof text, "%s has changed by %+.4f %s (%.1f times the sigma of both together, limit %g %s)",
                  std::string(kParameterNames[i]).c_str(), by, is_angle(i) ? "deg" : "m", std::abs(by) / sigma, limit,
                  is_angle(i) ? "deg" : "m");
    words += (words.empty() ? "" : "; ") + std::string(text);
  }
  return words;
}

std::string FleetRow::drift() const {
  if (!has_reference_of_its_own || reference.drift.empty()) return last.drift;
  return (last.drift.empty() ? "" : last.drift + "; ") + reference.drift + ", the reference";
}

std::vector<FleetRow> fleet_rows(const Fleet& fleet, const WhyOutOfDate& why_out_of_date) {
  std::vector<FleetRow> rows;
  std::optional<VehicleHistory> history;
  for (std::size_t i = 0; i < fleet.jobs.size(); ++i) {
    const FleetJob& job = fleet.jobs[i];
    if (i == 0 || job.vehicle != fleet.jobs[i - 1].vehicle) history.emplace(fleet.vehicles[job.vehicle]);
    FleetRow& row = rows.emplace_back();
    row.job = i;
    row.last = row.reference = not_compared();
    const std::optional<ResultFile> file = examined(fleet, job, why_out_of_date, row);
    if (!file) continue;
    const NamedResult now{job.name, *file};
    row.last = change_since(history->last, now, fleet.drift);
    row.reference = change_since(history->reference, now, fleet.drift);
    row.has_reference_of_its_own = !history->reference_is_last;
    if (is_usable(file->result)) history->add(now);
  }
  return rows;
}

}  // namespace remount
