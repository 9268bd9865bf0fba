#include "model/formats/ins/sbet_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "algorithms/geometry/rotation.h"
#include "algorithms/messages/render.h"
#include "model/formats/files/time_stamp.h"
#include "tests/model/formats/reader_fixtures.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::formats {
namespace {

std::string bytes_of_doubles(std::initializer_list<double> values) {
  return {reinterpret_cast<const char*>(values.begin()), values.size() * sizeof(double)};
}

struct SbetLine {
  double time_s = 1000.0;
  double latitude_deg = 48.0, longitude_deg = 9.0, height_m = 300.0;
  double roll_deg = 0.0, pitch_deg = 0.0, platform_heading_deg = 0.0, wander_deg = 0.0;
};

std::string sbet_line(const SbetLine& line) {
  const auto rad = [](double deg) { return degrees_to_radians(deg); };
  return bytes_of_doubles({line.time_s, rad(line.latitude_deg), rad(line.longitude_deg), line.height_m, 1.0, 2.0, 3.0,
                           rad(line.roll_deg), rad(line.pitch_deg), rad(line.platform_heading_deg),
                           rad(line.wander_deg), 0.1, 0.2, 9.8, 0.01, 0.02, 0.03});
}

std::string smrmsg_line(double time_s, double north_m, double heading_arcmin) {
  return bytes_of_doubles({time_s, north_m, 0.02, 0.03, 0.001, 0.002, 0.003, 0.5, 0.6, heading_arcmin});
}

InsLog read_lines(const TemporaryFolder& folder, std::initializer_list<SbetLine> lines,
                  std::vector<drive::Finding>& findings) {
  std::string bytes;
  for (const SbetLine& line : lines) bytes += sbet_line(line);
  const auto path = folder.write("sbet_a.out", bytes);
  EXPECT_TRUE(recognise_sbet(path));
  return read_sbet(path, findings);
}

// The body is forward-right-down of north-east-down in the file, and forward-left-up of east-north-up here.
TEST(sbet_file, attitudes_are_those_of_an_aircraft_and_headings_less_the_wander_angle) {
  const TemporaryFolder folder;
  std::vector<drive::Finding> findings;
  const InsLog log = read_lines(
      folder,
      {{.time_s = 1.0, .platform_heading_deg = 90.0},                       // ahead to the east
       {.time_s = 2.0, .platform_heading_deg = 120.0, .wander_deg = 30.0},  // the same
       {.time_s = 3.0, .pitch_deg = 10.0},                                  // north, nose up
       {.time_s = 4.0, .roll_deg = 20.0},                                   // north, right side down
       {.time_s = 5.0, .roll_deg = 20.0, .pitch_deg = 10.0, .platform_heading_deg = 400.0, .wander_deg = -300.0}},
      findings);
  ASSERT_EQ(log.ins.size(), 5U);
  EXPECT_EQ(log.axes, drive::InsAxes::ForwardLeftUp);
  const auto ahead = [&](std::size_t i) { return log.ins[i].enu_from_ins * Eigen::Vector3d::UnitX(); };
  const auto left = [&](std::size_t i) { return log.ins[i].enu_from_ins * Eigen::Vector3d::UnitY(); };
  const auto up = [&](std::size_t i) { return log.ins[i].enu_from_ins * Eigen::Vector3d::UnitZ(); };
  for (const std::size_t i : {0U, 1U}) {
    EXPECT_LT((ahead(i) - Eigen::Vector3d::UnitX()).norm(), 1e-12) << i;
    EXPECT_LT((left(i) - Eigen::Vector3d::UnitY()).norm(), 1e-12) << i;
    EXPECT_LT((up(i) - Eigen::Vector3d::UnitZ()).norm(), 1e-12) << i;
  }
  EXPECT_NEAR(ahead(2).y(), std::cos(degrees_to_radians(10.0)), 1e-12);
  EXPECT_NEAR(ahead(2).z(), std::sin(degrees_to_radians(10.0)), 1e-12) << "nose up";
  EXPECT_NEAR(left(3).z(), std::sin(degrees_to_radians(20.0)), 1e-12) << "left side up";
  // Rz(heading) Ry(pitch) Rx(roll) of NED and FRD, turned into the axes used here.
  const Eigen::Matrix3d ned_from_frd = (Eigen::AngleAxisd(degrees_to_radians(700.0), Eigen::Vector3d::UnitZ()) *
                                        Eigen::AngleAxisd(degrees_to_radians(10.0), Eigen::Vector3d::UnitY()) *
                                        Eigen::AngleAxisd(degrees_to_radians(20.0), Eigen::Vector3d::UnitX()))
                                           .toRotationMatrix();
  Eigen::Matrix3d enu_from_ned, frd_from_flu;
  enu_from_ned << 0, 1, 0, 1, 0, 0, 0, 0, -1;
  frd_from_flu << 1, 0, 0, 0, -1, 0, 0, 0, -1;
  const double off = (log.ins[4].enu_from_ins.toRotationMatrix() - enu_from_ned * ned_from_frd * frd_from_flu).norm();
  EXPECT_LT(off, 1e-12);
  std::printf("all three angles at once: off by %.2g\n", off);
}

TEST(sbet_file, places_heights_and_times_are_as_they_stand) {
  const TemporaryFolder folder;
  std::vector<drive::Finding> findings;
  const InsLog log = read_lines(folder,
                                {{.time_s = 345'600.005, .latitude_deg = -33.5, .longitude_deg = 151.25},
                                 {.time_s = 345'600.010, .latitude_deg = -33.5, .longitude_deg = 151.25}},
                                findings);
  ASSERT_EQ(log.ins.size(), 2U);
  EXPECT_TRUE(log.week_open && log.stamps_from_gps);
  EXPECT_EQ(log.ins[0].stamp_ns, *unix_ns_from_gps_week(0, 345'600'005'000'000)) << "in the first week of GPS";
  EXPECT_EQ(log.ins[1].stamp_ns - log.ins[0].stamp_ns, 5'000'000);
  EXPECT_NEAR(radians_to_degrees(log.ins[0].latitude_rad), -33.5, 1e-12);
  EXPECT_NEAR(radians_to_degrees(log.ins[0].longitude_rad), 151.25, 1e-12);
  EXPECT_EQ(log.ins[0].height_m, 300.0);
  EXPECT_EQ(log.ins[0].quality, motion::InsQuality::Unknown);
  EXPECT_TRUE(std::isnan(log.ins[0].sigma.position_enu_m.x())) << "nobody has said";
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_TRUE(contains(english(findings[0].explanation), "No errors are known")) << english(findings[0].explanation);
}

TEST(sbet_file, errors_stand_in_the_file_beside_it) {
  const TemporaryFolder folder;
  folder.write("smrmsg_a.out", smrmsg_line(1.0, 0.01, 6.0) + smrmsg_line(2.0, 0.05, 12.0));
  std::vector<drive::Finding> findings;
  const InsLog log = read_lines(folder, {{.time_s = 1.1}, {.time_s = 1.9}, {.time_s = 9.0}}, findings);
  ASSERT_EQ(log.ins.size(), 3U);
  ASSERT_EQ(log.files.size(), 2U);
  EXPECT_EQ(log.ins[0].sigma.position_enu_m, Eigen::Vector3d(0.02, 0.01, 0.03)) << "east, north, up";
  EXPECT_EQ(log.ins[1].sigma.position_enu_m.y(), 0.05) << "the nearest";
  EXPECT_NEAR(radians_to_degrees(log.ins[0].sigma.attitude_rad.x()), 0.5 / 60.0, 1e-12) << "minutes of arc about x";
  EXPECT_NEAR(radians_to_degrees(log.ins[0].sigma.attitude_rad.y()), 0.6 / 60.0, 1e-12);
  EXPECT_NEAR(radians_to_degrees(log.ins[0].sigma.attitude_rad.z()), 0.1, 1e-12) << "heading";
  EXPECT_TRUE(std::isnan(log.ins[2].sigma.position_enu_m.x())) << "7 s away";
  testing::expect_told(findings, "ins-log-chosen", "smrmsg_a.out, the nearest in time: 2 of 3 samples");
}

TEST(sbet_file, of_several_files_of_errors_the_one_of_its_name_is_taken) {
  const TemporaryFolder folder;
  folder.write("SMRMSG_A.out", smrmsg_line(1.0, 0.01, 6.0) + smrmsg_line(2.0, 0.01, 6.0));
  const auto other = folder.write("smrmsg_b.out", smrmsg_line(1.0, 0.5, 6.0) + smrmsg_line(2.0, 0.5, 6.0));
  EXPECT_TRUE(recognise_smrmsg(other));
  EXPECT_FALSE(recognise_sbet(other));
  std::vector<drive::Finding> findings;
  EXPECT_EQ(read_lines(folder, {{.time_s = 1.0}, {.time_s = 2.0}}, findings).ins[0].sigma.position_enu_m.y(), 0.01);
  folder.write("SMRMSG_A.out", "");
  folder.write("smrmsg_c.out", smrmsg_line(1.0, 0.5, 6.0) + smrmsg_line(2.0, 0.5, 6.0));
  EXPECT_TRUE(
      std::isnan(read_lines(folder, {{.time_s = 1.0}, {.time_s = 2.0}}, findings).ins[0].sigma.position_enu_m.y()))
      << "of two others none";
}

TEST(sbet_file, a_week_that_ends_within_it_goes_on) {
  const TemporaryFolder folder;
  for (const double behind_s : {604'801.0, 1.0}) {
    std::vector<drive::Finding> findings;
    const InsLog log = read_lines(
        folder, {{.time_s = 604'798.0}, {.time_s = 604'799.5}, {.time_s = behind_s}, {.time_s = behind_s + 1.0}},
        findings);
    ASSERT_EQ(log.ins.size(), 4U) << behind_s;
    EXPECT_EQ(log.ins[2].stamp_ns - log.ins[1].stamp_ns, 1'500'000'000) << behind_s;
  }
}

TEST(sbet_file, broken_records_are_left_out_and_counted) {
  const TemporaryFolder folder;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::string bytes;
  for (int i = 0; i < 20; ++i) {
    SbetLine line{.time_s = 100.0 + i};
    if (i == 12) line.latitude_deg = 5000.0;
    if (i == 13) line.roll_deg = nan;
    if (i == 14) line.time_s = nan;
    if (i == 15) line.time_s = 0.0;  // would be the next week
    bytes += sbet_line(line);
  }
  std::vector<drive::Finding> findings;
  const InsLog log = read_sbet(folder.write("a.out", bytes + bytes.substr(0, 100)), findings);
  EXPECT_EQ(log.ins.size(), 16U);
  EXPECT_EQ(log.ins.back().stamp_ns - log.ins.front().stamp_ns, 19'000'000'000);
  testing::expect_told(findings, "bad-ins", "3 records cannot be used");
  testing::expect_told(findings, "bad-ins", "a.out, byte 1632: latitude, longitude or height is not possible");
  testing::expect_told(findings, "log-cut", "within a record of 136 bytes, of which 100 bytes are there");
}

TEST(sbet_file, a_broken_time_does_not_end_the_week) {
  const TemporaryFolder folder;
  std::vector<drive::Finding> findings;
  std::string bytes;
  for (const double time_s : {1000.0, 1001.0, 604'000.0, 1002.0, 1003.0}) bytes += sbet_line({.time_s = time_s});
  const InsLog log = read_sbet(folder.write("a.out", bytes), findings);
  ASSERT_EQ(log.ins.size(), 4U);
  EXPECT_EQ(log.ins.back().stamp_ns - log.ins.front().stamp_ns, 3'000'000'000);
  testing::expect_told(findings, "bad-ins", "most of a week away from the one before");
}

TEST(sbet_file, what_cannot_be_read_says_what_is_expected) {
  const TemporaryFolder folder;
  std::vector<drive::Finding> findings;
  const auto of_unix = folder.write("unix.out", sbet_line({.time_s = 1.7e9}) + sbet_line({.time_s = 1.7e9 + 1.0}));
  EXPECT_TRUE(recognise_sbet(of_unix)) << "to be refused by name";
  EXPECT_ERROR(read_sbet(of_unix, findings), "Export the SBET with the seconds of the week.");
  EXPECT_ERROR(read_sbet(of_unix, findings), "holds no usable INS sample");
  EXPECT_ERROR(read_sbet(folder.write("none.out", ""), findings), "none.out");
  EXPECT_ERROR(read_sbet(folder.path() / "missing.out", findings), "missing.out");
}

TEST(sbet_file, lists_of_times_are_no_records) {
  const TemporaryFolder folder;
  std::string lines;  // as KITTI has them beside its points
  for (int i = 0; i < 60; ++i) {
    lines += "2011-09-30 12:00:" + std::to_string(10 + i / 10) + "." + std::to_string(i % 10) + "03736000\n";
    const auto path = folder.write("timestamps.txt", lines);
    EXPECT_FALSE(recognise_sbet(path)) << lines.size();
    EXPECT_FALSE(recognise_smrmsg(path)) << lines.size();
  }
}

TEST(sbet_file, is_told_from_what_else_is_binary) {
  const TemporaryFolder folder;
  for (const std::string& bytes :
       {std::string(20 * 136, '\0'), std::string(20 * 136, '\x40'), sbet_line({}), sbet_line({}) + sbet_line({}),
        sbet_line({.time_s = 1.0}) + sbet_line({.time_s = 2.0, .pitch_deg = 95.0}), std::string()}) {
    const auto path = folder.write("a.bin", bytes);
    EXPECT_FALSE(recognise_sbet(path)) << bytes.size();
    EXPECT_FALSE(recognise_smrmsg(path)) << bytes.size();
  }
  EXPECT_FALSE(recognise_sbet(folder.path()));
}

}  // namespace
}  // namespace remount::formats
