// No reader takes more memory than four times what it reads, and a constant.
#include <gtest/gtest.h>

#include <cstdio>
#include <iostream>

#include "model/formats/bags/cloud_message.h"
#include "model/formats/bags/message_writer.h"
#include "model/formats/clouds/cloud_file.h"
#include "model/formats/documents/table_rows.h"
#include "model/formats/poses/pose_file.h"
#include "tests/model/formats/allocation_meter.h"
#include "tests/model/formats/bags/bag_fixtures.h"
#include "tests/model/formats/las_bytes.h"
#include "tests/model/formats/laz/made_scans.h"
#include "tests/model/formats/mutator.h"
#include "tests/model/formats/reader_outcome.h"
#include "tests/model/formats/sample_files.h"
#include "tests/model/formats/sample_inputs.h"
#include "tests/model/formats/temporary_folder.h"
#include "tests/support/findings.h"

namespace remount::formats {
namespace {

namespace fs = std::filesystem;

/// Without the judgement of a session, which proposes its pairs.
Outcome only_opened(const Reader& reader, const fs::path& input, const fs::path& folder) {
  for (const auto& sessions : session_readers()) {
    if (!sessions->id().starts_with(reader.name)) continue;
    Progress progress;
    return {.read = true, .text = open_session(input, progress).name};
  }
  for (const char* scan : {"pcd", "ply", "las", "kitti-bin", "scan-text"})
    if (reader.name == scan) return {.read = !load_cloud(input, 1'600'000'000'000'000'000).points.empty(), .text = ""};
  return outcome_of(reader, input, folder);
}

std::string repeated(const std::string& line, int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += line;
  return text;
}

/// A column of points that are bytes, as narrow as its type.
struct NarrowColumn {
  const char* name;
  char type;  ///< I, U or F
  int bytes;
};

std::string narrow_pcd(const std::vector<NarrowColumn>& columns, std::size_t points) {
  std::string fields = "FIELDS", sizes = "SIZE", types = "TYPE";
  std::size_t point_bytes = 0;
  for (const NarrowColumn& column : columns) {
    fields += std::string(" ") + column.name, sizes += " " + std::to_string(column.bytes);
    types += std::string(" ") + column.type, point_bytes += static_cast<std::size_t>(column.bytes);
  }
  const std::string count = std::to_string(points);
  return "VERSION 0.7\n" + fields + "\n" + sizes + "\n" + types + "\nWIDTH " + count + "\nHEIGHT 1\nPOINTS " + count +
         "\nDATA binary\n" + std::string(points * point_bytes, '\1');
}

std::vector<NarrowColumn> coordinates(int bytes) { return {{"x", 'I', bytes}, {"y", 'I', bytes}, {"z", 'I', bytes}}; }

std::vector<NarrowColumn> and_more(std::vector<NarrowColumn> columns, const std::vector<NarrowColumn>& more) {
  columns.insert(columns.end(), more.begin(), more.end());
  return columns;
}

/// A PointCloud2 of one-byte points on which all columns lie, or of the columns one behind the other.
std::string narrow_message(const std::vector<NarrowColumn>& columns, std::size_t points, bool on_each_other) {
  bags::MessageWriter writer(bags::MessageEncoding::Ros1);
  writer.header(bags::kStart_ns, "lidar").number<std::uint32_t>(1).number(static_cast<std::uint32_t>(points));
  writer.number(static_cast<std::uint32_t>(columns.size()));
  std::uint32_t at = 0;
  for (const NarrowColumn& column : columns) {
    const int type = column.type == 'F' ? 7
                                        : (column.bytes == 1   ? 1
                                           : column.bytes == 2 ? 3
                                                               : 5) +
                                              (column.type == 'U');
    writer.string(column.name).number(on_each_other ? 0U : at).number(static_cast<std::uint8_t>(type));
    writer.number<std::uint32_t>(1);
    at += static_cast<std::uint32_t>(column.bytes);
  }
  const std::uint32_t point_bytes = on_each_other ? static_cast<std::uint32_t>(columns.front().bytes) : at;
  writer.number<std::uint8_t>(0).number(point_bytes).number(static_cast<std::uint32_t>(point_bytes * points));
  return writer.byte_sequence(std::string(points * point_bytes, '\1')).number<std::uint8_t>(1).bytes();
}

/// A bag of an INS and of scans.
std::string bag_of(std::unique_ptr<bags::BagWriter> writer, const fs::path& path,
                   const std::vector<std::string>& scans) {
  const auto cloud =
      writer->add_topic("/points", bags::message_definition("sensor_msgs/PointCloud2", bags::MessageEncoding::Ros1));
  const auto imu = writer->add_topic("/imu", bags::message_definition("sensor_msgs/Imu", bags::MessageEncoding::Ros1));
  const auto fix =
      writer->add_topic("/fix", bags::message_definition("sensor_msgs/NavSatFix", bags::MessageEncoding::Ros1));
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const std::int64_t stamp_ns = bags::kStart_ns + static_cast<std::int64_t>(i) * 100'000'000;
    motion::InsSample sample;
    sample.stamp_ns = stamp_ns;
    writer->write(cloud, stamp_ns, scans[i]);
    writer->write(imu, stamp_ns, bags::attitude_message(sample, 0.001, "ins", bags::MessageEncoding::Ros1));
    writer->write(fix, stamp_ns,
                  bags::fix_message({stamp_ns, 0.7, 0.2, 100.0, {}}, 2, "ins", bags::MessageEncoding::Ros1));
  }
  writer->finish();
  return bytes_of(path);
}

/// Twenty megabytes: three seconds of a sensor of 32 beams.
std::string real_bag(bool mcap) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "bag";
  cloud::PointCloud cloud;
  Mutator draw(3);
  for (std::size_t k = 0; k < 30000; ++k) {
    cloud.points.emplace_back(static_cast<float>(1 + draw.below(100'000)), 2.0f, 3.0f);
    cloud.intensity.push_back(static_cast<float>(draw.below(256)));
    cloud.ring.push_back(static_cast<std::uint16_t>(k % 32));
    cloud.time_from_stamp_s.push_back(0.1f * static_cast<float>(k) / 30000.0f);
  }
  const std::vector<std::string> scans(
      34, bags::cloud_message(cloud, bags::kStart_ns, "lidar", bags::MessageEncoding::Ros1));
  return bag_of(
      mcap ? bags::make_mcap_writer(path, bags::MessageEncoding::Ros1, bags::ChunkCompression::None, 768 * 1024)
           : bags::make_rosbag1_writer(path, bags::ChunkCompression::None, 768 * 1024),
      path, scans);
}

/// Of opening a bag and reading its scans.
std::size_t peak_of_scans(const fs::path& path) {
  const AllocationMeter meter;
  Progress progress;
  const drive::Session session = open_session(path, progress);
  for (std::size_t i = 0; i < session.scans->size(); ++i) try {
      session.scans->load(i);
    } catch (const Error&) {
      continue;
    }
  return meter.peak_bytes();
}

TEST(long_inputs, in_bags_of_real_size_take_no_more_than_their_index_and_a_scan) {
  if (!AllocationMeter::works()) GTEST_SKIP() << "the sanitizers count allocations themselves";
  for (const char* name : {"rosbag1", "mcap"}) {
    const TemporaryFolder folder;
    const Reader& reader = reader_of(name);
    const std::string bytes = real_bag(reader.name == "mcap");
    const fs::path path = write_input(reader, bytes, folder.path());
    const std::size_t peak = peak_of_scans(path);
    std::cout << name << ": " << (bytes.size() >> 20) << " MiB, memory " << (peak >> 10) << " KiB\n";
    EXPECT_GT(bytes.size(), std::size_t{20} << 20);
    EXPECT_LT(peak, 4 * bytes.size() + constant_bytes(reader)) << name;
  }
}

TEST(long_inputs, of_narrow_columns_take_at_most_four_times_their_size_or_are_refused) {
  if (!AllocationMeter::works()) GTEST_SKIP() << "the sanitizers count allocations themselves";
  const std::vector<NarrowColumn> two = coordinates(2), one = coordinates(1);
  const std::vector<NarrowColumn> bytes_more{{"intensity", 'U', 1}, {"ring", 'U', 1}, {"time", 'U', 1}};
  const std::vector<std::pair<std::vector<NarrowColumn>, bool>> layouts{
      {one, false},
      {and_more(one, bytes_more), false},
      {two, true},
      {and_more(two, bytes_more), true},
      {and_more(two, {{"time", 'U', 1}}), true},
      {and_more(two, {{"time", 'U', 2}}), true},
      {and_more(two, {{"time", 'F', 4}}), true},
      {and_more(two, {{"intensity", 'U', 1}, {"time", 'U', 4}}), true},
      {and_more(two, {{"intensity", 'U', 1}, {"ring", 'U', 1}, {"time", 'F', 4}}), true},
  };
  const auto measured = [](const auto& load, std::size_t size, bool expected, const std::string& what) {
    const AllocationMeter meter;
    bool is_read = true;
    try {
      load();
    } catch (const Error& error) {
      is_read = false;
    }
    const std::size_t taken = meter.peak_bytes();
    std::cout << what << (is_read ? "" : " (refused)") << ": " << (size >> 10) << " KiB, memory "
              << static_cast<double>(taken) / static_cast<double>(size) << " times as much\n";
    EXPECT_EQ(is_read, expected) << what;
    EXPECT_LT(taken, 4 * size + (std::size_t{1} << 20)) << what;
  };
  constexpr std::size_t kPoints = 1'000'000;
  const TemporaryFolder folder;
  for (const auto& [columns, accepted] : layouts) {
    std::string what;
    for (const NarrowColumn& column : columns) what += column.name + std::to_string(column.bytes) + " ";
    const std::string pcd = narrow_pcd(columns, kPoints);
    const fs::path path = write_input(reader_of("pcd"), pcd, folder.path());
    measured([&] { load_cloud(path, 0); }, pcd.size(), accepted, "PCD, " + what);
    for (const bool on_each_other : {false, true}) {
      // A copy is the reader's: a bag gives it the bytes of the message.
      const std::string message = narrow_message(columns, kPoints, on_each_other);
      measured(
          [&] {
            const std::string bytes = message;
            bags::MessageReader reader(bytes, bags::MessageEncoding::Ros1, "message");
            bags::read_cloud(reader, bags::MessageKind::PointCloud2, bags::kStart_ns);
          },
          message.size(), accepted && !on_each_other, (on_each_other ? "message on itself, " : "message, ") + what);
    }
  }
}

TEST(long_inputs, whose_scans_lie_on_themselves_are_opened_without_their_memory) {
  if (!AllocationMeter::works()) GTEST_SKIP() << "the sanitizers count allocations themselves";
  std::vector<NarrowColumn> columns =
      and_more(coordinates(1), {{"intensity", 'U', 1}, {"ring", 'U', 1}, {"time", 'U', 1}});
  const TemporaryFolder folder, made;
  const Reader& reader = reader_of("rosbag1");
  const std::string bytes =
      bag_of(bags::make_rosbag1_writer(made.path() / "bag", bags::ChunkCompression::None, 768 * 1024),
             made.path() / "bag", std::vector<std::string>(3, narrow_message(columns, 8'000'000, true)));
  const std::size_t peak = peak_of_scans(write_input(reader, bytes, folder.path()));
  std::cout << "a bag of " << (bytes.size() >> 20) << " MiB, memory " << (peak >> 20) << " MiB\n";
  EXPECT_LT(peak, 4 * bytes.size() / 3 + constant_bytes(reader)) << "four times a message";
}

TEST(long_inputs, take_at_most_four_times_their_size) {
  if (!AllocationMeter::works()) GTEST_SKIP() << "the sanitizers count allocations themselves";
  using namespace samples;
  const PackedFile lidar{"lidar.txt", poses(" ", 30000)};
  LasOptions points;
  points.points.assign(100000, {1.0, 2.0, 3.0});
  RandomValues random(3);
  const std::vector<laz::Point> scan = laz::made_points(random, 100000, 1, {});
  const std::string packed_las = laz::laz_of(scan, {});
  // What is compressed counts as it is unpacked; for hostile promises see above.
  const std::size_t unpacked_bytes = binary_pcd(200000).size();
  const std::vector<Sample> inputs{
      {"poses", "text", pack_files({{"hand.csv", poses(",", 30000)}, lidar})},
      {"poses", "blank lines",
       pack_files({{"hand.csv", poses(",", 40) + std::string(2'000'000, '\n')}, {"lidar.txt", poses(" ", 40)}})},
      {"novatel", "log", pack_files({{"a.log", inspvax_log(20000)}, lidar})},
      {"novatel", "inspva", pack_files({{"a.log", inspva_log(20000)}, lidar})},
      {"novatel", "binary", pack_files({{"a.gps", novatel_binary(30000)}, lidar})},
      {"novatel", "csv", pack_files({{"ins.csv", inspvax_csv(30000)}, {"aft_mapped.csv", odometry_csv(30000)}})},
      {"gnss-log", "nmea", pack_files({{"gnss.nmea", nmea(30000)}, lidar})},
      {"gnss-log", "headings", pack_files({{"gnss.nmea", nmea_headings(30000)}, lidar})},
      {"gnss-log", "headings of few poses",
       pack_files({{"gnss.nmea", nmea_headings(30000)}, {"lidar.txt", poses(" ", 200)}})},
      {"gnss-log", "headings of short lines",
       pack_files({{"gnss.nmea", nmea_short(200'000)}, {"lidar.txt", poses(" ", 200)}})},
      {"gnss-log", "gpx", pack_files({{"track.gpx", gpx(30000)}, lidar})},
      {"smartloc", "drive", smartloc(30000)},
      {"motion-pairs", "pairs", motion_pairs(20000)},
      {"pcd", "ascii", ascii_pcd(200000)},
      {"pcd", "binary", binary_pcd(200000)},
      {"pcd", "compressed", compressed_pcd(200000)},
      {"ply", "ascii", ply("ascii", 200000)},
      {"ply", "binary", ply("binary_little_endian", 200000)},
      {"las", "points", las(points)},
      {"las", "packed", packed_las},
      {"kitti-bin", "points", kitti_bin(200000)},
      {"scan-text", "points", repeated("1 2 3\n", 700000)},
      {"scan-text", "times", "x y z t\n" + repeated("1 2 3 4\n", 500000)},
      {"scan-text", "all columns", "x,y,z,i,ring,t\n" + repeated("1,2,3,4,5,6\n", 400000)},
      {"scan-text", "blank lines", "1 2 3\n" + std::string(4'000'000, '\n')},
  };
  for (const Sample& input : inputs) {
    const TemporaryFolder folder;
    const Reader& reader = reader_of(input.reader);
    const fs::path path = write_input(reader, input.bytes, folder.path());
    const AllocationMeter meter;
    const Outcome outcome = only_opened(reader, path, folder.path());
    const double times = static_cast<double>(meter.peak_bytes()) / static_cast<double>(input.bytes.size());
    std::cout << input.reader << ", " << input.name << ": " << (input.bytes.size() >> 10) << " KiB, memory " << times
              << " times as much\n";
    EXPECT_TRUE(outcome.read) << input.reader << ", " << input.name << ": " << outcome.text.substr(0, 400);
    const std::size_t size = input.name == "compressed" ? unpacked_bytes
                             : input.name == "packed"   ? laz::plain_of(scan, {}).size()
                                                        : input.bytes.size();
    EXPECT_LT(meter.peak_bytes(), 4 * size + constant_bytes(reader)) << input.reader << ", " << input.name;
  }
}

TEST(long_inputs, of_one_line_of_separators_are_refused_without_their_memory) {
  if (!AllocationMeter::works()) GTEST_SKIP() << "the sanitizers count allocations themselves";
  constexpr std::size_t kMegabytes = 8;
  const TemporaryFolder folder;
  const auto refused = [&](const std::string& name, const std::string& text, const auto& read) {
    const fs::path path = folder.write(name, text);
    const AllocationMeter meter;
    bool is_read = true;
    try {
      read(path);
    } catch (const Error&) {
      is_read = false;
    }
    const double times = static_cast<double>(meter.peak_bytes()) / static_cast<double>(text.size());
    std::cout << name << " begins with '" << text.substr(0, 6) << "': memory " << times << " times as much\n";
    EXPECT_FALSE(is_read) << name;
    EXPECT_LT(meter.peak_bytes(), 3 * text.size() + (std::size_t{1} << 20)) << name;
  };
  for (const std::string& one : {std::string(","), std::string(";"), std::string(" 1"), std::string("\t1")}) {
    const std::string line = repeated(one, static_cast<int>((kMegabytes << 20) / one.size())) + "\n";
    for (const std::string& text : {line, "x,y,z" + line, "1,2,3\n" + line}) {
      refused("scan.csv", text, [](const fs::path& path) { load_cloud(path, 0); });
      refused("lidar.csv", "1,0,0,0,0,0,0,1\n" + text, [](const fs::path& path) {
        std::vector<drive::Finding> findings;
        if (read_pose_file(path, PoseFormat::EthCsv, findings).size() == 1 && testing::has_code(findings, "bad-poses"))
          throw Error(ErrorCode::Format, path.string(), findings.front().explanation);
      });
    }
  }
}

TEST(long_inputs, tables_are_walked_in_little_memory) {
  std::string text = "[";
  for (int i = 0; i < 100'000; ++i)
    text += std::string(i == 0 ? "" : ",") + "\n{\n\"token\": \"" + std::to_string(i) +
            "\",\n\"filename\": \"sweeps/LIDAR_TOP/n015-2018-07-24-11-22-45+0800__LIDAR_TOP__1532402927647951.bin\"\n}";
  text += "\n]";
  const TemporaryFolder folder;
  TableRows rows(folder.write("sample_data.json", text));
  std::size_t count = 0, others = 0;
  const AllocationMeter meter;
  for (; rows.next(); ++count) others += rows.text("token") != std::to_string(count);
  EXPECT_EQ(count, 100'000U);
  EXPECT_EQ(others, 0U);
  std::cout << (text.size() >> 10) << " KiB were read in " << (meter.peak_bytes() >> 10) << " KiB of memory\n";
  EXPECT_LT(meter.peak_bytes(), std::size_t{3} << 20);
}

}  // namespace
}  // namespace remount::formats
