// Receivers 1024 weeks back: named and mended, in every source of stamps.
#include "model/conventions/week_rollover.h"

#include <gtest/gtest.h>

#include "model/drive/session_frames.h"
#include "model/formats/files/time_stamp.h"
#include "model/formats/session_readers.h"
#include "model/formats/sessions/native_session_writer.h"
#include "model/simulator/drive_formats.h"
#include "tests/model/formats/bags/bag_maker.h"
#include "tests/model/simulator/written_drive.h"
#include "tests/support/motion_drive.h"

namespace remount::conventions {
namespace {

constexpr std::int64_t kWeeks_ns = std::int64_t{1024} * 604'800 * 1'000'000'000;

simulator::SimulatedDrive drive_of_today() {
  simulator::SimulationOptions options = testing::motion_options(simulator::ScenarioKind::FigureEight, 12.0, 20.0);
  options.gnss.rate_hz = 2.0;
  options.wheels.rate_hz = 10.0;
  return simulator::simulate_drive(options);
}

std::size_t rollovers_in(const drive::Session& session) {
  return static_cast<std::size_t>(
      std::count_if(session.findings.begin(), session.findings.end(),
                    [](const drive::Finding& finding) { return finding.code == "gps-week-rollover"; }));
}

bool says_clocks_are_apart(const drive::Session& session) {
  return std::any_of(session.findings.begin(), session.findings.end(), [](const drive::Finding& finding) {
    return finding.code == "clocks-apart" || finding.code == "sensor-clock" || finding.code == "clock-ambiguous" ||
           finding.code == "clock-moved";
  });
}

template <class Items>
void move_back(Items& items, std::int64_t by_ns) {
  for (auto& item : items) item.stamp_ns -= by_ns;
}

TEST(week_rollover, of_every_stream_of_a_session_is_mended_exactly) {
  const simulator::SimulatedDrive drive = drive_of_today();
  const formats::TemporaryFolder folder;
  simulator::SimulatedDrive back = drive;
  move_back(back.session.ins, kWeeks_ns);
  move_back(back.session.imu, kWeeks_ns);
  move_back(back.session.gnss, kWeeks_ns);
  move_back(back.session.wheels, kWeeks_ns);
  const drive::Session read = simulator::read_back(back, "native", folder);
  EXPECT_EQ(rollovers_in(read), 4u);
  EXPECT_FALSE(says_clocks_are_apart(read));
  ASSERT_EQ(read.ins.size(), drive.session.ins.size());
  for (std::size_t i = 0; i < read.ins.size(); ++i) EXPECT_EQ(read.ins[i].stamp_ns, drive.session.ins[i].stamp_ns);
  EXPECT_EQ(read.imu.back().stamp_ns, drive.session.imu.back().stamp_ns);
  EXPECT_EQ(read.gnss.back().stamp_ns, drive.session.gnss.back().stamp_ns);
  EXPECT_EQ(read.wheels.back().stamp_ns, drive.session.wheels.back().stamp_ns);
}

TEST(week_rollover, of_poses_with_poses_is_mended_before_clocks_are_aligned) {
  const simulator::SimulatedDrive drive = drive_of_today();
  std::vector<motion::StampedPose> ins = drive::metric_poses(drive.session);
  move_back(ins, kWeeks_ns);
  const formats::TemporaryFolder folder;
  folder.write("ins.txt", formats::tum_text(ins));
  folder.write("lidar.txt", formats::tum_text(simulator::exact_odometry(drive)));
  Progress progress;
  const drive::Session read = formats::open_session(folder.path(), progress);
  EXPECT_EQ(rollovers_in(read), 1u);
  EXPECT_FALSE(says_clocks_are_apart(read));
  EXPECT_EQ(read.world_from_ins.front().stamp_ns, drive.session.ins.front().stamp_ns);
}

TEST(week_rollover, of_a_log_of_gps_weeks_takes_the_leap_seconds_of_the_right_year) {
  const simulator::SimulatedDrive drive = drive_of_today();
  drive::Session session = drive.session;
  // As a reader has it that finds the week in the log: no second of 2023 was a leap second in 2004 already.
  for (motion::InsSample& sample : session.ins)
    sample.stamp_ns = formats::unix_ns_from_gps_ns(formats::gps_ns_from_unix_ns(sample.stamp_ns) - kWeeks_ns);
  EXPECT_NE(drive.session.ins.front().stamp_ns - session.ins.front().stamp_ns, kWeeks_ns);
  for (const bool from_gps : {true, false}) {  // the drive covers its scans by one of them alone
    drive::Session one = session;
    one.ins_stamps_from_gps = from_gps;
    mend_week_rollover(one);
    EXPECT_EQ(one.ins.front().stamp_ns, drive.session.ins.front().stamp_ns);
  }
}

TEST(week_rollover, where_a_log_covers_the_scans_either_way_its_kind_decides) {
  const std::int64_t day_ns = 86'400'000'000'000, now_ns = 1'700'000'000'000'000'000;
  const TimeSpan scans{now_ns, now_ns + 20'000'000'000}, whole_day{now_ns - day_ns / 2, now_ns + day_ns / 2};
  const TimeSpan back{whole_day.first_ns - kWeeks_ns, whole_day.last_ns - kWeeks_ns};
  EXPECT_EQ(week_rollover_ns(back, scans, false), kWeeks_ns);
  EXPECT_EQ(week_rollover_ns(back, scans, true), kWeeks_ns - 5'000'000'000);  // 13 s in 2004, 18 s in 2023
}

TEST(week_rollover, is_nothing_else_that_is_far_apart) {
  const std::int64_t now_ns = 1'700'000'000'000'000'000, minute_ns = 60'000'000'000;
  const TimeSpan scans{now_ns, now_ns + minute_ns};
  const auto shifted = [&](std::int64_t by_ns) { return TimeSpan{scans.first_ns + by_ns, scans.last_ns + by_ns}; };
  EXPECT_EQ(week_rollover_ns(shifted(0), scans, false), 0);
  EXPECT_EQ(week_rollover_ns(shifted(-20 * minute_ns), scans, false), 0);
  EXPECT_EQ(week_rollover_ns(shifted(-kWeeks_ns - 10 * minute_ns), scans, false), 0) << "another drive";
  EXPECT_EQ(week_rollover_ns(shifted(-now_ns), scans, false), 0) << "since power-on";
  EXPECT_EQ(week_rollover_ns(shifted(-2 * kWeeks_ns), scans, false), 2 * kWeeks_ns);
  EXPECT_EQ(week_rollover_ns(shifted(kWeeks_ns), scans, false), -kWeeks_ns);
  EXPECT_EQ(week_rollover_ns({0, -1}, scans, false), 0);
}

TEST(week_rollover, of_a_bag_is_told_by_the_clock_of_its_recorder) {
  const formats::TemporaryFolder folder;
  bags::BagMaker bag(folder.path() / "drive.bag");
  bag.add_ins("/ins", 41, -kWeeks_ns);
  bag.add_scans("/points", 20, 30);
  bag.finish();
  Progress progress;
  const drive::Session read = formats::open_session(folder.path() / "drive.bag", progress);
  EXPECT_EQ(rollovers_in(read), 2u) << "orientation and fix, whatever they are used for";
  EXPECT_FALSE(says_clocks_are_apart(read));
  ASSERT_EQ(read.ins.size(), 41u);
  EXPECT_EQ(read.ins.front().stamp_ns, bags::BagMaker::on_circle(0).stamp_ns);
  EXPECT_EQ(read.gnss.front().stamp_ns, bags::BagMaker::on_circle(0).stamp_ns);
}

TEST(week_rollover, of_inspva_moves_the_inspvax_beside_it_whose_errors_it_has) {
  const formats::TemporaryFolder folder;
  bags::BagMaker bag(folder.path() / "drive.bag");
  bag.add_inspva("/novatel/oem7/inspva", 201, 1024);
  bag.add_inspvax("/novatel/oem7/inspvax", 11, 20, 56, 0, 1024);
  bag.add_scans("/points", 100, 30);
  bag.finish();
  Progress progress;
  const drive::Session read = formats::open_session(folder.path() / "drive.bag", progress);
  EXPECT_EQ(rollovers_in(read), 1u) << "of one receiver";
  EXPECT_FALSE(says_clocks_are_apart(read));
  ASSERT_EQ(read.ins.size(), 201u);
  for (std::size_t i = 0; i < read.ins.size(); ++i) {
    EXPECT_EQ(read.ins[i].stamp_ns, bags::BagMaker::on_circle(static_cast<int>(i)).stamp_ns);
    EXPECT_NEAR(read.ins[i].sigma.position_enu_m.x(), 0.02, 1e-6) << i;
  }
}

TEST(week_rollover, moves_which_positions_were_measured_with_the_ins) {
  drive::Session session = drive_of_today().session;
  const std::int64_t measured_ns = session.ins.at(40).stamp_ns;
  session.ins_fix_stamps_ns = {session.ins.front().stamp_ns - kWeeks_ns, measured_ns - kWeeks_ns};
  move_back(session.ins, kWeeks_ns);
  mend_week_rollover(session);
  EXPECT_EQ(session.ins.at(40).stamp_ns, measured_ns);
  EXPECT_EQ(session.ins_fix_stamps_ns.back(), measured_ns);
}

}  // namespace
}  // namespace remount::conventions
