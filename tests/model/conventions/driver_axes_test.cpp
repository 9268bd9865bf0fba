#include "model/conventions/driver_axes.h"

#include <gtest/gtest.h>

#include "model/drive/attitude_convention.h"
#include "model/simulator/simulator.h"
#include "tests/support/motion_drive.h"

namespace remount::conventions {
namespace {

/// What a reader makes of attitudes that were written as east-north-up, where it takes them for north-east-down.
std::vector<motion::InsSample> taken_for_ned(std::vector<motion::InsSample> ins) {
  for (motion::InsSample& sample : ins)
    sample.enu_from_ins = drive::enu_from_ins(sample.enu_from_ins, drive::QuaternionConvention::NedFromBody);
  return ins;
}

/// Early versions change nothing where attitudes are of one of the two conventions.
void expect_enu(const std::vector<motion::InsSample>& read_as_ned, bool enu, double turned_rad = 0.0) {
  for (const double early_turn_rad : {0.0, 0.5 * kPi}) {
    const auto axes = find_driver_axes(read_as_ned, early_turn_rad);
    ASSERT_TRUE(axes) << turned_rad;
    EXPECT_EQ(axes->enu, enu) << turned_rad << ", " << early_turn_rad;
    EXPECT_EQ(axes->turn_rad, 0.0) << turned_rad << ", " << early_turn_rad;
    EXPECT_FALSE(axes->may_be_turned) << turned_rad << ", " << early_turn_rad;
    EXPECT_EQ(axes->goes_sideways(), turned_rad == 0.5 * kPi) << turned_rad << ": " << axes->yaw_rad;
  }
}

TEST(driver_axes, a_drive_with_turns_tells_the_convention_whichever_way_the_box_is_turned) {
  for (const double turned_rad : {0.0, 1.2, kPi / 2.0, kPi}) {
    std::vector<motion::InsSample> ins =
        simulator::simulate_drive(testing::motion_options(simulator::ScenarioKind::FigureEight, 40.0, 20.0))
            .session.ins;
    for (motion::InsSample& sample : ins)
      sample.enu_from_ins = sample.enu_from_ins * Eigen::AngleAxisd(turned_rad, Eigen::Vector3d::UnitZ());
    expect_enu(ins, false, turned_rad);
    expect_enu(taken_for_ned(ins), true, turned_rad);
  }
}

TEST(driver_axes, a_vehicle_that_stands_tells_nothing) {
  std::vector<motion::InsSample> ins(400);
  for (std::size_t i = 0; i < ins.size(); ++i)
    ins[i] = {static_cast<std::int64_t>(i) * 50'000'000, 0.9, 0.2, 100.0, Eigen::Quaterniond::Identity(), {}};
  for (const double early_turn_rad : {0.0, 0.5 * kPi}) {
    EXPECT_FALSE(find_driver_axes(ins, early_turn_rad));
    EXPECT_FALSE(find_driver_axes({}, early_turn_rad));
  }
}

// A drive on one straight road.
std::vector<motion::InsSample> straight_road(double heading_rad) {
  std::vector<motion::InsSample> ins(400);
  const Eigen::Quaterniond heading = drive::enu_from_ins({heading_rad, 0.0, 0.0}, drive::AttitudeConvention::Heading);
  for (std::size_t i = 0; i < ins.size(); ++i) {
    const double way_rad = 0.5 * static_cast<double>(i) / 6.37e6;
    ins[i] = {static_cast<std::int64_t>(i) * 50'000'000,
              0.9 + way_rad * std::cos(heading_rad),
              0.2 + way_rad * std::sin(heading_rad) / std::cos(0.9),
              100.0,
              heading,
              {}};
  }
  return ins;
}

// Both keep to a direction there: that counts under which the vehicle goes ahead.
TEST(driver_axes, on_a_straight_road_the_vehicle_goes_ahead) {
  expect_enu(straight_road(0.3), false);
  expect_enu(taken_for_ned(straight_road(0.3)), true);
}

/// As an early version writes them, whose world is turned.
std::vector<motion::InsSample> of_early_version(std::vector<motion::InsSample> ins, double early_turn_rad) {
  for (motion::InsSample& sample : ins)
    sample.enu_from_ins = Eigen::AngleAxisd(-early_turn_rad, Eigen::Vector3d::UnitZ()) * sample.enu_from_ins;
  return taken_for_ned(std::move(ins));
}

TEST(driver_axes, a_world_that_is_turned_is_known_by_the_vehicle_that_goes_ahead_in_no_other) {
  const std::vector<motion::InsSample> drive =
      simulator::simulate_drive(testing::motion_options(simulator::ScenarioKind::FigureEight, 40.0, 20.0)).session.ins;
  for (const double early_turn_rad : {0.5 * kPi, 0.5 * kPi - degrees_to_radians(0.5 * kPi)})
    for (const std::vector<motion::InsSample>& ins : {drive, straight_road(0.8)}) {
      const auto axes = find_driver_axes(of_early_version(ins, early_turn_rad), early_turn_rad);
      ASSERT_TRUE(axes);
      EXPECT_TRUE(axes->enu);
      EXPECT_EQ(axes->turn_rad, early_turn_rad);
      EXPECT_LT(std::abs(axes->yaw_rad), 0.02);
    }
  const auto untold = find_driver_axes(of_early_version(drive, 0.5 * kPi), 0.0);
  ASSERT_TRUE(untold && untold->enu);
  EXPECT_TRUE(untold->goes_sideways()) << untold->yaw_rad;
}

TEST(driver_axes, a_road_to_the_north_does_not_tell_early_versions) {
  const auto axes = find_driver_axes(straight_road(0.0), 0.5 * kPi);
  ASSERT_TRUE(axes);
  EXPECT_FALSE(axes->enu);
  EXPECT_TRUE(axes->may_be_turned);
}

}  // namespace
}  // namespace remount::conventions
