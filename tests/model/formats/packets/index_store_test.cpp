#include "model/formats/packets/index_store.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>

#include "algorithms/messages/render.h"
#include "model/formats/packets/kept_index.h"
#include "tests/model/formats/mutator.h"
#include "tests/model/formats/packets/capture_sessions.h"
#include "tests/model/formats/packets/hesai_bytes.h"
#include "tests/support/findings.h"

namespace remount::formats {
namespace {

namespace fs = std::filesystem;
using testing::said_of;

constexpr std::int64_t kKept_ns = 1'700'000'000'000'000'000;

/// Two LiDARs, a receiver, a datagram in pieces and what is none of these.
std::vector<TimedFrame> kept_frames() {
  std::vector<TimedFrame> frames = vlp16_drive(300, kKept_ns, 800e6);
  const std::vector<TimedFrame> others =
      vlp16_drive(60, kKept_ns + 5'000, 800e6, {.address = 0xc0a801ca, .port = 2369}, 0x39);
  frames.insert(frames.end(), others.begin(), others.end());
  const std::string sentence = "$GPGGA,221320.00,4846.8000,N,00910.8000,E,4,12,0.6,300.0,M,48.0,M,,*5A\r\n";
  frames.push_back({kKept_ns + 1, ethernet_udp(position_packet(sentence, 2), {.port = 8308})});
  const std::string datagram = vlp16_drive(301, kKept_ns, 800e6).back().bytes.substr(14 + 20);
  frames.push_back({kKept_ns + 400'000'000, ethernet(ipv4(datagram.substr(0, 800), {.id = 3}, 0, true))});
  frames.push_back({kKept_ns + 400'000'100, ethernet(ipv4(datagram.substr(800), {.id = 3}, 800))});
  frames.push_back({kKept_ns + 400'000'200, ethernet_udp("neither", {.port = 9})});
  return frames;
}

/// A capture and the folder in which its index is kept.
class KeptCapture {
 public:
  explicit KeptCapture(const std::string& bytes = pcap(kept_frames()))
      : capture_(folder_.write("drive.pcap", bytes)), store_{folder_.path() / "cache" / "captures", 0} {}

  const fs::path& capture() const { return capture_; }
  const TemporaryFolder& folder() const { return folder_; }
  IndexStore& store() { return store_; }
  fs::path kept() const { return kept_index_file(capture_, store_); }

  PacketIndex open() const {
    Progress progress;
    return index_capture(capture_, progress, store_);
  }
  std::string remark() const { return english(open().remark); }
  /// Other bytes of the same size and time: nothing but the bytes tells.
  void replace(std::size_t at, const std::string& bytes) const {
    const auto changed = fs::last_write_time(capture_);
    std::string all = bytes_of(capture_);
    folder_.write("drive.pcap", all.replace(at, bytes.size(), bytes));
    fs::last_write_time(capture_, changed);
  }
  void write_kept(const std::string& bytes) const {
    folder_.write("cache/captures/" + kept().filename().string(), bytes);
  }

 private:
  TemporaryFolder folder_;
  fs::path capture_;
  IndexStore store_;
};

/// Everything that a session takes of an index.
std::string told(PacketIndex index) {
  std::string text;
  for (std::size_t i = 0; i < index.sensors.size(); ++i) {
    text += name_of(index.sensors[i]) + " " + index.sensors[i].decoder->model() + "\n";
    for (const IndexedPacket& packet : index.sensors[i].packets)
      text += std::to_string(packet.host_ns) + " " + std::to_string(packet.time_ns) + " " +
              std::to_string(packet.offset) + " " + std::to_string(packet.first_place) + "\n";
  }
  for (const auto& [address, receiver] : index.receivers)
    text += std::to_string(address) + " " + receiver.sentences + std::to_string(receiver.states.size()) + "\n";
  for (const auto& [route, count] : index.others) text += to_string(route) + " " + std::to_string(count) + "\n";
  for (const Error& refused : index.refused) text += english(refused.message()) + "\n";
  text += std::to_string(index.counts.frames) + " " + std::to_string(index.counts.datagrams);
  for (std::size_t i = 0; i < index.sensors.size(); ++i) {
    drive::Session session;
    PacketIndex one = index;
    take_scans(one, i, session);
    for (std::size_t scan = 0; scan < session.scans->size(); ++scan) {
      const cloud::PointCloud cloud = session.scans->load(scan);
      text.append(reinterpret_cast<const char*>(cloud.points.data()), cloud.size() * sizeof(cloud.points[0]));
    }
  }
  return text;
}

TEST(index_store, another_opening_is_the_same_without_a_pass) {
  KeptCapture kept;
  const std::string first = told(kept.open());
  EXPECT_TRUE(fs::is_regular_file(kept.kept()));
  // Where a pass would stop at once, an opening that needs none does not.
  kept.replace(24 + 8, "\xff\xff\xff\x7f");
  const PacketIndex second = kept.open();
  EXPECT_EQ(english(second.remark), "");
  EXPECT_EQ(second.sensors.size(), 2U);
  EXPECT_EQ(told(second), first);
  std::cout << fs::file_size(kept.kept()) << " bytes of " << second.counts.datagrams << " datagrams\n";
  EXPECT_LT(fs::file_size(kept.kept()), 14U * second.counts.datagrams);
  EXPECT_EQ(fs::status(kept.store().folder).permissions(), fs::perms::owner_all);
}

TEST(index_store, small_captures_and_no_folder_keep_none) {
  KeptCapture kept;
  kept.store().least_bytes = fs::file_size(kept.capture()) + 1;
  kept.open();
  EXPECT_FALSE(fs::exists(kept.kept()));
  EXPECT_EQ(KeptCapture().remark(), "");
  Progress progress;
  EXPECT_EQ(index_capture(kept.capture(), progress, {}).sensors.size(), 2U);
}

TEST(index_store, a_capture_that_changed_is_passed_anew) {
  KeptCapture kept;
  kept.open();
  std::vector<TimedFrame> frames = kept_frames();
  frames.resize(100);
  kept.folder().write("drive.pcap", pcap(frames));
  const PacketIndex shorter = kept.open();
  EXPECT_EQ(english(shorter.remark),
            "The index that was kept of this capture is not used: the capture has changed since. The capture was read "
            "through anew.");
  EXPECT_EQ(shorter.sensors.at(0).packets.size(), 100U);
  EXPECT_EQ(kept.remark(), "") << "the new one is kept";
  fs::last_write_time(kept.capture(), fs::last_write_time(kept.capture()) + std::chrono::seconds(1));
  EXPECT_TRUE(contains(kept.remark(), "has changed")) << "by its time alone";
}

TEST(index_store, packets_that_are_others_than_the_index_says_are_found) {
  KeptCapture kept;
  kept.open();
  kept.replace(24 + 16 + 42 + 1200, "\x01\x02\x03\x04");  // the stamp of the first packet
  EXPECT_TRUE(contains(kept.remark(), "it is not of what the capture holds")) << kept.remark();
}

TEST(index_store, another_files_index_and_other_versions_are_not_used) {
  KeptCapture kept, other(pcap(vlp16_drive(100, kKept_ns, 800e6)));
  kept.open(), other.open();
  kept.write_kept(bytes_of(other.kept()));
  EXPECT_TRUE(contains(kept.remark(), "has changed")) << kept.remark();
  std::string bytes = bytes_of(kept.kept());
  kept.write_kept("0" + bytes);
  EXPECT_TRUE(contains(kept.remark(), "it is no index of a capture"));
  bytes.replace(bytes.find("/1"), 2, "/0");
  kept.write_kept(bytes);
  EXPECT_TRUE(contains(kept.remark(), "another version of the program"));
  kept.write_kept("");
  EXPECT_TRUE(contains(kept.remark(), "it is no index of a capture"));
  EXPECT_EQ(kept.remark(), "");
}

TEST(index_store, what_tells_of_a_sensor_may_not_change) {
  HesaiPacket packet;
  std::vector<TimedFrame> frames;
  for (std::uint32_t i = 0; i < 8; ++i) {
    packet.azimuths.clear();
    for (std::size_t block = 0; block < packet.blocks; ++block)
      packet.azimuths.push_back(static_cast<std::uint16_t>(200 * i + 20 * block));
    packet.stamp_us = 250'000 + 500 * i;
    frames.push_back({kKept_ns + 500'000 * i, ethernet_udp(packet.bytes())});
  }
  std::string angles = "Laser id,Elevation,Azimuth\n";
  for (std::size_t i = 0; i < packet.channels; ++i)
    angles += std::to_string(i + 1) + "," + std::to_string(15.0 - 0.5 * static_cast<double>(i)) + ",0.25\n";
  KeptCapture kept(pcap(frames));
  kept.open();
  kept.folder().write("drive.csv", angles);
  EXPECT_TRUE(contains(kept.remark(), "what lies beside the capture")) << "a file that is new";
  EXPECT_EQ(kept.remark(), "");
  kept.folder().write("drive.csv", angles + "\n");
  EXPECT_TRUE(contains(kept.remark(), "what lies beside the capture")) << "a file that is another";
  fs::remove(kept.folder().path() / "drive.csv");
  EXPECT_TRUE(contains(kept.remark(), "what lies beside the capture")) << "a file that is gone";
}

TEST(index_store, damaged_indexes_are_passed_over) {
  KeptCapture kept;
  const std::string whole = told(kept.open()), bytes = bytes_of(kept.kept());
  std::size_t damaged = 0;
  for (std::size_t at = 0; at < bytes.size(); at += 1 + bytes.size() / 60) {
    std::string broken = bytes;
    broken[at] = static_cast<char>(broken[at] ^ 0x40);
    kept.write_kept(at % 2 == 0 ? broken : bytes.substr(0, at));
    PacketIndex index = kept.open();
    damaged += index.remark.empty() ? 0 : 1;
    EXPECT_FALSE(index.remark.empty()) << at;
    index.remark = {};
    if (at % 5 == 0) {
      EXPECT_EQ(told(std::move(index)), whole) << at;
    }
  }
  std::cout << damaged << " damaged indexes were refused\n";
}

TEST(index_store, what_is_said_twice_or_is_no_datagram_is_damaged) {
  KeptCapture kept;
  kept.open();
  const KeptIndex index = read_kept_index(bytes_of(kept.kept()), "x");
  const auto body = [&](const PassedPackets& passed) {
    return pack_index(index.capture, index.counts, passed, index.sensors);
  };
  // The body of one route stands twice: the second would be looked up among the pieces of the first.
  PassedPackets one = index.passed, none = index.passed;
  one.routes = {*one.routes.begin()};
  one.receivers = none.receivers = {};
  one.descriptions = none.descriptions = {};
  none.routes = {};
  const std::string with = body(one), without = body(none);
  const std::size_t at = without.size() - 3;  // behind the number of routes, which is a byte
  ASSERT_EQ(with[at], 1);
  const std::string route = with.substr(at + 1, with.size() - at - 3);
  EXPECT_EQ(
      unpack_index(with.substr(0, at) + std::string("\1") + route + std::string(2, '\0'), "x").passed.routes.size(),
      1U);
  EXPECT_ERROR(unpack_index(with.substr(0, at) + std::string("\2") + route + route + std::string(2, '\0'), "x"),
               "it is damaged");

  PassedPackets large = index.passed;
  for (auto& [key, sensor] : large.routes)
    if (!sensor.told_by.empty()) sensor.told_by.assign(100, {0, 1000});
  EXPECT_ERROR(unpack_index(body(large), "x"), "it is damaged");
}

TEST(index_store, folders_and_programs_that_get_in_the_way_cost_the_index_alone) {
  KeptCapture kept;
  const fs::path left = kept.folder().write("cache/captures/" + std::string(32, 'a') + ".index.a1b2c3", "half of one");
  const fs::path fresh = kept.folder().write("cache/captures/" + std::string(32, 'b') + ".index.a1b2c3", "half of one");
  fs::last_write_time(left, fs::last_write_time(left) - std::chrono::hours(48));
  EXPECT_EQ(kept.remark(), "");
  EXPECT_FALSE(fs::exists(left)) << "of a program that was ended";
  EXPECT_TRUE(fs::exists(fresh)) << "of one that may still write it";
}

TEST(index_store, bodies_that_pass_the_checksum_never_lead_out_of_the_capture) {
  KeptCapture kept;
  kept.open();
  const std::string bytes = bytes_of(kept.kept());
  const KeptIndex index = read_kept_index(bytes, "x");
  const std::string body = pack_index(index.capture, index.counts, index.passed, index.sensors);
  EXPECT_TRUE(bytes.ends_with(body));
  Mutator mutator(7);
  std::size_t refused = 0, read = 0;
  for (int i = 0; i < 2000; ++i) try {
      const KeptIndex one = unpack_index(mutator.damaged(body), "x");
      ++read;
      for (const auto& [key, route] : one.passed.routes)
        for (const IndexedPacket& packet : route.sensor.packets) {
          const std::uint64_t all = packet.pieces == 1 ? one.capture.bytes : route.sensor.pieces.size();
          ASSERT_LE(packet.offset, all);
          ASSERT_LE(packet.pieces == 1 ? packet.bytes : packet.pieces, all - packet.offset);
        }
    } catch (const Error& error) {
      ++refused;
      EXPECT_EQ(english(error.what_happened()), "it is damaged");
    }
  std::cout << refused << " refused, " << read << " read\n";
  EXPECT_GT(refused, 500U);
  EXPECT_GT(read, 50U);
}

TEST(index_store, a_pass_that_is_cancelled_or_cannot_be_kept_keeps_none) {
  KeptCapture kept;
  std::stop_source stop;
  stop.request_stop();
  Progress cancelled(stop.get_token());
  index_capture(kept.capture(), cancelled, kept.store());
  EXPECT_FALSE(fs::exists(kept.kept()));
  kept.folder().write("cache/captures", "a file where the folder should be");
  EXPECT_TRUE(contains(kept.remark(), "could not be kept")) << kept.remark();
  EXPECT_EQ(kept.open().sensors.size(), 2U);
}

TEST(index_store, the_longest_unused_go_where_there_are_too_many) {
  KeptCapture kept;
  const fs::path old = kept.folder().write("cache/captures/old.index", std::string(1000, '0')),
                 other = kept.folder().write("cache/captures/other.txt", std::string(1000, '0'));
  fs::last_write_time(old, fs::last_write_time(old) - std::chrono::hours(1));
  kept.open();
  EXPECT_TRUE(fs::exists(old));
  kept.store().most_bytes = 1;
  fs::remove(kept.kept());
  kept.open();
  EXPECT_FALSE(fs::exists(old));
  EXPECT_TRUE(fs::exists(other)) << "is none of ours";
  EXPECT_TRUE(fs::exists(kept.kept())) << "the newest stays";
}

TEST(index_store, a_session_says_that_its_index_was_made_anew) {
  KeptCapture kept;
  kept.open();
  kept.write_kept("broken");
  PacketIndex index = kept.open();
  drive::Session session;
  take_scans(index, 0, session);
  EXPECT_TRUE(contains(said_of(session.findings, "capture-index"), "read through anew"));
}

}  // namespace
}  // namespace remount::formats
