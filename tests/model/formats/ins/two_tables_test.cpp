#include "model/formats/ins/two_tables.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "algorithms/core/error.h"
#include "tests/model/formats/temporary_folder.h"
#include "tests/support/findings.h"

namespace remount::formats {
namespace {

constexpr double kCircleRate_radps = 0.5, kCircleRadius_m = 20.0, kRoundEarth_m = 6'371'000.0;

/// A vehicle on a circle, at a time since the begin.
motion::InsSample on_circle(std::int64_t stamp_ns) {
  const double angle_rad = kCircleRate_radps * 1e-9 * static_cast<double>(stamp_ns);
  motion::InsSample sample;
  sample.stamp_ns = stamp_ns;
  sample.latitude_rad = 0.8 + kCircleRadius_m * std::sin(angle_rad) / kRoundEarth_m;
  sample.longitude_rad = 0.2 + kCircleRadius_m * std::cos(angle_rad) / kRoundEarth_m;
  sample.enu_from_ins = Eigen::AngleAxisd(angle_rad, Eigen::Vector3d::UnitZ());
  return sample;
}

/// Every so many ms of 20 s, but for those left out.
std::vector<motion::InsSample> positions_each(int period_ms, int from_ms = 0, int gap_from_ms = -1,
                                              int gap_to_ms = -1) {
  std::vector<motion::InsSample> samples;
  for (int ms = from_ms; ms <= 20'000; ms += period_ms) {
    if (ms > gap_from_ms && ms < gap_to_ms) continue;
    samples.push_back(on_circle(std::int64_t{ms} * 1'000'000));
    samples.back().enu_from_ins = Eigen::Quaterniond::Identity();
  }
  return samples;
}
std::vector<StampedAttitude> attitudes_each(int period_ms, int from_ms = 0, int to_ms = 20'000) {
  std::vector<StampedAttitude> attitudes;
  for (int ms = from_ms; ms <= to_ms; ms += period_ms) {
    const motion::InsSample sample = on_circle(std::int64_t{ms} * 1'000'000);
    attitudes.push_back({sample.stamp_ns, sample.enu_from_ins, {0.001, 0.002, 0.003}});
  }
  return attitudes;
}

/// The largest errors of position (m) and attitude (rad).
std::pair<double, double> errors_of(const std::vector<motion::InsSample>& samples) {
  double worst_m = 0.0, worst_rad = 0.0;
  for (const motion::InsSample& sample : samples) {
    const motion::InsSample truth = on_circle(sample.stamp_ns);
    worst_m = std::max({worst_m, kRoundEarth_m * std::abs(sample.latitude_rad - truth.latitude_rad),
                        kRoundEarth_m * std::abs(sample.longitude_rad - truth.longitude_rad)});
    worst_rad = std::max(worst_rad, sample.enu_from_ins.angularDistance(truth.enu_from_ins));
  }
  return {worst_m, worst_rad};
}

TEST(two_tables, make_samples_at_the_positions_where_attitudes_are_not_rarer) {
  std::vector<drive::Finding> findings;
  const JoinedMotion joined = join_tables(positions_each(100), attitudes_each(10, 3, 20'003), "attitude.csv", findings);
  const auto [off_m, off_rad] = errors_of(joined.ins);
  std::printf("%zu samples, off by %.2e m and %.2e rad\n", joined.ins.size(), off_m, off_rad);
  EXPECT_EQ(joined.ins.size(), 200U) << "the first has no attitude before it";
  EXPECT_LT(off_m, 1e-6);
  EXPECT_LT(off_rad, 1e-6);
  EXPECT_TRUE(joined.fix_stamps_ns.empty());
  EXPECT_GT(joined.position_lag_sigma_s, 0.0) << "stamps of their own may be late";
  EXPECT_EQ(joined.ins.front().sigma.attitude_rad.z(), 0.003);
  testing::expect_told(findings, "ins-incomplete", "1 position has no attitude beside in the other table");
}

TEST(two_tables, keep_all_turns_between_slow_positions) {
  std::vector<drive::Finding> findings;
  const JoinedMotion joined = join_tables(positions_each(500), attitudes_each(20), "attitude.csv", findings);
  const auto [off_m, off_rad] = errors_of(joined.ins);
  std::printf("%zu samples, off by %.2e m and %.2e rad\n", joined.ins.size(), off_m, off_rad);
  EXPECT_EQ(joined.ins.size(), 1001U);
  EXPECT_EQ(joined.fix_stamps_ns.size(), 41U);
  EXPECT_LT(off_m, 0.03) << "at the ends of the drive, where the cubic has a neighbour less";
  EXPECT_LT(off_rad, 1e-9);
  EXPECT_EQ(joined.position_lag_sigma_s, 0.0) << "one device stamps both";
  EXPECT_TRUE(findings.empty());
}

TEST(two_tables, make_samples_at_attitudes_that_are_rarer) {
  std::vector<drive::Finding> findings;
  const JoinedMotion joined = join_tables(positions_each(50, 0, 5'000, 7'000), attitudes_each(130), "a.csv", findings);
  const auto [off_m, off_rad] = errors_of(joined.ins);
  std::printf("%zu samples, off by %.2e m and %.2e rad\n", joined.ins.size(), off_m, off_rad);
  EXPECT_LT(off_m, 1e-4);
  EXPECT_EQ(off_rad, 0.0);
  for (const motion::InsSample& sample : joined.ins)
    EXPECT_FALSE(sample.stamp_ns > 5'000'000'000 && sample.stamp_ns < 7'000'000'000) << "no way is known there";
  testing::expect_told(findings, "ins-incomplete", "attitudes have no position beside in the other table");
}

TEST(two_tables, without_a_time_in_common_are_refused) {
  std::vector<drive::Finding> findings;
  EXPECT_ERROR(join_tables(positions_each(100), attitudes_each(10, 25'000, 30'000), "attitude.csv", findings),
               "attitude.csv");
  EXPECT_ERROR(join_tables(positions_each(100), attitudes_each(10, 25'000, 30'000), "attitude.csv", findings),
               "no time in common, they are 5.00 s apart");
}

}  // namespace
}  // namespace remount::formats
