#include "model/formats/sessions/smartloc_reader.h"

#include <gtest/gtest.h>

#include <cmath>

#include "algorithms/geometry/rotation.h"
#include "algorithms/messages/render.h"
#include "model/overview/session_report.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::formats {
namespace {

const std::string kOdometry =
    "odom3 0 5.85 0 0 0 0 -0.005 0.0025 0.0009 0.0009 4e-06 4e-06 4e-06   \n"
    "pseudorange3 0 2e7 1 1 2 3 4 1 45 40\n"
    "odom3 0.30000001 6.5 0 0 0 0.25 -0.016 0.0025 0.0009 0.0009 4e-06 4e-06 4e-06\n";
const std::string kPublishedTruth = "point3 0 3785108.1107158 899901.49390314 5037234.4571748 0 0 0 0 0 0 0 0 0\n";

drive::Session open(const std::filesystem::path& path) {
  Progress progress;
  return open_session(path, progress);
}

TEST(smartloc, speed_and_turn_rate_become_wheels_and_imu_and_the_truth_stands_in_for_gnss) {
  const TemporaryFolder folder;
  folder.write("City_GT.txt", kPublishedTruth);
  const drive::Session session = open(folder.write("City_Input.txt", kOdometry));
  EXPECT_EQ(session.format, "smartloc");
  EXPECT_EQ(session.name, "City");
  ASSERT_EQ(session.wheels.size(), 2u);
  EXPECT_EQ(session.wheels[1].stamp_ns, 300'000'010);
  EXPECT_EQ(session.wheels[1].rear_left_mps, 6.5);
  EXPECT_EQ(session.wheels[1].rear_right_mps, 6.5);
  ASSERT_EQ(session.imu.size(), 2u);
  EXPECT_EQ(session.imu[1].angular_rate_radps, Eigen::Vector3d(0, 0.25, -0.016));
  EXPECT_TRUE(session.imu[1].specific_force_mps2.array().isNaN().all());
  ASSERT_EQ(session.gnss.size(), 1u);
  EXPECT_NEAR(radians_to_degrees(session.gnss[0].latitude_rad), 52.508, 0.01) << "Berlin";
  EXPECT_NEAR(radians_to_degrees(session.gnss[0].longitude_rad), 13.37, 0.01);
  EXPECT_EQ(session.files.size(), 2u);
}

TEST(smartloc, a_folder_with_one_drive_is_that_drive) {
  const TemporaryFolder folder;
  folder.write("City_GT.txt", kPublishedTruth);
  folder.write("City_Input.txt", kOdometry);
  folder.write("Other_GT.txt", kPublishedTruth);
  const drive::Session session = open(folder.path());
  EXPECT_EQ(session.format, "smartloc");
  EXPECT_EQ(session.name, "City");
  EXPECT_EQ(session.gnss.size(), 1u);
  folder.write("Other_Input.txt", kOdometry);
  EXPECT_ERROR(open(folder.path()), "holds 2 drives; name one of them, as City_Input.txt");
}

TEST(smartloc, the_truth_may_be_missing_and_damaged_lines_are_named) {
  const TemporaryFolder folder;
  const drive::Session session =
      open(folder.write("City_Input.txt", kOdometry + "odom3 0.5 1 2\nodom3 x 1 0 0 0 0 0\n"));
  EXPECT_TRUE(session.gnss.empty());
  EXPECT_EQ(session.wheels.size(), 2u);
  EXPECT_EQ(session.findings[0].code, "bad-odometry");
  EXPECT_TRUE(contains(english(session.findings[0].explanation), "City_Input.txt:4"))
      << english(session.findings[0].explanation);
  EXPECT_ERROR(open(folder.write("None_Input.txt", "pseudorange3 0 2e7 1 1 2 3 4 1 45 40\n")), "no usable odom3 line");
  folder.write("City_GT.txt", "point3 0 1 2 3 0 0 0 0 0 0 0 0 0\n");
  EXPECT_ERROR(open(folder.path() / "City_Input.txt"), "not near the Earth's surface");
}

TEST(smartloc, recorded_drive_has_speeds_that_agree_with_its_truth) {
  const auto path = shared_data() / "smartloc" / "Berlin_Potsdamer_Platz_Input.txt";
  SKIP_WITHOUT(path);
  const drive::Session session = open(path);
  ASSERT_EQ(session.wheels.size(), 1372u);
  ASSERT_EQ(session.gnss.size(), 1372u);
  constexpr double kRadius_m = 6.38e6;
  double by_wheels_m = 0.0, by_truth_m = 0.0;
  for (std::size_t i = 1; i < session.gnss.size(); ++i) {
    ASSERT_EQ(session.wheels[i].stamp_ns, session.gnss[i].stamp_ns);
    const motion::GnssFix &a = session.gnss[i - 1], &b = session.gnss[i];
    const double step_s = static_cast<double>(b.stamp_ns - a.stamp_ns) * 1e-9;
    by_wheels_m += 0.5 * step_s * (session.wheels[i].rear_left_mps + session.wheels[i - 1].rear_left_mps);
    by_truth_m += kRadius_m * std::hypot(b.latitude_rad - a.latitude_rad,
                                         (b.longitude_rad - a.longitude_rad) * std::cos(a.latitude_rad));
  }
  EXPECT_NEAR(by_wheels_m / by_truth_m, 1.0, 0.02) << by_wheels_m << " m by wheels, " << by_truth_m << " m by truth";
  EXPECT_GT(by_truth_m, 1000.0);
  Progress progress;
  const overview::SessionReport report = overview::report_session(session, progress);
  EXPECT_TRUE(report.usable) << overview::describe(session, report);
  RecordProperty("m by wheels and by truth", std::to_string(by_wheels_m) + ", " + std::to_string(by_truth_m));
}

}  // namespace
}  // namespace remount::formats
