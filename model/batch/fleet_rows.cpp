#include "model/batch/fleet_rows.h"

#include <array>
#include <cmath>
#include <cstdio>

#include "algorithms/core/error.h"
#include "model/batch/job_state.h"
#include "model/display_units.h"
#include "model/io/input_file.h"
#include "model/report/comparison.h"

namespace remount {
namespace {

constexpr std::uint64_t kMaxFailureBytes = std::uint64_t{1} << 20;

/// The vehicle's latest usable calibration so far.
struct LastCalibration {
  std::optional<NamedResult> result;
  std::string problem;  ///< why the one that the file names cannot be had
};

LastCalibration named_last(const FleetVehicle& vehicle) {
  LastCalibration last;
  if (vehicle.last.empty()) return last;
  try {
    last.result = NamedResult{vehicle.last.filename().string(), load_result(vehicle.last)};
    if (!is_usable(last.result->file.result)) {
      last.problem = vehicle.last.string() + " has nothing to use";
      last.result.reset();
    }
  } catch (const Error& error) {
    last.problem = error.what();
  }
  return last;
}

void compare(FleetRow& row, const ResultFile& file, const std::string& name, const LastCalibration& last,
             const DriftLimits& limits) {
  if (!last.problem.empty()) row.comparison = "Not compared: " + last.problem + ".";
  if (!last.result || !is_usable(file.result)) return;
  const ComparedResults compared = compare_results({NamedResult{name, file}, *last.result}).front();
  row.compared_with = last.result->name;
  row.comparison = compared.words;
  row.change = compared.difference;
  row.drift = drift_in_words(row.change, limits);
  if (!row.drift.empty()) row.drift += "; since " + row.compared_with;
}

/// What is there of one job; its result where it is usable or not.
std::optional<ResultFile> examined(const Fleet& fleet, const FleetJob& job, FleetRow& row) {
  try {
    if (is_file(job.failure)) {
      row.state = JobState::Failed;
      row.message = std::string(trimmed(read_regular_file(job.failure, kMaxFailureBytes)));
      return std::nullopt;
    }
    if (!is_file(job.result)) return std::nullopt;
    ResultFile file = load_result(job.result);
    row.message = why_other_job(file, fleet.vehicles[job.vehicle].settings, file.nominal_ins_from_lidar);
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

std::vector<FleetRow> fleet_rows(const Fleet& fleet) {
  std::vector<FleetRow> rows;
  LastCalibration last;
  for (std::size_t i = 0; i < fleet.jobs.size(); ++i) {
    const FleetJob& job = fleet.jobs[i];
    if (i == 0 || job.vehicle != fleet.jobs[i - 1].vehicle) last = named_last(fleet.vehicles[job.vehicle]);
    FleetRow& row = rows.emplace_back();
    row.job = i;
    row.change.difference.fill(std::nan(""));
    row.change.sigma.fill(std::nan(""));
    const std::optional<ResultFile> file = examined(fleet, job, row);
    if (!file) continue;
    compare(row, *file, job.name, last, fleet.drift);
    if (is_usable(file->result)) last = {NamedResult{job.name, *file}, ""};
  }
  return rows;
}

}  // namespace remount
