// What the jobs of a fleet have made so far: X, how it has changed since the vehicle's calibration before, and drift.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "algorithms/calibration/agreement.h"
#include "algorithms/calibration/calibration_result.h"
#include "model/batch/fleet.h"

namespace remount {

enum class JobState {
  Waiting,    ///< nothing is there
  Failed,     ///< it could not be run: `message` says why
  OutOfDate,  ///< a result is there that other settings or another version made: `message` says which
  Done,       ///< a result is there, usable or not
};
/// "waiting", "failed", "out of date", "done".
std::string_view to_string(JobState state);

struct FleetRow {
  std::size_t job = 0;  ///< index into Fleet::jobs
  JobState state = JobState::Waiting;
  std::string message;
  std::optional<CalibrationResult> result;  ///< of OutOfDate and Done
  std::string compared_with;                ///< the vehicle's last usable calibration before this; empty: there is none
  std::string comparison;                   ///< in words; why there is none where it cannot be made
  ResultDifference change;                  ///< this minus that; NaN where they are not compared or not observed
  std::string drift;                        ///< the alarm in words; empty: none
};

/// The parameters whose change exceeds both limits, in words ("yaw has changed by +0.41 deg, ..."); empty for none.
std::string drift_in_words(const ResultDifference& change, const DriftLimits& limits);

/// One row a job, in order. Reads the results that are there, no session; what of a result's inputs has changed since
/// is known only to the job itself.
std::vector<FleetRow> fleet_rows(const Fleet& fleet);

}  // namespace remount
