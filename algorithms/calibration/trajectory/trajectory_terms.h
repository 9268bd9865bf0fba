// The residuals of trajectory alignment with their derivatives.
#pragma once

#include <array>
#include <vector>

#include "algorithms/calibration/trajectory/trajectory_problem.h"

namespace remount::calibration {

/// InsTilt: roll and pitch that are assumed, whose error is stated and not estimated; InsAttitude then is the heading.
enum class TermKind { InsPosition, InsAttitude, Antenna, StepTranslation, StepRotation, InsTilt };
inline constexpr std::size_t kTermKinds = 6;

/// Three residuals in units of their sigma. A pose T = enu_from_lidar is moved as T <- T [Exp(omega), nu], with
/// [nu; omega] in LiDAR axes.
struct TrajectoryTerm {
  TermKind kind = TermKind::InsPosition;
  std::size_t epoch = 0;  ///< of a step: the later one
  Eigen::Vector3d residual = Eigen::Vector3d::Zero();
  Eigen::Vector3d used = Eigen::Vector3d::Ones();  ///< 0 where a component says nothing
  Eigen::Matrix<double, 3, 6> by_pose = Eigen::Matrix<double, 3, 6>::Zero();
  Eigen::Matrix<double, 3, 6> by_before = Eigen::Matrix<double, 3, 6>::Zero();  ///< the pose of the epoch before
  Eigen::Matrix<double, 3, kBorderSize> by_border = Eigen::Matrix<double, 3, kBorderSize>::Zero();

  bool is_step() const { return kind == TermKind::StepTranslation || kind == TermKind::StepRotation; }
};

/// All terms of one session at `state`, in the order of its epochs.
///   INS:     p(T X^-1) - p_ins and Log(R_ins' R(T X^-1)), both delayed by the clock offset
///   antenna: T a - p_gnss
///   step:    Q^-1 T_i^-1 T_i+1 with Q the odometry's step, where T_i^-1 T_i+1 counts 1 + scale times as far
/// docs/maths/trajectory.md (T1) to (T5)
std::vector<TrajectoryTerm> trajectory_terms(const TrajectorySession& session, std::size_t index,
                                             const TrajectoryState& state);

/// Moves a pose of the LiDAR by [nu; omega] in its own axes.
inline RigidTransform moved_in_lidar(const RigidTransform& enu_from_lidar, const Vector6d& step) {
  return make_rigid(enu_from_lidar.linear() * so3_exp(step.tail<3>()),
                    enu_from_lidar.translation() + enu_from_lidar.linear() * step.head<3>());
}

}  // namespace remount::calibration
