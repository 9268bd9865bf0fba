#include "algorithms/quality/clearance.h"

#include <gtest/gtest.h>

namespace remount::quality {
namespace {

constexpr VehicleBox kBox{3.5, 1.5, 1.0, -0.5, 2.0};

double distance_m(const Clearances& found, Side side) { return found.sides[static_cast<std::size_t>(side)].distance_m; }

TEST(clearance, is_to_the_nearest_point_straight_off_each_side) {
  const Clearances found = find_clearances(
      {{7.5F, 0.5F, 0.0F}, {9.0F, 0.0F, 0.0F}, {-4.0F, -1.0F, 0.0F}, {0.0F, 3.0F, 1.0F}, {1.0F, -1.25F, 0.0F}}, kBox);
  EXPECT_NEAR(distance_m(found, Side::Front), 4.0, 1e-6);
  EXPECT_NEAR(distance_m(found, Side::Rear), 2.5, 1e-6);
  EXPECT_NEAR(distance_m(found, Side::Left), 2.0, 1e-6);
  EXPECT_NEAR(distance_m(found, Side::Right), 0.25, 1e-6);
  EXPECT_NEAR(found.nearest.distance_m, 0.25, 1e-6);
  EXPECT_EQ(found.obstacles, 5U);
}

TEST(clearance, a_corner_is_near_and_on_no_side) {
  const Clearances found = find_clearances({{6.5F, 5.0F, 0.0F}}, kBox);
  for (const Clearance& side : found.sides) EXPECT_TRUE(std::isinf(side.distance_m));
  EXPECT_NEAR(found.nearest.distance_m, 5.0, 1e-6);
  EXPECT_EQ(found.nearest.point_in_vehicle, Eigen::Vector3f(6.5F, 5.0F, 0.0F));
}

TEST(clearance, the_vehicle_the_ground_and_what_is_overhead_are_no_obstacles) {
  const float nothing = std::numeric_limits<float>::quiet_NaN();
  const Clearances found = find_clearances(
      {{2.0F, 0.0F, 0.5F}, {3.5F, 1.0F, 0.0F}, {5.0F, 0.0F, -0.6F}, {5.0F, 0.0F, 2.1F}, {5.0F, nothing, 0.0F}}, kBox);
  EXPECT_EQ(found.on_vehicle, 2U) << "the outline belongs to it";
  EXPECT_EQ(found.obstacles, 0U);
  EXPECT_TRUE(std::isinf(found.nearest.distance_m));
}

TEST(clearance, of_nothing_is_infinite) { EXPECT_TRUE(std::isinf(find_clearances({}, kBox).nearest.distance_m)); }

}  // namespace
}  // namespace remount::quality
