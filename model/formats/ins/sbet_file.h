// Trajectories that Applanix' POSPac has smoothed (SBET), with the errors beside them (SMRMSG).
#pragma once

#include "model/formats/ins/ins_log.h"

namespace remount::formats {

/// From the first records: 17 doubles each, with what an INS may say in all of them. Never throws.
bool recognise_sbet(const std::filesystem::path& path);

/// The same of 10 doubles: time and root mean square errors.
bool recognise_smrmsg(const std::filesystem::path& path);

/// Samples with the seconds of a GPS week that nobody names (InsLog::week_open); they may run on, or begin anew, where
/// a week ends. Latitude, longitude and angles in radians, heights above the ellipsoid. The heading from true north is
/// the platform's less the wander angle; heading, pitch and roll take forward-right-down to north-east-down, and the
/// samples have these axes as forward-left-up. Errors are those of the SMRMSG in the same folder, where there is one
/// alone, or one with the same name behind "smrmsg": the nearest in time (give_errors). Records that hold no possible
/// sample are left out and counted. Throws Error as InsLogKind::read says, and where times are no seconds of a week.
InsLog read_sbet(const std::filesystem::path& path, std::vector<drive::Finding>& findings);

}  // namespace remount::formats
