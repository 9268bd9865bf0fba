#include "algorithms/calibration/rig/relative_mounting.h"

#include <algorithm>
#include <cmath>

#include "algorithms/calibration/observability.h"

namespace remount::calibration {

RigidTransform relative_mounting(const RigidTransform& ins_from_lidar_a, const RigidTransform& ins_from_lidar_b) {
  return ins_from_lidar_a.inverse() * ins_from_lidar_b;
}

Eigen::Matrix<double, 6, 12> relative_jacobian(const RigidTransform& ins_from_lidar_a,
                                               const RigidTransform& ins_from_lidar_b) {
  const Eigen::Matrix3d a_from_ins = ins_from_lidar_a.linear().transpose();
  const Eigen::Vector3d apart_m = ins_from_lidar_b.translation() - ins_from_lidar_a.translation();
  Eigen::Matrix<double, 6, 12> jacobian = Eigen::Matrix<double, 6, 12>::Zero();
  jacobian.block<3, 3>(0, 0) = jacobian.block<3, 3>(3, 3) = -a_from_ins;
  jacobian.block<3, 3>(0, 3) = a_from_ins * skew(apart_m);
  jacobian.block<3, 3>(0, 6) = jacobian.block<3, 3>(3, 9) = a_from_ins;
  return jacobian;
}

RelativeMounting describe_relative(const RigidTransform& ins_from_lidar_a, const RigidTransform& ins_from_lidar_b,
                                   const Eigen::Matrix<double, 12, 12>& covariance, const Vector6d& limits) {
  RelativeMounting relative;
  relative.lidar_a_from_lidar_b = relative_mounting(ins_from_lidar_a, ins_from_lidar_b);
  const Eigen::Matrix<double, 6, 12> jacobian = relative_jacobian(ins_from_lidar_a, ins_from_lidar_b);
  relative.covariance =
      parameter_covariance(relative.lidar_a_from_lidar_b, jacobian * covariance * jacobian.transpose());
  for (const Parameter parameter : kParameters) {
    const int row = row_of(parameter);
    if (std::sqrt(std::max(0.0, relative.covariance(row, row))) < limits[row]) relative.observed.insert(parameter);
  }
  Eigen::Matrix<double, 12, 1> height = Eigen::Matrix<double, 12, 1>::Zero();
  height[2] = -1.0, height[8] = 1.0;
  relative.height_m = ins_from_lidar_b.translation().z() - ins_from_lidar_a.translation().z();
  relative.height_sigma_m = std::sqrt(std::max(0.0, height.dot(covariance * height)));
  return relative;
}

}  // namespace remount::calibration
