#include "model/formats/ins/sbf_file.h"

#include <gtest/gtest.h>

#include <GeographicLib/Geocentric.hpp>
#include <chrono>
#include <cmath>

#include "algorithms/geometry/rotation.h"
#include "model/formats/files/time_stamp.h"
#include "model/formats/ins/sbf_blocks.h"
#include "model/formats/sessions/gnss_log_reader.h"
#include "tests/model/formats/ins/sbf_records.h"
#include "tests/model/formats/reader_fixtures.h"
#include "tests/model/formats/temporary_folder.h"
#include "tests/support/sanitized.h"

namespace remount::formats {
namespace {

using namespace sbf;

class sbf_file : public ::testing::Test {
 protected:
  InsLog read(const std::string& bytes) {
    findings_.clear();
    return recognised_and_read("drive.sbf", bytes, recognise_sbf, read_sbf, findings_);
  }
  std::string said(const std::string& code) const { return testing::said_of(findings_, code); }
  TemporaryFolder folder_;
  std::vector<drive::Finding> findings_;
};

TEST_F(sbf_file, checksums_are_those_of_xmodem) {
  EXPECT_EQ(sbf_crc16("123456789"), 0x31C3);
  EXPECT_EQ(sbf_crc16("123456789"), sbf::crc("123456789"));
}

// Heading clockwise from north, pitch nose up, roll right side down; x forward, y left, z up.
TEST_F(sbf_file, an_attitude_that_is_known_points_where_it_does) {
  const InsLog log = read(InsRecord{.seconds = 44'818.0, .angles = {90.0F, 0.0F, 0.0F}}.bytes() +
                          InsRecord{.seconds = 44'818.1, .angles = {0.0F, 10.0F, 0.0F}}.bytes() +
                          InsRecord{.seconds = 44'818.2, .angles = {0.0F, 0.0F, 20.0F}}.bytes());
  ASSERT_EQ(log.ins.size(), 3U);
  EXPECT_EQ(log.axes, drive::InsAxes::ForwardLeftUp);
  EXPECT_TRUE(log.stamps_from_gps);
  const auto axis = [&](std::size_t i, const Eigen::Vector3d& of) { return (log.ins[i].enu_from_ins * of).eval(); };
  EXPECT_LT((axis(0, Eigen::Vector3d::UnitX()) - Eigen::Vector3d::UnitX()).norm(), 1e-7) << "heads east";
  EXPECT_NEAR(axis(1, Eigen::Vector3d::UnitX()).z(), std::sin(degrees_to_radians(10.0)), 1e-7) << "nose up";
  EXPECT_NEAR(axis(1, Eigen::Vector3d::UnitX()).y(), std::cos(degrees_to_radians(10.0)), 1e-7) << "heads north";
  EXPECT_NEAR(axis(2, Eigen::Vector3d::UnitY()).z(), std::sin(degrees_to_radians(20.0)), 1e-7) << "right side down";
  const motion::InsSample& sample = log.ins[0];
  EXPECT_EQ(sample.latitude_rad, 0.9);
  EXPECT_EQ(sample.height_m, 310.0) << "above the ellipsoid, without the undulation";
  EXPECT_EQ(sample.stamp_ns, *unix_ns_from_gps_week(kSbfWeek, std::int64_t{44'818'000} * 1'000'000));
  EXPECT_LT((sample.sigma.position_enu_m - Eigen::Vector3d(0.02, 0.01, 0.03)).norm(), 1e-8) << "latitude comes first";
  EXPECT_LT((sample.sigma.attitude_rad - degrees_to_radians(0.1) * Eigen::Vector3d(1, 2, 3)).norm(), 1e-8);
  EXPECT_EQ(sample.quality, motion::InsQuality::Good);
  EXPECT_EQ(said("ins-log-chosen"), "") << "there was nothing to choose";
}

TEST_F(sbf_file, sub_blocks_that_are_not_there_say_nothing) {
  const InsLog log =
      read(InsRecord{.sigma = {}, .angle_sigma = {}}.bytes() +
           InsRecord{.seconds = 44'818.1, .mode = 0, .sigma = {kDoNotUse, kDoNotUse, kDoNotUse}}.bytes() +
           InsRecord{.seconds = 44'818.2, .error = 28}.bytes());
  ASSERT_EQ(log.ins.size(), 3U);
  EXPECT_TRUE(log.ins[0].sigma.position_enu_m.array().isNaN().all());
  EXPECT_TRUE(log.ins[0].sigma.attitude_rad.array().isNaN().all());
  EXPECT_TRUE(log.ins[1].sigma.position_enu_m.array().isNaN().all());
  EXPECT_NEAR(log.ins[1].sigma.attitude_rad.z(), degrees_to_radians(0.3), 1e-8);
  EXPECT_EQ(log.ins[1].quality, motion::InsQuality::Degraded) << "of the IMU alone";
  EXPECT_EQ(log.ins[2].quality, motion::InsQuality::Invalid);
}

TEST_F(sbf_file, earth_centred_positions_are_the_same_place) {
  InsRecord record{.cartesian = true, .with_covariance = true, .sigma = {0.02F, 0.02F, 0.02F}};
  GeographicLib::Geocentric::WGS84().Forward(radians_to_degrees(0.9), radians_to_degrees(0.16), 310.0, record.place[0],
                                             record.place[1], record.place[2]);
  const InsLog log = read(record.bytes());
  ASSERT_EQ(log.ins.size(), 1U);
  EXPECT_NEAR(log.ins[0].latitude_rad, 0.9, 1e-12);
  EXPECT_NEAR(log.ins[0].longitude_rad, 0.16, 1e-12);
  EXPECT_NEAR(log.ins[0].height_m, 310.0, 1e-6);
  EXPECT_LT((log.ins[0].sigma.position_enu_m - Eigen::Vector3d::Constant(0.02)).norm(), 1e-7);
}

TEST_F(sbf_file, errors_along_the_axes_of_the_earth_become_those_of_height_and_plane) {
  // 1 cm in the plane and 5 cm in height, at 60 degrees north and 90 east: y is up and east is -x.
  constexpr double kUp2 = 0.0025, kPlane2 = 0.0001, kSin2 = 0.75, kCos2 = 0.25, kSinCos = 0.4330127018922193;
  InsRecord record{.cartesian = true,
                   .with_covariance = true,
                   .covariances = {0.0F, 0.0F, static_cast<float>((kUp2 - kPlane2) * kSinCos)},
                   .sigma = {0.01F, static_cast<float>(std::sqrt(kUp2 * kCos2 + kPlane2 * kSin2)),
                             static_cast<float>(std::sqrt(kUp2 * kSin2 + kPlane2 * kCos2))}};
  GeographicLib::Geocentric::WGS84().Forward(60.0, 90.0, 100.0, record.place[0], record.place[1], record.place[2]);
  const InsLog log = read(record.bytes());
  ASSERT_EQ(log.ins.size(), 1U);
  EXPECT_LT((log.ins[0].sigma.position_enu_m - Eigen::Vector3d(0.01, 0.01, 0.05)).norm(), 1e-5)
      << log.ins[0].sigma.position_enu_m.transpose();
  record.with_covariance = false;
  const InsLog without = read(record.bytes());
  ASSERT_EQ(without.ins.size(), 1U);
  EXPECT_TRUE(without.ins[0].sigma.position_enu_m.array().isNaN().all()) << "what they have in common is not told";
}

TEST_F(sbf_file, what_has_no_solution_and_events_are_no_samples) {
  InsRecord without{.seconds = 44'818.1, .error = 24, .angles = {kDoNotUse, kDoNotUse, kDoNotUse}};
  for (double& value : without.place) value = -2e10;
  InsRecord no_attitude{.seconds = 44'818.2, .angles = {}};
  InsRecord event{.seconds = 44'818.3, .id = 4230};
  const std::string bytes = "noise$@" + InsRecord{}.bytes() + without.bytes() + no_attitude.bytes() + event.bytes();
  EXPECT_EQ(read(bytes).ins.size(), 1U);
  EXPECT_TRUE(contains(said("bad-ins"), "1 record cannot be used")) << said("bad-ins");
  EXPECT_TRUE(contains(said("bad-ins"), "heading, pitch or roll is marked as not there")) << said("bad-ins");
  const std::string told = said("ins-log-chosen");
  EXPECT_TRUE(contains(told, "1 log of it was written while the INS had no solution")) << told;
  EXPECT_TRUE(contains(told, "Not used: ExtEventINSNavGeod (1).")) << told;
  EXPECT_TRUE(contains(told, "7 bytes belong to none of its blocks.")) << told;
}

TEST_F(sbf_file, antennas_give_attitudes_at_the_positions_of_their_times) {
  std::string bytes;
  for (int i = 0; i < 10; ++i) {
    const double t = 44'818.0 + 0.1 * i;
    bytes += pvt_geodetic(t, i < 8 ? 4 : 5) + pos_cov_geodetic(t) + att_euler(t, 90.0F, 5.0F, -3.0F, i == 7 ? 3 : 4) +
             att_cov_euler(t);
  }
  bytes += pvt_geodetic(44'820.0) + att_euler(44'820.1, 90.0F, 5.0F, -3.0F) + pvt_geodetic(44'820.2, 0);
  const InsLog log = read(bytes);
  ASSERT_EQ(log.ins.size(), 10U) << "one position and one attitude have no other of their time";
  EXPECT_LT((log.ins[0].sigma.position_enu_m - Eigen::Vector3d(0.02, 0.01, 0.03)).norm(), 1e-8);
  EXPECT_LT((log.ins[0].sigma.attitude_rad - degrees_to_radians(0.1) * Eigen::Vector3d(1, 2, 3)).norm(), 1e-8);
  EXPECT_NEAR((log.ins[0].enu_from_ins * Eigen::Vector3d::UnitX()).z(), std::sin(degrees_to_radians(5.0)), 1e-7);
  EXPECT_EQ(log.ins[0].quality, motion::InsQuality::Good);
  EXPECT_EQ(log.ins[9].quality, motion::InsQuality::Degraded) << "not fixed";
  EXPECT_EQ(log.ins[7].quality, motion::InsQuality::Degraded) << "not fixed between the antennas";
  EXPECT_EQ(said("roll-assumed"), "");
}

TEST_F(sbf_file, two_antennas_tell_no_roll) {
  std::string bytes;
  for (int i = 0; i < 3; ++i)
    bytes +=
        pvt_geodetic(44'818.0 + 0.1 * i) + att_euler(44'818.0 + 0.1 * i, 90.0F, 5.0F, i == 0 ? kDoNotUse : 0.0F, 2);
  const InsLog log = read(bytes);
  ASSERT_EQ(log.ins.size(), 3U);
  for (const motion::InsSample& sample : log.ins) {
    EXPECT_NEAR(radians_to_degrees(sample.sigma.attitude_rad.x()), 3.0, 0.01);
    EXPECT_NEAR(radians_to_degrees(sample.sigma.attitude_rad.y()), 0.5, 0.01);
    EXPECT_NEAR(radians_to_degrees(sample.sigma.attitude_rad.z()), 0.5, 0.01);
    EXPECT_EQ(sample.quality, motion::InsQuality::Good);
  }
  EXPECT_NEAR(log.ins[0].sigma.position_enu_m.z(), 0.3, 1e-9) << "by the position's own accuracy, of two sigma";
  EXPECT_NEAR(log.ins[0].sigma.position_enu_m.x(), 0.2 / std::sqrt(2.0), 1e-9);
  EXPECT_TRUE(contains(said("roll-assumed"), "(AttEuler)")) << said("roll-assumed");
}

TEST_F(sbf_file, positions_alone_are_fixes) {
  std::string bytes;
  for (int i = 0; i < 5; ++i) bytes += pvt_geodetic(44'818.0 + i) + (i < 3 ? pos_cov_geodetic(44'818.0 + i) : "");
  const auto path = folder_.write("a.sbf", bytes + pvt_geodetic(44'830.0, 0));
  const std::vector<motion::GnssFix> fixes = read_gnss(path, findings_);
  ASSERT_EQ(fixes.size(), 5U);
  EXPECT_NEAR(fixes[0].covariance_enu_m2(1, 1), 1e-4, 1e-9) << "north";
  EXPECT_NEAR(fixes[0].covariance_enu_m2(0, 1), 1e-5, 1e-9);
  EXPECT_NEAR(fixes[4].covariance_enu_m2(2, 2), 0.09, 1e-9);
  EXPECT_TRUE(contains(said("ins-log-chosen"), "the 5 fixes of PVTGeodetic")) << said("ins-log-chosen");
  EXPECT_ERROR(open(path), "holds 5 positions (PVTGeodetic) and no attitude of the same times");
}

TEST_F(sbf_file, broken_blocks_are_counted) {
  const std::string good = InsRecord{}.bytes();
  std::string flipped = InsRecord{.seconds = 44'818.1}.bytes();
  flipped[30] = static_cast<char>(flipped[30] ^ 1);
  const std::string cut = good.substr(0, good.size() - 4), short_block = block(4226, 44'818.2, std::string(20, '\0'));
  EXPECT_EQ(read(good + flipped + short_block + good + cut).ins.size(), 1U) << "of one stamp";
  EXPECT_TRUE(contains(said("ins-log-chosen"), "2 blocks are cut or have a wrong checksum")) << said("ins-log-chosen");
  EXPECT_TRUE(contains(said("bad-ins"), "the body has 36 bytes, expected")) << said("bad-ins");
  InsRecord far{};
  far.place[0] = 2.0;
  const auto none = folder_.write("none.sbf", far.bytes());
  EXPECT_ERROR(open(none), "holds no solution of an INS (INSNavGeod, INSNavCart) and no position (PVTGeodetic)");
}

// The greatest length behind every mark, and blocks behind it.
TEST_F(sbf_file, hostile_lengths_cost_no_more_than_the_bytes) {
  constexpr std::size_t kBytes = testing::kSanitized ? 200'000 : 2'000'000;
  std::string hostile;
  while (hostile.size() < kBytes) hostile += std::string("$@\x00\x00\x01\x00\xfc\xff", 8);
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(read(InsRecord{}.bytes() + hostile + InsRecord{.seconds = 44'818.1}.bytes()).ins.size(), 2U);
  const double taken_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::printf("%.1f MB of beginnings: %.3f s\n", 1e-6 * static_cast<double>(hostile.size()), taken_s);
  EXPECT_LT(taken_s, 5.0 * testing::kSanitizerSlowdown);
}

}  // namespace
}  // namespace remount::formats
