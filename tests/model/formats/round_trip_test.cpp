// Scans and bags read back as they were written, to the bit: random ones with the edges of their types, in every format
// and compression.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "algorithms/messages/render.h"
#include "model/formats/bags/cloud_message.h"
#include "model/formats/clouds/cloud_file.h"
#include "model/formats/files/lzf.h"
#include "tests/model/formats/bags/sqlite_fixture.h"
#include "tests/model/formats/cloud_comparison.h"
#include "tests/model/formats/random_values.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::formats {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kStamp_ns = 1'600'000'000'123'456'789;

// ---- Scans

template <class T>
void append(std::string& bytes, T value, bool swapped = false) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  if (swapped) std::reverse(raw, raw + sizeof(T));
  bytes.append(raw, sizeof(T));
}

std::string number_text(float value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", static_cast<double>(value));
  return text;
}

/// What the formats that the product reads and does not write are made of: a column is a name and how a value is put.
struct Column {
  const char* name;
  char type;  ///< F or U
  int bytes;
  std::function<void(std::string&, std::size_t point, bool swapped)> put;
  std::function<std::string(std::size_t point)> text;
};

std::vector<Column> columns_of(const cloud::PointCloud& cloud) {
  std::vector<Column> columns;
  const auto real = [&](const char* name, auto&& value) {
    columns.push_back({name, 'F', 4,
                       [value](std::string& bytes, std::size_t i, bool swapped) { append(bytes, value(i), swapped); },
                       [value](std::size_t i) { return number_text(value(i)); }});
  };
  real("x", [&cloud](std::size_t i) { return cloud.points[i].x(); });
  real("y", [&cloud](std::size_t i) { return cloud.points[i].y(); });
  real("z", [&cloud](std::size_t i) { return cloud.points[i].z(); });
  if (!cloud.intensity.empty()) real("intensity", [&cloud](std::size_t i) { return cloud.intensity[i]; });
  if (!cloud.ring.empty())
    columns.push_back(
        {"ring", 'U', 2,
         [&cloud](std::string& bytes, std::size_t i, bool swapped) { append(bytes, cloud.ring[i], swapped); },
         [&cloud](std::size_t i) { return std::to_string(cloud.ring[i]); }});
  if (!cloud.time_from_stamp_s.empty()) real("time", [&cloud](std::size_t i) { return cloud.time_from_stamp_s[i]; });
  return columns;
}

std::string rows(const cloud::PointCloud& cloud, bool text, bool swapped) {
  std::string bytes;
  const std::vector<Column> columns = columns_of(cloud);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    for (const Column& column : columns) {
      if (text)
        (bytes += column.text(i)) += &column == &columns.back() ? '\n' : ' ';
      else
        column.put(bytes, i, swapped);
    }
  }
  return bytes;
}

std::string pcd(const cloud::PointCloud& cloud, const std::string& encoding) {
  std::string fields = "FIELDS", sizes = "SIZE", types = "TYPE", counts = "COUNT", data;
  for (const Column& column : columns_of(cloud)) {
    fields += std::string(" ") + column.name, sizes += " " + std::to_string(column.bytes);
    types += std::string(" ") + column.type, counts += " 1";
    for (std::size_t i = 0; i < cloud.size(); ++i) column.put(data, i, false);  // column by column
  }
  const std::string count = std::to_string(cloud.size());
  const std::string head = "VERSION 0.7\n" + fields + "\n" + sizes + "\n" + types + "\n" + counts + "\nWIDTH " + count +
                           "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + count + "\nDATA " + encoding + "\n";
  if (encoding != "binary_compressed") return head + rows(cloud, encoding == "ascii", false);
  const std::string packed = lzf_encode(data);
  std::string sizes_of_data;
  append(sizes_of_data, static_cast<std::uint32_t>(packed.size()));
  append(sizes_of_data, static_cast<std::uint32_t>(data.size()));
  return head + sizes_of_data + packed;
}

std::string ply(const cloud::PointCloud& cloud, const std::string& encoding) {
  std::string head = "ply\nformat " + encoding + " 1.0\nelement vertex " + std::to_string(cloud.size()) + "\n";
  for (const Column& column : columns_of(cloud))
    head += std::string("property ") + (column.type == 'F' ? "float " : "ushort ") + column.name + "\n";
  return head + "end_header\n" + rows(cloud, encoding == "ascii", encoding == "binary_big_endian");
}

using Encoder = std::function<std::string(const cloud::PointCloud&)>;

TEST(round_trip, scans_in_every_file_format_and_with_any_columns) {
  const TemporaryFolder folder;
  const auto written_by = [&](auto write) {
    return [&folder, write](const cloud::PointCloud& cloud) {
      write(folder.path() / "written", cloud);
      return bytes_of(folder.path() / "written");
    };
  };
  const std::vector<std::tuple<const char*, const char*, Encoder>> formats{
      {"written PCD", "a.pcd", written_by(write_pcd)},
      {"written text", "a.csv", written_by(write_text_cloud)},
      {"PCD ascii", "a.pcd", [](const cloud::PointCloud& c) { return pcd(c, "ascii"); }},
      {"PCD binary", "a.pcd", [](const cloud::PointCloud& c) { return pcd(c, "binary"); }},
      {"PCD binary_compressed", "a.pcd", [](const cloud::PointCloud& c) { return pcd(c, "binary_compressed"); }},
      {"PLY ascii", "a.ply", [](const cloud::PointCloud& c) { return ply(c, "ascii"); }},
      {"PLY little", "a.ply", [](const cloud::PointCloud& c) { return ply(c, "binary_little_endian"); }},
      {"PLY big", "a.ply", [](const cloud::PointCloud& c) { return ply(c, "binary_big_endian"); }},
  };
  RandomValues random(11);
  for (int draw = 0; draw < 40; ++draw) {
    const cloud::PointCloud cloud = random.cloud(1 + random.below(60), random.flip(), random.flip(), random.flip());
    for (const auto& [what, name, encode] : formats)
      expect_same(load_cloud(folder.write(name, encode(cloud)), kStamp_ns), cloud,
                  std::string(what) + ", draw " + std::to_string(draw));
    cloud::PointCloud plain = cloud;
    plain.ring.clear(), plain.time_from_stamp_s.clear();
    write_kitti_bin(folder.path() / "a.bin", plain);
    if (plain.intensity.empty()) plain.intensity.assign(plain.size(), 0.0F);  // the format always has it
    expect_same(load_cloud(folder.path() / "a.bin", kStamp_ns), plain, "KITTI");
  }
}

TEST(round_trip, scans_as_messages_in_both_serialisations) {
  RandomValues random(12);
  for (int draw = 0; draw < 60; ++draw)
    for (const bags::MessageEncoding encoding : {bags::MessageEncoding::Ros1, bags::MessageEncoding::Cdr}) {
      const cloud::PointCloud cloud = random.cloud(random.below(50), random.flip(), random.flip(), random.flip());
      const std::string frame = random.text(), bytes = bags::cloud_message(cloud, kStamp_ns, frame, encoding);
      bags::MessageReader reader(bytes, encoding, "message");
      expect_same(bags::read_cloud(reader, bags::MessageKind::PointCloud2, kStamp_ns).cloud, cloud,
                  "draw " + std::to_string(draw));
    }
}

// ---- Bags

TEST(round_trip, bags_of_every_kind_and_compression) {
  using Make = std::function<void(const fs::path&, const std::vector<bags::TestMessage>&)>;
  std::vector<std::pair<std::string, Make>> kinds;
  for (const auto compression :
       {bags::ChunkCompression::None, bags::ChunkCompression::Bzip2, bags::ChunkCompression::Lz4})
    kinds.emplace_back("ROS 1, " + std::to_string(static_cast<int>(compression)), [=](const auto& path, const auto& m) {
      bags::write_messages(*bags::make_rosbag1_writer(path, compression, 500), m);
    });
  for (const auto compression :
       {bags::ChunkCompression::None, bags::ChunkCompression::Lz4, bags::ChunkCompression::Zstd})
    for (const auto encoding : {bags::MessageEncoding::Ros1, bags::MessageEncoding::Cdr})
      kinds.emplace_back("MCAP, " + std::to_string(static_cast<int>(compression)),
                         [=](const auto& path, const auto& m) {
                           bags::write_messages(*bags::make_mcap_writer(path, encoding, compression, 500), m);
                         });
  for (const bool packed : {false, true})
    kinds.emplace_back(packed ? "packed database" : "database",
                       [=](const auto& path, const auto& m) { bags::write_database(path, m, packed); });
  RandomValues random(13);
  for (int draw = 0; draw < 12; ++draw) {
    std::vector<bags::TestMessage> messages;
    for (std::size_t i = 0, count = 1 + random.below(40); i < count; ++i) {
      std::string bytes;  // empty ones, and some that are longer than a chunk
      for (std::size_t k = 0, length = random.below(10) == 0 ? 3000 : random.below(60); k < length; ++k)
        bytes += static_cast<char>(random.below(256));
      messages.push_back({static_cast<std::uint32_t>(random.below(2)),
                          bags::kStart_ns + static_cast<std::int64_t>(i) * 10'000'000, std::move(bytes)});
    }
    for (const auto& [what, make] : kinds) {
      SCOPED_TRACE(what + ", draw " + std::to_string(draw));
      const TemporaryFolder folder;
      make(folder.path() / "bag.db3", messages);
      const auto bag = bags::open_quietly(folder.path() / "bag.db3");
      EXPECT_EQ(bags::count_and_check(*bag, messages), messages.size());
      EXPECT_TRUE(bag->findings().empty()) << english(bag->findings()[0].explanation);
    }
  }
}

}  // namespace
}  // namespace remount::formats
