#include "model/formats/packets/capture_scans.h"

#include <gtest/gtest.h>

#include <iostream>

#include "model/formats/packets/sensor_clock.h"
#include "tests/model/formats/packets/capture_sessions.h"
#include "tests/support/findings.h"

namespace remount::formats {
namespace {

using testing::finding_of;
using testing::has_code;
using testing::said_of;

constexpr std::int64_t kHourBegins_ns = 1'699'999'200'000'000'000;  // 2023-11-14, 22:00 UTC
constexpr double kPacket_us = 12 * 110.592;

/// A host has a packet when it is complete.
std::vector<TimedFrame> complete_frames(std::vector<TimedFrame> frames) {
  for (TimedFrame& frame : frames) frame.time_ns += std::llround(1e3 * kPacket_us);
  return frames;
}

/// The time of every point of a scan, Unix time.
std::vector<std::int64_t> times_of(const drive::ScanSource& scans, std::size_t scan) {
  std::vector<std::int64_t> times_ns;
  for (const float after_s : scans.load(scan).time_from_stamp_s)
    times_ns.push_back(scans.stamp_ns(scan) + std::llround(1e9 * static_cast<double>(after_s)));
  return times_ns;
}

TEST(capture_scans, are_whole_turns_that_begin_ahead) {
  const std::int64_t begins_ns = kHourBegins_ns + 800'000'000'000;
  const drive::Session session = scans_of(vlp16_drive(400, begins_ns, 800e6));
  EXPECT_TRUE(session.findings.empty());
  ASSERT_EQ(session.scans->size(), 5U) << "the sixth is hardly begun";
  EXPECT_EQ(session.scan_timing, drive::ScanTiming::PerPoint);
  EXPECT_EQ(session.scans->name(1), "a.pcap: 192.168.1.201:2368, scan 2");
  std::size_t points = 0;
  for (std::size_t scan = 0; scan < session.scans->size(); ++scan) {
    // The first firing of a turn is at most one behind ahead.
    EXPECT_NEAR(static_cast<double>(session.scans->stamp_ns(scan) - begins_ns), 1e8 * static_cast<double>(scan), 60e3);
    const cloud::PointCloud cloud = session.scans->load(scan);
    points += cloud.size();
    EXPECT_NEAR(static_cast<double>(cloud.size()), 28'935.0, 40.0);
    EXPECT_NEAR(std::atan2(-cloud.points.front().y(), cloud.points.front().x()), 0.0, 0.004);
    EXPECT_NEAR(cloud.time_from_stamp_s.front(), 0.0, 1e-6);
    EXPECT_NEAR(cloud.time_from_stamp_s.back(), 0.1, 1e-4);
    EXPECT_TRUE(std::is_sorted(cloud.time_from_stamp_s.begin(), cloud.time_from_stamp_s.end(),
                               [](float a, float b) { return a < b - 1e-7f; }));
  }
  std::cout << points << " points in " << session.scans->size() << " scans\n";
}

TEST(capture_scans, the_hour_is_the_hosts_and_may_end_in_between) {
  const std::int64_t begins_ns = kHourBegins_ns + 3'599'800'000'000;  // two tenths of a second before the next hour
  // The host takes packets down a millisecond later.
  const drive::Session session = scans_of(vlp16_drive(400, begins_ns + 1'000'000, 3'599.8e6));
  EXPECT_FALSE(has_code(session.findings, "capture-clock"));
  EXPECT_FALSE(has_code(session.findings, "capture-missing"));
  ASSERT_EQ(session.scans->size(), 5U);
  for (std::size_t scan = 0; scan < 5; ++scan)
    EXPECT_NEAR(static_cast<double>(session.scans->stamp_ns(scan) - begins_ns), 1e8 * static_cast<double>(scan), 60e3);
  // The host's clock is 1.5 s ahead and in the next hour already.
  const drive::Session late = scans_of(vlp16_drive(100, begins_ns + 1'500'000'000, 3'599.8e6));
  EXPECT_NEAR(static_cast<double>(late.scans->stamp_ns(0) - begins_ns), 0.0, 60e3);
}

TEST(capture_scans, a_clock_that_follows_nothing_gives_way_to_the_hosts) {
  const std::int64_t begins_ns = kHourBegins_ns + 800'000'000'000;
  std::vector<TimedFrame> frames = complete_frames(vlp16_drive(400, begins_ns, 12e6));
  for (std::size_t i = 0; i < frames.size(); i += 3) frames[i].time_ns += 4'000'000;  // some are taken down late
  const drive::Session session = scans_of(frames);
  EXPECT_NEAR(static_cast<double>(session.scans->stamp_ns(0) - begins_ns), 0.0, 60e3);
  EXPECT_EQ(said_of(session.findings, "capture-clock"),
            "The LiDAR's clock is 13.1 min from the clock of the computer that captured it, and follows no receiver. "
            "400 of 400 packets have the computer's time.");
  // Where position packets say that it follows a receiver, the computer is wrong.
  frames.push_back({begins_ns + 1, ethernet_udp(position_packet("", 2), {.port = 8308})});
  const drive::Session locked = scans_of(frames);
  EXPECT_NEAR(static_cast<double>(locked.scans->stamp_ns(0) - kHourBegins_ns), 12e9, 60e3);
  EXPECT_EQ(finding_of(locked.findings, "capture-clock")->severity, drive::Severity::Note);
}

TEST(capture_scans, the_drift_of_a_free_clock_is_taken_off) {
  std::vector<IndexedPacket> packets;
  for (int i = 0; i < 60'000; ++i) {
    IndexedPacket packet;
    const std::int64_t time_ns = kHourBegins_ns + std::int64_t{i} * 2'000'000;
    packet.clock_period_s = 3600;
    packet.host_ns = time_ns + 2'000'000 + 100'000 + i % 7 * 300'000;  // when it is complete, and later
    packet.time_ns = static_cast<std::int64_t>((time_ns - kHourBegins_ns) * (1.0 + 50e-6)) + 77'000'000'000;
    packets.push_back(packet);
  }
  std::vector<drive::Finding> findings;
  settle_clock(packets, {}, "a.pcap", findings);
  double worst_s = 0.0;
  for (std::size_t i = 0; i < packets.size(); ++i)
    worst_s = std::max(worst_s, std::abs(1e-9 * static_cast<double>(packets[i].time_ns - kHourBegins_ns) - 0.1e-3 -
                                         2e-3 * static_cast<double>(i)));
  std::cout << "two minutes with 50 ppm: at most " << 1e6 * worst_s << " us off\n";
  EXPECT_LT(worst_s, 50e-6) << "without the drift it would be 6 ms";
  EXPECT_TRUE(has_code(findings, "capture-clock"));
}

TEST(capture_scans, a_clock_that_finds_its_receiver_is_judged_before_and_behind) {
  std::vector<TimedFrame> frames = complete_frames(vlp16_drive(400, kHourBegins_ns, 1'000e6));  // free
  const std::int64_t later_ns = kHourBegins_ns + std::llround(400 * kPacket_us * 1e3);
  const std::vector<TimedFrame> followed = vlp16_drive(400, later_ns + 500'000, 1e-3 * (later_ns - kHourBegins_ns));
  frames.insert(frames.end(), followed.begin(), followed.end());
  const drive::Session session = scans_of(frames);
  EXPECT_TRUE(contains(said_of(session.findings, "capture-clock"), "400 of 800 packets have the computer's time"));
  EXPECT_NEAR(static_cast<double>(session.scans->stamp_ns(0) - kHourBegins_ns), 0.0, 60e3);
  EXPECT_NEAR(static_cast<double>(session.scans->stamp_ns(9) - later_ns), 0.4e9, 70e6);
}

TEST(capture_scans, missing_repeated_and_reversed_packets_are_told) {
  std::vector<TimedFrame> frames = vlp16_drive(400, kHourBegins_ns, 0.0);
  const std::vector<std::int64_t> before = times_of(*scans_of(frames).scans, 1);
  frames.insert(frames.begin() + 100, frames[99]);
  std::swap(frames[120], frames[121]);
  const drive::Session session = scans_of(frames);
  EXPECT_EQ(said_of(session.findings, "capture-repeated"), "1 of 401 packets came twice and are used once.");
  EXPECT_FALSE(has_code(session.findings, "capture-missing"));
  EXPECT_EQ(times_of(*session.scans, 1), before);
  frames.erase(frames.begin() + 200, frames.begin() + 210);
  const drive::Session torn = scans_of(frames);
  EXPECT_EQ(said_of(torn.findings, "capture-missing"), "10 of 400 packets are missing.");
  EXPECT_EQ(finding_of(torn.findings, "capture-missing")->severity, drive::Severity::Warning);
  EXPECT_EQ(torn.scans->size(), session.scans->size());
}

TEST(capture_scans, a_sensor_that_looks_at_a_part_of_the_turn_misses_nothing) {
  std::vector<TimedFrame> frames = vlp16_drive(800, kHourBegins_ns, 0.0);
  // 100 ms are 75.35 packets.
  std::vector<TimedFrame> seen;
  for (std::size_t i = 0; i < frames.size(); ++i)
    if (const double turns = static_cast<double>(i) / 75.352; turns - std::floor(turns) < 0.4)
      seen.push_back(frames[i]);
  const drive::Session session = scans_of(seen);
  EXPECT_FALSE(has_code(session.findings, "capture-missing")) << said_of(session.findings, "capture-missing");
  EXPECT_GE(session.scans->size(), 10U);
}

TEST(capture_scans, two_returns_make_twice_the_points) {
  const drive::Session session = scans_of(vlp16_drive(800, kHourBegins_ns, 0.0, {}, 0x39));
  ASSERT_EQ(session.scans->size(), 5U);
  EXPECT_NEAR(static_cast<double>(session.scans->load(2).size()), 28'935.0, 40.0) << "both returns are the same here";
}

TEST(capture_scans, sensors_are_told_apart_by_address_and_port) {
  std::vector<TimedFrame> frames = vlp16_drive(200, kHourBegins_ns, 0.0);
  for (const FrameOptions& options :
       {FrameOptions{.address = 0xc0a801ca}, FrameOptions{.address = 0xc0a801c9, .port = 2369}}) {
    const std::vector<TimedFrame> more = vlp16_drive(200, kHourBegins_ns, 0.0, options);
    frames.insert(frames.end(), more.begin(), more.end());
  }
  EXPECT_ERROR(scans_of(frames),
               "192.168.1.201:2368 (VLP-16), 192.168.1.201:2369 (VLP-16), "
               "192.168.1.202:2368 (VLP-16)");
  EXPECT_ERROR(scans_of(frames, "192.168.1.201"), "several LiDARs");
  EXPECT_ERROR(scans_of(frames, "10.0.0.1"), "holds no LiDAR 10.0.0.1");
  EXPECT_TRUE(contains(scans_of(frames, "192.168.1.202").scans->name(0), "192.168.1.202:2368"));
  EXPECT_TRUE(contains(scans_of(frames, "2369").scans->name(0), "192.168.1.201:2369"));
  EXPECT_TRUE(contains(scans_of(frames, "192.168.1.201:2368").scans->name(0), "192.168.1.201:2368"));
}

TEST(capture_scans, without_a_lidar_what_is_there_is_named) {
  EXPECT_ERROR(scans_of({{1, ethernet_udp("hello", {.port = 7502})}}), "datagrams of 192.168.1.201:7502");
  EXPECT_ERROR(scans_of({}), "holds no packets at all");
  std::string of_tcp = ipv4(udp("hello"));
  of_tcp[9] = 6;
  EXPECT_ERROR(scans_of({{1, ethernet(of_tcp)}}), "holds no UDP datagrams");
  EXPECT_ERROR(scans_of({{1, ethernet_udp(position_packet("", 2), {.port = 8308})}}),
               "datagrams of 192.168.1.201:8308");
  VelodynePacket other_mode;
  other_mode.azimuths.assign(12, 0);
  other_mode.mode = 0x3a;
  EXPECT_ERROR(scans_of({{1, ethernet_udp(other_mode.bytes())}, {2, ethernet_udp(other_mode.bytes())}}),
               "holds 2 datagrams of a VLP-16");
  VelodynePacket unknown;
  unknown.azimuths.assign(12, 0);
  unknown.product = 0x31;
  EXPECT_ERROR(scans_of({{1, ethernet_udp(unknown.bytes())}}), "product number 49");
}

TEST(capture_scans, datagrams_of_something_else_are_counted) {
  std::vector<TimedFrame> frames = vlp16_drive(200, kHourBegins_ns, 0.0);
  frames.push_back({kHourBegins_ns, ethernet_udp("hello")});
  EXPECT_EQ(said_of(scans_of(frames).findings, "capture-foreign"),
            "1 datagram is no whole packet of a VLP-16 and is not used.");
}

TEST(capture_scans, datagrams_of_another_setting_are_a_warning_where_they_are_many) {
  std::vector<TimedFrame> frames = vlp16_drive(500, kHourBegins_ns, 0.0);
  const auto severity = [&] { return finding_of(scans_of(frames).findings, "capture-foreign")->severity; };
  frames.push_back({kHourBegins_ns + 1, ethernet_udp("something")});
  EXPECT_EQ(severity(), drive::Severity::Note);
  for (int i = 0; i < 10; ++i) frames.push_back({kHourBegins_ns + 2, ethernet_udp("something")});
  EXPECT_EQ(severity(), drive::Severity::Warning);
}

TEST(capture_scans, fragments_are_read_as_whole_packets) {
  std::vector<TimedFrame> frames = vlp16_drive(200, kHourBegins_ns, 0.0), pieces;
  const drive::Session whole = scans_of(frames);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const std::string datagram = frames[i].bytes.substr(14 + 20);
    const FrameOptions options{.id = static_cast<std::uint16_t>(i)};
    pieces.push_back({frames[i].time_ns, ethernet(ipv4(datagram.substr(0, 800), options, 0, true))});
    pieces.push_back({frames[i].time_ns, ethernet(ipv4(datagram.substr(800), options, 800))});
  }
  const drive::Session cut = scans_of(pieces);
  ASSERT_EQ(cut.scans->size(), whole.scans->size());
  EXPECT_EQ(cut.scans->load(1).points, whole.scans->load(1).points);
  EXPECT_EQ(cut.scans->load(1).time_from_stamp_s, whole.scans->load(1).time_from_stamp_s);
}

}  // namespace
}  // namespace remount::formats
