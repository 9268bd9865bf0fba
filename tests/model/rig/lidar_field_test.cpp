#include "model/rig/lidar_field.h"

#include <gtest/gtest.h>

#include "model/simulator/simulator.h"

namespace remount::rig {
namespace {

LidarField field_of(std::string_view model) {
  simulator::SimulationOptions options;
  options.lidar.model = simulator::lidar_named(model);
  options.lidar.points_per_scan = model == "spinning" ? 0 : 4000;
  options.beams = 16;
  options.azimuth_steps = 300;
  options.duration_s = 2.0;
  return LidarField({std::make_shared<drive::Session>(simulator::simulate_drive(options).session)}, {});
}

RigidTransform turned(double yaw_deg) {
  return make_rigid(rotation_from_yaw_pitch_roll({degrees_to_radians(yaw_deg), 0.0, 0.0}), {0.0, 0.0, 0.0});
}

TEST(lidar_field, shares_what_lies_in_both_fields) {
  const LidarField narrow = field_of("mid-70");
  EXPECT_GT(narrow.share_in(narrow, RigidTransform::Identity()), 0.8);
  EXPECT_LT(narrow.share_in(narrow, turned(180.0)), 0.02);
  const double half = narrow.share_in(narrow, turned(35.0));
  EXPECT_GT(half, 0.15);
  EXPECT_LT(half, 0.6);
}

TEST(lidar_field, one_that_looks_around_sees_what_others_see_and_not_the_other_way_round) {
  const LidarField around = field_of("spinning"), narrow = field_of("m1");
  EXPECT_GT(narrow.share_in(around, turned(100.0)), 0.6);
  const double back = around.share_in(narrow, turned(100.0));
  EXPECT_GT(back, 0.15);
  EXPECT_LT(back, 0.55);
}

TEST(lidar_field, nothing_is_shared_with_what_was_not_seen) {
  const LidarField none({std::make_shared<drive::Session>()}, {});
  EXPECT_TRUE(none.empty());
  EXPECT_EQ(none.share_in(field_of("m1"), RigidTransform::Identity()), 0.0);
}

}  // namespace
}  // namespace remount::rig
