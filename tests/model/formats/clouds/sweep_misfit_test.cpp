#include "model/formats/clouds/sweep_misfit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "algorithms/geometry/rotation.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::formats {
namespace {

/// A turn, clockwise, whose times run from `first_s` to `last_s`.
ReadCloud turn(double first_s, double last_s, bool clockwise = true, double share = 1.0) {
  constexpr int kPoints = 1440;
  ReadCloud read;
  read.columns = "x y z intensity scalar_Time";
  std::transform(read.columns.begin(), read.columns.end(), read.columns.begin(),
                 [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
  for (int i = 0; i < kPoints; ++i) {
    const double turned = (i + 0.5) / kPoints, azimuth_rad = (clockwise ? -2.0 : 2.0) * kPi * share * turned;
    read.cloud.points.emplace_back(static_cast<float>(10.0 * std::cos(azimuth_rad)),
                                   static_cast<float>(10.0 * std::sin(azimuth_rad)), 0.3f);
    read.cloud.time_from_stamp_s.push_back(static_cast<float>(first_s + (last_s - first_s) * turned));
  }
  return read;
}

TEST(sweep_misfit, times_of_a_sweep_fit_the_time_between_scans) {
  for (const double interval_s : {0.05, 0.1, 0.2}) {
    EXPECT_TRUE(sweep_misfit(turn(0.0, interval_s), interval_s).empty());
    EXPECT_TRUE(sweep_misfit(turn(-interval_s, 0.0), interval_s).empty());
    EXPECT_TRUE(sweep_misfit(turn(0.0, 2.0 * interval_s), interval_s).empty()) << "two sensors out of step";
    EXPECT_TRUE(sweep_misfit(turn(0.0, interval_s), 0.0).empty()) << "a single scan";
  }
  EXPECT_TRUE(sweep_misfit(turn(0.0, 0.1), 1.0).empty()) << "every tenth scan is kept";
  EXPECT_TRUE(sweep_misfit(turn(0.0, 0.004, true, 0.2), 0.1).empty()) << "a sensor that looks ahead";
}

TEST(sweep_misfit, shares_of_a_turn_and_wrong_units_are_named) {
  const std::string share = english(sweep_misfit(turn(0.0, 1.0), 0.1));
  EXPECT_TRUE(contains(share, "column scalar_time spans 0.999 s") && contains(share, "0.100 s apart")) << share;
  const std::string tenth = english(sweep_misfit(turn(0.0, 0.01), 0.1));
  EXPECT_TRUE(contains(tenth, "spans 0.010 s")) << tenth;
  EXPECT_FALSE(sweep_misfit(turn(0.0, 0.36), 0.1).empty()) << "degrees";
}

TEST(sweep_misfit, floats_that_are_too_coarse_are_named) {
  ReadCloud read = turn(0.0, 0.1);
  for (float& time_s : read.cloud.time_from_stamp_s)
    time_s = static_cast<float>(static_cast<double>(static_cast<float>(302'400.3 + static_cast<double>(time_s))) -
                                302'400.3);
  const std::string coarse = english(coarse_times(read));
  EXPECT_TRUE(contains(coarse, "steps of 0.031 s: 32-bit floats cannot hold")) << coarse;
  EXPECT_TRUE(coarse_times(turn(0.0, 0.1)).empty());
}

TEST(sweep_misfit, times_that_go_round_the_other_way_may_count_backwards) {
  EXPECT_EQ(times_count(turn(0.0, 0.1).cloud), drive::TimesCount::Forwards);
  EXPECT_EQ(times_count(turn(0.0, 0.1, false).cloud), drive::TimesCount::Forwards) << "stored as it turns";
  EXPECT_EQ(times_count(turn(0.1, 0.0).cloud), drive::TimesCount::Open);
  EXPECT_EQ(times_count(turn(0.1, 0.0, false).cloud), drive::TimesCount::Open);
  ReadCloud by_sides = turn(0.0, 0.1, false);  // in an order that tells nothing
  const auto mixed = [](auto& values) {
    auto copy = values;
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = copy[i * 7 % values.size()];
  };
  // 1440 and 7 have no common divisor.
  mixed(by_sides.cloud.points), mixed(by_sides.cloud.time_from_stamp_s);
  EXPECT_EQ(times_count(by_sides.cloud), drive::TimesCount::Open) << "sensors turn clockwise";
}

}  // namespace
}  // namespace remount::formats
