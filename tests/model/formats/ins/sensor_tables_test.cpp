#include "model/formats/ins/sensor_tables.h"

#include <gtest/gtest.h>

#include <cmath>

#include "algorithms/geometry/rotation.h"
#include "algorithms/messages/render.h"
#include "model/formats/session_readers.h"
#include "model/formats/sessions/native_session_reader.h"
#include "model/formats/sessions/native_session_writer.h"
#include "model/overview/session_report.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::formats {
namespace {

constexpr std::int64_t kTableStart = 1'600'000'000'123'456'789;

/// Every stream but the LiDAR's and the INS's.
drive::Session made_session() {
  drive::Session session;
  session.name = "sensors";
  for (int i = 0; i < 50; ++i) {
    const std::int64_t stamp_ns = kTableStart + i * 10'000'001LL;
    session.imu.push_back({stamp_ns, {0.1 / 3.0 * i, -1e-7, 2.0}, {0.01, -0.02 / 7.0, 9.8}});
    Eigen::Matrix3d root = Eigen::Matrix3d::Identity() * 0.02;
    root(1, 0) = 0.001 / 3.0 * i;
    root(2, 0) = -0.004;
    root(2, 1) = 0.007;
    session.gnss.push_back({stamp_ns, 0.8514 + 1.2e-7 * i, -2.1, 250.0 + i / 3.0, root * root.transpose()});
    session.wheels.push_back({stamp_ns, 5.0 + i / 7.0, -0.3});
    session.barometer.push_back({stamp_ns, 251.0 - i / 9.0});
  }
  session.imu[7].specific_force_mps2.setConstant(std::numeric_limits<double>::quiet_NaN());
  return session;
}

template <class Read>
std::string refusal(const TemporaryFolder& folder, std::string_view text, Read&& read) {
  std::vector<drive::Finding> findings;
  const auto path = folder.write("table.csv", text);
  return error_of([&] { read(path, findings); });
}

TEST(sensor_tables, read_back_what_was_written) {
  const TemporaryFolder folder;
  const drive::Session written = made_session();
  Progress progress;
  write_native_session(written, folder.path() / "drive", 1, progress);
  const drive::Session read = open_session(folder.path() / "drive", progress);
  EXPECT_TRUE(read.findings.empty()) << english(read.findings[0].explanation);
  EXPECT_EQ(read.files.size(), 5u);
  ASSERT_EQ(read.imu.size(), 50u);
  ASSERT_EQ(read.gnss.size(), 50u);
  ASSERT_EQ(read.wheels.size(), 50u);
  ASSERT_EQ(read.barometer.size(), 50u);
  for (std::size_t i = 0; i < 50; ++i) {
    EXPECT_EQ(read.imu[i].stamp_ns, written.imu[i].stamp_ns);
    EXPECT_EQ(read.imu[i].angular_rate_radps, written.imu[i].angular_rate_radps);
    if (i != 7) {
      EXPECT_EQ(read.imu[i].specific_force_mps2, written.imu[i].specific_force_mps2);
    }
    EXPECT_EQ(read.gnss[i].stamp_ns, written.gnss[i].stamp_ns);
    EXPECT_NEAR(read.gnss[i].latitude_rad, written.gnss[i].latitude_rad, 1e-15);
    EXPECT_NEAR(read.gnss[i].longitude_rad, written.gnss[i].longitude_rad, 1e-15);
    EXPECT_EQ(read.gnss[i].height_m, written.gnss[i].height_m);
    EXPECT_EQ(read.gnss[i].covariance_enu_m2, written.gnss[i].covariance_enu_m2);
    EXPECT_EQ(read.wheels[i].stamp_ns, written.wheels[i].stamp_ns);
    EXPECT_EQ(read.wheels[i].rear_left_mps, written.wheels[i].rear_left_mps);
    EXPECT_EQ(read.wheels[i].rear_right_mps, written.wheels[i].rear_right_mps);
    EXPECT_EQ(read.barometer[i].stamp_ns, written.barometer[i].stamp_ns);
    EXPECT_EQ(read.barometer[i].height_m, written.barometer[i].height_m);
  }
  EXPECT_TRUE(read.imu[7].specific_force_mps2.array().isNaN().all());
}

TEST(sensor_tables, columns_may_stand_in_any_order_and_forces_and_covariances_may_be_missing) {
  const TemporaryFolder folder;
  std::vector<drive::Finding> findings;
  const auto imu = read_imu_table(
      folder.write("i.csv",
                   "gyro_z_radps,temperature,gyro_y_radps,gyro_x_radps,time_ns\n3,20,2,1,1600000000000000000\n"),
      findings);
  ASSERT_EQ(imu.size(), 1u);
  EXPECT_EQ(imu[0].angular_rate_radps, Eigen::Vector3d(1, 2, 3));
  EXPECT_TRUE(imu[0].specific_force_mps2.array().isNaN().all());
  const auto gnss =
      read_gnss_table(folder.write("g.csv",
                                   "time_ns,latitude_deg,longitude_deg,height_m,var_east_m2,var_north_m2,var_up_m2\n"
                                   "1600000000000000000,48,9,250,1,4,9\n"),
                      findings);
  ASSERT_EQ(gnss.size(), 1u);
  EXPECT_EQ(gnss[0].covariance_enu_m2, Eigen::Matrix3d(Eigen::Vector3d(1, 4, 9).asDiagonal()));
  EXPECT_TRUE(findings.empty());
}

TEST(sensor_tables, damaged_lines_are_named_and_left_out) {
  const TemporaryFolder folder;
  std::vector<drive::Finding> findings;
  const auto path = folder.write("wheels.csv",
                                 "time_ns,rear_left_mps,rear_right_mps\n"
                                 "1600000000000000000,1,2\n1600000000100000000,1\n1600000000200000000,inf,2\n"
                                 "soon,1,2\n1600000000300000000,3,4\n1600000000300000000,3,4\n");
  const auto samples = read_wheel_table(path, findings);
  ASSERT_EQ(samples.size(), 2u);
  EXPECT_EQ(samples[1].rear_right_mps, 4.0);
  ASSERT_EQ(findings.size(), 2u);
  EXPECT_EQ(findings[0].code, "bad-wheels");
  EXPECT_TRUE(contains(english(findings[0].explanation), "wheels.csv:3")) << english(findings[0].explanation);
  EXPECT_EQ(findings[1].code, "wheels-duplicate-stamps");
}

TEST(sensor_tables, a_table_without_a_usable_line_is_refused_with_the_place) {
  const TemporaryFolder folder;
  const std::string gnss = "time_ns,latitude_deg,longitude_deg,height_m,var_east_m2,var_north_m2,var_up_m2";
  EXPECT_TRUE(contains(refusal(folder, "", read_imu_table), "is empty"));
  EXPECT_TRUE(contains(refusal(folder, "time_ns,height\n1,2\n", read_barometer_table), "table.csv:1: has no column"));
  EXPECT_TRUE(
      contains(refusal(folder, "time_ns,height_m\n1,x\n", read_barometer_table), "table.csv:2: height_m is 'x'"));
  EXPECT_TRUE(contains(refusal(folder, gnss + "\n1600000000000000000,98,9,250,1,1,1\n", read_gnss_table),
                       "table.csv:2: latitude, longitude or height is not possible"));
  EXPECT_TRUE(
      contains(refusal(folder, gnss + "\n1600000000000000000,48,9,250,1,0,1\n", read_gnss_table), "positive definite"));
  EXPECT_TRUE(
      contains(refusal(folder, gnss + ",cov_east_up_m2\n1600000000000000000,48,9,250,1,1,1,0\n", read_gnss_table),
               "stand together or not at all"));
  EXPECT_TRUE(contains(refusal(folder, "time_ns,gyro_x_radps,gyro_y_radps,gyro_z_radps\n1,1,nan,1\n", read_imu_table),
                       "table.csv:2"));
}

TEST(sensor_tables, a_session_needs_no_ins_where_other_sensors_tell_its_motion) {
  const TemporaryFolder folder;
  folder.write("s/1600000000.bin", std::string(32, '\x3f'));
  folder.write("s/1600000000.1.bin", std::string(32, '\x3f'));
  folder.write("w.csv", "time_ns,rear_left_mps,rear_right_mps\n1600000000000000000,1,2\n1600000000100000000,1,2\n");
  folder.write(
      "i.csv",
      "time_ns,gyro_x_radps,gyro_y_radps,gyro_z_radps\n1600000000000000000,0,0,0\n1600000000100000000,0,0,0\n");
  const std::string head =
      "format: remount-session/1\nname: x\n"
      "scans: {directory: s, type: kitti-bin, stamps: from-names, timing: instant}\n";
  const auto open = [&](const std::string& manifest) {
    folder.write("session.yaml", manifest);
    Progress progress;
    return open_session(folder.path(), progress);
  };
  EXPECT_TRUE(contains(error_of([&] { open(head); }), "expected either 'ins' or 'ins_poses'"));
  EXPECT_TRUE(contains(error_of([&] { open(head + "wheels: {file: none.csv}\n"); }), "none.csv"));
  EXPECT_TRUE(contains(error_of([&] { open(head + "wheels: {file: w.csv, scale: 2}\n"); }), "session.yaml:4"));
  const drive::Session session = open(head + "wheels: {file: w.csv}\nimu: {file: i.csv}\n");
  EXPECT_TRUE(session.ins.empty());
  EXPECT_EQ(session.scans->size(), 2u);
  Progress progress;
  const overview::SessionReport report = overview::report_session(session, progress);
  EXPECT_TRUE(report.usable) << overview::describe(session, report);
  const std::string text = overview::describe(session, report);
  EXPECT_TRUE(contains(text, "  IMU: 2, 2020-09-13 12:26:40.000 UTC")) << text;
  EXPECT_TRUE(contains(text, "  wheels: 2,")) << text;
  EXPECT_TRUE(contains(text, "no INS motion: only methods")) << text;
  EXPECT_FALSE(contains(text, "barometer")) << text;
  const drive::Session wheels_only = open(head + "wheels: {file: w.csv}\n");
  EXPECT_FALSE(overview::report_session(wheels_only, progress).usable);
}

}  // namespace
}  // namespace remount::formats
