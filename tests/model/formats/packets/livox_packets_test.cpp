#include "model/formats/packets/livox_packets.h"

#include <gtest/gtest.h>

#include "algorithms/geometry/rotation.h"
#include "tests/model/formats/packets/capture_sessions.h"
#include "tests/model/formats/packets/livox_bytes.h"
#include "tests/support/findings.h"

namespace remount::formats {
namespace {

using testing::finding_of;
using testing::has_code;
using testing::said_of;

constexpr std::int64_t kLivoxBegins_ns = 1'700'000'000'000'000'000;

std::unique_ptr<PacketDecoder> livox_decoder_of(const std::string& payload) {
  return recognised(payload, "a.pcap: 192.168.1.3:56301");
}

cloud::PointCloud livox_decoded(const std::string& payload, std::int64_t interval_ns = 0) {
  cloud::PointCloud cloud;
  const auto decoder = livox_decoder_of(payload);
  EXPECT_TRUE(decoder && decoder->glance(payload));
  if (!decoder) return cloud;
  decoder->tune({.interval_ns = interval_ns}, "");
  decoder->decode(payload, {0, PacketDecoder::kAllColumns}, {}, cloud);
  EXPECT_TRUE(cloud.ring.empty());
  return cloud;
}

void expect_first(const cloud::PointCloud& cloud, std::size_t size, const Eigen::Vector3d& expected,
                  double tolerance_m = 1e-5) {
  ASSERT_EQ(cloud.size(), size);
  EXPECT_LT((cloud.points[0].cast<double>() - expected).norm(), tolerance_m) << cloud.points[0].transpose();
  EXPECT_EQ(cloud.intensity[0], 77.0f);
}

/// 10 m, 60 degrees down from straight up, 30 to the left.
constexpr LivoxShot kAside{10'000, 6'000, 3'000};
const Eigen::Vector3d kAside_m = 10.0 * Eigen::Vector3d(std::sin(kPi / 3) * std::cos(kPi / 6),
                                                        std::sin(kPi / 3) * std::sin(kPi / 6), std::cos(kPi / 3));

TEST(livox_packets, points_of_the_second_sdk_in_every_layout) {
  const auto packet = [](std::uint8_t type, std::size_t shots, const std::string& points) {
    return sdk2_packet(0, type, 123, 4800, static_cast<std::uint16_t>(shots), points);
  };
  const LivoxShot shot{-1'234, 56'789, -300};
  const cloud::PointCloud fine = livox_decoded(packet(1, 96, repeated(cartesian(shot, 4, true), 96)));
  expect_first(fine, 96, {-1.234, 56.789, -0.3});
  EXPECT_NEAR(fine.time_from_stamp_s[1], 5e-6, 1e-11);
  EXPECT_NEAR(fine.time_from_stamp_s[95], 475e-6, 1e-10);
  expect_first(livox_decoded(packet(2, 40, repeated(cartesian({-123, 4'567, -30}, 2, true), 40))), 40,
               {-1.23, 45.67, -0.3});
  expect_first(livox_decoded(packet(3, 7, repeated(spherical(kAside, true), 7))), 7, kAside_m);
  const std::string two = cartesian(shot, 4, true) + cartesian({1, 2, 3}, 4, true);
  expect_first(livox_decoded(packet(0x11, 48, repeated(two, 48))), 96, {-1.234, 56.789, -0.3});
}

TEST(livox_packets, points_of_the_first_sdk_in_every_layout) {
  const auto packet = [](std::uint8_t type, const std::string& points) {
    return sdk1_packet(0, type, little(123, 8), points);
  };
  const LivoxShot shot{-1'234, 56'789, -300};
  const Eigen::Vector3d shot_m(-1.234, 56.789, -0.3);
  const cloud::PointCloud plain = livox_decoded(packet(0, repeated(cartesian(shot, 4, false), 100)), 1'000'000);
  expect_first(plain, 100, shot_m);
  EXPECT_NEAR(plain.time_from_stamp_s[99], 990e-6, 1e-9) << "100 shots in a millisecond";
  expect_first(livox_decoded(packet(1, repeated(spherical(kAside, false), 100))), 100, kAside_m);
  expect_first(livox_decoded(packet(2, repeated(cartesian(shot, 4, true), 96))), 96, shot_m);
  expect_first(livox_decoded(packet(3, repeated(spherical(kAside, true), 96))), 96, kAside_m);
  const std::string two = cartesian(shot, 4, true) + cartesian({500, 0, 0}, 4, true);
  const cloud::PointCloud both = livox_decoded(packet(4, repeated(two, 48)), 200'000);
  expect_first(both, 96, shot_m);
  EXPECT_EQ(both.time_from_stamp_s[0], both.time_from_stamp_s[1]) << "of one shot";
  EXPECT_NEAR(both.time_from_stamp_s[2], 200e-6 / 48, 1e-10);
  const cloud::PointCloud ranges = livox_decoded(packet(5, repeated(spherical_returns(kAside, {10'000, 20'000}), 48)));
  expect_first(ranges, 96, kAside_m);
  EXPECT_NEAR(ranges.points[1].norm(), 20.0, 1e-5);
  expect_first(livox_decoded(packet(7, repeated(two + cartesian({7, 8, 9}, 4, true), 30))), 90, shot_m);
  expect_first(livox_decoded(packet(8, repeated(spherical_returns(kAside, {10'000, 20'000, 30'000}), 30))), 90,
               kAside_m);
}

TEST(livox_packets, what_is_no_return_or_the_same_again_is_left_out) {
  std::string points = cartesian({0, 0, 0}, 4, true) + cartesian({1'000, 0, 0}, 4, true) +
                       cartesian({2'000'000'000, 0, 0}, 4, true) + repeated(cartesian({0, 0, 0}, 4, true), 93);
  const cloud::PointCloud cloud = livox_decoded(sdk2_packet(0, 1, 0, 4800, 96, points));
  ASSERT_EQ(cloud.size(), 1U);
  EXPECT_NEAR(cloud.time_from_stamp_s[0], 5e-6, 1e-11) << "it is the second shot";
  EXPECT_EQ(cloud.dropped_points, 1U) << "2000 km";
  points = repeated(cartesian({5, 6, 7}, 4, true), 2);
  EXPECT_EQ(livox_decoded(sdk2_packet(0, 0x11, 0, 4800, 48, repeated(points, 48))).size(), 48U);
}

TEST(livox_packets, times_of_every_kind) {
  const auto glance = [](const std::string& payload) { return *livox_decoder_of(payload)->glance(payload); };
  const std::string points = numbered_shots(0, 96);
  const auto date = static_cast<std::uint64_t>(kLivoxBegins_ns) + 12'345'678;
  EXPECT_EQ(glance(sdk2_packet(1, 1, date, 4800, 96, points)).sensor_time_ns, kLivoxBegins_ns + 12'345'678);
  EXPECT_EQ(glance(sdk2_packet(1, 1, date, 4800, 96, points)).first_place, 12'345U);
  EXPECT_TRUE(glance(sdk2_packet(1, 1, date, 4800, 96, points)).clock_follows.value());
  EXPECT_FALSE(glance(sdk2_packet(0, 1, date, 4800, 96, points)).clock_follows.value());
  EXPECT_FALSE(glance(sdk2_packet(1, 1, 5'000'000'000, 4800, 96, points)).clock_follows.value())
      << "a master that has no date itself";
  // 2023-11-14, 22:13:20 UTC.
  const std::string spelt = little(23, 1) + little(11, 1) + little(14, 1) + little(22, 1) + little(800'012'345, 4);
  EXPECT_EQ(glance(sdk1_packet(3, 2, spelt, points)).sensor_time_ns, kLivoxBegins_ns + 12'345'000);
  EXPECT_TRUE(glance(sdk1_packet(3, 2, spelt, points)).clock_follows.value());
  EXPECT_EQ(livox_decoder_of(sdk1_packet(3, 2, little(0, 8), points)), nullptr) << "no such date";
  const std::string pulse = sdk1_packet(4, 2, little(999'999'999, 8), points);
  EXPECT_EQ(glance(pulse).clock_period_s, 1);
  EXPECT_EQ(glance(sdk1_packet(1, 2, little(date, 8), points)).clock_period_s, 0);
  EXPECT_EQ(livox_decoder_of(sdk2_packet(1, 1, ~std::uint64_t{0}, 4800, 96, points)), nullptr) << "the year 2554";
}

TEST(livox_packets, others_are_not_taken_for_them) {
  const std::string good = sdk2_packet(0, 1, 0, 4800, 96, numbered_shots(0, 96));
  const auto with = [](std::string bytes, std::size_t at, int value) {
    bytes[at] = static_cast<char>(value);
    return bytes;
  };
  ASSERT_NE(livox_decoder_of(good), nullptr);
  for (const auto& [at, value] : {std::pair{0, 1}, {1, 1}, {5, 95}, {5, 0}, {10, 0}, {10, 4}})
    EXPECT_EQ(livox_decoder_of(with(good, static_cast<std::size_t>(at), value)), nullptr) << at << " " << value;
  EXPECT_EQ(livox_decoder_of(good.substr(0, good.size() - 1)), nullptr);
  const std::string former = sdk1_packet(0, 2, little(0, 8), numbered_shots(0, 96));
  ASSERT_NE(livox_decoder_of(former), nullptr);
  for (const auto& [at, value] : {std::pair{0, 4}, {8, 2}, {9, 6}, {9, 0}, {9, 9}})
    EXPECT_EQ(livox_decoder_of(with(former, static_cast<std::size_t>(at), value)), nullptr) << at << " " << value;
  EXPECT_EQ(livox_decoder_of(former + "x"), nullptr);
  // Behind a hub several sensors share an address: one is read, the others are not mixed in.
  const auto decoder = livox_decoder_of(former);
  EXPECT_TRUE(decoder->glance(former));
  EXPECT_FALSE(decoder->glance(sdk1_packet(0, 2, little(0, 8), numbered_shots(0, 96), 2)));
}

TEST(livox_packets, scans_are_tenths_of_a_second_of_the_sensor) {
  const drive::Session session =
      scans_of(mid360_drive(1'000, kLivoxBegins_ns + 37'000'000, kLivoxBegins_ns + 37'000'000, 2));
  EXPECT_TRUE(session.findings.empty());
  ASSERT_EQ(session.scans->size(), 4U) << "480 ms, of which the first 63 and the last 17 are no whole tenth";
  for (std::size_t scan = 0; scan < 4; ++scan) {
    const std::int64_t after_ns = session.scans->stamp_ns(scan) - kLivoxBegins_ns - 100'000'000;
    EXPECT_GE(after_ns, static_cast<std::int64_t>(scan) * 100'000'000);
    EXPECT_LT(after_ns, static_cast<std::int64_t>(scan) * 100'000'000 + 480'000);
    const cloud::PointCloud cloud = session.scans->load(scan);
    EXPECT_NEAR(static_cast<double>(cloud.size()), 20'000.0, 96.0);
    EXPECT_EQ(cloud.time_from_stamp_s.front(), 0.0f);
    EXPECT_NEAR(cloud.time_from_stamp_s.back(), 0.1, 5e-4);
    // Which shot it is says its time.
    const double first = 1e3 * static_cast<double>(cloud.points.front().x()) - 1e3;
    EXPECT_NEAR(1e-9 * static_cast<double>(session.scans->stamp_ns(scan) - kLivoxBegins_ns), 0.037 + 5e-6 * first,
                1e-6);
  }
}

TEST(livox_packets, an_imu_at_the_same_port_is_passed_over) {
  std::vector<TimedFrame> frames = mid360_drive(500, kLivoxBegins_ns, kLivoxBegins_ns, 1);
  const auto imu = sdk2_packet(1, 0, static_cast<std::uint64_t>(kLivoxBegins_ns), 0, 1, std::string(24, 'i'));
  frames.push_back({kLivoxBegins_ns + 1, ethernet_udp(imu, {.port = 56301})});
  EXPECT_TRUE(scans_of(frames).findings.empty());
  frames.push_back({kLivoxBegins_ns + 2, ethernet_udp(imu + "x", {.port = 56301})});
  EXPECT_TRUE(contains(said_of(scans_of(frames).findings, "capture-foreign"), "1 datagram is no whole packet"));
}

TEST(livox_packets, packets_of_other_sensors_behind_a_hub_are_no_damage) {
  std::vector<TimedFrame> frames;
  for (std::int64_t i = 0; i < 1'000; ++i)
    for (const std::uint8_t id : {std::uint8_t{1}, std::uint8_t{2}, std::uint8_t{3}})
      frames.push_back(
          {kLivoxBegins_ns + (i + 1) * 400'000,
           ethernet_udp(sdk1_packet(1, 2, little(static_cast<std::uint64_t>(kLivoxBegins_ns + i * 400'000), 8),
                                    numbered_shots(0, 96), id))});
  const drive::Session session = scans_of(frames);
  EXPECT_EQ(session.scans->size(), 4U);
  EXPECT_FALSE(has_code(session.findings, "capture-foreign")) << said_of(session.findings, "capture-foreign");
  EXPECT_TRUE(contains(said_of(session.findings, "capture-other-sensors"), "2000 packets are of other sensors"))
      << said_of(session.findings, "capture-other-sensors");
  ASSERT_TRUE(has_code(session.findings, "capture-other-sensors"));
  EXPECT_EQ(finding_of(session.findings, "capture-other-sensors")->severity, drive::Severity::Note);
}

TEST(livox_packets, a_clock_that_is_set_is_believed_against_the_computers) {
  const std::int64_t host_ns = kLivoxBegins_ns + 3'600'000'000'000;
  const drive::Session set = scans_of(mid360_drive(500, host_ns, kLivoxBegins_ns, 1));
  EXPECT_LT(std::abs(set.scans->stamp_ns(0) - kLivoxBegins_ns), 1'000'000'000);
  EXPECT_EQ(finding_of(set.findings, "capture-clock")->severity, drive::Severity::Note);
  const drive::Session free = scans_of(mid360_drive(500, host_ns, 77'000'000'000, 0));
  EXPECT_LT(std::abs(free.scans->stamp_ns(0) - host_ns), 1'000'000'000);
  EXPECT_TRUE(contains(said_of(free.findings, "capture-clock"), "follows no receiver"));
}

TEST(livox_packets, what_tai_is_ahead_is_taken_off) {
  const drive::Session session = scans_of(mid360_drive(500, kLivoxBegins_ns, kLivoxBegins_ns + 37'000'000'000, 1));
  EXPECT_LT(std::abs(session.scans->stamp_ns(0) - kLivoxBegins_ns), 1'000'000'000);
  EXPECT_FALSE(has_code(session.findings, "capture-clock"));
}

TEST(livox_packets, several_sensors_are_told_apart) {
  std::vector<TimedFrame> frames = mid360_drive(500, kLivoxBegins_ns, kLivoxBegins_ns, 1);
  const auto more = mid360_drive(500, kLivoxBegins_ns, kLivoxBegins_ns, 1, {.address = 0xc0a80104, .port = 56301});
  frames.insert(frames.end(), more.begin(), more.end());
  EXPECT_ERROR(scans_of(frames), "192.168.1.4:56301 (Livox), 192.168.1.201:56301 (Livox)");
  EXPECT_TRUE(contains(scans_of(frames, "192.168.1.4").scans->name(0), "192.168.1.4:56301, scan 1"));
}

TEST(livox_packets, a_pulse_alone_gets_its_seconds_from_the_computer) {
  std::vector<TimedFrame> frames;
  for (std::size_t i = 0; i < 3'000; ++i) {  // 400 us each, over a full second
    const auto time_ns = 800'000'000 + static_cast<std::int64_t>(i) * 400'000;
    frames.push_back({kLivoxBegins_ns + time_ns + 450'000,
                      ethernet_udp(sdk1_packet(4, 2, little(static_cast<std::uint64_t>(time_ns % 1'000'000'000), 8),
                                               numbered_shots(0, 96)))});
  }
  const drive::Session session = scans_of(frames);
  EXPECT_FALSE(has_code(session.findings, "capture-missing"));
  ASSERT_EQ(session.scans->size(), 12U);
  for (std::size_t scan = 0; scan < 12; ++scan)
    EXPECT_EQ(session.scans->stamp_ns(scan),
              kLivoxBegins_ns + 800'000'000 + static_cast<std::int64_t>(scan) * 100'000'000);
  EXPECT_NEAR(session.scans->load(3).time_from_stamp_s[1], 400e-6 / 96, 1e-9) << "an Avia, by its packets' times";
}

}  // namespace
}  // namespace remount::formats
