#include "algorithms/calibration/noise_model.h"

#include <Eigen/Cholesky>

#include "algorithms/calibration/linear_solutions.h"

namespace remount::calibration {

Matrix6d NoiseModel::ins_covariance() const {
  Vector6d variances;
  variances << Eigen::Vector3d::Constant(ins_position_sigma_m * ins_position_sigma_m),
      Eigen::Vector3d::Constant(ins_attitude_sigma_rad * ins_attitude_sigma_rad);
  return variances.asDiagonal();
}

NoiseModel NoiseModel::times(double factor) const {
  NoiseModel noise = *this;
  noise.ins_position_sigma_m *= factor;
  noise.ins_attitude_sigma_rad *= factor;
  noise.registration_scale *= factor;
  noise.registration_floor_m *= factor;
  noise.registration_floor_rad *= factor;
  noise.ins_position_drift *= factor;
  noise.ins_attitude_drift *= factor;
  return noise;
}

Matrix6d NoiseModel::drift_covariance(double gap_s) const {
  Vector6d variances;
  variances << Eigen::Vector3d::Constant(ins_position_drift * ins_position_drift * gap_s),
      Eigen::Vector3d::Constant(ins_attitude_drift * ins_attitude_drift * gap_s);
  return variances.asDiagonal();
}

Matrix6d NoiseModel::node_covariance(const Matrix6d& scan_covariance) const {
  return ins_covariance() + kScanShare * registration_scale * registration_scale * scan_covariance;
}

Matrix6d NoiseModel::registration_information(const Matrix6d& information, double share) const {
  // (s^2 L^-1 + F)^-1 = F^-1 - F^-1 (F^-1 + L / s^2)^-1 F^-1 needs no inverse of L. docs/maths/covariance.md (C3)
  Vector6d floor_information;
  floor_information << Eigen::Vector3d::Constant(1.0 / (registration_floor_m * registration_floor_m)),
      Eigen::Vector3d::Constant(1.0 / (registration_floor_rad * registration_floor_rad));
  Matrix6d sum = information / (share * registration_scale * registration_scale);
  sum.diagonal() += floor_information;
  // Symmetric scaling keeps the difference of large numbers accurate.
  const Vector6d root = floor_information.cwiseSqrt();
  const Matrix6d scaled = root.cwiseInverse().asDiagonal() * sum * root.cwiseInverse().asDiagonal();
  Matrix6d inner = Matrix6d::Identity() - symmetric_inverse(scaled);
  inner = 0.5 * (inner + inner.transpose().eval());
  return root.asDiagonal() * inner * root.asDiagonal();
}

}  // namespace remount::calibration
