// Motion of the LiDAR from its scans alone: each scan is aligned with a map of the last keyframes.
// docs/maths/odometry.md
//
// Motion within a scan is compensated by the odometry's own motion, and for that the scan after it must be known too: a
// velocity of the past alone lags behind, by so much as the vehicle accelerates. The lag tears a scan in the same way
// whenever a turn begins or ends, which no average removes: it looked like a LiDAR some centimetres beside its place,
// on the one side or on the other, as the sensor turns.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "algorithms/messages/message.h"
#include "algorithms/odometry/lidar/lidar_odometry_options.h"
#include "algorithms/odometry/lidar/local_map.h"
#include "algorithms/odometry/lidar/sweep_motion.h"
#include "algorithms/registration/registration.h"

namespace remount::odometry {

/// The pose of one scan.
struct OdometryPose {
  std::int64_t stamp_ns = 0;
  RigidTransform odometry_from_lidar = RigidTransform::Identity();
  /// Of the pose within the map, [m; rad] in LiDAR axes; large along what the surfaces do not determine.
  Matrix6d covariance = Matrix6d::Zero();
  bool aligned = true;   ///< false: the pose is a prediction; `problem` says why
  Message problem;       ///< empty, or why there is no alignment
  Message undetermined;  ///< directions that the surfaces leave to the prediction; empty: none
  double rmse_m = 0.0, overlap = 0.0;
  /// Counts the maps that were begun anew where the surroundings were lost. Poses of different maps differ by the error
  /// of the pose at which the later one began as well: the first that carries its number.
  int map = 0;
};

/// Incremental and deterministic. Not thread-safe.
class LidarOdometry {
 public:
  /// @param registration algorithm, ranges and limits; the voxel is that of `options`
  LidarOdometry(LidarOdometryOptions options, registration::RegistrationOptions registration);
  LidarOdometry(const LidarOdometry&) = delete;
  LidarOdometry& operator=(const LidarOdometry&) = delete;
  ~LidarOdometry();

  /// Takes the next scan and returns the poses that are final now, in the order of their scans: a scan with times waits
  /// for the one after it, one without is final at once. The pose of the first is identity. A scan is predicted by
  /// constant velocity, or by `predicted_step` (before_from_here) where the caller knows the motion. `times_s`, from
  /// the stamp, of each point: motion within the scan is compensated by the odometry's own motion; empty: the scan is
  /// used as it is. Stamps must ascend: throws Error(Contract). A scan that cannot be aligned keeps its prediction and
  /// says so. Where `progress` is cancelled the pose may be the prediction too.
  std::vector<OdometryPose> push(const cloud::PointCloud& cloud_in_lidar, std::span<const float> times_s,
                                 std::int64_t stamp_ns, const Progress& progress,
                                 const std::optional<RigidTransform>& predicted_step = std::nullopt);

  /// The pose of the scan that still waits, where one does: none comes after it.
  std::vector<OdometryPose> finish(const Progress& progress);

 private:
  struct Scan;
  struct Attempt;
  struct Waiting;
  std::unique_ptr<registration::PreparedCloud> prepare(const Scan& scan, const SweepMotion& motion,
                                                       const Progress& progress) const;
  Attempt attempt(const Scan& scan, const RigidTransform& start, const SweepMotion& motion,
                  const registration::RegistrationOptions& registration, const Progress& progress) const;
  void start_map(const Scan& scan, const RigidTransform& odometry_from_lidar, const SweepMotion& motion,
                 const Progress& progress);
  void mend_first_map(const Scan& second, OdometryPose pose, Attempt& found, const Progress& progress);
  void compensate_again(const Scan& scan, OdometryPose pose, const OdometryPose& before, Attempt& found,
                        const Progress& progress) const;
  bool joins_map(const RigidTransform& odometry_from_lidar) const;
  SweepMotion motion_around(const OdometryPose& pose, const OdometryPose* after) const;
  OdometryPose accept(const Scan& scan, const Attempt& best, const SweepMotion& motion, OdometryPose pose,
                      const Progress& progress);
  OdometryPose settle(const OdometryPose* after, const Progress& progress);
  OdometryPose keep(OdometryPose pose);
  std::vector<OdometryPose> start(const Scan& scan, std::int64_t stamp_ns, const Progress& progress);

  LidarOdometryOptions options_;
  registration::RegistrationOptions registration_;
  LocalMap map_;
  std::unique_ptr<Waiting> waiting_;
  std::vector<OdometryPose> final_;       ///< the last two
  Vector6d velocity_ = Vector6d::Zero();  ///< at the newest scan, LiDAR axes, [m/s; rad/s]
  int failures_ = 0, maps_ = 0;
};

}  // namespace remount::odometry
