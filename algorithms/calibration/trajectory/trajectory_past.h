// What epochs of a long drive have said that are no longer solved for.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "algorithms/geometry/rigid_transform.h"

namespace remount::calibration {

/// What is common to many poses: X under `perturb` (0-5), the antenna in the LiDAR frame (6-8), and of each session
/// the scale of its odometry (9), its clock offset (10), how much older positions of its INS are than attitudes (11),
/// and where its odometry drifts with the way, in axes of the LiDAR (12-14).
inline constexpr int kSharedSize = 9, kOwnSize = 6, kBorderSize = kSharedSize + kOwnSize;
inline constexpr int kAntennaAt = 6, kScaleAt = 9, kClockAt = 10, kLagAt = 11, kDriftAt = 12;
using SharedMatrix = Eigen::Matrix<double, kSharedSize, kSharedSize>;
using SharedVector = Eigen::Matrix<double, kSharedSize, 1>;
using BorderMatrix = Eigen::Matrix<double, kBorderSize, kBorderSize>;
using OwnVector = Eigen::Matrix<double, kOwnSize, 1>;
using BorderVector = Eigen::Matrix<double, kBorderSize, 1>;

/// A value of all of these.
struct BorderPoint {
  RigidTransform ins_from_lidar = RigidTransform::Identity();
  Eigen::Vector3d antenna_in_lidar = Eigen::Vector3d::Zero();
  OwnVector own = OwnVector::Zero();
};

inline BorderVector border_difference(const BorderPoint& from, const BorderPoint& to) {
  BorderVector out;
  out << difference(from.ins_from_lidar, to.ins_from_lidar), to.antenna_in_lidar - from.antenna_in_lidar,
      to.own - from.own;
  return out;
}

/// The first epochs of a session, with their poses eliminated: linear about where the solution was then, with the
/// weights and the noise of that time.
struct TrajectoryPast {
  double duration_s = 0.0;  ///< 0: there is none
  BorderPoint centre;
  BorderMatrix information = BorderMatrix::Zero();
  BorderVector pull = BorderVector::Zero();  ///< moving by d from the centre costs 2 pull . d + d . information d
  RigidTransform linearised_ins_from_lidar = RigidTransform::Identity();  ///< of the oldest part
  SharedMatrix scatter = SharedMatrix::Zero();                            ///< sum of squared pulls of blocks of time
  double blocks = 0.0;                                                    ///< how many these are
  SharedMatrix spurious = SharedMatrix::Zero();                           ///< see spurious_trajectory_information
  bool has_ins = false, has_antenna = false;
  std::vector<RigidTransform> odometry_from_lidar;  ///< thinned: how the vehicle turned

  bool empty() const { return duration_s == 0.0; }
  double cost(const BorderPoint& at) const {
    const BorderVector away = border_difference(centre, at);
    return away.dot(information * away) + 2.0 * pull.dot(away);
  }
  /// Half the slope of that cost.
  BorderVector pull_at(const BorderPoint& at) const { return pull + information * border_difference(centre, at); }
};

}  // namespace remount::calibration
