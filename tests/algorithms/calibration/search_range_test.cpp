#include "algorithms/calibration/search_range.h"

#include <gtest/gtest.h>

#include "algorithms/messages/render.h"

namespace remount::calibration {
namespace {

TEST(search_range_words, name_every_parameter_that_is_outside_and_by_how_much) {
  SearchRange range;
  EXPECT_EQ(outside_range(RigidTransform::Identity(), range), Message());
  range.yaw_max_rad = degrees_to_radians(10.0);
  range.pitch_min_rad = degrees_to_radians(-10.0);
  SixParameters six;
  six.x_m = 6.2;
  EXPECT_EQ(english(outside_range(rigid_from_six(six), range)), "x 6.20 m (at most 5.00 m)");
  six.z_m = -7.0;
  six.yaw_rad = degrees_to_radians(20.0);
  six.pitch_rad = degrees_to_radians(-30.0);
  EXPECT_EQ(
      english(outside_range(rigid_from_six(six), range)),
      "x 6.20 m (at most 5.00 m), z -7.00 m (at least -5.00 m), yaw 20.00 deg (at most 10.00 deg), pitch -30.00 deg "
      "(at least -10.00 deg)");
  SixParameters close;
  close.x_m = 5.00004;
  EXPECT_EQ(english(outside_range(rigid_from_six(close), range)), "x 5.00004 m (at most 5.00000 m)")
      << "the two are told apart";
}

TEST(search_range_words, half_a_turn_to_each_side_holds_every_angle_also_where_it_was_rounded) {
  SearchRange rounded;
  rounded.yaw_min_rad = rounded.roll_min_rad = -3.14159;
  rounded.yaw_max_rad = rounded.roll_max_rad = 3.14159;
  SearchRange half;
  half.yaw_min_rad = 0.0;
  for (const double off_rad : {0.0, 1e-16, 1e-12, 1e-7, 1e-3})
    for (const double sign : {-1.0, 1.0}) {
      const double angle = sign * (kPi - off_rad);
      for (const SixParameters& six :
           {SixParameters{0, 0, 0, angle, 0, 0}, SixParameters{0, 0, 0, 0, 0, angle},
            SixParameters{0, 0, 0, angle, 0.3, -angle}, SixParameters{0, 0, 0, angle, sign * kPi / 2, 0}}) {
        EXPECT_EQ(english(outside_range(rigid_from_six(six), SearchRange{})), "") << angle;
        EXPECT_EQ(english(outside_range(rigid_from_six(six), rounded)), "") << angle;
      }
    }
  EXPECT_NE(outside_range(rigid_from_six({0, 0, 0, -1.0, 0, 0}), half), Message()) << "half a turn is no full one";
}

}  // namespace
}  // namespace remount::calibration
