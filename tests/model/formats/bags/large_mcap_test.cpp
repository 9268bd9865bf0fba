// An MCAP that is larger than memory.
#include "tests/model/formats/bags/large_fixture.h"

namespace remount::bags {
namespace {

std::string head(std::uint8_t op, std::uint64_t bytes) { return raw(op) + raw(bytes); }
std::string sparse_record(std::uint8_t op, const std::string& content) { return head(op, content.size()) + content; }

/// Chunks that are not compressed, their indexes and a summary.
class SparseMcap {
 public:
  SparseMcap(const fs::path& path, int chunks, std::uint64_t scan_bytes) : file_(path) {
    const std::string magic("\x89MCAP0\r\n", 8);
    file_.put(magic + sparse_record(1, counted("ros2") + counted("by hand")));
    for (int i = 0; i < chunks; ++i) add_chunk(i, scan_bytes);
    file_.put(sparse_record(15, raw<std::uint32_t>(0)));
    const std::uint64_t summary = file_.at();
    for (std::uint16_t id = 0; id < 3; ++id) {
      std::string type = kLargeTypes[id];
      type.insert(type.find('/'), "/msg");
      file_.put(sparse_record(3, raw<std::uint16_t>(id + 1) + counted(type) + counted("ros2msg") + counted("")) +
                sparse_record(4, raw(id) + raw<std::uint16_t>(id + 1) + counted(kLargeTopics[id]) + counted("cdr") +
                                     counted("")));
    }
    file_.put(infos_);
    file_.put(sparse_record(2, raw(summary) + raw<std::uint64_t>(0) + raw<std::uint32_t>(0)) + magic);
  }

 private:
  static std::string message_head(std::uint16_t id, std::int64_t time_ns, std::uint64_t bytes) {
    return head(5, 22 + bytes) + raw(id) + raw<std::uint32_t>(0) + raw(time_ns) + raw(time_ns);
  }

  void add_chunk(int i, std::uint64_t scan_bytes) {
    std::string small, index[3];
    const auto enter = [&](std::uint16_t id, std::int64_t time_ns, const std::string& bytes, std::uint64_t more) {
      index[id] += raw(time_ns) + raw<std::uint64_t>(small.size());
      small += message_head(id, time_ns, bytes.size() + more) + bytes;
    };
    for (int k = 0; k < kInsPerScan; ++k) {
      const LargeInsMessages ins = large_ins_messages(kInsPerScan * i + k, kCdr);
      enter(1, ins.stamp_ns, ins.imu, 0);
      enter(2, ins.stamp_ns, ins.fix, 0);
    }
    const LargeScan scan = large_scan(i, scan_bytes, kCdr);
    enter(0, scan.stamp_ns, scan.begin, scan.zeros + scan.end.size());
    const std::uint64_t chunk_bytes = small.size() + scan.zeros + scan.end.size(), start = file_.at();
    const std::string about = raw(scan.stamp_ns) + raw(scan.stamp_ns) + raw(chunk_bytes) + raw<std::uint32_t>(0) +
                              counted("") + raw(chunk_bytes);
    file_.put(head(6, about.size() + chunk_bytes) + about + small);
    file_.skip(scan.zeros);
    file_.put(scan.end);
    const std::uint64_t length = file_.at() - start;
    std::string indexes, offsets;
    for (std::uint16_t id = 0; id < 3; ++id) {
      offsets += raw(id) + raw<std::uint64_t>(file_.at() + indexes.size());
      indexes += sparse_record(7, raw(id) + counted(index[id]));
    }
    file_.put(indexes);
    infos_ +=
        sparse_record(8, raw(scan.stamp_ns) + raw(scan.stamp_ns) + raw(start) + raw(length) + counted(offsets) +
                             raw<std::uint64_t>(indexes.size()) + counted("") + raw(chunk_bytes) + raw(chunk_bytes));
  }

  SparseFile file_;
  std::string infos_;
};

TEST(large_mcap, opens_twenty_gigabytes_in_seconds_and_takes_memory_for_one_scan_at_a_time) {
  constexpr int kScans = 2000;
  constexpr std::uint64_t kScanBytes = 10'500'000;
  const formats::TemporaryFolder folder;
  const fs::path path = folder.path() / "drive.mcap";
  { SparseMcap bag(path, kScans, kScanBytes); }
  expect_opens_in_seconds(path, kScans, kScanBytes);
}

}  // namespace
}  // namespace remount::bags
