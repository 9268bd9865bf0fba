#include "algorithms/registration/undetermined.h"

#include <gtest/gtest.h>

#include <random>

#include "algorithms/calibration/linear_solutions.h"
#include "algorithms/core/decompositions.h"
#include "algorithms/messages/render.h"
#include "algorithms/registration/registration.h"
#include "tests/algorithms/support/room.h"

namespace remount::registration {
namespace {

constexpr double kPointNoise_m = 0.01;

std::vector<testing::Rectangle> open_field() { return {{{-30, -30, -1.7}, {60, 0, 0}, {0, 60, 0}}}; }

RegistrationResult align_in(const std::vector<testing::Rectangle>& world, const Eigen::Matrix3d& turned_sensor) {
  const RigidTransform mounting = make_rigid(turned_sensor, Eigen::Vector3d::Zero());
  const RigidTransform there = make_rigid(so3_exp({0.0, 0.0, 0.03}), {0.4, 0.1, 0.0});
  const PreparedCloud source(testing::scan_of(world, there * mounting, kPointNoise_m, 1), {}),
      target(testing::scan_of(world, mounting, kPointNoise_m, 2), {});
  return align_scans(source, target, mounting.inverse() * there * mounting, {}, {});
}

double information_along(const RegistrationResult& result, const Eigen::Vector3d& direction) {
  return direction.dot(result.quality.information.topLeftCorner<3, 3>() * direction);
}

TEST(undetermined_directions, of_a_room_are_none) {
  const RegistrationResult result = align_in(testing::room(), Eigen::Matrix3d::Identity());
  EXPECT_EQ(result.quality.undetermined, Message());
  EXPECT_EQ(result.quality.failure, Message());
}

TEST(undetermined_directions, of_a_corridor_are_its_length) {
  const RegistrationResult result = align_in(testing::corridor(), Eigen::Matrix3d::Identity());
  EXPECT_EQ(english(result.quality.undetermined), "x (axes of the lidar)");
  EXPECT_EQ(result.quality.failure, Message());
  EXPECT_LT(information_along(result, Eigen::Vector3d::UnitX()), 25.0) << "less than 0.2 m is said to be known";
  EXPECT_GT(information_along(result, Eigen::Vector3d::UnitY()), 1e4);
}

TEST(undetermined_directions, are_named_in_the_axes_of_a_turned_sensor) {
  const Eigen::Matrix3d quarter = so3_exp({0.0, 0.0, 0.5 * kPi}), eighth = so3_exp({0.0, 0.0, 0.25 * kPi});
  EXPECT_EQ(english(align_in(testing::corridor(), quarter).quality.undetermined), "y (axes of the lidar)");
  const std::string between = english(align_in(testing::corridor(), eighth).quality.undetermined);
  EXPECT_EQ(between.rfind("the shift along [0.7", 0), 0U) << between;
}

TEST(undetermined_directions, of_an_open_field_are_its_plane_and_yaw) {
  const RegistrationResult result = align_in(open_field(), Eigen::Matrix3d::Identity());
  EXPECT_EQ(english(result.quality.undetermined), "x, y, yaw (axes of the lidar)");
  EXPECT_LT(information_along(result, {0.6, 0.8, 0.0}), 1.0);
  EXPECT_GT(information_along(result, Eigen::Vector3d::UnitZ()), 1e4);
}

TEST(undetermined_directions, of_nothing_are_all) {
  const UndeterminedDirections none = undetermined_directions({});
  EXPECT_TRUE(none.all());
  EXPECT_TRUE(none.removed_from(Matrix6d::Identity()).isZero(0.0));
}

TEST(undetermined_directions, of_a_few_surfaces_are_all_and_leave_exactly_nothing) {
  std::mt19937_64 random(4);
  std::normal_distribution<double> normal;
  const auto vector = [&] { return Eigen::Vector3d(normal(random), normal(random), normal(random)); };
  std::vector<SurfaceElement> elements;
  for (int i = 0; i < 5; ++i) elements.push_back({vector().normalized(), 8.0 * vector(), 1.0});
  const UndeterminedDirections few = undetermined_directions(elements);
  ASSERT_TRUE(few.all());
  EXPECT_TRUE(few.removed_from(1e4 * Matrix6d::Identity()).isZero(0.0));
}

TEST(undetermined_directions, leave_the_inverse_of_the_covariance_of_the_rest) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  const auto filled = [&] { return Matrix6d(Matrix6d::NullaryExpr([&] { return normal(random); })); };
  const Matrix6d root = filled(), information = root * root.transpose() + Matrix6d::Identity(),
                 axes = orthogonal_factor(filled());
  UndeterminedDirections directions;
  directions.lever_m = 5.0;
  directions.basis = axes.leftCols<2>();
  const Vector6d scale = (Vector6d() << 1.0, 1.0, 1.0, 5.0, 5.0, 5.0).finished();
  const Eigen::Matrix<double, 6, 4> rest = axes.rightCols<4>();
  const Matrix6d covariance = scale.asDiagonal() * calibration::inverse_by_lu(information) * scale.asDiagonal();
  const Matrix6d expected = scale.asDiagonal() * rest * (rest.transpose() * covariance * rest).inverse() *
                            rest.transpose() * scale.asDiagonal();
  const Matrix6d found = directions.removed_from(information);
  EXPECT_TRUE(found.isApprox(expected, 1e-9)) << found << "\n\n" << expected;
}

TEST(undetermined_directions, of_which_nothing_at_all_is_known_leave_the_rest_finite) {
  UndeterminedDirections directions;
  directions.basis = Vector6d::Unit(2);
  Matrix6d information = Matrix6d::Identity();
  information(2, 2) = 1e-18;
  information(2, 0) = information(0, 2) = 1e-16;
  const Matrix6d left = directions.removed_from(information);
  EXPECT_NEAR(left(0, 0), 1.0, 1e-12);
  EXPECT_EQ(left(2, 2), 0.0);
}

TEST(undetermined_directions, leave_the_rest_of_the_information_as_it_was) {
  UndeterminedDirections directions;
  directions.lever_m = 5.0;
  directions.basis = Vector6d::Unit(0);
  const Vector6d diagonal = (Vector6d() << 1.0, 2.0, 3.0, 4.0, 5.0, 6.0).finished();
  Vector6d expected = diagonal;
  expected[0] = 0.0;
  EXPECT_TRUE(directions.removed_from(diagonal.asDiagonal()).isApprox(Matrix6d(expected.asDiagonal()), 1e-12));
}

}  // namespace
}  // namespace remount::registration
