#include "algorithms/calibration/slew/slew_axis.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/algorithms/support/random_motion.h"

namespace remount::calibration {
namespace {

const RigidTransform kMachineFromLidar = make_rigid(rotation_from_yaw_pitch_roll({0.3, 0.2, -0.1}), {1.1, -0.9, 0.0});
constexpr double kWay_m = 0.003, kTurn_rad = 5e-4;

struct Turning {
  double arc_rad = 2.0 * kPi;
  int poses = 120;
  double linked = 0.0;  ///< of the errors of neighbours
  RigidTransform common = RigidTransform::Identity();
};

std::vector<RigidTransform> turn(const Turning& how, int seed, double noise = 1.0) {
  std::mt19937_64 random(static_cast<std::uint64_t>(seed));
  const auto draw = [&] { return Vector6d(noise * testing::random_step(random, kWay_m, kTurn_rad)); };
  std::vector<RigidTransform> poses;
  Vector6d error = draw();
  for (int i = 0; i < how.poses; ++i) {
    const double angle = how.arc_rad * i / how.poses;
    const RigidTransform turned = make_rigid(so3_exp({0.0, 0.0, angle}), Eigen::Vector3d::Zero());
    // In the axes of the LiDAR: what lasts in those of the first scan goes around with it, and does less.
    const RigidTransform off = make_rigid(so3_exp(error.tail<3>()), error.head<3>());
    poses.push_back(how.common * kMachineFromLidar.inverse() * turned * kMachineFromLidar * off);
    error = how.linked * error + std::sqrt(1.0 - how.linked * how.linked) * draw();
  }
  return poses;
}

Eigen::Vector3d true_direction() { return kMachineFromLidar.linear().row(2).transpose(); }
Eigen::Vector3d true_centre_m() { return kMachineFromLidar.inverse().translation(); }

/// Two errors of the centre across the axis and two of the direction, squared, over what is stated.
std::array<double, 4> squares(const SlewAxis& axis) {
  const Eigen::Vector3d v = true_direction();
  const Eigen::Vector3d sense = axis.direction_in_lidar.dot(v) < 0.0 ? Eigen::Vector3d(-v) : v;
  const Eigen::Vector3d turned = sense.cross(axis.direction_in_lidar), moved = axis.centre_in_lidar_m - true_centre_m();
  std::array<double, 4> out{};
  for (int k = 0; k < 2; ++k) {
    const Eigen::Vector3d across = kMachineFromLidar.linear().row(k).transpose();
    const auto at = static_cast<std::size_t>(k);
    out[at] = std::pow(across.dot(moved), 2) / across.dot(axis.covariance.topLeftCorner<3, 3>() * across);
    out[at + 2] = std::pow(across.dot(turned), 2) / across.dot(axis.covariance.bottomRightCorner<3, 3>() * across);
  }
  return out;
}

std::array<double, 4> mean_squares(const Turning& how, int seeds) {
  std::array<double, 4> mean{};
  for (int seed = 0; seed < seeds; ++seed) {
    const SlewAxis axis = fit_slew_axis(turn(how, seed));
    EXPECT_TRUE(axis.found);
    const std::array<double, 4> one = squares(axis);
    for (std::size_t i = 0; i < 4; ++i) mean[i] += one[i] / seeds;
  }
  std::printf("  arc %.0f deg, linked %.1f: centre %.2f %.2f, direction %.2f %.2f\n", radians_to_degrees(how.arc_rad),
              how.linked, mean[0], mean[1], mean[2], mean[3]);
  return mean;
}

TEST(slew_axis, exact_poses_give_the_axis) {
  const SlewAxis axis = fit_slew_axis(turn({}, 1, 0.0));
  ASSERT_TRUE(axis.found);
  EXPECT_LT(axis.direction_in_lidar.cross(true_direction()).norm(), 1e-9);
  EXPECT_LT((axis.centre_in_lidar_m - true_centre_m()).norm(), 1e-9);
  EXPECT_LT(axis.covariance.norm(), 1e-12);
}

TEST(slew_axis, an_error_that_all_poses_have_in_common_moves_nothing) {
  Turning moved;
  moved.common = make_rigid(rotation_from_yaw_pitch_roll({0.5, 0.05, -0.04}), {0.3, -0.2, 0.1});
  const SlewAxis one = fit_slew_axis(turn({}, 3)), other = fit_slew_axis(turn(moved, 3));
  EXPECT_LT(one.direction_in_lidar.cross(other.direction_in_lidar).norm(), 1e-9);
  EXPECT_LT((one.centre_in_lidar_m - other.centre_in_lidar_m).norm(), 1e-9);
  EXPECT_LT((one.covariance - other.covariance).norm(), 1e-6 * one.covariance.norm());
}

TEST(slew_axis, errors_are_as_large_as_the_covariance_says) {
  for (const double arc_deg : {360.0, 280.0}) {
    Turning how;
    how.arc_rad = degrees_to_radians(arc_deg);
    for (const double mean : mean_squares(how, 300)) {
      // 300 degrees of freedom: the 0.1% limits are 0.77 and 1.27. What chance alone shows of errors that last makes
      // the covariance a little larger.
      EXPECT_GT(mean, 0.70);
      EXPECT_LT(mean, 1.27);
    }
  }
}

TEST(slew_axis, errors_that_neighbours_share_widen_the_covariance) {
  Turning how;
  how.poses = 180;
  how.linked = 0.8;
  for (const double mean : mean_squares(how, 200)) {
    // As independent errors they would be nine.
    EXPECT_GT(mean, 0.7);
    EXPECT_LT(mean, 1.9);
  }
}

TEST(slew_axis, a_wrong_pose_in_ten_does_not_move_it) {
  std::vector<RigidTransform> poses = turn({}, 5);
  for (std::size_t i = 3; i < poses.size(); i += 10)
    poses[i] = poses[i] * make_rigid(so3_exp({0.05, -0.02, 0.1}), {0.6, 0.3, -0.4});
  const SlewAxis axis = fit_slew_axis(poses);
  ASSERT_TRUE(axis.found);
  EXPECT_LT((axis.centre_in_lidar_m - true_centre_m()).norm(), 5.0 * kWay_m / std::sqrt(108.0));
  EXPECT_LT(axis.direction_in_lidar.cross(true_direction()).norm(), 5.0 * kTurn_rad / std::sqrt(108.0));
}

TEST(slew_axis, poses_that_do_not_turn_and_too_few_have_no_axis) {
  std::vector<RigidTransform> along;
  for (int i = 0; i < 50; ++i) along.push_back(make_rigid(Eigen::Matrix3d::Identity(), {0.1 * i, 0.0, 0.0}));
  EXPECT_FALSE(fit_slew_axis(along).found);
  EXPECT_FALSE(fit_slew_axis({}).found);
  std::vector<RigidTransform> few = turn({}, 1);
  few.resize(7);
  EXPECT_FALSE(fit_slew_axis(few).found);
}

}  // namespace
}  // namespace remount::calibration
