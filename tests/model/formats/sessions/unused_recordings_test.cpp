#include "model/formats/sessions/unused_recordings.h"

#include <gtest/gtest.h>

#include "tests/model/formats/packets/capture_bytes.h"
#include "tests/model/formats/reader_fixtures.h"

namespace remount::formats {
namespace {

constexpr std::int64_t kPacketsBegin_ns = 1'636'512'535'000'000'000;

std::string log_without_lidar() {
  std::string log;
  for (int i = 0; i < 120; ++i) log += inspvaxa(2183, 269352.5 + 0.02 * i, 90.0 + 0.1 * i);
  return log;
}

/// Of which the first 200 bytes of each frame were kept.
std::string cut_capture() { return pcap(vlp16_drive(200, kPacketsBegin_ns, 0.0), {.most_bytes = 200}); }

TEST(unused_recordings, are_named_beside_a_log_with_their_reasons) {
  struct Case {
    std::string name, bytes, reason;
  };
  const std::vector<Case> cases = {
      {"drive.pcap", cut_capture(), "200 were looked at, of which the ends were not captured"},
      {"drive.pcap", pcap({}), "holds no packets at all"},
      {"drive.pcap", pcap({{1, ethernet_udp("hello")}}), "datagrams of 192.168.1.201:2368"},
      {"DRIVE.PCAP", "", "does not begin as a recording"},
      {"drive.mcap", "", "does not begin as a recording"},
      {"drive.bag", "something else", "does not begin as a recording"}};
  for (const auto& [name, bytes, reason] : cases) {
    const TemporaryFolder folder;
    folder.write(name, bytes);
    folder.write("ins.log", log_without_lidar());
    folder.write("notes.txt", "");
    const drive::Session session = open(folder.path());
    EXPECT_EQ(session.ins.size(), 120U);
    const auto named = std::ranges::count_if(
        session.findings, [](const drive::Finding& finding) { return finding.code == "recording-unused"; });
    EXPECT_EQ(named, 1) << name << ", " << reason;
    const drive::Finding* finding = find(session, "recording-unused");
    ASSERT_NE(finding, nullptr) << name << ", " << reason;
    EXPECT_EQ(finding->severity, drive::Severity::Problem);
    EXPECT_TRUE(contains(english(finding->where), name)) << english(finding->where);
    EXPECT_TRUE(contains(english(finding->explanation), reason)) << english(finding->explanation);
  }
}

TEST(unused_recordings, are_not_named_where_there_is_a_lidar) {
  const TemporaryFolder folder;
  folder.write("drive.pcap", pcap(vlp16_drive(400, kPacketsBegin_ns, 0.0)));
  folder.write("other.pcap", pcap({{1, ethernet_udp("hello")}}));
  folder.write("ins.log", log_without_lidar());
  const drive::Session session = open(folder.path());
  EXPECT_TRUE(session.scans);
  EXPECT_EQ(find(session, "recording-unused"), nullptr);
}

TEST(unused_recordings, that_are_opened_alone_say_why) {
  const TemporaryFolder folder;
  EXPECT_ERROR(open(folder.write("drive.pcap", cut_capture())), "tcpdump -s 0");
  EXPECT_ERROR(open(folder.write("empty.pcap", pcap({}))), "holds no packets at all");
}

}  // namespace
}  // namespace remount::formats
