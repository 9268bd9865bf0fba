// Motion of the LiDAR from its scans alone: each scan is aligned with a map of the last keyframes.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "algorithms/odometry/lidar_odometry_options.h"
#include "algorithms/odometry/local_map.h"
#include "algorithms/registration/registration.h"

namespace remount {

/// The pose of one scan.
struct OdometryPose {
  std::int64_t stamp_ns = 0;
  RigidTransform odometry_from_lidar = RigidTransform::Identity();
  /// Of the pose within the map, [m; rad] in LiDAR axes; large along what the surfaces do not determine.
  Matrix6d covariance = Matrix6d::Zero();
  bool aligned = true;       ///< false: the pose is a prediction; `problem` says why
  std::string problem;       ///< empty, or why there is no alignment
  std::string undetermined;  ///< directions that the surfaces leave to the prediction, in words; empty: none
  double rmse_m = 0.0, overlap = 0.0;
  /// Counts the maps that were begun anew where the surroundings were lost. Poses of different maps differ by the error
  /// of the pose at which the later one began as well: the first that carries its number.
  int map = 0;
};

/// Incremental and deterministic. Not thread-safe.
class LidarOdometry {
 public:
  /// @param registration algorithm, ranges and limits; the voxel is that of `options`
  LidarOdometry(LidarOdometryOptions options, RegistrationOptions registration);

  /// The pose of the next scan; the first one's is identity. Predicted by constant velocity, or by `predicted_step`
  /// (before_from_here) where the caller knows the motion. `times_s`, from the stamp, of each point: motion within the
  /// scan is compensated by the odometry's own motion; empty: the scan is used as it is. Stamps must ascend: throws
  /// Error(Contract). A scan that cannot be aligned keeps its prediction and says so. Where `progress` is cancelled the
  /// pose may be the prediction too.
  OdometryPose push(const PointCloud& cloud_in_lidar, std::span<const float> times_s, std::int64_t stamp_ns,
                    const Progress& progress, const std::optional<RigidTransform>& predicted_step = std::nullopt);

 private:
  struct Scan;
  struct Attempt;
  PreparedCloud prepared(const Scan& scan, const Vector6d& velocity, const Progress& progress) const;
  Vector6d velocity_to(const RigidTransform& odometry_from_lidar, std::int64_t stamp_ns) const;
  Attempt attempt(const Scan& scan, const RigidTransform& start, const Vector6d& velocity,
                  const Progress& progress) const;
  void start(const Scan& scan, std::int64_t stamp_ns, const Progress& progress);
  Attempt best_attempt(const Scan& scan, const RigidTransform& predicted, std::int64_t stamp_ns,
                       const Progress& progress);
  OdometryPose accept(const Scan& scan, const Attempt& best, OdometryPose pose, const Progress& progress);
  void start_map(const Scan& scan, const Vector6d& velocity, const Progress& progress);
  bool joins_map(const RigidTransform& odometry_from_lidar) const;

  LidarOdometryOptions options_;
  RegistrationOptions registration_;
  LocalMap map_;
  OdometryPose last_;
  Vector6d velocity_ = Vector6d::Zero();  ///< LiDAR axes, [m/s; rad/s]
  int scans_ = 0, failures_ = 0;
  PointCloud first_cloud_;
  std::vector<float> first_times_s_;
};

}  // namespace remount
