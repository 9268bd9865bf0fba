// An MCAP that is larger than memory, written with holes.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <chrono>

#include "tests/model/io/bag/bag_maker.h"
#include "tests/support/sanitized.h"

namespace remount {
namespace {

using namespace bags;

constexpr MessageEncoding kCdr = MessageEncoding::Cdr;

/// Peak memory of the process, MB.
double peak_mb() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

std::string head(std::uint8_t op, std::uint64_t bytes) { return raw(op) + raw(bytes); }
std::string record(std::uint8_t op, const std::string& content) { return head(op, content.size()) + content; }

/// Chunks that are not compressed, with holes where the points would be, their indexes and a summary.
class SparseMcap {
 public:
  SparseMcap(const fs::path& path, int chunks, std::uint64_t scan_bytes) : file_(std::fopen(path.c_str(), "wb")) {
    const std::string magic("\x89MCAP0\r\n", 8);
    put(magic + record(1, counted("ros2") + counted("by hand")));
    for (int i = 0; i < chunks; ++i) add_chunk(i, scan_bytes);
    put(record(15, raw<std::uint32_t>(0)));
    const std::uint64_t summary = at_;
    const char* topics[] = {"/points", "/ins/imu", "/ins/fix"};
    const char* types[] = {"sensor_msgs/msg/PointCloud2", "sensor_msgs/msg/Imu", "sensor_msgs/msg/NavSatFix"};
    for (std::uint16_t id = 0; id < 3; ++id)
      put(record(3, raw<std::uint16_t>(id + 1) + counted(types[id]) + counted("ros2msg") + counted("")) +
          record(4, raw(id) + raw<std::uint16_t>(id + 1) + counted(topics[id]) + counted("cdr") + counted("")));
    put(infos_);
    put(record(2, raw(summary) + raw<std::uint64_t>(0) + raw<std::uint32_t>(0)) + magic);
  }
  ~SparseMcap() { std::fclose(file_); }

 private:
  void put(const std::string& bytes) {
    std::fwrite(bytes.data(), 1, bytes.size(), file_);
    at_ += bytes.size();
  }
  void skip(std::uint64_t bytes) {
    std::fseek(file_, static_cast<long>(bytes), SEEK_CUR);
    at_ += bytes;
  }
  static std::string message_head(std::uint16_t id, std::int64_t time_ns, std::uint64_t bytes) {
    return head(5, 22 + bytes) + raw(id) + raw<std::uint32_t>(0) + raw(time_ns) + raw(time_ns);
  }

  /// Two samples of the INS, then a scan of one real point and zeros, which are no returns.
  void add_chunk(int i, std::uint64_t scan_bytes) {
    std::string small, index[3];
    const auto enter = [&](std::uint16_t id, std::int64_t time_ns, const std::string& bytes, std::uint64_t more) {
      index[id] += raw(time_ns) + raw<std::uint64_t>(small.size());
      small += message_head(id, time_ns, bytes.size() + more) + bytes;
    };
    for (int k = 0; k < 2; ++k) {
      const InsSample sample = BagMaker::on_circle(2 * i + k);
      const GnssFix fix{sample.stamp_ns, sample.latitude_rad, sample.longitude_rad, 100.0, Eigen::Matrix3d::Identity()};
      enter(1, sample.stamp_ns, attitude_message(sample, 0.001, "ins", kCdr), 0);
      enter(2, sample.stamp_ns, fix_message(fix, 2, "ins", kCdr), 0);
    }
    const std::int64_t stamp_ns = kStart_ns + i * kStep_ns;
    const auto points = static_cast<std::uint32_t>(scan_bytes / 16);
    MessageWriter scan(kCdr);
    scan.header(stamp_ns, "lidar").number<std::uint32_t>(1).number(points).number<std::uint32_t>(3);
    for (std::uint32_t axis = 0; axis < 3; ++axis)
      scan.string(std::string(1, static_cast<char>('x' + axis)))
          .number(axis * 4)
          .number<std::uint8_t>(7)
          .number<std::uint32_t>(1);
    scan.number<std::uint8_t>(0).number<std::uint32_t>(16).number(points * 16).number(points * 16);
    const std::string first_point = raw(1.0f) + raw(2.0f) + raw(static_cast<float>(i));
    const std::uint64_t rest = std::uint64_t{points} * 16 - first_point.size();
    enter(0, stamp_ns, scan.bytes() + first_point, rest + 1);
    const std::uint64_t chunk_bytes = small.size() + rest + 1, start = at_;
    const std::string about =
        raw(stamp_ns) + raw(stamp_ns) + raw(chunk_bytes) + raw<std::uint32_t>(0) + counted("") + raw(chunk_bytes);
    put(head(6, about.size() + chunk_bytes) + about + small);
    skip(rest);
    put(std::string(1, '\1'));
    const std::uint64_t length = at_ - start;
    std::string indexes, offsets;
    for (std::uint16_t id = 0; id < 3; ++id) {
      offsets += raw(id) + raw<std::uint64_t>(at_ + indexes.size());
      indexes += record(7, raw(id) + counted(index[id]));
    }
    put(indexes);
    infos_ += record(8, raw(stamp_ns) + raw(stamp_ns) + raw(start) + raw(length) + counted(offsets) +
                            raw<std::uint64_t>(indexes.size()) + counted("") + raw(chunk_bytes) + raw(chunk_bytes));
  }

  std::FILE* file_;
  std::uint64_t at_ = 0;
  std::string infos_;
};

TEST(large_mcap, opens_twenty_gigabytes_in_seconds_and_takes_memory_for_one_scan_at_a_time) {
  constexpr int kChunks = 2000;
  constexpr std::uint64_t kScanBytes = 10'500'000;
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "drive.mcap";
  { SparseMcap bag(path, kChunks, kScanBytes); }
  const double bytes = static_cast<double>(fs::file_size(path));
  ASSERT_GT(bytes, 20e9);
  const double before_mb = peak_mb();
  const auto started = std::chrono::steady_clock::now();
  const Session session = open(path);
  const double opened_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
  const double opened_mb = peak_mb() - before_mb;
  EXPECT_FALSE(find(session, "bag-unindexed"));
  ASSERT_TRUE(session.scans);
  EXPECT_EQ(session.scans->size(), std::size_t{kChunks});
  EXPECT_EQ(session.ins.size(), std::size_t{2 * kChunks});
  for (const std::size_t scan : {std::size_t{0}, std::size_t{1234}, std::size_t{kChunks - 1}}) {
    const PointCloud cloud = session.scans->load(scan);
    ASSERT_EQ(cloud.size(), 1u);
    EXPECT_EQ(cloud.points[0], Eigen::Vector3f(1.0f, 2.0f, static_cast<float>(scan)));
    EXPECT_EQ(cloud.dropped_points, kScanBytes / 16 - 1);
  }
  std::cout << bytes * 1e-9 << " GB: opened in " << opened_s << " s, memory grew by " << opened_mb
            << " MB, with scans by " << peak_mb() - before_mb << " MB\n";
  EXPECT_LT(opened_s, 5.0 * kSanitizerSlowdown);
  EXPECT_LT(peak_mb() - before_mb, 100.0 + kSanitizerKeeps_mb);
}

}  // namespace
}  // namespace remount
