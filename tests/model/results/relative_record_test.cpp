#include "model/results/relative_record.h"

#include <gtest/gtest.h>

#include <cmath>

namespace remount::results {
namespace {

VehicleFile two_lidars() {
  VehicleFile vehicle;
  RelativeRecord two;
  two.lidar_a = "front", two.lidar_b = "rear";
  two.lidar_a_from_lidar_b = rigid_from_six({-3.0, 0.4, 0.2, 3.1, 0.02, -0.01});
  for (const calibration::Parameter parameter : calibration::kParameters)
    two.sigma[parameter] = calibration::is_angle(parameter) ? 1e-3 : 2e-3;
  two.height_m = 0.2, two.height_sigma_m = 0.001;
  vehicle.relatives = {two};
  return vehicle;
}

TEST(relative_record, is_as_the_file_has_it_or_turned_round) {
  const VehicleFile vehicle = two_lidars();
  const auto as_it_is = relative_record(vehicle, "front", "rear"), turned = relative_record(vehicle, "rear", "front");
  ASSERT_TRUE(as_it_is && turned);
  EXPECT_LT(difference(as_it_is->lidar_a_from_lidar_b, vehicle.relatives[0].lidar_a_from_lidar_b).norm(), 1e-12);
  EXPECT_LT(difference(turned->lidar_a_from_lidar_b.inverse(), as_it_is->lidar_a_from_lidar_b).norm(), 1e-12);
  EXPECT_EQ(turned->lidar_a, "rear");
  EXPECT_EQ(turned->lidar_b, "front");
  EXPECT_DOUBLE_EQ(turned->height_m, -0.2);
  EXPECT_DOUBLE_EQ(turned->height_sigma_m, 0.001);
}

TEST(relative_record, turned_round_is_never_surer_than_what_a_turn_moves_at_that_distance) {
  const auto turned = relative_record(two_lidars(), "rear", "front");
  ASSERT_TRUE(turned);
  const double turn_rad = 1e-3 * std::sqrt(3.0), arm_m = turned->lidar_a_from_lidar_b.translation().norm();
  EXPECT_NEAR(turned->sigma[calibration::Parameter::X].value(), std::hypot(2e-3 * std::sqrt(3.0), turn_rad * arm_m),
              1e-12);
  EXPECT_NEAR(turned->sigma[calibration::Parameter::Yaw].value(), turn_rad, 1e-12);
}

TEST(relative_record, is_none_where_a_parameter_is_not_observed_or_nobody_is_called_so) {
  VehicleFile vehicle = two_lidars();
  vehicle.relatives[0].sigma[calibration::Parameter::Z].reset();
  EXPECT_TRUE(relative_record(vehicle, "front", "rear"));
  EXPECT_FALSE(relative_record(vehicle, "rear", "front"));
  EXPECT_FALSE(relative_record(vehicle, "front", "left"));
}

}  // namespace
}  // namespace remount::results
