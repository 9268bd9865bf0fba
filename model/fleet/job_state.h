// Whether a job of a fleet is done: what there is already need not be calibrated again.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "model/fleet/fleet.h"
#include "model/results/vehicle_file.h"
#include "model/rig/rig_calibration.h"

namespace remount::fleet {

/// The nominal that is asked for now of a LiDAR of a result, in the axes of that.
using AskedNominal = std::function<std::optional<RigidTransform>(const results::LidarResult&)>;

/// Why what made `stored` is not what the job asks for now: another version of the program, LiDARs, settings, a nominal
/// or topics that have changed, a run that was cancelled. Empty where nothing is. Only topics that somebody asked for
/// are compared; which others would be suggested now is known only to the opened bag.
Message why_other_job(const FleetJob& job, const FleetVehicle& vehicle, const results::VehicleFile& stored,
                      const AskedNominal& nominal_of);

/// Why the job must run (again); empty where its result answers `lidars` as they are now. Files that have not been
/// written since the result was are taken to be unchanged; others are compared by their hashes.
/// @param lidars what the job reads, of each LiDAR; one without a name of a job of one
Message why_not_done(const FleetJob& job, const std::vector<rig::LidarJob>& lidars, Progress& progress);

/// Whether anything where the job's sessions lie was written, added or taken away since its result was made, judged by
/// the files' times alone: only then need they be opened to be sure. True where it cannot be told.
bool may_have_changed(const FleetJob& job, const results::VehicleFile& stored);

/// Whether a file was written at the time of the job's result or later; true where one of them is not there.
bool written_since_result(const std::filesystem::path& file, const FleetJob& job);

/// The first of these files and folders where something was written, added or taken away since the job failed, judged
/// by times alone; one that is not there (any more) has nothing new. Empty where there is none, or no failure.
std::string changed_since_failure(const FleetJob& job, const std::vector<std::filesystem::path>& read);

/// "session/file" of the first input that was written at `since_ns` (ns since 1970) or later; empty where none was.
std::string file_written_since(const std::vector<rig::LidarJob>& lidars, std::int64_t since_ns);

}  // namespace remount::fleet
