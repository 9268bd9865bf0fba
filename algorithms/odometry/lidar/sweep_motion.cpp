#include "algorithms/odometry/lidar/sweep_motion.h"

namespace remount::odometry {
namespace {

Vector6d twist_of(const RigidTransform& motion) {
  const Eigen::Vector3d turn = so3_log(motion.linear());
  Vector6d twist;
  twist << so3_left_jacobian_inverse(turn) * motion.translation(), turn;
  return twist;
}

}  // namespace

RigidTransform SweepMotion::at(double time_from_stamp_s) const {
  const Vector6d twist = time_from_stamp_s * (velocity + time_from_stamp_s * half_acceleration);
  const Eigen::Vector3d turn = twist.tail<3>();
  return make_rigid(so3_exp(turn), so3_left_jacobian(turn) * twist.head<3>());
}

// docs/maths/sweeps.md (W3)
SweepMotion SweepMotion::through(std::span<const TimedMotion> others) {
  SweepMotion motion;
  if (others.empty()) return motion;
  const double first_s = others[0].time_from_stamp_s;
  const Vector6d first = twist_of(others[0].lidar_at_stamp_from_lidar_at);
  motion.velocity = first / first_s;
  if (others.size() < 2) return motion;
  const double second_s = others[1].time_from_stamp_s;
  const Vector6d second_velocity = twist_of(others[1].lidar_at_stamp_from_lidar_at) / second_s;
  motion.half_acceleration = (second_velocity - motion.velocity) / (second_s - first_s);
  motion.velocity -= first_s * motion.half_acceleration;
  return motion;
}

}  // namespace remount::odometry
