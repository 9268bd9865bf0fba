#include "model/formats/ins/samples_between_fixes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "algorithms/geodesy/local_level.h"

namespace remount::formats {
namespace {

constexpr double kRate_radps = 0.3, kSpeed_mps = 6.0;

std::int64_t circle_ns(double time_s) { return std::llround(1e9 * (1.7e9 + time_s)); }

/// A circle, across the date line.
motion::InsSample on_wide_circle(double time_s) {
  const double heading_rad = kRate_radps * time_s, radius_m = kSpeed_mps / kRate_radps;
  motion::InsSample sample;
  sample.stamp_ns = circle_ns(time_s);
  sample.latitude_rad = radius_m * (1.0 - std::cos(heading_rad)) / 6.36e6;
  sample.longitude_rad = std::remainder(kPi - 1e-7 + radius_m * std::sin(heading_rad) / 6.378e6, 2.0 * kPi);
  sample.height_m = 100.0;
  sample.enu_from_ins = Eigen::AngleAxisd(heading_rad, Eigen::Vector3d::UnitZ());
  return sample;
}

struct Streams {
  std::vector<motion::InsSample> fixes;
  std::vector<StampedAttitude> attitudes;
};
Streams streams_at(double fix_hz, double attitude_hz, double length_s = 20.0) {
  Streams out;
  for (int i = 0; i <= static_cast<int>(length_s * fix_hz); ++i) out.fixes.push_back(on_wide_circle(i / fix_hz));
  for (int i = 0; i <= static_cast<int>(length_s * attitude_hz); ++i) {
    const motion::InsSample sample = on_wide_circle(i / attitude_hz + 0.003);
    out.attitudes.push_back({sample.stamp_ns, sample.enu_from_ins, {}});
  }
  return out;
}

TEST(samples_between_fixes, turn_as_measured_and_lie_on_the_way) {
  const Streams streams = streams_at(1.0, 50.0);
  const SamplesBetweenFixes whole = samples_between_fixes(streams.fixes, streams.attitudes);
  ASSERT_EQ(whole.fix_stamps_ns.size(), 21U);
  ASSERT_EQ(whole.ins.size(), 21U + 1000U);
  const geodesy::LocalLevel level(0.0, kPi - 1e-7, 100.0);
  for (std::size_t i = 0; i < whole.ins.size(); ++i) {
    if (i > 0) {
      ASSERT_GT(whole.ins[i].stamp_ns, whole.ins[i - 1].stamp_ns);
    }
    const double time_s = 1e-9 * static_cast<double>(whole.ins[i].stamp_ns - circle_ns(0.0));
    const RigidTransform found = level.enu_from_ins(whole.ins[i]), truth = level.enu_from_ins(on_wide_circle(time_s));
    EXPECT_LT(rotation_angle_between_rad(found, truth), 1e-5) << time_s;
    const bool at_an_end = time_s < 1.0 || time_s > 19.0;  // where a neighbour is missing
    EXPECT_LT((found.translation() - truth.translation()).norm(), at_an_end ? 0.15 : 0.02) << time_s;
  }
}

TEST(samples_between_fixes, are_not_made_where_fixes_are_quick_or_attitudes_slow_or_fixes_are_missing) {
  for (const auto& [fix_hz, attitude_hz] : {std::pair(10.0, 100.0), std::pair(1.0, 1.0)}) {
    const Streams streams = streams_at(fix_hz, attitude_hz);
    const SamplesBetweenFixes same = samples_between_fixes(streams.fixes, streams.attitudes);
    EXPECT_EQ(same.ins.size(), streams.fixes.size());
    EXPECT_TRUE(same.fix_stamps_ns.empty());
  }
  Streams gap = streams_at(1.0, 50.0);
  gap.fixes.erase(gap.fixes.begin() + 6, gap.fixes.begin() + 14);
  const SamplesBetweenFixes whole = samples_between_fixes(gap.fixes, gap.attitudes);
  for (const motion::InsSample& sample : whole.ins)
    EXPECT_FALSE(sample.stamp_ns > circle_ns(5.0) && sample.stamp_ns < circle_ns(14.0));
}

TEST(samples_between_fixes, are_not_claimed_where_no_orientation_comes_between) {
  const Streams streams = streams_at(1.0, 50.0);
  const SamplesBetweenFixes same = samples_between_fixes(streams.fixes, {});
  EXPECT_EQ(same.ins.size(), streams.fixes.size());
  EXPECT_TRUE(same.fix_stamps_ns.empty());
}

}  // namespace
}  // namespace remount::formats
