// A bag that is larger than memory, written with holes.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <chrono>

#include "model/io/bag/bag_streams.h"
#include "tests/model/io/bag/bag_maker.h"
#include "tests/support/sanitized.h"

namespace remount {
namespace {

using namespace bags;

/// Peak memory of the process, MB.
double peak_mb() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

std::string ros1_field(const std::string& name, const std::string& value) { return counted(name + "=" + value); }
std::string ros1_head(const std::string& header, std::uint64_t data_bytes) {
  return counted(header) + raw(static_cast<std::uint32_t>(data_bytes));
}
std::string ros1_time(std::int64_t time_ns) {
  return raw(static_cast<std::uint32_t>(time_ns / 1'000'000'000)) +
         raw(static_cast<std::uint32_t>(time_ns % 1'000'000'000));
}

/// Chunks with holes where the points would be, and their index at the end.
class SparseBag {
 public:
  SparseBag(const fs::path& path, int chunks, std::uint64_t scan_bytes) : file_(std::fopen(path.c_str(), "wb")) {
    put("#ROSBAG V2.0\n" + bag_header(0));
    for (int i = 0; i < chunks; ++i) add_chunk(i, scan_bytes);
    const std::uint64_t index = at_;
    const char* topics[] = {"/points", "/ins/imu", "/ins/fix"};
    const char* types[] = {"sensor_msgs/PointCloud2", "sensor_msgs/Imu", "sensor_msgs/NavSatFix"};
    for (std::uint32_t id = 0; id < 3; ++id) {
      const std::string data = ros1_field("topic", topics[id]) + ros1_field("type", types[id]) +
                               ros1_field("md5sum", "*") + ros1_field("message_definition", "");
      put(ros1_head(op(7) + ros1_field("conn", raw(id)) + ros1_field("topic", topics[id]), data.size()) + data);
    }
    put(infos_);
    std::fseek(file_, 13, SEEK_SET);
    const std::string head = bag_header(index);
    std::fwrite(head.data(), 1, head.size(), file_);
  }
  ~SparseBag() { std::fclose(file_); }

 private:
  static std::string op(std::uint8_t code) { return ros1_field("op", raw(code)); }
  static std::string bag_header(std::uint64_t index) {
    const std::string header = op(3) + ros1_field("index_pos", raw(index)) +
                               ros1_field("conn_count", raw<std::uint32_t>(3)) +
                               ros1_field("chunk_count", raw<std::uint32_t>(0));
    const std::uint64_t padding = 4096 - 8 - header.size();
    return ros1_head(header, padding) + std::string(padding, ' ');
  }
  static std::string message_head(std::uint32_t id, std::int64_t time_ns, std::uint64_t bytes) {
    return ros1_head(op(2) + ros1_field("conn", raw(id)) + ros1_field("time", ros1_time(time_ns)), bytes);
  }

  void put(const std::string& bytes) {
    std::fwrite(bytes.data(), 1, bytes.size(), file_);
    at_ += bytes.size();
  }
  void skip(std::uint64_t bytes) {
    std::fseek(file_, static_cast<long>(bytes), SEEK_CUR);
    at_ += bytes;
  }

  void add_chunk(int i, std::uint64_t scan_bytes) {
    // Two samples of the INS, then a scan of one real point and zeros, which are no returns.
    std::string small;
    std::string index[3];
    const auto enter = [&](std::uint32_t id, std::int64_t time_ns) {
      index[id] += ros1_time(time_ns) + raw(static_cast<std::uint32_t>(small.size()));
    };
    for (int k = 0; k < 2; ++k) {
      const InsSample sample = BagMaker::on_circle(2 * i + k);
      const std::string imu = attitude_message(sample, 0.001, "ins", kRos1);
      const GnssFix fix{sample.stamp_ns, sample.latitude_rad, sample.longitude_rad, 100.0, Eigen::Matrix3d::Identity()};
      const std::string position = fix_message(fix, 2, "ins", kRos1);
      enter(1, sample.stamp_ns);
      small += message_head(1, sample.stamp_ns, imu.size()) + imu;
      enter(2, sample.stamp_ns);
      small += message_head(2, sample.stamp_ns, position.size()) + position;
    }
    const std::int64_t stamp_ns = kStart_ns + i * kStep_ns;
    const std::uint32_t points = static_cast<std::uint32_t>(scan_bytes / 16);
    MessageWriter scan(kRos1);
    scan.header(stamp_ns, "lidar").number<std::uint32_t>(1).number(points).number<std::uint32_t>(3);
    for (std::uint32_t axis = 0; axis < 3; ++axis)
      scan.string(std::string(1, static_cast<char>('x' + axis)))
          .number(axis * 4)
          .number<std::uint8_t>(7)
          .number<std::uint32_t>(1);
    scan.number<std::uint8_t>(0).number<std::uint32_t>(16).number(points * 16).number(points * 16);
    const std::string first_point = raw(1.0f) + raw(2.0f) + raw(static_cast<float>(i));
    const std::uint64_t rest = std::uint64_t{points} * 16 - first_point.size();
    enter(0, stamp_ns);
    small +=
        message_head(0, stamp_ns, scan.bytes().size() + first_point.size() + rest + 1) + scan.bytes() + first_point;
    const std::uint64_t chunk_bytes = small.size() + rest + 1, offset = at_;
    put(ros1_head(op(5) + ros1_field("compression", "none") +
                      ros1_field("size", raw(static_cast<std::uint32_t>(chunk_bytes))),
                  chunk_bytes) +
        small);
    skip(rest);
    put(std::string(1, '\1'));
    for (std::uint32_t id = 0; id < 3; ++id)
      put(ros1_head(op(4) + ros1_field("ver", raw<std::uint32_t>(1)) + ros1_field("conn", raw(id)) +
                        ros1_field("count", raw(static_cast<std::uint32_t>(index[id].size() / 12))),
                    index[id].size()) +
          index[id]);
    infos_ += ros1_head(op(6) + ros1_field("ver", raw<std::uint32_t>(1)) + ros1_field("chunk_pos", raw(offset)), 0);
  }

  std::FILE* file_;
  std::uint64_t at_ = 0;
  std::string infos_;
};

TEST(large_bag, opens_twenty_gigabytes_in_seconds_and_takes_memory_for_one_scan_at_a_time) {
  constexpr int kChunks = 2000;
  constexpr std::uint64_t kScanBytes = 10'500'000;
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "drive.bag";
  { SparseBag bag(path, kChunks, kScanBytes); }
  const double bytes = static_cast<double>(fs::file_size(path));
  ASSERT_GT(bytes, 20e9);
  const double before_mb = peak_mb();
  const auto started = std::chrono::steady_clock::now();
  const Session session = open(path);
  const double opened_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
  const double opened_mb = peak_mb() - before_mb;
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

// ---- Compressed chunks

/// Bytes that do not pack, the same for every scan: points without times.
const PointCloud& noise_cloud() {
  static const PointCloud cloud = [] {
    PointCloud points;
    std::uint32_t state = 1;
    const auto draw = [&] { return 1.0f + static_cast<float>((state = state * 1664525U + 1013904223U) >> 8) * 1e-6f; };
    for (int i = 0; i < 150'000; ++i) {
      const float x = draw(), y = draw(), z = draw();
      points.points.emplace_back(x, y, z);
    }
    return points;
  }();
  return cloud;
}

struct SpoiltBag {
  std::size_t scans = 0, spoilt = 0;
};

/// A bag of chunks with samples of the INS and a scan each, as recorders make them. Where `spoil`, the last tenth of
/// each chunk, which holds points, is overwritten.
SpoiltBag write_packed_bag(const fs::path& path, ChunkCompression compression, std::uint64_t bytes, bool spoil) {
  const auto writer = make_mcap_writer(path, MessageEncoding::Cdr, compression);
  const std::uint32_t points = writer->add_topic("/points", definition("sensor_msgs/PointCloud2")),
                      fixes = writer->add_topic("/ins/fix", definition("sensor_msgs/NavSatFix")),
                      imu = writer->add_topic("/ins/imu", definition("sensor_msgs/Imu"));
  SpoiltBag made;
  for (std::uint64_t written = 0; written < bytes; ++made.scans) {
    const int i = static_cast<int>(made.scans);
    for (int k = 0; k < 2; ++k) {
      const InsSample sample = BagMaker::on_circle(2 * i + k);
      const GnssFix fix{sample.stamp_ns, sample.latitude_rad, sample.longitude_rad, 100.0, Eigen::Matrix3d::Identity()};
      writer->write(imu, sample.stamp_ns, attitude_message(sample, 0.001, "ins", MessageEncoding::Cdr));
      writer->write(fixes, sample.stamp_ns, fix_message(fix, 2, "ins", MessageEncoding::Cdr));
    }
    // Stamps that the recorder's times do not tell.
    const std::int64_t stamp_ns = kStart_ns + i * kStep_ns + (i * 7919) % 3'000'000;
    const std::string scan = cloud_message(noise_cloud(), stamp_ns, "lidar", MessageEncoding::Cdr);
    writer->write(points, kStart_ns + i * kStep_ns + kStep_ns / 2 + 1'000'000, scan);
    written += scan.size();
  }
  writer->finish();
  if (!spoil) return made;
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  for (std::uint64_t at = 8;;) {
    std::uint8_t op = 0;
    std::uint64_t length = 0;
    file.seekg(static_cast<std::streamoff>(at));
    file.read(reinterpret_cast<char*>(&op), 1).read(reinterpret_cast<char*>(&length), 8);
    if (!file || op == 15) break;
    if (op == 6 && length > 1'000'000) {
      file.seekp(static_cast<std::streamoff>(at + 9 + length - length / 10));
      file << std::string(length / 10, '\xff');
      ++made.spoilt;
    }
    at += 9 + length;
  }
  return made;
}

TEST(large_bag, with_compressed_chunks_is_opened_without_unpacking_the_points) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "drive.mcap";
  for (const ChunkCompression compression : {ChunkCompression::Zstd, ChunkCompression::Lz4}) {
    const SpoiltBag made = write_packed_bag(path, compression, std::uint64_t{320} << 20, true);
    ASSERT_GT(fs::file_size(path), std::uint64_t{256} << 20);
    EXPECT_EQ(made.spoilt, made.scans);
    const auto started = std::chrono::steady_clock::now();
    const auto bag = open_quietly(path);
    std::vector<Finding> findings;
    Progress progress;
    const TopicRoles roles = choose_topics(*bag, {}, findings).roles;
    const BagStreams streams = read_streams(*bag, roles, findings, progress);
    const double took_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
    EXPECT_EQ(streams.attitude.messages.size(), 2 * made.scans);
    EXPECT_EQ(streams.position.messages.size(), 2 * made.scans);
    ASSERT_EQ(streams.scans.scans.size(), made.scans);
    for (std::size_t i = 0; i < made.scans; ++i)
      EXPECT_EQ(streams.scans.scans[i].stamp_ns,
                kStart_ns + static_cast<std::int64_t>(i) * kStep_ns + static_cast<std::int64_t>(i * 7919 % 3'000'000));
    // The points themselves are checked when they are asked for, and the damage is told.
    const BagTopic& scans = bag->topics()[*roles.lidar];
    EXPECT_ERROR(bag->message(scans.entries.back()), "the compressed chunk is damaged");
    std::cout << "compression " << static_cast<int>(compression) << ": "
              << static_cast<double>(fs::file_size(path)) * 1e-9 << " GB, streams read in " << took_s << " s\n";
  }
}

}  // namespace
}  // namespace remount
