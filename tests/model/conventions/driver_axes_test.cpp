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

TEST(driver_axes, a_drive_with_turns_tells_the_convention_whichever_way_the_box_is_turned) {
  for (const double turned_rad : {0.0, 1.2, kPi / 2.0, kPi}) {
    std::vector<motion::InsSample> ins =
        simulator::simulate_drive(testing::motion_options(simulator::ScenarioKind::FigureEight, 40.0, 20.0))
            .session.ins;
    for (motion::InsSample& sample : ins)
      sample.enu_from_ins = sample.enu_from_ins * Eigen::AngleAxisd(turned_rad, Eigen::Vector3d::UnitZ());
    EXPECT_EQ(are_east_north_up(ins), std::optional(false)) << turned_rad;
    EXPECT_EQ(are_east_north_up(taken_for_ned(ins)), std::optional(true)) << turned_rad;
  }
}

TEST(driver_axes, a_vehicle_that_stands_tells_nothing) {
  std::vector<motion::InsSample> ins(400);
  for (std::size_t i = 0; i < ins.size(); ++i)
    ins[i] = {static_cast<std::int64_t>(i) * 50'000'000, 0.9, 0.2, 100.0, Eigen::Quaterniond::Identity(), {}};
  EXPECT_EQ(are_east_north_up(ins), std::nullopt);
  EXPECT_EQ(are_east_north_up({}), std::nullopt);
}

// On one straight road both keep to a direction: that counts under which the vehicle goes ahead.
TEST(driver_axes, on_a_straight_road_the_vehicle_goes_ahead) {
  std::vector<motion::InsSample> ins(400);
  const Eigen::Quaterniond heading = drive::enu_from_ins({0.3, 0.0, 0.0}, drive::AttitudeConvention::Heading);
  for (std::size_t i = 0; i < ins.size(); ++i) {
    const double way_rad = 0.5 * static_cast<double>(i) / 6.37e6;
    ins[i] = {static_cast<std::int64_t>(i) * 50'000'000,
              0.9 + way_rad * std::cos(0.3),
              0.2 + way_rad * std::sin(0.3) / std::cos(0.9),
              100.0,
              heading,
              {}};
  }
  EXPECT_EQ(are_east_north_up(ins), std::optional(false));
  EXPECT_EQ(are_east_north_up(taken_for_ned(ins)), std::optional(true));
}

}  // namespace
}  // namespace remount::conventions
