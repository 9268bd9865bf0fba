// A bag of ROS 1 that is larger than memory, and large bags of compressed chunks.
#include <fstream>

#include "model/formats/bags/bag_streams.h"
#include "tests/model/formats/bags/large_fixture.h"

namespace remount::bags {
namespace {

std::string ros1_field(const std::string& name, const std::string& value) { return counted(name + "=" + value); }
std::string ros1_head(const std::string& header, std::uint64_t data_bytes) {
  return counted(header) + raw(static_cast<std::uint32_t>(data_bytes));
}
std::string ros1_time(std::int64_t time_ns) {
  return raw(static_cast<std::uint32_t>(time_ns / 1'000'000'000)) +
         raw(static_cast<std::uint32_t>(time_ns % 1'000'000'000));
}

/// Chunks and their index at the end.
class SparseBag {
 public:
  SparseBag(const fs::path& path, int chunks, std::uint64_t scan_bytes) : file_(path) {
    file_.put("#ROSBAG V2.0\n" + bag_header(0));
    for (int i = 0; i < chunks; ++i) add_chunk(i, scan_bytes);
    const std::uint64_t index = file_.at();
    for (std::uint32_t id = 0; id < 3; ++id) {
      const std::string data = ros1_field("topic", kLargeTopics[id]) + ros1_field("type", kLargeTypes[id]) +
                               ros1_field("md5sum", "*") + ros1_field("message_definition", "");
      file_.put(ros1_head(op(7) + ros1_field("conn", raw(id)) + ros1_field("topic", kLargeTopics[id]), data.size()) +
                data);
    }
    file_.put(infos_);
    file_.put_at(13, bag_header(index));
  }

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

  void add_chunk(int i, std::uint64_t scan_bytes) {
    std::string small;
    std::string index[3];
    const auto enter = [&](std::uint32_t id, std::int64_t time_ns, const std::string& bytes, std::uint64_t more) {
      index[id] += ros1_time(time_ns) + raw(static_cast<std::uint32_t>(small.size()));
      small += message_head(id, time_ns, bytes.size() + more) + bytes;
    };
    for (int k = 0; k < kInsPerScan; ++k) {
      const LargeInsMessages ins = large_ins_messages(kInsPerScan * i + k, kRos1);
      enter(1, ins.stamp_ns, ins.imu, 0);
      enter(2, ins.stamp_ns, ins.fix, 0);
    }
    const LargeScan scan = large_scan(i, scan_bytes, kRos1);
    enter(0, scan.stamp_ns, scan.begin, scan.zeros + scan.end.size());
    const std::uint64_t chunk_bytes = small.size() + scan.zeros + scan.end.size(), offset = file_.at();
    file_.put(ros1_head(op(5) + ros1_field("compression", "none") +
                            ros1_field("size", raw(static_cast<std::uint32_t>(chunk_bytes))),
                        chunk_bytes) +
              small);
    file_.skip(scan.zeros);
    file_.put(scan.end);
    for (std::uint32_t id = 0; id < 3; ++id)
      file_.put(ros1_head(op(4) + ros1_field("ver", raw<std::uint32_t>(1)) + ros1_field("conn", raw(id)) +
                              ros1_field("count", raw(static_cast<std::uint32_t>(index[id].size() / 12))),
                          index[id].size()) +
                index[id]);
    infos_ += ros1_head(op(6) + ros1_field("ver", raw<std::uint32_t>(1)) + ros1_field("chunk_pos", raw(offset)), 0);
  }

  SparseFile file_;
  std::string infos_;
};

TEST(large_bag, opens_twenty_gigabytes_in_seconds_and_takes_memory_for_one_scan_at_a_time) {
  constexpr int kScans = 2000;
  constexpr std::uint64_t kScanBytes = 10'500'000;
  const formats::TemporaryFolder folder;
  const fs::path path = folder.path() / "drive.bag";
  { SparseBag bag(path, kScans, kScanBytes); }
  expect_opens_in_seconds(path, kScans, kScanBytes);
}

// ---- Compressed chunks

/// Bytes that do not pack, the same for every scan: points without times.
const cloud::PointCloud& noise_cloud() {
  static const cloud::PointCloud cloud = [] {
    cloud::PointCloud points;
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

/// Of a message whose header is its first field. Writing all of its points anew takes ten times as long.
void set_stamp(std::int64_t stamp_ns, std::string& cdr_message) {
  constexpr std::size_t kEncapsulation = 4, kSeconds = 4;
  cdr_message.replace(kEncapsulation, kSeconds, raw(static_cast<std::uint32_t>(stamp_ns / 1'000'000'000)));
  cdr_message.replace(kEncapsulation + kSeconds, 4, raw(static_cast<std::uint32_t>(stamp_ns % 1'000'000'000)));
}

/// A bag of chunks with samples of the INS and a scan each, as recorders make them. Where `spoil`, the last tenth of
/// each chunk, which holds points, is overwritten.
SpoiltBag write_packed_bag(const fs::path& path, ChunkCompression compression, std::uint64_t bytes, bool spoil) {
  const auto writer = make_mcap_writer(path, MessageEncoding::Cdr, compression);
  const std::uint32_t points = writer->add_topic("/points", definition("sensor_msgs/PointCloud2")),
                      fixes = writer->add_topic("/ins/fix", definition("sensor_msgs/NavSatFix")),
                      imu = writer->add_topic("/ins/imu", definition("sensor_msgs/Imu"));
  SpoiltBag made;
  std::string scan = cloud_message(noise_cloud(), kStart_ns, "lidar", MessageEncoding::Cdr);
  for (std::uint64_t written = 0; written < bytes; ++made.scans) {
    const int i = static_cast<int>(made.scans);
    for (int k = 0; k < 2; ++k) {
      const motion::InsSample sample = BagMaker::on_circle(2 * i + k);
      const motion::GnssFix fix{sample.stamp_ns, sample.latitude_rad, sample.longitude_rad, 100.0,
                                Eigen::Matrix3d::Identity()};
      writer->write(imu, sample.stamp_ns, attitude_message(sample, 0.001, "ins", MessageEncoding::Cdr));
      writer->write(fixes, sample.stamp_ns, fix_message(fix, 2, "ins", MessageEncoding::Cdr));
    }
    // Stamps that the recorder's times do not tell.
    const std::int64_t stamp_ns = kStart_ns + i * kStep_ns + (i * 7919) % 3'000'000;
    set_stamp(stamp_ns, scan);
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
  const formats::TemporaryFolder folder;
  const fs::path path = folder.path() / "drive.mcap";
  for (const ChunkCompression compression : {ChunkCompression::Zstd, ChunkCompression::Lz4}) {
    const SpoiltBag made = write_packed_bag(path, compression, std::uint64_t{320} << 20, true);
    ASSERT_GT(fs::file_size(path), std::uint64_t{256} << 20);
    EXPECT_EQ(made.spoilt, made.scans);
    const auto started = std::chrono::steady_clock::now();
    const auto bag = open_quietly(path);
    std::vector<drive::Finding> findings;
    Progress progress;
    const ChosenTopics chosen = choose_topics(*bag, {}, findings, std::make_shared<PacketTopics>());
    const TopicRoles& roles = chosen.roles;
    const BagStreams streams = read_streams(*bag, chosen, findings, progress);
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
}  // namespace remount::bags
