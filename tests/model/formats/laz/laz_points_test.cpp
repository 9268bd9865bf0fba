#include "model/formats/laz/laz_points.h"

#include <gtest/gtest.h>

#include <cstdio>

#include "algorithms/core/error.h"
#include "model/formats/clouds/cloud_file.h"
#include "model/formats/files/crc32.h"
#include "model/formats/files/number_bytes.h"
#include "tests/model/formats/laz/made_scans.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::formats {
namespace {

/// As the header of a file has it that laz_bytes.h makes.
LazFile file_of(const std::string& bytes) {
  return {bytes,
          "scan.laz",
          375,
          little_number<std::uint32_t>(bytes, 100),
          little_number<std::uint32_t>(bytes, 96),
          little_number<std::uint64_t>(bytes, 247),
          little_number<std::uint16_t>(bytes, 105),
          std::size_t{byte_at(bytes, 104)} & 0x3fU};
}

std::vector<LasRecord> unpacked(const std::string& bytes) {
  std::vector<LasRecord> records;
  unpack_laz(file_of(bytes), [&](const LasRecord& record) { records.push_back(record); });
  return records;
}

std::string refusal(const std::string& bytes) {
  return error_of([&] { unpacked(bytes); });
}

laz::Options random_options(RandomValues& random, int format) {
  laz::Options options;
  options.format = format;
  options.extra_bytes = random.flip() ? 0 : random.below(5);
  options.chunked = format >= 6 || random.below(8) > 0;
  options.table_place_at_end = random.flip();
  if (random.flip()) options.chunks = {1 + random.below(30)};
  if (random.flip()) options.chunks = {1, 7, 1 + random.below(60), 300};
  return options;
}

TEST(laz_points, of_every_format_are_those_that_were_packed) {
  RandomValues random(31);
  std::size_t points = 0, packed_bytes = 0, plain_bytes = 0;
  for (int draw = 0; draw < 330; ++draw) {
    const laz::Options options = random_options(random, draw % 11);
    const laz::Habits habits{random.below(4) == 0, random.below(4) == 0, random.below(3) == 0};
    const std::vector<laz::Point> made = laz::made_points(random, 1 + random.below(400), options.format, habits);
    const std::string bytes = laz::laz_of(made, options);
    const std::vector<LasRecord> records = unpacked(bytes);
    ASSERT_EQ(records.size(), made.size()) << draw;
    for (std::size_t i = 0; i < made.size(); ++i) {
      ASSERT_EQ(records[i].xyz, made[i].xyz) << draw << ", point " << i;
      ASSERT_EQ(records[i].intensity, made[i].intensity) << draw << ", point " << i;
      if (laz::has_time(options.format)) ASSERT_EQ(records[i].time, made[i].time) << draw << ", point " << i;
    }
    points += made.size(), packed_bytes += bytes.size(), plain_bytes += laz::plain_of(made, options).size();
  }
  std::printf("330 files, %zu points, %zu bytes for %zu\n", points, packed_bytes, plain_bytes);
}

/// The decoder and the encoder of the tests share their models: an error in these would not show between them. Files
/// that other programs packed were read as these were when the sums were taken.
TEST(laz_points, are_packed_as_ever) {
  for (const auto& [format, sum] : {std::pair{1, 0x8a652640U}, {3, 0xacb868a3U}, {6, 0x0856a993U}}) {
    const std::string bytes = laz::made_scan(format);
    const std::uint32_t now = crc32(bytes);
    std::printf("format %d: %zu bytes, %08x\n", format, bytes.size(), now);
    EXPECT_EQ(now, sum) << "format " << format;
  }
}

TEST(laz_points, make_the_same_scan_as_plain_ones) {
  const TemporaryFolder folder;
  RandomValues random(5);
  for (int format = 0; format <= 10; ++format) {
    laz::Options options;
    options.format = format;
    std::vector<laz::Point> points = laz::made_points(random, 2000, format, {});
    for (std::size_t i = 0; i < points.size(); ++i) {
      points[i].time = 3e8 + 5e-5 * static_cast<double>(i);
      if (i % 10 == 0) points[i].xyz = {};  // no return
    }
    const cloud::PointCloud packed = load_cloud(folder.write("a.laz", laz::laz_of(points, options)), 0);
    const cloud::PointCloud plain = load_cloud(folder.write("a.las", laz::plain_of(points, options)), 0);
    EXPECT_EQ(packed.points, plain.points) << format;
    EXPECT_EQ(packed.intensity, plain.intensity) << format;
    EXPECT_EQ(packed.time_from_stamp_s, plain.time_from_stamp_s) << format;
    EXPECT_EQ(packed.dropped_points, plain.dropped_points) << format;
    EXPECT_EQ(plain.size(), 1800U) << format;
    EXPECT_EQ(plain.time_from_stamp_s.size(), laz::has_time(format) ? 1800U : 0U) << format;
  }
}

TEST(laz_points, that_are_damaged_are_refused_with_the_place) {
  const std::string good = laz::made_scan(1);
  const std::size_t points_at = little_number<std::uint32_t>(good, 96), record = 375 + 54;
  const auto changed = [&](std::size_t at, auto value) {
    std::string bytes = good;
    put(bytes, at, value);
    return refusal(bytes);
  };
  EXPECT_TRUE(contains(changed(375 + 18, std::uint16_t{1}), "byte 375: The points are compressed, but no record"));
  EXPECT_TRUE(contains(changed(record, std::uint16_t{3}), "in a way (3) that is not read"));
  EXPECT_TRUE(contains(changed(record + 34 + 4, std::uint16_t{1}), "first version of LASzip"));
  EXPECT_TRUE(contains(changed(record + 34 + 4, std::uint16_t{9}), "Version 9 of the compression of part 6"));
  EXPECT_TRUE(contains(changed(record + 34, std::uint16_t{99}), "unknown kind (99)"));
  EXPECT_TRUE(contains(changed(record + 34 + 2, std::uint16_t{21}), "Part 6 of a point has 21 bytes"));
  EXPECT_TRUE(contains(changed(record + 32, std::uint16_t{200}), "lists 200 parts"));
  EXPECT_TRUE(contains(changed(105, std::uint16_t{35}), "points of 29 bytes"));
  EXPECT_TRUE(contains(changed(points_at, std::uint64_t{12}), "list of the compressed pieces is missing"));
  EXPECT_TRUE(contains(changed(247, std::uint64_t{60}), "hold 51 points, the header says 60"));
  EXPECT_TRUE(contains(changed(247, std::uint64_t{4'000'000'000}), "4000000000 points cannot lie in"));
  EXPECT_TRUE(contains(refusal(good.substr(0, good.size() / 2)), "list of the compressed pieces is missing"));
  // A chunk that goes on where its bytes end.
  laz::Options options;
  options.chunked = false;
  RandomValues random(3);
  const std::string stream = laz::laz_of(laz::made_points(random, 500, 1, {}), options);
  EXPECT_TRUE(contains(refusal(stream.substr(0, stream.size() - 200)), "(chunk 0): The compressed points are damaged"));
}

/// Extra bytes take a model each.
TEST(laz_points, with_many_bytes_of_their_own_are_refused) {
  laz::Options options;
  RandomValues random(3);
  const std::vector<laz::Point> points = laz::made_points(random, 5, 1, {});
  options.extra_bytes = 256;
  EXPECT_EQ(unpacked(laz::laz_of(points, options)).size(), 5U);
  options.extra_bytes = 257;
  EXPECT_TRUE(contains(refusal(laz::laz_of(points, options)), "at most 256 are read"));
}

}  // namespace
}  // namespace remount::formats
