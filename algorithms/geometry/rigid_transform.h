// Rigid transforms between named frames.
#pragma once

#include "algorithms/geometry/rotation.h"

namespace remount {

/// Named a_from_b wherever it appears. Conventions: rotation.h.
using RigidTransform = Eigen::Isometry3d;

inline RigidTransform make_rigid(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& translation_m) {
  RigidTransform a_from_b = RigidTransform::Identity();
  a_from_b.linear() = rotation;
  a_from_b.translation() = translation_m;
  return a_from_b;
}

/// Translation and yaw-pitch-roll of a transform, as the user sets and reads them.
struct SixParameters {
  double x_m = 0.0, y_m = 0.0, z_m = 0.0;
  double yaw_rad = 0.0, pitch_rad = 0.0, roll_rad = 0.0;
};

inline RigidTransform rigid_from_six(const SixParameters& six) {
  return make_rigid(rotation_from_yaw_pitch_roll({six.yaw_rad, six.pitch_rad, six.roll_rad}),
                    {six.x_m, six.y_m, six.z_m});
}

inline SixParameters six_from_rigid(const RigidTransform& a_from_b) {
  const YawPitchRoll angles = yaw_pitch_roll_from_rotation(a_from_b.linear());
  const Eigen::Vector3d t = a_from_b.translation();
  return {t.x(), t.y(), t.z(), angles.yaw_rad, angles.pitch_rad, angles.roll_rad};
}

/// t <- t + delta[0:3], R <- Exp(delta[3:6]) R, both in the axes of frame a.
inline RigidTransform perturb(const RigidTransform& a_from_b, const Vector6d& delta) {
  return make_rigid(so3_exp(delta.tail<3>()) * a_from_b.linear(), a_from_b.translation() + delta.head<3>());
}

/// The delta with perturb(from, delta) == to.
inline Vector6d difference(const RigidTransform& from, const RigidTransform& to) {
  Vector6d delta;
  delta << to.translation() - from.translation(), so3_log(to.linear() * from.linear().transpose());
  return delta;
}

/// Angle between the rotations of two transforms, rad.
inline double rotation_angle_between_rad(const RigidTransform& first, const RigidTransform& second) {
  return so3_log(first.linear() * second.linear().transpose()).norm();
}

}  // namespace remount
