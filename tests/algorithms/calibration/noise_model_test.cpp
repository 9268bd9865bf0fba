#include "algorithms/calibration/noise_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "algorithms/calibration/linear_solutions.h"
#include "algorithms/core/symmetric_eigen.h"
#include "tests/algorithms/support/random_motion.h"

namespace remount::calibration {
namespace {

Matrix6d floor_covariance(const NoiseModel& noise) {
  Vector6d variances;
  variances << Eigen::Vector3d::Constant(noise.registration_floor_m * noise.registration_floor_m),
      Eigen::Vector3d::Constant(noise.registration_floor_rad * noise.registration_floor_rad);
  return variances.asDiagonal();
}

// Of a scan: metres and radians with sigmas of millimetres and tenths of milliradians, and correlated.
Matrix6d random_information(std::mt19937_64& random, int rank) {
  Vector6d scale;
  scale << Eigen::Vector3d::Constant(1.0 / 2e-3), Eigen::Vector3d::Constant(1.0 / 1e-4);
  Matrix6d information = Matrix6d::Zero();
  for (int i = 0; i < rank; ++i) {
    const Vector6d row = scale.cwiseProduct(testing::random_step(random, 1.0, 1.0));
    information += row * row.transpose();
  }
  return information;
}

TEST(noise_model, registration_information_is_the_inverse_of_the_sum_of_both_covariances) {
  std::mt19937_64 random(1);
  const NoiseModel noise;
  for (int i = 0; i < 30; ++i) {
    const Matrix6d information = random_information(random, 12);
    const Matrix6d covariance =
        noise.registration_scale * noise.registration_scale * inverse_by_lu(information) + floor_covariance(noise);
    const Matrix6d product = noise.registration_information(information) * covariance;
    EXPECT_LT((product - Matrix6d::Identity()).cwiseAbs().maxCoeff(), 1e-6);
  }
}

TEST(noise_model, a_direction_without_information_has_none_and_the_others_keep_theirs) {
  std::mt19937_64 random(2);
  const NoiseModel noise;
  for (int rank = 0; rank < 6; ++rank) {
    const Matrix6d information = random_information(random, rank);
    const Matrix6d result = noise.registration_information(information);
    ASSERT_TRUE(result.allFinite());
    EXPECT_LT((result - result.transpose()).norm(), 1e-12 * (1.0 + result.norm()));
    // In units of the floor, so that metres and radians compare.
    const Matrix6d root = floor_covariance(noise).cwiseSqrt();
    const auto eigen = symmetric_eigen(Matrix6d(root * result * root));
    EXPECT_GT(eigen.eigenvalues()[0], -1e-12) << "rank " << rank;
    EXPECT_LT(eigen.eigenvalues()[5], 1.0) << "never better than the floor";
    for (int i = 0; i < 6 - rank; ++i) EXPECT_NEAR(eigen.eigenvalues()[i], 0.0, 1e-9) << "rank " << rank;
    EXPECT_TRUE(rank == 0 || eigen.eigenvalues()[std::min(5, 6 - rank)] > 1e-6) << "rank " << rank;
  }
}

TEST(noise_model, drift_grows_with_the_root_of_time) {
  NoiseModel noise;
  EXPECT_FALSE(noise.drifts());
  noise.ins_position_drift = 0.02;
  EXPECT_TRUE(noise.drifts());
  EXPECT_NEAR(std::sqrt(noise.drift_covariance(4.0)(0, 0)), 0.04, 1e-15);
  EXPECT_EQ(noise.drift_covariance(4.0)(5, 5), 0.0);
  EXPECT_NEAR(std::sqrt(noise.ins_covariance()(0, 0)), noise.ins_position_sigma_m, 1e-15);
  EXPECT_NEAR(std::sqrt(noise.ins_covariance()(5, 5)), noise.ins_attitude_sigma_rad, 1e-15);
}

}  // namespace
}  // namespace remount::calibration
