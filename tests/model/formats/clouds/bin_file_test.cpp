// Scans of bare floats: how many make a point is told by the numbers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "model/formats/clouds/cloud_file.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::formats {
namespace {

/// Points on ground and walls around a sensor at 1.8 m, beam by beam or in no order, as rows of six numbers.
std::vector<std::array<float, 6>> measured_rows(unsigned seed, bool ordered) {
  std::mt19937 random(seed);
  std::normal_distribution<float> noise(0.0f, 0.02f);
  std::uniform_real_distribution<float> share(0.0f, 1.0f);
  std::vector<std::array<float, 6>> rows;
  for (int beam = 0; beam < 16; ++beam)
    for (int step = 0; step < 100; ++step) {
      const float azimuth = 0.0628f * static_cast<float>(step), range = 6.0f + 4.0f * std::sin(3.0f * azimuth);
      const float height = beam < 8 ? -1.8f : -1.8f + 0.3f * static_cast<float>(beam);
      rows.push_back({(range + noise(random)) * std::cos(azimuth), (range + noise(random)) * std::sin(azimuth),
                      height + noise(random), share(random), static_cast<float>(beam), 0.1f * share(random)});
    }
  if (!ordered) std::shuffle(rows.begin(), rows.end(), random);
  return rows;
}

std::string bytes_of_rows(const std::vector<std::array<float, 6>>& rows, std::size_t width) {
  std::string bytes;
  for (const auto& row : rows) bytes.append(reinterpret_cast<const char*>(row.data()), 4 * width);
  return bytes;
}

TEST(bin_file, tells_how_many_floats_make_a_point) {
  const TemporaryFolder folder;
  int right = 0, told = 0;
  for (unsigned seed = 1; seed <= 10; ++seed)
    for (const bool ordered : {true, false})
      for (const std::size_t width : {3UL, 4UL, 5UL, 6UL}) {
        const auto rows = measured_rows(seed, ordered);
        const cloud::PointCloud cloud = load_cloud(folder.write("scan.bin", bytes_of_rows(rows, width)), 0);
        ++told;
        ASSERT_EQ(cloud.size(), rows.size()) << width << " floats a point, seed " << seed << ", ordered " << ordered;
        ++right;
        EXPECT_EQ(cloud.points[77], Eigen::Vector3f(rows[77][0], rows[77][1], rows[77][2]));
        ASSERT_EQ(cloud.intensity.size(), width > 3 ? rows.size() : 0U);
        if (width > 3) {
          EXPECT_EQ(cloud.intensity[77], rows[77][3]);
        }
        ASSERT_EQ(cloud.ring.size(), width > 4 ? rows.size() : 0U);
        if (width > 4) {
          EXPECT_EQ(cloud.ring[77], static_cast<std::uint16_t>(rows[77][4]));
        }
      }
  std::printf("%d of %d scans with the right layout\n", right, told);
}

TEST(bin_file, reflectances_of_any_scale_do_not_mislead) {
  const TemporaryFolder folder;
  for (const float scale : {0.0f, 1.0f, 255.0f, 65535.0f})
    for (const std::size_t width : {3UL, 4UL, 5UL}) {
      auto rows = measured_rows(3, true);
      for (auto& row : rows) row[3] *= scale;
      EXPECT_EQ(load_cloud(folder.write("scan.bin", bytes_of_rows(rows, width)), 0).size(), rows.size())
          << width << " floats a point, reflectance up to " << scale;
    }
}

TEST(bin_file, bytes_of_other_layouts_are_refused_by_name) {
  const TemporaryFolder folder;
  const auto rows = measured_rows(5, true);
  const auto message = [&](const std::string& bytes) {
    return error_of([&] { load_cloud(folder.write("scan.bin", bytes), 0); });
  };
  std::string by_column, doubles, random_bytes;
  for (std::size_t column = 0; column < 4; ++column)
    for (const auto& row : rows) by_column.append(reinterpret_cast<const char*>(&row[column]), 4);
  for (const auto& row : rows)
    for (std::size_t column = 0; column < 4; ++column) {
      const double value = row[column];
      doubles.append(reinterpret_cast<const char*>(&value), 8);
    }
  std::mt19937 random(1);
  while (random_bytes.size() < 24'000) random_bytes += static_cast<char>(random());
  for (const std::string& bytes : {by_column, doubles, random_bytes})
    EXPECT_TRUE(contains(message(bytes), "bytes that are no points, expected 32-bit floats, 3 to 6 a point"))
        << message(bytes);
  std::string nclt;
  for (const auto& row : rows) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto value = static_cast<std::uint16_t>(std::lround((row[axis] + 100.0f) / 0.005f));
      nclt.append(reinterpret_cast<const char*>(&value), 2);
    }
    nclt += static_cast<char>(50.0f * row[3]);
    nclt += static_cast<char>(row[4]);
  }
  EXPECT_TRUE(contains(message(nclt), "NCLT's records of 8 bytes")) << message(nclt);
}

}  // namespace
}  // namespace remount::formats
