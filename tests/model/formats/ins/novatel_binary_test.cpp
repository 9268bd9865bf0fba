// NovAtel's binary logs: layouts, headers, and what stands among them.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "algorithms/geometry/rotation.h"
#include "model/formats/ins/novatel_log.h"
#include "tests/model/formats/ins/novatel_records.h"
#include "tests/model/formats/reader_fixtures.h"
#include "tests/model/formats/temporary_folder.h"
#include "tests/support/sanitized.h"

namespace remount::formats {
namespace {

using namespace novatel;

class novatel_binary : public ::testing::Test {
 protected:
  std::vector<motion::InsSample> read(const std::string& bytes) {
    findings_.clear();
    const auto path = folder_.write("a.gps", bytes);
    EXPECT_EQ(recognise_novatel(path), NovatelFormat::Log);
    return read_novatel(path, NovatelFormat::Log, findings_).ins;
  }
  std::string said(const std::string& code) const { return testing::said_of(findings_, code); }
  TemporaryFolder folder_;
  std::vector<drive::Finding> findings_;
};

void expect_alike(const motion::InsSample& read, const motion::InsSample& logged, const std::string& what) {
  EXPECT_EQ(read.stamp_ns, logged.stamp_ns) << what;
  EXPECT_NEAR(read.latitude_rad, logged.latitude_rad, 1e-15) << what;
  EXPECT_NEAR(read.longitude_rad, logged.longitude_rad, 1e-15) << what;
  EXPECT_NEAR(read.height_m, logged.height_m, 1e-5) << what << ": above the ellipsoid";
  EXPECT_LT(read.enu_from_ins.angularDistance(logged.enu_from_ins), 1e-12) << what;
  EXPECT_EQ(read.quality, logged.quality) << what;
}

TEST_F(novatel_binary, says_what_the_ascii_log_says) {
  const motion::InsSample inspvax = read(inspvaxa(kWeek, 100.5, 87.25)).front();
  const motion::InsSample by_inspvax = read(long_log(1465, 100.5, inspvax_body(87.25))).front();
  expect_alike(by_inspvax, inspvax, "INSPVAX");
  EXPECT_LT((by_inspvax.sigma.position_enu_m - inspvax.sigma.position_enu_m).norm(), 1e-6);
  EXPECT_LT((by_inspvax.sigma.attitude_rad - inspvax.sigma.attitude_rad).norm(), 1e-7);
  expect_alike(read(long_log(507, 100.5, inspva_body(100.5, 87.25))).front(), inspvax, "INSPVA");
  expect_alike(read(long_log(1778, 100.5, inspva_body(100.5, 87.25))).front(), inspvax, "IMURATEPVA");
  expect_alike(read(short_log(508, 100.5, inspva_body(100.5, 87.25))).front(), inspvax, "INSPVAS");
  expect_alike(read(short_log(1305, 100.5, inspva_body(100.5, 87.25))).front(), inspvax, "IMURATEPVAS");
}

// Azimuth clockwise from north, pitch nose up, roll right side down; x right, y forward, z up.
TEST_F(novatel_binary, an_attitude_that_is_known_points_where_it_does) {
  const motion::InsSample sample = read(short_log(508, 100.5, inspva_body(100.5, 90.0))).front();
  const Eigen::Vector3d nose = sample.enu_from_ins * Eigen::Vector3d::UnitY(),
                        right = sample.enu_from_ins * Eigen::Vector3d::UnitX();
  EXPECT_NEAR(nose.x(), std::cos(degrees_to_radians(2.5)), 1e-12) << "heads east";
  EXPECT_NEAR(nose.z(), std::sin(degrees_to_radians(-2.5)), 1e-12) << "pitch is -2.5 deg: the nose is down";
  EXPECT_LT(right.z(), 0.0) << "roll is 1.5 deg: the right side is down";
  EXPECT_LT(right.y(), -0.99) << "the right is south";
}

TEST_F(novatel_binary, the_time_of_inspva_is_the_bodys_and_that_of_inspvax_the_headers) {
  const std::int64_t header_ns = read(long_log(1465, 100.123, inspvax_body(90.0))).front().stamp_ns;
  const std::int64_t body_ns = read(long_log(507, 100.123, inspva_body(100.123456789, 90.0))).front().stamp_ns;
  EXPECT_EQ(body_ns - header_ns, 456'789);
}

TEST_F(novatel_binary, statuses_are_read_by_number) {
  using motion::InsQuality;
  for (const auto& [status, quality] : {std::pair{3U, InsQuality::Good},
                                        {2U, InsQuality::Degraded},
                                        {6U, InsQuality::Degraded},
                                        {7U, InsQuality::Degraded},
                                        {1U, InsQuality::Invalid},
                                        {0U, InsQuality::Invalid},
                                        {8U, InsQuality::Invalid}})
    EXPECT_EQ(read(short_log(508, 100.5, inspva_body(100.5, 90.0, status))).front().quality, quality) << status;
}

TEST_F(novatel_binary, errors_come_from_the_logs_beside_it) {
  for (const bool by_insstdev : {true, false}) {
    std::string bytes;
    for (int i = 0; i < 100; ++i) {
      bytes += short_log(508, 100.0 + 0.02 * i, inspva_body(100.0 + 0.02 * i, 90.0));
      if (i % 50 == 0)
        bytes += by_insstdev ? short_log(2052, 100.0 + 0.02 * i, insstdev_body())
                             : long_log(1465, 100.0 + 0.02 * i, inspvax_body(90.0));
      if (i % 50 == 0) bytes += short_log(1462, 100.0 + 0.02 * i, rawimux_body(100.0 + 0.02 * i));
    }
    const std::vector<motion::InsSample> ins = read(bytes);
    ASSERT_EQ(ins.size(), 100U);
    for (const motion::InsSample& sample : ins) {
      EXPECT_LT((sample.sigma.position_enu_m - Eigen::Vector3d(0.9, 0.8, 1.2)).norm(), 1e-6);
      EXPECT_NEAR(radians_to_degrees(sample.sigma.attitude_rad.y()), 0.5, 1e-6) << "roll is about y";
    }
    EXPECT_EQ(said("ins-log-chosen"), std::string("The INS is taken from INSPVAS (100 samples). Its errors are those "
                                                  "of ") +
                                          (by_insstdev ? "INSSTDEVS" : "INSPVAX") +
                                          ", the nearest in time and not more than 2 s away. The IMU is taken from "
                                          "RAWIMUSX (2 samples, type EPSON_G320).");
  }
}

TEST_F(novatel_binary, what_stands_among_the_logs_is_passed_over_and_counted) {
  std::string bytes = "\x01\x02garbage\xAA\x44[COM1]<OK\r\n$GPGGA,120000.00,,,,,0,,,,,,,,*66\r\n";
  const std::size_t before = bytes.size();
  for (int i = 0; i < 50; ++i) {
    const double time = 100.0 + 0.1 * i;
    bytes += i % 2 == 0 ? short_log(508, time, inspva_body(time, 90.0)) : inspva("INSPVASA", time, 90.0);
    bytes += long_log(42, time, bestpos_body()) + long_log(42, time, bestpos_body(), 1);
    bytes += long_log(9999, time, Body().add(1.0));
  }
  EXPECT_EQ(read(bytes).size(), 50U) << "ASCII and binary";
  EXPECT_EQ(said("bad-ins"), "");
  const std::string told = said("ins-log-chosen");
  EXPECT_TRUE(contains(told, "Not used: BESTPOS (50), BESTPOS_1 (50), ID 9999 (50).")) << told;
  EXPECT_TRUE(contains(told, std::to_string(before) + " bytes belong to none of its logs.")) << told;
}

TEST_F(novatel_binary, broken_logs_are_counted_with_the_place_of_the_first) {
  const std::string good = short_log(508, 100.0, inspva_body(100.0, 90.0));
  std::string flipped = short_log(508, 100.1, inspva_body(100.1, 90.0));
  flipped[40] = static_cast<char>(flipped[40] ^ 1);
  const std::string impossible_week = short_log(508, 100.2, Body(inspva_body(700'000.0, 90.0)));
  const std::string short_body = short_log(508, 100.3, Body().add(1.0));
  const std::string bytes = good + flipped + impossible_week + short_body + good.substr(0, 50);
  EXPECT_EQ(read(bytes).size(), 1U);
  const std::string told = said("bad-ins");
  EXPECT_TRUE(contains(told, "4 logs cannot be used")) << told;
  EXPECT_TRUE(contains(told, "a.gps, byte " + std::to_string(good.size()) + ": the checksum does not agree")) << told;
  EXPECT_EQ(read(flipped.substr(0, 60) + good).size(), 1U) << "a log within what was lost of another";
  EXPECT_TRUE(contains(said("bad-ins"), "1 log cannot")) << said("bad-ins");
  EXPECT_EQ(read(good + good.substr(0, 50)).size(), 1U);
  EXPECT_TRUE(contains(said("bad-ins"), "the recording ends within a log of 104 bytes, of which 50 bytes are there"))
      << said("bad-ins");
  const auto none = folder_.write("none.gps", long_log(140, 100.0, Body().add(1.0)) + flipped);
  EXPECT_ERROR(read_novatel(none, NovatelFormat::Log, findings_), "no usable position (BESTPOS), but RANGECMP (1)");
}

TEST_F(novatel_binary, answers_to_commands_are_no_logs) {
  const std::string answer = long_log(507, 100.0, inspva_body(100.0, 10.0), 0x80);
  const std::vector<motion::InsSample> ins = read(answer + long_log(507, 100.1, inspva_body(100.1, 90.0)));
  ASSERT_EQ(ins.size(), 1U);
  EXPECT_NEAR((ins[0].enu_from_ins * Eigen::Vector3d::UnitY()).x(), 1.0, 1e-3) << "heads east";
}

// What begins like logs of the greatest length on every third byte, and a log behind it.
TEST_F(novatel_binary, hostile_lengths_cost_no_more_than_the_bytes) {
  // What it costs is for the release tests.
  constexpr std::size_t kBytes = testing::kSanitized ? 300'000 : 3'000'000;
  std::string bytes;
  while (bytes.size() < kBytes) bytes += std::string("\xAA\x44\x12\x1c\x8c\x00\x00\xff\xff\xff", 10);
  std::string used;
  while (used.size() < kBytes) used += std::string("\xAA\x44\x13\xff\xfc\x01", 6);
  const std::string good = short_log(508, 100.0, inspva_body(100.0, 90.0));
  for (const std::string& hostile : {bytes, used}) {
    const auto start = std::chrono::steady_clock::now();
    EXPECT_EQ(read(good + hostile + good).size(), 1U) << "of one stamp";
    const double taken_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    std::printf("%.1f MB of beginnings: %.3f s\n", 1e-6 * static_cast<double>(hostile.size()), taken_s);
    EXPECT_LT(taken_s, 10.0 * testing::kSanitizerSlowdown);
  }
}

TEST_F(novatel_binary, a_native_session_names_a_log_without_columns) {
  std::string log;
  for (int i = 0; i < 40; ++i) {
    log += short_log(508, 100.0 + 0.1 * i, inspva_body(100.0 + 0.1 * i, 90.0));
    if (i % 10 == 0) log += long_log(1429, 100.0 + 0.1 * i, bestpos_body());
  }
  log += "\xAA\x44\x13";
  std::string poses;
  for (int i = 0; i < 40; ++i)
    poses += std::to_string(1'636'243'282.0 + 0.1 * i) + " " + std::to_string(i) + " 0 0 0 0 0 1\n";
  folder_.write("d/a.gps", log);
  folder_.write("d/lidar.txt", poses);
  folder_.write("d/session.yaml",
                "format: remount-session/1\nname: d\nlidar_poses: {file: lidar.txt, format: tum}\nclocks: shared\n"
                "ins: {file: a.gps}\ngnss: {file: a.gps}\n");
  const drive::Session session = open(folder_.path() / "d");
  EXPECT_EQ(session.format, "native");
  EXPECT_EQ(session.ins_axes, drive::InsAxes::RightForwardUp);
  EXPECT_EQ(session.ins.size(), 40U);
  EXPECT_EQ(session.gnss.size(), 4U);
  EXPECT_EQ(std::ranges::count(session.findings, std::string("ins-log-chosen"), &drive::Finding::code), 1)
      << "one log that is two streams";
}

TEST_F(novatel_binary, a_log_may_stand_in_two_files_of_a_folder) {
  std::string solution, errors;
  for (int i = 0; i < 40; ++i) solution += short_log(508, 100.0 + 0.1 * i, inspva_body(100.0 + 0.1 * i, 90.0));
  for (int i = 0; i < 5; ++i) errors += long_log(1465, 100.0 + i, inspvax_body(90.0));
  const auto folder = folder_.path() / "d";
  folder_.write("d/b.gps", solution);
  folder_.write("d/a.gps", errors);
  const drive::Session session = open(folder);
  EXPECT_EQ(session.format, "novatel");
  EXPECT_EQ(session.ins_axes, drive::InsAxes::RightForwardUp);
  ASSERT_EQ(session.ins.size(), 40U);
  EXPECT_NEAR(session.ins[20].sigma.position_enu_m.x(), 0.9, 1e-6);
  EXPECT_TRUE(contains(testing::said_of(session.findings, "ins-log-chosen"), "Its errors are those of a.gps"));
  EXPECT_TRUE(contains(testing::said_of(session.findings, "ins-file-chosen"), "no samples are taken from a.gps"));
}

}  // namespace
}  // namespace remount::formats
