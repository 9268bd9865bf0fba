#include "model/fleet/fleet_rows.h"

#include <array>
#include <cmath>

#include "algorithms/core/error.h"
#include "algorithms/core/index.h"
#include "messages/fleet.h"
#include "model/fleet/failed_job.h"
#include "model/fleet/job_state.h"
#include "model/formats/files/input_file.h"
#include "model/report/comparison.h"
#include "model/results/display_units.h"

namespace remount::fleet {
namespace {

/// An earlier calibration of a vehicle.
struct Earlier {
  std::optional<report::NamedResult> result;
  Message problem;  ///< why the one that the fleet names cannot be had
};

Earlier named(const std::filesystem::path& path) {
  Earlier earlier;
  if (path.empty()) return earlier;
  try {
    earlier.result = report::NamedResult{path.filename().string(), results::load_result(path)};
    if (!calibration::is_usable(earlier.result->file.result))
      earlier = {std::nullopt, say::fleet_nothing_to_use(path.string())};
  } catch (const Error& error) {
    earlier.problem = error.message();
  }
  return earlier;
}

FleetChange not_compared() {
  FleetChange change;
  change.change.difference.fill(std::nan(""));
  change.change.sigma.fill(std::nan(""));
  return change;
}

FleetChange change_since(const Earlier& earlier, const report::NamedResult& now, const DriftLimits& limits) {
  FleetChange change = not_compared();
  if (!earlier.problem.empty()) change.words = say::fleet_not_compared(earlier.problem);
  if (!earlier.result || !calibration::is_usable(now.file.result)) return change;
  const report::ComparedResults compared = report::compare_results({now, *earlier.result}).front();
  change.since = earlier.result->name;
  change.words = compared.words;
  change.change = compared.difference;
  change.drift = drift_in_words(change.change, limits);
  if (!change.drift.empty()) change.drift = say::fleet_drift_since(std::move(change.drift), change.since);
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
  void add(const report::NamedResult& calibration) {
    last = {calibration, {}};
    // One that is named and cannot be read is not replaced in silence.
    reference_is_last = !reference.result && reference.problem.empty();
    if (reference_is_last) reference = last;
  }
};

/// What is there of one job; its result, usable or not.
std::optional<results::ResultFile> examine(const Fleet& fleet, const FleetJob& job, const WhyOutOfDate& why_out_of_date,
                                           FleetRow& row) {
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
    results::ResultFile file = results::load_result(job.result);
    const FleetVehicle& vehicle = fleet.vehicles[job.vehicle];
    row.message = why_other_job(file, vehicle.settings, file.nominal_ins_from_lidar, vehicle.topics);
    if (row.message.empty() && why_out_of_date) row.message = why_out_of_date(job, file);
    row.state = row.message.empty() ? JobState::Done : JobState::OutOfDate;
    if (row.message.empty()) row.message = file.result.message;
    row.result = file.result;
    return file;
  } catch (const Error& error) {
    row.state = JobState::Failed;
    row.message = error.message();
    return std::nullopt;
  }
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

Message FleetRow::drift() const {
  if (!has_reference_of_its_own || reference.drift.empty()) return last.drift;
  Message by_reference = say::fleet_drift_from_reference(reference.drift);
  return last.drift.empty() ? by_reference : say::fleet_and(last.drift, std::move(by_reference));
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
    const std::optional<results::ResultFile> file = examine(fleet, job, why_out_of_date, row);
    if (!file) continue;
    const report::NamedResult now{job.name, *file};
    row.last = change_since(history->last, now, fleet.drift);
    row.reference = change_since(history->reference, now, fleet.drift);
    row.has_reference_of_its_own = !history->reference_is_last;
    if (calibration::is_usable(file->result)) history->add(now);
  }
  return rows;
}

}  // namespace remount::fleet
