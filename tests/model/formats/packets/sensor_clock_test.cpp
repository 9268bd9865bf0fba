// Clocks that change on the way: what counts before the change is not believed because of what comes behind.
#include "model/formats/packets/sensor_clock.h"

#include <gtest/gtest.h>

#include <iostream>

#include "tests/model/formats/packets/capture_sessions.h"
#include "tests/model/formats/packets/livox_bytes.h"
#include "tests/model/formats/packets/robosense_bytes.h"
#include "tests/support/findings.h"

namespace remount::formats {
namespace {

using testing::has_code;
using testing::said_of;

constexpr std::int64_t kClockBegins_ns = 1'700'000'000'000'000'000;

/// From the first scan's stamp to the last one's, after a time.
std::pair<double, double> span_s(const drive::ScanSource& scans, std::int64_t begins_ns) {
  const auto after_s = [&](std::size_t scan) { return 1e-9 * static_cast<double>(scans.stamp_ns(scan) - begins_ns); };
  return {after_s(0), after_s(scans.size() - 1)};
}

TEST(sensor_clock, what_a_clock_counts_before_it_is_set_is_not_believed) {
  constexpr std::int64_t kStep_us = 158, kFreeFrom_us = 1'514'764'800'000'000;  // 2018, by a clock that nothing set
  const auto nothing = [](std::size_t, std::size_t) { return std::array<int, 3>{2000, 0, 0}; };
  std::vector<TimedFrame> frames;
  for (std::int64_t i = 0; i < 5'040; ++i) {
    const bool set = i >= 2'520;
    const std::int64_t time_us = (set ? kClockBegins_ns / 1000 : kFreeFrom_us) + i * kStep_us;
    frames.push_back({kClockBegins_ns + 1000 * kStep_us * (i + 1),
                      ethernet_udp(m1_packet(static_cast<std::uint16_t>(1 + i % 630), set ? 1 : 0, time_us, nothing),
                                   {.port = 6699})});
  }
  const drive::Session session = scans_of(frames);
  ASSERT_EQ(session.scans->size(), 8U);
  const auto [first_s, last_s] = span_s(*session.scans, kClockBegins_ns);
  std::cout << "scans from " << first_s << " to " << last_s << " s\n";
  EXPECT_NEAR(first_s, 0.0, 1e-3) << "the computer's time";
  EXPECT_NEAR(last_s, 7 * 630 * 158e-6, 1e-3);
  EXPECT_TRUE(contains(said_of(session.findings, "capture-clock"), "2520 of 5040 packets have the computer's time"))
      << said_of(session.findings, "capture-clock");
}

TEST(sensor_clock, a_livox_that_finds_a_pulse_and_then_the_date_is_read_on) {
  constexpr std::int64_t kStep_ns = 400'000;
  std::vector<TimedFrame> frames;
  for (std::int64_t i = 0; i < 2'250; ++i) {
    const std::int64_t after_ns = i * kStep_ns;
    const auto packet = [&](std::uint8_t type, const std::string& time) {
      return sdk1_packet(type, 2, time, numbered_shots(0, 96));
    };
    const auto counted = [](std::int64_t ns) { return little(static_cast<std::uint64_t>(ns), 8); };
    // 2023-11-14, 22:13:20 UTC
    const std::string spelt = little(23, 1) + little(11, 1) + little(14, 1) + little(22, 1) +
                              little(static_cast<std::uint64_t>(800'000'000 + after_ns / 1000), 4);
    frames.push_back(
        {kClockBegins_ns + after_ns + kStep_ns, ethernet_udp(i < 750     ? packet(0, counted(5'000'000'000 + after_ns))
                                                             : i < 1'500 ? packet(4, counted(after_ns % 1'000'000'000))
                                                                         : packet(3, spelt))});
  }
  const drive::Session session = scans_of(frames);
  EXPECT_FALSE(has_code(session.findings, "capture-foreign")) << said_of(session.findings, "capture-foreign");
  EXPECT_FALSE(has_code(session.findings, "capture-no-date"));
  ASSERT_EQ(session.scans->size(), 9U);
  const auto [first_s, last_s] = span_s(*session.scans, kClockBegins_ns);
  EXPECT_NEAR(first_s, 0.0, 1e-3);
  EXPECT_NEAR(last_s, 0.8, 1e-3);
}

TEST(sensor_clock, states_in_between_count_more_than_those_nearby) {
  std::vector<IndexedPacket> packets;
  for (std::int64_t i = 0; i < 1'000; ++i) {
    IndexedPacket packet;
    packet.host_ns = kClockBegins_ns + i * 1'000'000;
    packet.time_ns = packet.host_ns + (i < 500 ? -90'000'000'000'000 : 5'000'000'000);
    packets.push_back(packet);
  }
  const std::vector<SensorReceiver::State> states{
      {kClockBegins_ns, false}, {kClockBegins_ns + 500'000'000, true}, {kClockBegins_ns + 1'500'000'000, true}};
  std::vector<drive::Finding> findings;
  settle_clock(packets, states, "a.pcap", findings);
  EXPECT_NEAR(1e-9 * static_cast<double>(packets[0].time_ns - kClockBegins_ns), 0.0, 5e-3) << "a day behind";
  EXPECT_EQ(packets[999].time_ns, packets[999].host_ns + 5'000'000'000) << "the sensor's own";
}

}  // namespace
}  // namespace remount::formats
