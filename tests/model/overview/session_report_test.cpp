#include "model/overview/session_report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "algorithms/calibration/calibration_result.h"
#include "model/formats/files/time_stamp.h"
#include "model/formats/session_readers.h"
#include "tests/model/formats/temporary_folder.h"
#include "tests/support/findings.h"

namespace remount::overview {
namespace {

enum class RoadKind { Straight, Flat, Hilly, Parked };

/// Poses of an INS at 100 Hz and of a LiDAR at 10 Hz, ten seconds at 6 m/s along a road; both clocks the same but for
/// `lidar_late_ns`.
drive::Session example(std::int64_t lidar_late_ns = 0, RoadKind road = RoadKind::Straight) {
  drive::Session session;
  session.name = "drive";
  session.format = "poses";
  Eigen::Vector2d position(0, 0);
  for (int i = 0; i <= 1000; ++i) {
    const double time_s = 0.01 * i, speed_mps = road == RoadKind::Parked ? 0.0 : 6.0;
    const double yaw = road == RoadKind::Flat || road == RoadKind::Hilly ? std::sin(0.8 * time_s) : 0.0;
    const double tilt = road == RoadKind::Hilly ? 0.08 : 0.0;
    position += 0.01 * speed_mps * Eigen::Vector2d(std::cos(yaw), std::sin(yaw));
    session.world_from_ins.push_back(
        {i * 10'000'000LL, rigid_from_six({position.x(), position.y(), 0, yaw, tilt * std::sin(1.3 * time_s),
                                           tilt * std::cos(1.1 * time_s)})});
  }
  for (int i = 0; i < 100; ++i)
    session.odometry_from_lidar.push_back({i * 100'000'000LL + lidar_late_ns, RigidTransform::Identity()});
  return session;
}

bool has(const SessionReport& report, const std::string& code) { return testing::has_code(report.findings, code); }

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

TEST(session_report, counts_where_stamps_lie_a_century_apart) {
  constexpr std::int64_t kCentury_ns = 3'500'000'000'000'000'000;  // three of them are more than 64 bits hold
  const StreamReport report = report_stream({-kCentury_ns, 0, kCentury_ns});
  EXPECT_EQ(report.gaps, 0U);
  EXPECT_DOUBLE_EQ(report.longest_gap_s, 3.5e9);
}

TEST(session_report, a_good_session_is_usable) {
  Progress progress;
  const drive::Session session = example();
  const SessionReport report = report_session(session, progress);
  EXPECT_TRUE(report.usable) << describe(session, report);
  EXPECT_EQ(report.lidar_covered, 100U);
  EXPECT_NEAR(report.travelled_m, 60.0, 0.1);
}

// What the calibration of such drives comes to observe: tests/model/pipeline/simulated_drive_test.cpp.
TEST(session_report, says_in_words_what_the_motion_can_tell) {
  Progress progress;
  const std::vector<std::pair<RoadKind, std::string>> cases{
      {RoadKind::Straight, "usable: in part, for yaw, pitch; not for x, y, z, roll"},
      {RoadKind::Flat, "usable: in part, for x, y, yaw, pitch, roll; not for z"},
      {RoadKind::Hilly, "the motion can tell: x, y, z, yaw, pitch, roll\n  usable: yes\n"},
      {RoadKind::Parked, "usable: no"}};
  for (const auto& [road, said] : cases) {
    const drive::Session session = example(0, road);
    const SessionReport report = report_session(session, progress);
    EXPECT_NE(describe(session, report).find(said), std::string::npos) << said << "\n" << describe(session, report);
    EXPECT_EQ(report.usable, road != RoadKind::Parked) << said;
    if (road == RoadKind::Straight) {
      EXPECT_FALSE(report.outlook.advice.empty());
    }
  }
}

TEST(session_report, the_way_the_lidar_is_turned_does_not_change_what_can_be_told) {
  drive::Session session = example(0, RoadKind::Flat);
  session.nominal_ins_from_lidar = rigid_from_six({1, 0, 2, kPi / 2, 0, kPi / 6});
  EXPECT_EQ(motion_outlook(session).determinable, ~calibration::ParameterSet{calibration::Parameter::Z});
}

// As the calibration says: tests/algorithms/calibration.
TEST(session_report, while_yaw_is_open_nothing_can_be_told_without_a_nominal) {
  drive::Session session = example(0, RoadKind::Flat);
  for (motion::StampedPose& pose : session.world_from_ins) pose.pose.translation() *= 0.05;  // hardly moves, but turns
  const MotionOutlook outlook = motion_outlook(session);
  ASSERT_FALSE(outlook.determinable.contains(calibration::Parameter::Yaw))
      << calibration::parameter_names(outlook.determinable);
  ASSERT_TRUE(outlook.determinable.contains(calibration::Parameter::Roll))
      << calibration::parameter_names(outlook.determinable);
  EXPECT_TRUE(outlook.needs_nominal);
  Progress progress;
  EXPECT_NE(describe(session, report_session(session, progress))
                .find("usable: in part and only with a nominal mounting, for "),
            std::string::npos)
      << describe(session, report_session(session, progress));
  session.nominal_ins_from_lidar = RigidTransform::Identity();
  EXPECT_FALSE(motion_outlook(session).needs_nominal);
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
  drive::Session session = example();
  session.world_from_ins.clear();
  EXPECT_FALSE(report_session(session, progress).usable);
}

// Pairs of an odometry repeat each other: only those that the calibration takes may promise anything.
TEST(session_report, promises_no_more_of_an_arms_poses_than_the_calibration_finds) {
  SKIP_WITHOUT(formats::shared_data() / "ethz");
  const formats::TemporaryFolder folder;
  for (const char* name : {"robot_arm_sim_camera.csv", "robot_arm_sim_hand.csv"})
    std::filesystem::copy_file(formats::shared_data() / "ethz" / name, folder.path() / name);
  Progress progress;
  const SessionReport report = report_session(formats::open_session(folder.path(), progress), progress);
  EXPECT_EQ(calibration::parameter_names(report.outlook.determinable), "y, z, yaw, pitch");
  EXPECT_TRUE(formats::contains(describe({}, report), "usable: in part")) << describe({}, report);
}

drive::Session without_ins(bool lidar, bool gnss, bool wheels) {
  drive::Session session = example();
  session.world_from_ins.clear();
  if (!lidar) session.odometry_from_lidar.clear();
  for (int i = 0; i < 100; ++i) {
    const std::int64_t stamp_ns = i * 100'000'000LL;
    if (gnss) session.gnss.push_back({stamp_ns, 0.8 + 1e-7 * i, 0.1, 100.0, 1e-4 * Eigen::Matrix3d::Identity()});
    if (!wheels) continue;
    session.wheels.emplace_back().stamp_ns = stamp_ns;
    session.imu.emplace_back().stamp_ns = stamp_ns;
  }
  return session;
}

TEST(session_report, names_the_methods_that_a_session_serves_and_what_the_others_lack) {
  Progress progress;
  const auto said = [&](const drive::Session& session) { return describe(session, report_session(session, progress)); };
  const auto usable = [&](const drive::Session& session) { return report_session(session, progress).usable; };
  const drive::Session track = without_ins(false, true, false), fixes = without_ins(true, true, false),
                       log = without_ins(false, true, true), lidar = without_ins(true, false, false);
  EXPECT_FALSE(usable(track)) << "nothing to calibrate: " << said(track);
  EXPECT_TRUE(formats::contains(said(track), "methods that its streams serve: none\n")) << said(track);
  EXPECT_TRUE(formats::contains(said(track), "[no-lidar]")) << said(track);
  EXPECT_TRUE(usable(fixes));
  EXPECT_TRUE(formats::contains(said(fixes),
                                "usable: not by the default method, pairwise; with --method: trajectory (the "
                                "antenna's lever arm alone)\n"))
      << said(fixes);
  EXPECT_TRUE(formats::contains(said(fixes), "    not pairwise: it holds no motion of an INS with attitude\n"))
      << said(fixes);
  EXPECT_TRUE(formats::contains(said(log), "with --method: vehicle-frame (the antenna's place alone)\n")) << said(log);
  EXPECT_FALSE(usable(lidar));
  EXPECT_TRUE(formats::contains(said(lidar), "usable: no, unless it is a recording of an excavator (--method slew)\n"))
      << said(lidar);
  EXPECT_TRUE(formats::contains(said(example()), "methods that its streams serve: pairwise, trajectory, slew if"))
      << said(example());
}

// An angle of which the sigma that is foreseen lies at the limit comes out either way.
TEST(session_report, what_lies_close_to_the_limit_is_neither_promised_nor_denied) {
  drive::Session session = example(0, RoadKind::Hilly);
  int open = 0, sure = 0;
  bool was_sure = false;
  for (double tilt = 0.002; tilt < 0.3; tilt *= 1.25) {
    for (std::size_t i = 0; i < session.world_from_ins.size(); ++i) {
      const double time_s = 0.01 * static_cast<double>(i);
      session.world_from_ins[i].pose.linear() = rotation_from_yaw_pitch_roll(
          {std::sin(0.8 * time_s), tilt * std::sin(1.3 * time_s), tilt * std::cos(1.1 * time_s)});
    }
    const MotionOutlook outlook = motion_outlook(session);
    open += outlook.open.contains(calibration::Parameter::Z);
    sure +=
        outlook.determinable.contains(calibration::Parameter::Z) && !outlook.open.contains(calibration::Parameter::Z);
    EXPECT_FALSE(was_sure && !outlook.determinable.contains(calibration::Parameter::Z))
        << "more tilt tells more: " << tilt;
    was_sure =
        outlook.determinable.contains(calibration::Parameter::Z) && !outlook.open.contains(calibration::Parameter::Z);
    if (!outlook.open.contains(calibration::Parameter::Z)) continue;
    Progress progress;
    const std::string said = describe(session, report_session(session, progress));
    EXPECT_TRUE(formats::contains(said, "perhaps: z")) << said;
    EXPECT_TRUE(formats::contains(said, "; perhaps z\n")) << said;
  }
  EXPECT_GT(open, 0);
  EXPECT_GT(sure, 0);
}

TEST(session_report, a_single_gap_is_one_gap) {
  drive::Session session = example();
  session.odometry_from_lidar.erase(session.odometry_from_lidar.begin() + 20, session.odometry_from_lidar.begin() + 30);
  Progress progress;
  const std::string said = describe(session, report_session(session, progress));
  EXPECT_TRUE(formats::contains(said, "1 gap, the longest")) << said;
}

TEST(session_report, times_are_utc) {
  EXPECT_EQ(formats::utc_text(1317042171951000000LL), "2011-09-26 13:02:51.951 UTC");
  EXPECT_EQ(formats::utc_text(-1), "1969-12-31 23:59:59.999 UTC");
}

}  // namespace
}  // namespace remount::overview
