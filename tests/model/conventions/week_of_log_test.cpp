#include "model/conventions/week_of_log.h"

#include <gtest/gtest.h>

#include "model/formats/files/time_stamp.h"
#include "model/simulator/simulator.h"
#include "tests/model/formats/temporary_folder.h"
#include "tests/support/findings.h"
#include "tests/support/motion_drive.h"

namespace remount::conventions {
namespace {

constexpr std::int64_t kWholeWeek_ns = std::int64_t{604'800} * 1'000'000'000;

/// As a reader has it of a log of seconds of the week.
drive::Session with_open_week(const drive::Session& drive) {
  drive::Session session = drive;
  session.ins_week_open = session.ins_stamps_from_gps = true;
  for (motion::InsSample& sample : session.ins)
    sample.stamp_ns = formats::unix_ns_from_gps_ns(formats::gps_ns_from_unix_ns(sample.stamp_ns) % kWholeWeek_ns);
  return session;
}

drive::Session drive_of(double duration_s) {
  return simulator::simulate_drive(testing::motion_options(simulator::ScenarioKind::FigureEight, duration_s, 20.0))
      .session;
}

TEST(week_of_log, is_the_lidars) {
  const drive::Session drive = drive_of(12.0);
  drive::Session session = with_open_week(drive);
  place_in_week(session);
  ASSERT_EQ(session.ins.size(), drive.ins.size());
  for (std::size_t i = 0; i < drive.ins.size(); ++i) ASSERT_EQ(session.ins[i].stamp_ns, drive.ins[i].stamp_ns) << i;
  EXPECT_FALSE(session.ins_week_open);
  const std::string told = testing::said_of(session.findings, "ins-week");
  EXPECT_TRUE(formats::contains(told, "it is week 2288")) << told;
  EXPECT_TRUE(formats::contains(told, "2023-11-14 22:13:")) << told;
  place_in_week(session);  // once and for all
  EXPECT_EQ(session.findings.size(), 1U);
}

TEST(week_of_log, is_the_nearest_where_the_lidar_recorded_a_part_near_the_end_of_the_week) {
  const drive::Session drive = drive_of(12.0);
  drive::Session session = with_open_week(drive);
  // Saturday night by GPS: the log runs on over the end of the week, the LiDAR was on behind it.
  const std::int64_t in_week_ns = formats::gps_ns_from_unix_ns(session.ins.front().stamp_ns);
  const std::int64_t to_the_end_ns = kWholeWeek_ns - 6'000'000'000 - in_week_ns;
  for (motion::InsSample& sample : session.ins) sample.stamp_ns += to_the_end_ns;
  session.scans.reset();
  session.odometry_from_lidar.clear();
  for (int i = 0; i < 20; ++i)
    session.odometry_from_lidar.push_back(
        {drive.ins.front().stamp_ns + to_the_end_ns + 7'000'000'000 + i * 100'000'000LL, RigidTransform::Identity()});
  place_in_week(session);
  EXPECT_EQ(session.ins.front().stamp_ns, drive.ins.front().stamp_ns + to_the_end_ns);
}

TEST(week_of_log, of_a_lidar_without_dates_is_none) {
  const drive::Session drive = drive_of(3.0);
  drive::Session session = with_open_week(drive);
  session.scans.reset();
  const std::int64_t in_week_ns = formats::gps_ns_from_unix_ns(session.ins.front().stamp_ns);
  for (int i = 0; i < 20; ++i)
    session.odometry_from_lidar.push_back({in_week_ns + i * 100'000'000LL, RigidTransform::Identity()});
  place_in_week(session);
  EXPECT_EQ(session.ins.front().stamp_ns, in_week_ns);
  EXPECT_FALSE(session.ins_stamps_from_gps) << "no leap seconds are in it";
  EXPECT_TRUE(formats::contains(testing::said_of(session.findings, "ins-week"), "no dates either"));
}

TEST(week_of_log, stays_open_where_nothing_tells) {
  drive::Session session = with_open_week(drive_of(3.0));
  session.scans.reset();
  session.gnss.clear();
  const std::vector<motion::InsSample> before = session.ins;
  place_in_week(session);
  EXPECT_TRUE(session.ins_week_open);
  EXPECT_EQ(session.ins.front().stamp_ns, before.front().stamp_ns);
  EXPECT_TRUE(formats::contains(testing::said_of(session.findings, "ins-week"), "January 1980"));
  session.gnss.push_back({before.front().stamp_ns + 3 * kWholeWeek_ns, 0.8, 0.2, 100.0});
  session.gnss.front().stamp_ns = drive_of(3.0).ins.front().stamp_ns;
  place_in_week(session);
  EXPECT_EQ(session.ins.front().stamp_ns, session.gnss.front().stamp_ns) << "the receiver's week";
}

}  // namespace
}  // namespace remount::conventions
