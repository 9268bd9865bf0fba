// Rotations: exponential map, Jacobians and Euler angles. The one place that fixes the conventions.
//
// Conventions of the whole product
//   a_from_b       the rigid transform that takes coordinates in frame b to frame a
//   quaternions    written x, y, z, w in files and named so ("quaternion_xyzw"); Eigen::Quaterniond in code
//   yaw-pitch-roll R = Rz(yaw) Ry(pitch) Rx(roll), radians in code, degrees only where a name says _deg
//   perturbation   of a rotation: R <- Exp(phi) R (left, phi in the axes of the *target* frame a);
//                  of a rigid transform: translation t <- t + dt and rotation as above, stacked as
//                  [dt; phi] ("translation first"), so that the six numbers are metres and radians about the
//                  axes of the target frame. See docs/adr/0002-perturbation.md.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace remount {

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

/// Of unit length: the azimuth from x towards y, the elevation above the plane of the two.
Eigen::Vector3d direction_at(double azimuth_rad, double elevation_rad);

Eigen::Matrix3d skew(const Eigen::Vector3d& v);

/// Exp: rotation vector (rad) to rotation matrix; exact to first order at zero. (Rodrigues)
Eigen::Matrix3d so3_exp(const Eigen::Vector3d& phi_rad);

/// Log: rotation matrix to rotation vector with angle in [0, pi]; stable near 0 and near pi.
Eigen::Vector3d so3_log(const Eigen::Matrix3d& rotation);

/// Left Jacobian J: Exp(phi + d) = Exp(J d) Exp(phi) to first order. (Barfoot 2017, eq. 7.77)
Eigen::Matrix3d so3_left_jacobian(const Eigen::Vector3d& phi_rad);
Eigen::Matrix3d so3_left_jacobian_inverse(const Eigen::Vector3d& phi_rad);

struct YawPitchRoll {
  double yaw_rad = 0.0;
  double pitch_rad = 0.0;  ///< in [-pi/2, pi/2]
  double roll_rad = 0.0;
};

/// R = Rz(yaw) Ry(pitch) Rx(roll).
Eigen::Matrix3d rotation_from_yaw_pitch_roll(const YawPitchRoll& angles);

/// The inverse, with pitch in [-pi/2, pi/2]; at the poles roll is 0 and yaw takes the rest.
YawPitchRoll yaw_pitch_roll_from_rotation(const Eigen::Matrix3d& rotation);

/// d(yaw, pitch, roll) / d(phi) for R <- Exp(phi) R: rows yaw, pitch, roll; columns x, y, z of the target frame.
/// Not finite within 1e-9 of pitch = +-pi/2.
Eigen::Matrix3d yaw_pitch_roll_jacobian(const YawPitchRoll& angles);

/// The nearest rotation to a nearly orthonormal matrix (polar decomposition by SVD).
Eigen::Matrix3d nearest_rotation(const Eigen::Matrix3d& matrix);

/// Angle to a common range: (-pi, pi].
double wrap_angle_rad(double angle_rad);

inline constexpr double kPi = 3.14159265358979323846;
inline constexpr double degrees_to_radians(double angle_deg) { return angle_deg * kPi / 180.0; }
inline constexpr double radians_to_degrees(double angle_rad) { return angle_rad * 180.0 / kPi; }

}  // namespace remount
