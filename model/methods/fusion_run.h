// The multi-sensor odometry over a recorded session.
#pragma once

#include <string>
#include <vector>

#include "algorithms/calibration/method_details.h"
#include "algorithms/odometry/fusion_odometry.h"
#include "model/session.h"
#include "model/settings.h"

namespace remount {

/// Wheels, IMU and barometer reach the LiDAR through the nominal mounting: poses that rest on them cannot judge it.
enum class FusionSensors { All, ScansAlone };

struct FusionRun {
  FusionOdometryResult odometry;
  std::vector<StampedPose> odometry_from_lidar;  ///< as many as the session has scans, unless cancelled
  std::vector<std::int64_t> breaks_ns;  ///< stamps of scans that do not tell all of the motion since the scan before
  std::vector<Finding> findings;
};

/// Runs the odometry over a session's scans, wheels, IMU and barometer. `nominal_ins_from_lidar`: where the LiDAR sits;
/// settings.fusion says where the INS and the IMU sit. Without a nominal only the scans are used, and "vehicle" is the
/// LiDAR itself; with FusionSensors::ScansAlone that is so whatever the nominal. A scan that cannot be read becomes a
/// finding, and its pose the prediction; one whose points' times make no sense is used as it is. Throws
/// Error(Unsupported) for a session without scans.
FusionRun run_fusion_odometry(const Session& session, const std::optional<RigidTransform>& nominal_ins_from_lidar,
                              const Settings& settings, int threads, Progress& progress,
                              FusionSensors sensors = FusionSensors::All);

/// From above; height, pitch and roll, and distance of the features from the map against time.
std::vector<Plot> fusion_plots(const Session& session, const FusionRun& run);

/// `t x y z qx qy qz qw`, t in seconds: what pose files and the native format's lidar_poses are read from.
std::string odometry_text(const std::vector<StampedPose>& poses);

}  // namespace remount
