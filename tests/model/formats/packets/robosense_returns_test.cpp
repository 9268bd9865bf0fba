// RoboSense's sensors with two returns whose packets hold a half each, and times of early firmware.
#include <gtest/gtest.h>

#include <functional>

#include "tests/model/formats/packets/capture_sessions.h"
#include "tests/model/formats/packets/robosense_bytes.h"
#include "tests/support/findings.h"

namespace remount::formats {
namespace {

using testing::has_code;
using testing::said_of;

constexpr std::int64_t kReturns_ns = 1'700'000'000'000'000'000;

std::string described_ruby() {
  DifopPacket description;
  description.room = 128;
  description.angles = even_angles(100, 128);
  return description.bytes();
}

cloud::PointCloud decoded(const PacketDecoder& decoder, const std::string& payload, const std::string& before) {
  cloud::PointCloud cloud;
  decoder.decode(payload, {0, PacketDecoder::kAllColumns}, {.before = before}, cloud);
  return cloud;
}

/// One point of an M1's packet alone, and in some another.
std::string m1_of(std::uint16_t sequence, bool second, std::int64_t time_us, int other_range) {
  std::string payload = m1_packet(sequence, 1, time_us, [&](std::size_t block, std::size_t channel) {
    return block == 7 && channel == 2   ? std::array<int, 3>{2000, -1050, 4500}
           : block == 9 && channel == 0 ? std::array<int, 3>{other_range, 100, 200}
                                        : std::array<int, 3>{};
  });
  for (std::size_t block = 0; block < 25; ++block) payload[32 + 47 * block + 1] = second ? 2 : 1;
  return payload;
}

TEST(robosense_returns, the_second_one_of_an_m1_that_is_the_same_is_left_out) {
  const std::string first = m1_of(1, false, kReturns_ns / 1000, 1000),
                    second = m1_of(2, true, kReturns_ns / 1000 + 40, 1200);
  const auto decoder = recognised(first, "a.pcap");
  ASSERT_NE(decoder, nullptr);
  EXPECT_EQ(decoded(*decoder, first, "").size(), 2U);
  const cloud::PointCloud more = decoded(*decoder, second, first);
  ASSERT_EQ(more.size(), 1U) << "of two, one is the same";
  EXPECT_NEAR(more.points[0].norm(), 6.0f, 1e-4f);
  EXPECT_NEAR(more.time_from_stamp_s[0], 54e-6 - 40e-6, 1e-9) << "the time of the shot";
  EXPECT_EQ(decoded(*decoder, second, m1_of(5, false, kReturns_ns / 1000, 1000)).size(), 2U) << "of other shots";
  EXPECT_EQ(decoded(*decoder, second, "").size(), 2U) << "the first is missing";
  std::vector<TimedFrame> frames;
  for (std::int64_t i = 0; i < 3 * 1'260; ++i) {
    const std::int64_t after_us = i * 79;
    frames.push_back({kReturns_ns + 1000 * (after_us + 158),
                      ethernet_udp(m1_of(static_cast<std::uint16_t>(1 + i % 1'260), i % 2 == 1,
                                         kReturns_ns / 1000 + after_us, i % 2 == 1 ? 1200 : 1000),
                                   {.port = 6699})});
  }
  const drive::Session session = scans_of(frames);
  EXPECT_FALSE(has_code(session.findings, "capture-missing"));
  ASSERT_EQ(session.scans->size(), 3U);
  EXPECT_EQ(session.scans->load(1).size(), 630U * 3U);
}

TEST(robosense_returns, the_second_one_of_a_ruby_is_compared_with_the_first_of_the_packet_before) {
  const auto packet = [](std::vector<std::uint16_t> azimuths, std::uint16_t range) {
    return ruby_packet(128, 5, 1, azimuths, [=](std::size_t, std::size_t laser) {
      return laser == 5 ? range : laser == 6 ? std::uint16_t{3000} : std::uint16_t{0};
    });
  };
  const std::string first = packet({9000, 9000, 9020}, 2000), second = packet({9020, 9040, 9040}, 2500);
  const auto decoder = recognised(first, "a.pcap");
  decoder->describe({described_ruby()}, "a.pcap");
  EXPECT_EQ(decoded(*decoder, first, "").size(), 4U) << "both are the same within the packet";
  EXPECT_EQ(decoded(*decoder, second, "").size(), 4U);
  EXPECT_EQ(decoded(*decoder, second, first).size(), 3U) << "laser 6 has seen the same at 90.2 degrees";
  EXPECT_EQ(decoded(*decoder, second, packet({9000, 9020, 9020}, 2000)).size(), 4U) << "a column has no three returns";
}

/// Two and three quarters of a turn of a Ruby; what stands in the part of the second is `part(nanoseconds since the
/// second began)`.
std::vector<TimedFrame> ruby_drive(std::int64_t begins_after_ns,
                                   const std::function<std::uint64_t(std::int64_t)>& part) {
  std::vector<TimedFrame> frames{{kReturns_ns, ethernet_udp(described_ruby(), {.port = 7788})}};
  for (std::int64_t i = 0; i < 5'000; ++i) {
    const std::int64_t after_ns = begins_after_ns + 55'552 * i;
    const auto azimuth = static_cast<std::uint16_t>(20 * i % 36'000);
    std::string bytes = ruby_packet(80, 4, 0, {azimuth, azimuth, azimuth, azimuth},
                                    [](std::size_t, std::size_t) { return std::uint16_t{2000}; });
    bytes.replace(10, 10, big(1'700'000'000, 6) + big(part(after_ns), 4));
    frames.push_back({kReturns_ns + after_ns + 55'552, ethernet_udp(bytes, {.port = 6699})});
  }
  return frames;
}

TEST(robosense_returns, early_firmware_of_a_ruby_counts_nanoseconds) {
  const auto nanoseconds = [](std::int64_t after_ns) { return static_cast<std::uint64_t>(after_ns); };
  // From the first thousandth of a second on, in which they could be microseconds as well.
  for (const std::int64_t begins_after_ns : {1'500'000, 10'000}) {
    const drive::Session session = scans_of(ruby_drive(begins_after_ns, nanoseconds));
    EXPECT_FALSE(has_code(session.findings, "capture-foreign")) << said_of(session.findings, "capture-foreign");
    EXPECT_FALSE(has_code(session.findings, "capture-missing")) << said_of(session.findings, "capture-missing");
    ASSERT_EQ(session.scans->size(), 2U) << "the third is not whole";
    EXPECT_EQ(session.scans->stamp_ns(0), kReturns_ns + begins_after_ns);
    EXPECT_EQ(session.scans->stamp_ns(1), kReturns_ns + begins_after_ns + 1'800 * 55'552);
  }
}

TEST(robosense_returns, a_broken_time_of_a_ruby_does_not_change_what_the_others_count) {
  const std::int64_t begins_after_ns = 250'000'000;
  for (const std::uint64_t broken : {std::uint64_t{250'000'000}, std::uint64_t{1'000'000'000}}) {
    const drive::Session session = scans_of(ruby_drive(begins_after_ns, [&](std::int64_t after_ns) {
      return after_ns == begins_after_ns ? broken : static_cast<std::uint64_t>(after_ns / 1000);
    }));
    EXPECT_TRUE(contains(said_of(session.findings, "capture-foreign"), "1 datagram is no whole packet"))
        << broken << said_of(session.findings, "capture-foreign");
    ASSERT_EQ(session.scans->size(), 2U) << "the third is not whole";
    EXPECT_NEAR(1e-9 * static_cast<double>(session.scans->stamp_ns(1) - kReturns_ns), 0.25 + 1'800 * 55.552e-6, 1e-6)
        << broken;
  }
}

}  // namespace
}  // namespace remount::formats
