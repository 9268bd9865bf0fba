#include <gtest/gtest.h>

#include "algorithms/messages/render.h"
#include "model/checks/builtin.h"
#include "model/formats/session_readers.h"
#include "model/overview/session_report.h"
#include "model/simulator/simulator.h"
#include "tests/model/checks/check_fixture.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::checks {
namespace {

TEST(clock_check, streams_that_do_not_meet_are_named_with_what_is_likely) {
  EXPECT_TRUE(found_by(clock_check(), good_drive()).empty());
  drive::Session leap = good_drive();
  for (motion::StampedPose& pose : leap.odometry_from_lidar) pose.stamp_ns += 18'000'000'000;
  const std::vector<drive::Finding> findings = found_by(clock_check(), leap);
  ASSERT_TRUE(testing::has_code(findings, "clocks-apart"));
  EXPECT_EQ(findings[0].severity, drive::Severity::Problem);
  EXPECT_NE(english(findings[0].explanation).find("likely leap seconds"), std::string::npos)
      << english(findings[0].explanation);
}

TEST(clock_check, a_drive_that_is_longer_than_the_leap_seconds_still_shows_them) {
  simulator::SimulationOptions options;
  options.duration_s = 40.0;
  options.beams = 4;
  options.azimuth_steps = 60;
  simulator::SimulatedDrive drive = simulator::simulate_drive(options);
  EXPECT_TRUE(found_by(clock_check(), drive.session).empty());
  for (motion::InsSample& sample : drive.session.ins) sample.stamp_ns += 18'000'000'000;
  drive.session.imu.clear(), drive.session.gnss.clear(), drive.session.wheels.clear(), drive.session.barometer.clear();
  const formats::TemporaryFolder folder;
  Progress progress;
  simulator::write_drive(drive, folder.path() / "drive", "native", 1, progress);
  const drive::Session session = formats::open_session(folder.path() / "drive", progress);
  const std::string inspected = overview::describe(session, overview::report_session(session, progress));
  EXPECT_NE(inspected.find("[clock-leap-seconds]"), std::string::npos) << inspected;
  EXPECT_NE(inspected.find("GPS time is 18 s ahead of UTC"), std::string::npos) << inspected;
}

TEST(clock_check, a_sensor_on_another_clock_is_named) {
  drive::Session session = good_drive();
  for (int i = 0; i < 1000; ++i) {
    motion::ImuSample sample;
    sample.stamp_ns = session.ins.front().stamp_ns - 315'964'800'000'000'000 + i * 10'000'000LL;
    session.imu.push_back(sample);
    session.wheels.push_back({session.ins.front().stamp_ns + i * 10'000'000LL, 5.0, 5.0});
  }
  const std::vector<drive::Finding> findings = found_by(clock_check(), session);
  ASSERT_EQ(findings.size(), 1U) << "the wheels are on the clock of the INS";
  EXPECT_EQ(findings[0].code, "sensor-clock");
  EXPECT_EQ(drive::english(findings[0].where), "IMU");
  EXPECT_NE(english(findings[0].explanation).find("counts from 1980"), std::string::npos)
      << english(findings[0].explanation);
}

}  // namespace
}  // namespace remount::checks
