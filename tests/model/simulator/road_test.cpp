#include "model/simulator/road.h"

#include <gtest/gtest.h>

namespace remount::simulator {
namespace {

using Eigen::Vector2d;

TEST(road, vehicle_moves_along_the_road_by_the_distance_it_is_told) {
  for (const ScenarioKind kind : {ScenarioKind::Street, ScenarioKind::Flat, ScenarioKind::Straight,
                                  ScenarioKind::FigureEight, ScenarioKind::ParkingRamp}) {
    const Road road(kind, 6.0);
    for (double s = -20.0; s < 200.0; s += 0.37) {
      const double step = 1e-4;
      const Vector2d velocity = (road.point_in_road(s + step) - road.point_in_road(s - step)) / (2.0 * step);
      ASSERT_NEAR(velocity.norm(), 1.0, 1e-8) << "scenario " << static_cast<int>(kind) << " at " << s;
      ASSERT_NEAR(std::atan2(velocity.y(), velocity.x()), wrap_angle_rad(road.yaw_rad(s)), 1e-8);
    }
  }
}

TEST(road, figure_of_eight_closes) {
  const Road road(ScenarioKind::FigureEight, 6.0);
  EXPECT_LT((road.point_in_road(road.period_m() - 1e-9) - road.point_in_road(0.0)).norm(), 1e-7);
}

TEST(road, vehicle_on_flat_ground_stays_level) {
  const Road road(ScenarioKind::Flat, 6.0);
  const Ground ground = scenario_ground(ScenarioKind::Flat, 1);
  for (double s = 0.0; s < 72.0; s += 1.0) {
    const RigidTransform road_from_car = road_from_vehicle(road, ground, s);
    EXPECT_EQ(road_from_car.translation().z(), 0.0);
    EXPECT_NEAR(road_from_car.linear()(2, 2), 1.0, 1e-15);
  }
}

TEST(road, ramp_and_street_pitch_and_roll_the_vehicle) {
  for (const ScenarioKind kind : {ScenarioKind::Street, ScenarioKind::ParkingRamp}) {
    double pitch = 0.0, roll = 0.0;
    const Road road(kind, 6.0);
    const Ground ground = scenario_ground(kind, 1);
    for (double s = 0.0; s < 72.0; s += 0.5) {
      const Eigen::Matrix3d rotation = road_from_vehicle(road, ground, s).linear();
      ASSERT_LT((rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-12);
      const YawPitchRoll angles = yaw_pitch_roll_from_rotation(rotation);
      pitch = std::max(pitch, std::abs(radians_to_degrees(angles.pitch_rad)));
      roll = std::max(roll, std::abs(radians_to_degrees(angles.roll_rad)));
    }
    EXPECT_GT(pitch, 1.5);
    EXPECT_GT(roll, 1.5);
    EXPECT_LT(std::max(pitch, roll), 8.0);
  }
}

}  // namespace
}  // namespace remount::simulator
