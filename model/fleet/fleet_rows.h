// What the jobs of a fleet have made so far: X, how it has changed since the vehicle's calibrations before, and drift.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "algorithms/calibration/agreement.h"
#include "algorithms/calibration/calibration_result.h"
#include "model/fleet/fleet.h"
#include "model/fleet/job_warnings.h"
#include "model/results/vehicle_file.h"

namespace remount::fleet {

enum class JobState {
  Waiting,    ///< nothing is there, or a failure from before a change: `message` says which
  Failed,     ///< it could not be run: `message` says why
  OutOfDate,  ///< a result is there that was made from other files, settings or by another version: `message` says
              ///< which
  Done,       ///< a result is there, usable or not
};
/// "waiting", "failed", "out of date", "done": as tables for other programs have it.
std::string_view to_string(JobState state);
Message state_word(JobState state);

/// One calibration of a LiDAR compared with an earlier one of the same vehicle.
struct FleetChange {
  std::string since;  ///< the name of the earlier one; empty: there is none
  Message words;      ///< what to make of it; why it cannot be compared where it cannot
  calibration::ResultDifference
      change;     ///< this minus that, with the sigma of both; NaN where not compared or not observed
  Message drift;  ///< the alarm; empty: none
  /// That all LiDARs of the vehicle moved together since then, for it was the INS, and which moved as well; empty where
  /// nothing has drifted or nothing says so.
  Message together;
  bool with_ins = false;  ///< the LiDAR has drifted for no other reason
};
/// All NaN.
FleetChange not_compared();

/// One LiDAR of a job; the job as a whole where it has no result.
struct FleetRow {
  std::size_t job = 0;         ///< index into Fleet::jobs
  std::string lidar;           ///< empty: the only one, or all of them
  std::optional<bool> joined;  ///< whether it took part in a common solution; nothing for the only one
  JobState state = JobState::Waiting;
  Message message;
  std::optional<calibration::CalibrationResult> result;  ///< of OutOfDate and Done
  JobWarnings warnings;                                  ///< of the LiDAR
  FleetChange last;                                      ///< since the LiDAR's last usable calibration before this
  /// Since the one that the mounting is judged by: many small steps add up. Where the fleet file names no reference,
  /// the LiDAR's oldest usable calibration.
  FleetChange reference;
  bool has_reference_of_its_own = false;  ///< that is another calibration than the one of `last`

  /// All drift of the row, once; empty: none.
  Message drift() const;
  /// The same without what is for no other reason than that the INS moved.
  Message own_drift() const;
  /// That it was the INS, once for each calibration since which it was.
  std::vector<Message> together() const;
};

/// "vehicle, session", and the LiDAR where it has a name.
std::string title_of(const Fleet& fleet, const FleetRow& row);

/// What a user must hear of, in the order of the rows: drift of a LiDAR, and behind the LiDARs of a job that they moved
/// together.
struct FleetAlarm {
  std::string title;
  Message words;
};
std::vector<FleetAlarm> fleet_alarms(const Fleet& fleet, const std::vector<FleetRow>& rows);

/// The rows of each job, in their order.
std::vector<std::span<const FleetRow>> rows_of_jobs(const std::vector<FleetRow>& rows);

/// That the LiDARs of a job moved together, each sentence once.
std::vector<Message> together_of(std::span<const FleetRow> job);

/// The parameters whose change exceeds both limits ("yaw has changed by +0.41 deg, ..."); empty for none.
Message drift_in_words(const calibration::ResultDifference& change, const DriftLimits& limits);

/// Why a result is not what its job would make now, as far as the job's settings and the result do not tell; empty
/// where it is.
using WhyOutOfDate = std::function<Message(const FleetJob& job, const results::VehicleFile& stored)>;

/// One row a LiDAR of each job, in order. Reads the results that are there, no session. @param why_out_of_date may be
/// empty: then what of a result's inputs has changed since is known only to the job itself
std::vector<FleetRow> fleet_rows(const Fleet& fleet, const WhyOutOfDate& why_out_of_date = {});

}  // namespace remount::fleet
