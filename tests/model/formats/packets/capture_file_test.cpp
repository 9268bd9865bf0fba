#include "model/formats/packets/capture_file.h"

#include <gtest/gtest.h>

#include "algorithms/messages/render.h"
#include "model/formats/packets/capture_records.h"
#include "tests/model/formats/packets/capture_bytes.h"
#include "tests/model/formats/temporary_folder.h"
#include "tests/support/findings.h"

namespace remount::formats {
namespace {

constexpr std::int64_t kCaptured_ns = 1'700'000'000'123'456'000;

struct Visited {
  std::vector<Datagram> datagrams;
  std::vector<std::string> payloads, read_again;
  CaptureCounts counts;
};

Visited visit(const std::string& bytes) {
  const TemporaryFolder folder;
  const RandomAccessFile file(folder.write("a.pcap", bytes));
  Visited visited;
  Progress progress;
  visited.counts = visit_datagrams(
      file,
      [&](const Datagram& datagram) {
        visited.datagrams.push_back(datagram);
        visited.payloads.emplace_back(datagram.payload);
      },
      progress);
  for (const Datagram& datagram : visited.datagrams)
    visited.read_again.push_back(read_payload(file, datagram.pieces.data(), datagram.pieces.size()));
  EXPECT_EQ(visited.payloads, visited.read_again);
  return visited;
}

/// Expects one datagram with the payload "hello".
void expect_hello(const std::string& bytes, const std::string& what, std::int64_t time_ns = kCaptured_ns) {
  const Visited visited = visit(bytes);
  ASSERT_EQ(visited.payloads, std::vector<std::string>{"hello"}) << what;
  EXPECT_EQ(to_string(visited.datagrams[0].route), "192.168.1.201:2368") << what;
  EXPECT_EQ(visited.datagrams[0].time_ns, time_ns) << what;
  EXPECT_EQ(visited.counts.unread_bytes, 0U) << what;
}

TEST(capture_file, pcap_of_either_byte_order_and_unit_of_time) {
  const std::vector<TimedFrame> frames{{kCaptured_ns + 789, ethernet_udp("hello")}};
  for (const bool big_first : {false, true}) {
    expect_hello(pcap(frames, {.big = big_first}), "microseconds");
    expect_hello(pcap(frames, {.big = big_first, .nanoseconds = true}), "nanoseconds", kCaptured_ns + 789);
  }
}

TEST(capture_file, nanoseconds_behind_the_mark_of_microseconds_are_told_by_their_size) {
  constexpr std::int64_t kSecond = 1'000'000'000;
  const std::int64_t time_ns = kCaptured_ns / kSecond * kSecond + 712'345'678;
  std::string bytes = pcap({{time_ns, ethernet_udp("hello")}}, {.nanoseconds = true});
  bytes.replace(0, 4, "\xd4\xc3\xb2\xa1");
  expect_hello(bytes, "as some programs write them", time_ns);
}

TEST(capture_file, every_link_that_is_read) {
  const std::string ip = ipv4(udp("hello"));
  const auto frames = [](const std::string& bytes) { return std::vector<TimedFrame>{{kCaptured_ns, bytes}}; };
  expect_hello(pcap(frames(std::string(14, '\0') + big(0x0800, 2) + ip), {.link_type = 113}), "Linux cooked");
  expect_hello(pcap(frames(big(0x0800, 2) + std::string(18, '\0') + ip), {.link_type = 276}), "Linux cooked, 2");
  expect_hello(pcap(frames(ip), {.link_type = 101}), "raw");
  expect_hello(pcap(frames(ip), {.link_type = 228}), "raw IPv4");
  expect_hello(pcap(frames(little(2, 4) + ip), {.link_type = 0}), "loopback");
  const Visited other = visit(pcap(frames(ip), {.link_type = 147}));
  EXPECT_EQ(other.counts.unknown_link, 1U);
}

TEST(capture_file, tags_options_and_padding) {
  const auto one = [](const std::string& bytes) { return pcap({{kCaptured_ns, bytes}}); };
  const std::string ip = ipv4(udp("hello"));
  expect_hello(one(ethernet(ip, {0x8100})), "a tag");
  expect_hello(one(ethernet(ip, {0x88a8, 0x8100})), "two tags");
  expect_hello(one(ethernet(ipv4(udp("hello"), {.option_words = 3}))), "options");
  expect_hello(one(ethernet(ip) + std::string(30, '\xee')), "padding");
}

TEST(capture_file, pcapng_of_either_byte_order_and_resolution) {
  const std::string frame = ethernet_udp("hello");
  for (const bool big_first : {false, true}) {
    const auto file = [&](std::uint8_t resolution, std::uint64_t ticks) {
      return pcapng_section(big_first) + block(0x0bad, "remarks", big_first) + pcapng_interface(big_first, resolution) +
             pcapng_packet(frame, ticks, big_first);
    };
    expect_hello(file(0, kCaptured_ns / 1000), "microseconds");
    expect_hello(file(9, kCaptured_ns + 7), "nanoseconds", kCaptured_ns + 7);
    expect_hello(file(3, kCaptured_ns / 1'000'000), "milliseconds", kCaptured_ns / 1'000'000 * 1'000'000);
    // 2^-20 of a second: half a second is 2^19.
    expect_hello(file(0x80 | 20, (1'700'000'000ULL << 20U) + (1U << 19U)), "binary", 1'700'000'000'500'000'000);
  }
}

TEST(capture_file, simple_packets_have_the_time_of_those_before_and_sections_their_own_order) {
  const std::string frame = ethernet_udp("hello");
  const auto simple = [&](bool big_first) {
    return block(3, number_bytes(frame.size(), 4, big_first) + frame, big_first);
  };
  const Visited visited =
      visit(pcapng_section(false) + pcapng_interface(false) + pcapng_packet(frame, kCaptured_ns / 1000, false) +
            simple(false) + pcapng_section(true) + pcapng_interface(true, 9) + pcapng_packet(frame, 77, true));
  ASSERT_EQ(visited.datagrams.size(), 3U);
  EXPECT_EQ(visited.datagrams[1].time_ns, kCaptured_ns);
  EXPECT_EQ(visited.datagrams[2].time_ns, 77);
}

TEST(capture_file, fragments_in_any_order_are_put_together) {
  const std::string payload(3000, 'x'), whole = udp(payload + "end", {.id = 9});
  const auto part = [&](std::size_t at, std::size_t bytes, std::uint16_t id = 9) {
    return TimedFrame{kCaptured_ns, ethernet(ipv4(whole.substr(at, bytes), {.id = id}, at, at + bytes < whole.size()))};
  };
  const TimedFrame first = part(0, 1480), second = part(1480, 1480), third = part(2960, 1480);
  for (const auto& frames : std::vector<std::vector<TimedFrame>>{
           {first, second, third}, {third, first, second}, {second, third, third, first}}) {
    const Visited visited = visit(pcap(frames));
    ASSERT_EQ(visited.payloads.size(), 1U);
    EXPECT_EQ(visited.payloads[0], payload + "end");
    EXPECT_EQ(visited.counts.incomplete, 0U);
  }
  const Visited torn = visit(pcap({first, third, part(1480, 1480, 10)}));
  EXPECT_EQ(torn.payloads.size(), 0U);
  EXPECT_EQ(torn.counts.incomplete, 2U) << "the second is of another datagram";
  // Ten seconds later the number comes again, with another content.
  const std::string other = udp(std::string(3000, 'y') + "end", {.id = 9});
  std::vector<TimedFrame> reused{second};
  for (const std::size_t at : {std::size_t{0}, std::size_t{1480}, std::size_t{2960}})
    reused.push_back({kCaptured_ns + 10'000'000'000,
                      ethernet(ipv4(other.substr(at, 1480), {.id = 9}, at, at + 1480 < other.size()))});
  const Visited again = visit(pcap(reused));
  EXPECT_EQ(again.payloads, std::vector<std::string>{std::string(3000, 'y') + "end"}) << "of one moment";
  EXPECT_EQ(again.counts.incomplete, 1U);
  std::vector<TimedFrame> flood;
  for (std::uint16_t id = 0; id < 1000; ++id) flood.push_back(part(0, 1480, id));
  EXPECT_EQ(visit(pcap(flood)).counts.incomplete, 1000U);
}

TEST(capture_file, what_was_not_captured_to_the_end_is_counted) {
  const std::vector<TimedFrame> frames{{1, ethernet_udp("hello")}, {2, ethernet_udp(std::string(500, 'y'))}};
  const Visited truncated = visit(pcap(frames, {.most_bytes = 100}));
  EXPECT_EQ(truncated.payloads, std::vector<std::string>{"hello"});
  EXPECT_EQ(truncated.counts.truncated, 1U);

  const std::string whole = pcap(frames);
  const Visited cut = visit(whole.substr(0, whole.size() - 10));
  EXPECT_EQ(cut.payloads, std::vector<std::string>{"hello"});
  EXPECT_TRUE(cut.counts.cut);
  EXPECT_EQ(cut.counts.unread_bytes, 16U + 42U + 500U - 10U);

  std::string damaged = whole;
  damaged.replace(24 + 8, 4, "\xff\xff\xff\x7f");
  EXPECT_EQ(visit(damaged).counts.unread_bytes, whole.size() - 24U);
  EXPECT_FALSE(visit(damaged).counts.cut);

  std::vector<drive::Finding> findings;
  report_counts(cut.counts, "a.pcap", findings);
  report_counts(truncated.counts, "a.pcap", findings);
  ASSERT_EQ(findings.size(), 2U);
  EXPECT_EQ(english(findings[0].explanation), "The capture ends within a packet: the last 548 bytes are not used.");
  EXPECT_EQ(findings[1].code, "capture-truncated");
}

TEST(capture_file, other_protocols_and_other_files_are_none) {
  std::string tcp = ipv4(udp("hello"));
  tcp[9] = 6;
  EXPECT_EQ(visit(pcap({{1, ethernet(tcp)}, {2, "short"}, {3, ""}})).counts.frames, 3U);
  EXPECT_EQ(visit(pcap({{1, ethernet(tcp)}})).counts.datagrams, 0U);
  EXPECT_ERROR(visit("no capture at all, but long enough"), "is no capture of network packets");
  EXPECT_ERROR(visit(""), "is no capture of network packets");
  std::string version = pcap({});
  version[4] = 3;
  EXPECT_ERROR(visit(version), "version 3");
  const TemporaryFolder folder;
  EXPECT_TRUE(is_capture(folder.write("a", pcap({}))));
  EXPECT_TRUE(is_capture(folder.write("b", pcapng_section(true))));
  EXPECT_FALSE(is_capture(folder.write("c", "\xd4\xc3\xb2\xa1")));
  EXPECT_FALSE(is_capture(folder.path()));
}

TEST(capture_file, reading_can_be_cancelled) {
  const TemporaryFolder folder;
  const RandomAccessFile file(folder.write("a.pcap", pcap({{1, ethernet_udp("hello")}})));
  std::stop_source stop;
  stop.request_stop();
  Progress progress(stop.get_token());
  std::size_t met = 0;
  visit_datagrams(
      file, [&](const Datagram&) { ++met; }, progress);
  EXPECT_EQ(met, 0U);
}

}  // namespace
}  // namespace remount::formats
