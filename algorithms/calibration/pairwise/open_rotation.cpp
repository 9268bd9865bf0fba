#include "algorithms/calibration/pairwise/open_rotation.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "algorithms/calibration/linear_solutions.h"
#include "algorithms/calibration/observability.h"
#include "algorithms/core/symmetric_eigen.h"
#include "algorithms/geometry/rotation.h"

namespace remount::calibration {
namespace {

constexpr double kGround_rad = 0.1;  ///< to which a road is level, and an INS on its vehicle

Eigen::Vector3d yaw_pitch_roll_of(const Eigen::Matrix3d& rotation) {
  const YawPitchRoll angles = yaw_pitch_roll_from_rotation(rotation);
  return {angles.yaw_rad, angles.pitch_rad, angles.roll_rad};
}

}  // namespace

Matrix6d level_information(const std::optional<Eigen::Vector3d>& up_in_lidar, const RigidTransform& ins_from_lidar) {
  Matrix6d information = Matrix6d::Zero();
  if (!up_in_lidar) return information;
  const Eigen::Vector3d up_in_ins = ins_from_lidar.linear() * *up_in_lidar;
  const double sigma_rad = std::max(kGround_rad, std::atan2(up_in_ins.head<2>().norm(), up_in_ins.z()));
  information.diagonal().segment<2>(3).array() += 1.0 / (sigma_rad * sigma_rad);
  return information;
}

Eigen::Vector3d turned_by_open_rotation(const RigidTransform& ins_from_lidar, const Matrix6d& information) {
  constexpr double kOpen_rad = 1.2 * kGround_rad;  // the ground alone leaves less; there, first order holds
  constexpr int kSteps = 36;
  Matrix6d bounded = information;
  // On an arc X turns about the middle of the arc, as far as a LiDAR may be from the INS: a little, to first order.
  bounded.topLeftCorner<3, 3>() += weak_prior(false).topLeftCorner<3, 3>();
  bounded.diagonal().tail<3>().array() += 1.0 / (kPi * kPi);
  const Matrix6d covariance = symmetric_inverse(bounded);
  const auto eigen = symmetric_eigen(Eigen::Matrix3d(covariance.bottomRightCorner<3, 3>()));
  const Eigen::Vector3d here = yaw_pitch_roll_of(ins_from_lidar.linear());
  Eigen::Vector3d off = Eigen::Vector3d::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    const double sigma_rad = std::sqrt(std::max(0.0, eigen.eigenvalues()[axis]));
    if (sigma_rad < kOpen_rad) continue;
    const double reach_rad = std::min(kPi, 2.0 * sigma_rad);
    for (int k = -kSteps; k <= kSteps; ++k) {
      const Eigen::Matrix3d turn = so3_exp(reach_rad * k / kSteps * eigen.eigenvectors().col(axis));
      const Eigen::Vector3d there = yaw_pitch_roll_of(turn * ins_from_lidar.linear());
      for (int i = 0; i < 3; ++i) off[i] = std::max(off[i], std::abs(std::remainder(there[i] - here[i], 2.0 * kPi)));
    }
  }
  return off;
}

}  // namespace remount::calibration
