#include "algorithms/geometry/rotation.h"

#include <Eigen/LU>
#include <cmath>

#include "algorithms/core/decompositions.h"

namespace remount {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d direction_at(double azimuth_rad, double elevation_rad) {
  const double level = std::cos(elevation_rad);
  return {level * std::cos(azimuth_rad), level * std::sin(azimuth_rad), std::sin(elevation_rad)};
}

Matrix3d skew(const Vector3d& v) {
  Matrix3d m;
  m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return m;
}

Matrix3d so3_exp(const Vector3d& phi_rad) {
  const double theta2 = phi_rad.squaredNorm();
  const double theta = std::sqrt(theta2);
  // Series below 1e-4 rad: the next terms are beneath double precision there.
  const bool small = theta < 1e-4;
  const double a = small ? 1.0 - theta2 / 6.0 : std::sin(theta) / theta;
  const double b = small ? 0.5 - theta2 / 24.0 : (1.0 - std::cos(theta)) / theta2;
  const Matrix3d k = skew(phi_rad);
  return Matrix3d::Identity() + a * k + b * k * k;
}

Vector3d so3_log(const Matrix3d& rotation) {
  // Through the quaternion: atan2 keeps full precision near 0 and near pi, where the trace does not.
  Eigen::Quaterniond q(rotation);
  if (q.w() < 0.0) q.coeffs() = -q.coeffs();
  const double sine = q.vec().norm();
  if (sine < 1e-9) return 2.0 * q.vec() / q.w();
  return 2.0 * std::atan2(sine, q.w()) / sine * q.vec();
}

Matrix3d so3_left_jacobian(const Vector3d& phi_rad) {
  const double theta2 = phi_rad.squaredNorm();
  const double theta = std::sqrt(theta2);
  const bool small = theta < 1e-3;
  const double b = small ? 0.5 - theta2 / 24.0 : (1.0 - std::cos(theta)) / theta2;
  const double c = small ? 1.0 / 6.0 - theta2 / 120.0 : (theta - std::sin(theta)) / (theta2 * theta);
  const Matrix3d k = skew(phi_rad);
  return Matrix3d::Identity() + b * k + c * k * k;
}

Matrix3d so3_left_jacobian_inverse(const Vector3d& phi_rad) {
  const double theta2 = phi_rad.squaredNorm();
  const double theta = std::sqrt(theta2);
  const double c = theta < 1e-3 ? 1.0 / 12.0 + theta2 / 720.0
                                : 1.0 / theta2 - (1.0 + std::cos(theta)) / (2.0 * theta * std::sin(theta));
  const Matrix3d k = skew(phi_rad);
  return Matrix3d::Identity() - 0.5 * k + c * k * k;
}

Matrix3d rotation_from_yaw_pitch_roll(const YawPitchRoll& angles) {
  return (Eigen::AngleAxisd(angles.yaw_rad, Vector3d::UnitZ()) *
          Eigen::AngleAxisd(angles.pitch_rad, Vector3d::UnitY()) *
          Eigen::AngleAxisd(angles.roll_rad, Vector3d::UnitX()))
      .toRotationMatrix();
}

YawPitchRoll yaw_pitch_roll_from_rotation(const Matrix3d& rotation) {
  YawPitchRoll angles;
  const double cosine = std::hypot(rotation(0, 0), rotation(1, 0));
  angles.pitch_rad = std::atan2(-rotation(2, 0), cosine);
  if (cosine < 1e-9) {
    angles.yaw_rad = std::atan2(-rotation(0, 1), rotation(1, 1));
    return angles;
  }
  angles.yaw_rad = std::atan2(rotation(1, 0), rotation(0, 0));
  angles.roll_rad = std::atan2(rotation(2, 1), rotation(2, 2));
  return angles;
}

Matrix3d yaw_pitch_roll_jacobian(const YawPitchRoll& angles) {
  // phi = E (dyaw, dpitch, droll): the axes about which each angle turns, in the target frame.
  const double cy = std::cos(angles.yaw_rad), sy = std::sin(angles.yaw_rad);
  const double cp = std::cos(angles.pitch_rad), sp = std::sin(angles.pitch_rad);
  Matrix3d axes;
  axes << 0.0, -sy, cy * cp, 0.0, cy, sy * cp, 1.0, 0.0, -sp;
  return axes.inverse();
}

Matrix3d nearest_rotation(const Matrix3d& matrix) {
  const Eigen::JacobiSVD<Matrix3d> svd = singular_values(matrix);
  Matrix3d u = svd.matrixU();
  const Matrix3d& v = svd.matrixV();
  if ((u * v.transpose()).determinant() < 0.0) u.col(2) = -u.col(2);
  return u * v.transpose();
}

double wrap_angle_rad(double angle_rad) {
  const double wrapped = std::remainder(angle_rad, 2.0 * kPi);
  return wrapped <= -kPi ? wrapped + 2.0 * kPi : wrapped;
}

}  // namespace remount
