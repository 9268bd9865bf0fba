#include "algorithms/geometry/shortest_rotation.h"

#include <gtest/gtest.h>

#include <random>

#include "algorithms/geometry/rotation.h"

namespace remount {
namespace {

using Eigen::Vector3d;

TEST(shortest_rotation, takes_one_direction_to_the_other_by_the_angle_between_them) {
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 200; ++i) {
    const Vector3d from(normal(random), normal(random), normal(random));
    const Vector3d to(normal(random), normal(random), normal(random));
    const Eigen::Matrix3d rotation = shortest_rotation(from, to);
    EXPECT_NEAR((rotation * from.normalized() - to.normalized()).norm(), 0.0, 1e-12);
    EXPECT_NEAR(so3_log(rotation).norm(), std::acos(from.normalized().dot(to.normalized())), 1e-9);
    EXPECT_NEAR((rotation.transpose() * rotation - Eigen::Matrix3d::Identity()).norm(), 0.0, 1e-12);
  }
}

TEST(shortest_rotation, stays_a_rotation_as_directions_become_opposite) {
  const Vector3d from(0.3, -0.5, 0.8);
  for (const double away_rad : {1e-2, 1e-4, 1e-6, 1e-8, 1e-12, 0.0}) {
    const Vector3d to = -(so3_exp(away_rad * from.unitOrthogonal()) * from);
    const Eigen::Matrix3d rotation = shortest_rotation(from, to);
    EXPECT_NEAR((rotation * from.normalized() - to.normalized()).norm(), 0.0, 1e-7) << away_rad;
    EXPECT_NEAR(rotation.determinant(), 1.0, 1e-9) << away_rad;
    EXPECT_NEAR((rotation.transpose() * rotation - Eigen::Matrix3d::Identity()).norm(), 0.0, 1e-9) << away_rad;
  }
}

TEST(shortest_rotation, of_a_direction_to_itself_is_none) {
  EXPECT_NEAR((shortest_rotation(Vector3d(0, 2, 0), Vector3d(0, 5, 0)) - Eigen::Matrix3d::Identity()).norm(), 0, 1e-15);
}

}  // namespace
}  // namespace remount
