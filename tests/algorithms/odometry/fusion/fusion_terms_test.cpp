#include "algorithms/odometry/fusion/fusion_terms.h"

#include <gtest/gtest.h>

#include <random>

#include "algorithms/odometry/fusion/fusion_step_parts.h"

namespace remount::odometry {
namespace {

StepAnchor some_anchor() {
  return {make_rigid(so3_exp({0.1, -0.05, 0.8}), {120.0, -40.0, 3.0}),
          make_rigid(so3_exp({0.12, -0.03, 0.9}), {121.2, -39.1, 3.1})};
}

FusionVector some_vector() {
  FusionVector x;
  x << 0.2, -0.1, 0.3, 0.02, -0.03, 0.04, -0.15, 0.25, 0.1, 0.05, -0.02, 0.07, 0.001, -0.002, 0.003, 0.01, 0.02, -0.03,
      0.01, 0.001, -0.002, 0.0015, 0.01, -0.02;
  return x;
}

std::vector<FeatureMatch> some_matches() {
  std::vector<FeatureMatch> matches;
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 20; ++i) {
    FeatureMatch match;
    match.point_in_vehicle = 20.0 * Eigen::Vector3d(normal(random), normal(random), normal(random));
    match.centre = some_anchor().predicted * match.point_in_vehicle + Eigen::Vector3d(0.1, 0.2, -0.1);
    match.direction = Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
    matches.push_back(match);
  }
  return matches;
}

void expect_true_jacobian(const FusionTerm& term) {
  constexpr double kStep = 1e-6;
  const FusionVector x = some_vector();
  Eigen::VectorXd residuals(term.rows()), more(term.rows()), less(term.rows());
  FusionJacobian jacobian(term.rows(), kFusionUnknowns);
  term.evaluate(x, residuals, &jacobian);
  for (int column = 0; column < kFusionUnknowns; ++column) {
    FusionVector above = x, below = x;
    above[column] += kStep;
    below[column] -= kStep;
    term.evaluate(above, more, nullptr);
    term.evaluate(below, less, nullptr);
    const Eigen::VectorXd slope = (more - less) / (2.0 * kStep);
    EXPECT_LT((slope - jacobian.col(column)).norm(), 1e-5 * (1.0 + slope.norm())) << "column " << column;
  }
}

TEST(fusion_terms, jacobians_equal_perturbation) {
  const StepAnchor anchor = some_anchor();
  Matrix6d heard = Matrix6d::Identity();
  const Vector6d lost = (Vector6d() << 0.6, 0.8, 0.0, 0.0, 0.0, 0.0).finished();
  heard -= lost * lost.transpose();
  const std::vector<double> weights(20, 25.0);
  expect_true_jacobian(FeatureTerm(FeatureTerm::Kind::Lines, anchor, some_matches(), weights, heard));
  expect_true_jacobian(FeatureTerm(FeatureTerm::Kind::Planes, anchor, some_matches(), weights, heard));
  expect_true_jacobian(TurnTerm(anchor, so3_exp({0.01, 0.02, 0.12}), 0.1, {0.01, 0.01, 0.002}, true));
  expect_true_jacobian(TravelTerm(anchor, {1.4, 0.1, 0.05}, {0.02, 0.003, 0.003}, true));
  expect_true_jacobian(LevelTerm(anchor, {0.05, -0.1, 0.01, 0.02}));
  expect_true_jacobian(HeightTerm(anchor, 3.4, 0.5));
}

TEST(fusion_terms, a_filtered_term_hears_only_what_it_is_let) {
  Matrix6d speaks = Matrix6d::Identity();
  speaks(1, 1) = 0.0;
  speaks(0, 1) = 0.5;
  const auto filtered = [&](const Matrix6d& filter) {
    return FilteredTerm(std::make_unique<TravelTerm>(some_anchor(), Eigen::Vector3d(1.4, 0.1, 0.05),
                                                     Eigen::Vector3d(0.02, 0.003, 0.003), true),
                        filter);
  };
  expect_true_jacobian(filtered(speaks));
  Eigen::VectorXd here(3), there(3);
  FusionVector x = some_vector();
  filtered(Matrix6d::Zero()).evaluate(x, here, nullptr);
  x.segment<6>(kMotion).setConstant(3.0);
  filtered(Matrix6d::Zero()).evaluate(x, there, nullptr);
  EXPECT_EQ(here, there);
}

TEST(fusion_terms, the_fused_pose_has_the_jacobian_that_it_states) {
  const StepAnchor anchor = some_anchor();
  const FusionVector x = some_vector();
  const Eigen::Matrix<double, 6, kFusionUnknowns> jacobian = fused_pose_jacobian(anchor, x);
  for (int column = 0; column < kFusionUnknowns; ++column) {
    FusionVector above = x, below = x;
    above[column] += 1e-6;
    below[column] -= 1e-6;
    const RigidTransform at = fused_pose(anchor, x);
    const Vector6d slope =
        (difference(at, fused_pose(anchor, above)) - difference(at, fused_pose(anchor, below))) / 2e-6;
    EXPECT_LT((slope - jacobian.col(column)).norm(), 1e-6) << column;
  }
}

TEST(fusion_terms, features_do_not_speak_along_what_they_do_not_tell) {
  Matrix6d heard = Matrix6d::Identity();
  heard(0, 0) = 0.0;
  const FeatureTerm term(FeatureTerm::Kind::Planes, some_anchor(), some_matches(), std::vector<double>(20, 1.0), heard);
  Eigen::VectorXd here(20), there(20);
  FusionVector x = FusionVector::Zero();
  term.evaluate(x, here, nullptr);
  x[kMotion] = 5.0;
  term.evaluate(x, there, nullptr);
  EXPECT_EQ(here, there);
}

// The sign convention of the accelerometer, for x forward, y left, z up.
TEST(level, a_vehicle_at_rest_reads_its_roll_and_pitch) {
  for (const YawPitchRoll angles :
       {YawPitchRoll{0.4, 0.1, 0.0}, YawPitchRoll{-2.0, 0.0, 0.2}, YawPitchRoll{1.0, -0.3, -0.25}}) {
    const Eigen::Vector3d force = rotation_from_yaw_pitch_roll(angles).transpose() * Eigen::Vector3d(0.0, 0.0, 9.81);
    const LevelMeasurement level = level_from_gravity(force);
    EXPECT_NEAR(level.pitch_rad, angles.pitch_rad, 1e-12);
    EXPECT_NEAR(level.roll_rad, angles.roll_rad, 1e-12);
  }
  // Nose up (pitch is then negative: the nose turns from x towards z) presses the seat's back forwards.
  EXPECT_LT(level_from_gravity({1.0, 0.0, 9.7}).pitch_rad, 0.0);
  // Left side up: roll is positive, and the floor pushes to the left.
  EXPECT_GT(level_from_gravity({0.0, 1.0, 9.7}).roll_rad, 0.0);
}

// Braking, a bend and an IMU far from the rear axle must not pass for a slope.
TEST(level, the_acceleration_of_the_vehicle_is_taken_off) {
  const RigidTransform vehicle_from_imu = make_rigid(so3_exp({0.02, -0.01, 0.5}), {2.0, 0.5, 1.0});
  const Eigen::Vector3d bias(0.0, 0.0, 0.002), rate(0.0, 0.0, 0.3);
  const double acceleration = -3.0, speed = 12.0, spin_up = 0.1;
  std::vector<motion::ImuSample> imu;
  std::vector<motion::WheelSample> wheels;
  for (int i = -30; i <= 30; ++i) {
    const double t = 0.01 * i, v = speed + acceleration * t;
    const Eigen::Vector3d turning = rate + Eigen::Vector3d(0.0, 0.0, spin_up * t), arm = vehicle_from_imu.translation();
    const Eigen::Vector3d force = Eigen::Vector3d(acceleration, turning.z() * v, 9.81) +
                                  Eigen::Vector3d(0.0, 0.0, spin_up).cross(arm) + turning.cross(turning.cross(arm));
    const std::int64_t stamp_ns = 1000000000 + 10000000 * i;
    imu.push_back({stamp_ns, vehicle_from_imu.linear().transpose() * (turning + bias),
                   vehicle_from_imu.linear().transpose() * force});
    wheels.push_back({stamp_ns, v - 0.8 * turning.z(), v + 0.8 * turning.z()});
  }
  const DeadReckoning reckoning(imu, wheels, vehicle_from_imu, 1.6);
  const auto gravity = gravity_in_vehicle(imu, reckoning, vehicle_from_imu, {bias, 1.0}, std::nullopt, 1000000000);
  ASSERT_TRUE(gravity);
  const LevelMeasurement level = level_from_gravity(gravity->up_mps2);
  // Quadratic in time: what a mean over half a second leaves.
  EXPECT_NEAR(level.roll_rad, 0.0, 1e-3);
  EXPECT_NEAR(level.pitch_rad, 0.0, 1e-3);
  EXPECT_GT(gravity->taken_off_mps2, 3.0);
  // Without that it is off by a quarter of the braking.
  EXPECT_GT(std::abs(level_from_gravity(vehicle_from_imu.linear() * imu[30].specific_force_mps2).pitch_rad), 0.2);
}

// Nothing tells the acceleration without wheels, nor the speed in a bend without wheels and odometry.
TEST(level, what_cannot_be_taken_off_is_owned_up_to) {
  std::vector<motion::ImuSample> imu;
  for (int i = -30; i <= 30; ++i) imu.push_back({1000000000 + 10000000 * i, {0.0, 0.0, 0.3}, {-3.0, 0.0, 9.81}});
  const DeadReckoning reckoning(imu, {}, RigidTransform::Identity(), 1.6);
  const auto level = [&](const std::optional<Vector6d>& velocity) {
    return level_of(*gravity_in_vehicle(imu, reckoning, RigidTransform::Identity(), {}, velocity, 1000000000),
                    RigidTransform::Identity(), {});
  };
  EXPECT_GT(std::abs(level(std::nullopt).pitch_rad), 0.25);
  EXPECT_GT(level(std::nullopt).pitch_sigma_rad, 0.25);
  EXPECT_GT(level(std::nullopt).roll_sigma_rad, 0.25);
  EXPECT_LT(level(Vector6d::Zero()).roll_sigma_rad, 0.05);
}

TEST(level, the_curvature_of_the_earth_is_taken_off) {
  // 9 km to the left of the start on a plain that is straight, not level: the road seems to climb.
  const RigidTransform odometry_from_vehicle =
      make_rigid(rotation_from_yaw_pitch_roll({kPi / 2, 0.0, 0.0}), {0.0, 9000.0, 0.0});
  EXPECT_NEAR(drop_of_level_m(odometry_from_vehicle.translation()), 6.36, 0.01);
  const Eigen::Vector3d up_there = Eigen::Vector3d(0.0, 9000.0 / 6371000.0, 1.0).normalized();
  const Eigen::Vector3d measured = odometry_from_vehicle.linear().transpose() * up_there * 9.81;
  EXPECT_LT(level_from_gravity(measured).pitch_rad, -1e-3);
  EXPECT_NEAR(level_from_gravity(up_at_start(measured, odometry_from_vehicle)).pitch_rad, 0.0, 1e-5);
}

}  // namespace
}  // namespace remount::odometry
