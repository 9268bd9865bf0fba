// The multi-sensor odometry over a recorded session.
#pragma once

#include <string>
#include <vector>

#include "algorithms/calibration/method_details.h"
#include "algorithms/odometry/fusion/fusion_odometry.h"
#include "model/drive/session.h"
#include "model/settings/settings.h"

namespace remount::methods {

/// Wheels, IMU and barometer reach the LiDAR through the mounting: poses that rest on them cannot judge it.
enum class FusionUse {
  Motion,       ///< every sensor says what it knows: the best poses
  Calibration,  ///< the others speak only where the scans do not, and it is known where; corrections are left out
  ScansAlone,
};

struct FusionRun {
  odometry::FusionOdometryResult odometry;
  std::vector<motion::StampedPose> odometry_from_lidar;  ///< as many as the session has scans, unless cancelled
  std::vector<std::int64_t> breaks_ns;  ///< stamps of scans to which the motion since the scan before is a guess
  std::vector<Matrix6d> untold;         ///< of each pose, what of the motion to it no scan tells; for a calibration
  std::vector<drive::Finding> findings;
};

/// Runs the odometry over a session's scans, wheels, IMU and barometer. `mounting_ins_from_lidar`: where the LiDAR is
/// taken to sit; settings.fusion says where the INS and the IMU sit. Without it only the scans are used, and "vehicle"
/// is the LiDAR itself; with FusionUse::ScansAlone that is so whatever it is. A scan that cannot be read becomes a
/// finding, and its pose the prediction; one whose points' times make no sense is used as it is. Throws
/// Error(Unsupported) for a session without scans.
FusionRun run_fusion_odometry(const drive::Session& session,
                              const std::optional<RigidTransform>& mounting_ins_from_lidar,
                              const settings::Settings& settings, int threads, Progress& progress,
                              FusionUse use = FusionUse::Motion);

/// From above; height, pitch and roll, and distance of the features from the map against time.
std::vector<calibration::Plot> fusion_plots(const drive::Session& session, const FusionRun& run);

/// `t x y z qx qy qz qw`, t in seconds: what pose files and the native format's lidar_poses are read from.
std::string odometry_text(const std::vector<motion::StampedPose>& poses);

}  // namespace remount::methods
