// The multi-sensor odometry over a recorded session.
#pragma once

#include <string>
#include <vector>

#include "algorithms/calibration/method_details.h"
#include "algorithms/odometry/fusion_odometry.h"
#include "model/session.h"
#include "model/settings.h"

namespace remount {

struct FusionRun {
  FusionOdometryResult odometry;
  std::vector<StampedPose> odometry_from_lidar;  ///< as many as the session has scans, unless cancelled
  std::vector<Finding> findings;
};

/// Runs the odometry over a session's scans, wheels, IMU and barometer. `nominal_ins_from_lidar`: where the LiDAR sits;
/// settings.fusion says where the INS and the IMU sit. Without a nominal only the scans are used, and "vehicle" is the
/// LiDAR itself. A scan that cannot be read becomes a finding, and its pose the prediction. Throws Error(Unsupported)
/// for a session without scans.
FusionRun run_fusion_odometry(const Session& session, const std::optional<RigidTransform>& nominal_ins_from_lidar,
                              const Settings& settings, int threads, Progress& progress);

/// From above; height, pitch and roll against time; gyroscope and wheels.
std::vector<Plot> fusion_plots(const Session& session, const FusionRun& run);

/// `t x y z qx qy qz qw`, t in seconds: what pose files and the native format's lidar_poses are read from.
std::string tum_text(const std::vector<StampedPose>& poses);

}  // namespace remount
