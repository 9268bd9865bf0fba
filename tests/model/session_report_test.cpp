#include "model/session_report.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace remount {
namespace {

/// Poses of an INS at 100 Hz and of a LiDAR at 10 Hz, both along a straight line of 10 m.
Session example(std::int64_t lidar_late_ns = 0) {
  Session session;
  session.name = "drive";
  session.format = "poses";
  for (int i = 0; i <= 1000; ++i)
    session.world_from_ins.push_back({i * 10'000'000LL, rigid_from_six({0.01 * i, 0, 0, 0, 0, 0})});
  for (int i = 0; i < 100; ++i)
    session.odometry_from_lidar.push_back({i * 100'000'000LL + lidar_late_ns, RigidTransform::Identity()});
  return session;
}

bool has(const SessionReport& report, const std::string& code) {
  return std::any_of(report.findings.begin(), report.findings.end(),
                     [&](const Finding& finding) { return finding.code == code; });
}

TEST(session_report, counts_rates_and_gaps) {
  std::vector<std::int64_t> stamps;
  for (int i = 0; i < 50; ++i) stamps.push_back(i * 100'000'000LL + (i >= 30 ? 2'000'000'000LL : 0));
  const StreamReport report = report_stream(stamps);
  EXPECT_EQ(report.count, 50U);
  EXPECT_DOUBLE_EQ(report.rate_hz, 10.0);
  EXPECT_EQ(report.gaps, 1U);
  EXPECT_DOUBLE_EQ(report.longest_gap_s, 2.1);
  EXPECT_EQ(report_stream({}).count, 0U);
  EXPECT_EQ(report_stream({5}).rate_hz, 0.0);
}

TEST(session_report, a_good_session_is_usable) {
  Progress progress;
  const Session session = example();
  const SessionReport report = report_session(session, progress);
  EXPECT_TRUE(report.usable) << describe(session, report);
  EXPECT_EQ(report.lidar_covered, 100U);
  EXPECT_NEAR(report.travelled_m, 10.0, 1e-9);
  EXPECT_NE(describe(session, report).find("usable: yes"), std::string::npos);
}

TEST(session_report, clocks_that_do_not_meet_are_a_problem) {
  Progress progress;
  const SessionReport report = report_session(example(3'600'000'000'000LL), progress);
  EXPECT_FALSE(report.usable);
  EXPECT_TRUE(has(report, "clocks-apart"));
  const SessionReport partly = report_session(example(5'000'000'000LL), progress);
  EXPECT_TRUE(partly.usable);
  EXPECT_TRUE(has(partly, "partly-covered"));
  EXPECT_EQ(partly.lidar_covered, 51U);
}

TEST(session_report, a_session_without_motion_is_not_usable) {
  Progress progress;
  Session session = example();
  session.world_from_ins.clear();
  EXPECT_FALSE(report_session(session, progress).usable);
}

TEST(session_report, times_are_utc) {
  EXPECT_EQ(utc_text(1317042171951000000LL), "2011-09-26 13:02:51.951 UTC");
  EXPECT_EQ(utc_text(-1), "1969-12-31 23:59:59.999 UTC");
}

}  // namespace
}  // namespace remount
