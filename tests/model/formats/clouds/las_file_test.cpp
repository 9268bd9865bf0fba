#include <gtest/gtest.h>

#include <cstdio>

#include "model/formats/clouds/cloud_file.h"
#include "model/formats/files/time_stamp.h"
#include "model/formats/session_readers.h"
#include "tests/model/formats/las_bytes.h"
#include "tests/model/formats/random_values.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::formats {
namespace {

class las_file : public ::testing::Test {
 protected:
  cloud::PointCloud load(const std::string& bytes, std::int64_t stamp_ns = 0) {
    return load_cloud(folder_.write("scan.las", bytes), stamp_ns);
  }
  std::string refused(const std::string& bytes) {
    return error_of([&] { load(bytes); });
  }
  TemporaryFolder folder_;
};

TEST_F(las_file, every_version_and_point_format_gives_its_points) {
  for (int minor = 2; minor <= 4; ++minor)
    for (int format = 0; format <= (minor == 4 ? 10 : minor == 3 ? 5 : 3); ++format)
      for (const int extra_bytes : {0, 7}) {
        LasOptions options;
        options.minor = minor, options.format = format, options.extra_bytes = extra_bytes;
        const cloud::PointCloud cloud = load(las(options));
        ASSERT_EQ(cloud.size(), 2U) << minor << " " << format;
        EXPECT_NEAR((cloud.points[1] - Eigen::Vector3f(-4, 5.001f, -6)).norm(), 0.0, 1e-6) << minor << " " << format;
        EXPECT_EQ(cloud.intensity[1], 101.0f);
        EXPECT_TRUE(cloud.time_from_stamp_s.empty()) << "all at one time is no time";
      }
}

TEST_F(las_file, of_two_counts_that_of_the_version_counts) {
  LasOptions options;
  options.minor = 4, options.format = 6;
  std::string bytes = las(options);
  bytes[107] = 1;  // the count of older versions, which a program that cut the file may have left
  EXPECT_EQ(load(bytes).size(), 2U);
}

TEST_F(las_file, times_of_both_kinds_become_relative_to_the_stamp) {
  const std::int64_t gps_ns = 1'300'000'000'250'000'000;
  const std::int64_t stamp_ns = unix_ns_from_gps_ns(gps_ns);
  for (const int format : {1, 6}) {
    LasOptions options;
    options.minor = 4, options.format = format;
    options.times = {300'000'000.25, 300'000'000.34};
    const cloud::PointCloud whole = load(las(options), stamp_ns);
    ASSERT_EQ(whole.time_from_stamp_s.size(), 2U);
    EXPECT_NEAR(whole.time_from_stamp_s[0], 0.0, 1e-4);
    EXPECT_NEAR(whole.time_from_stamp_s[1], 0.09, 1e-4);
    options.whole_gps_time = false;
    const double week_s = std::fmod(1'300'000'000.25, 604800.0);
    options.times = {week_s, week_s + 0.09};
    const cloud::PointCloud week = load(las(options), stamp_ns);
    ASSERT_EQ(week.time_from_stamp_s.size(), 2U);
    EXPECT_NEAR(week.time_from_stamp_s[0], 0.0, 1e-4);
    EXPECT_NEAR(week.time_from_stamp_s[1], 0.09, 1e-4);
  }
}

/// Without a stamp the week is not known; the sweep is.
TEST_F(las_file, times_of_a_week_keep_their_sweep_without_a_stamp) {
  LasOptions options;
  options.whole_gps_time = false;
  options.times = {300'000.25, 300'000.34};
  const cloud::PointCloud cloud = load(las(options));
  ASSERT_EQ(cloud.time_from_stamp_s.size(), 2U);
  EXPECT_NEAR(cloud.time_from_stamp_s[0], 0.0, 1e-6);
  EXPECT_NEAR(cloud.time_from_stamp_s[1], 0.09, 1e-6);
}

/// Of any version and format that there is for it, as other programs write it.
TEST_F(las_file, random_ones_of_every_version_give_what_was_written) {
  RandomValues random(19);
  const std::int64_t stamp_ns = unix_ns_from_gps_ns(1'300'000'000'250'000'000);
  std::size_t points = 0, timed = 0;
  double worst_m = 0.0, worst_s = 0.0;
  for (int draw = 0; draw < 300; ++draw) {
    LasOptions options;
    options.minor = static_cast<int>(random.below(5));
    constexpr std::uint64_t kFormats[] = {2, 2, 4, 6, 11};
    options.format = static_cast<int>(random.below(kFormats[options.minor]));
    options.extra_bytes = static_cast<int>(random.below(9));
    options.offset_m = random.flip() ? 0.0 : random.between(-500.0, 500.0);
    options.whole_gps_time = options.minor >= 2 && random.flip();
    const std::size_t count = 2 + random.below(60);
    const bool has_times = options.format != 0 && options.format != 2 && random.flip();
    const double start_s = options.whole_gps_time ? 300'000'000.25 : std::fmod(1'300'000'000.25, 604'800.0);
    options.points.clear();
    for (std::size_t i = 0; i < count; ++i) {
      options.points.emplace_back(random.between(1.0, 100.0), random.between(-100.0, 100.0), random.between(-5.0, 5.0));
      if (has_times) options.times.push_back(start_s + 0.1 * static_cast<double>(i) / static_cast<double>(count));
    }
    const cloud::PointCloud cloud = load(las(options), stamp_ns);
    ASSERT_EQ(cloud.size(), count) << draw;
    ASSERT_EQ(cloud.time_from_stamp_s.size(), has_times ? count : 0U) << draw;
    for (std::size_t i = 0; i < count; ++i) {
      const double off_m = (cloud.points[i].cast<double>() - options.points[i]).cwiseAbs().maxCoeff();
      worst_m = std::max(worst_m, off_m);
      ASSERT_EQ(cloud.intensity[i], static_cast<float>(100 + i)) << draw;
      if (!has_times) continue;
      const double off_s = std::abs(static_cast<double>(cloud.time_from_stamp_s[i]) - (options.times[i] - start_s));
      worst_s = std::max(worst_s, off_s);
    }
    points += count, timed += has_times;
  }
  std::printf("300 files, %zu points, %zu with times, off by %.2e m and %.2e s at most\n", points, timed, worst_m,
              worst_s);
  EXPECT_LT(worst_m, 0.00051) << "a millimetre is the unit";
  EXPECT_LT(worst_s, 1e-6);
}

TEST_F(las_file, random_clouds_are_read_as_they_were_written) {
  RandomValues random(23);
  const std::int64_t stamp_ns = 1'600'000'000'123'456'789;
  double worst_m = 0.0, worst_s = 0.0;
  std::size_t points = 0;
  for (int draw = 0; draw < 200; ++draw) {
    cloud::PointCloud cloud;
    const bool intensity = random.flip(), time = random.flip();
    for (std::size_t i = 0, count = 2 + random.below(60); i < count; ++i) {
      cloud.points.emplace_back(1.0 + random.between(0.0, 200.0), random.between(-200.0, 200.0), random.between(-9, 9));
      if (intensity) cloud.intensity.push_back(static_cast<float>(random.below(65536)) / 65535.0F);
      if (time) cloud.time_from_stamp_s.push_back(0.1F * static_cast<float>(i) / static_cast<float>(count));
    }
    write_las(folder_.path() / "scan.las", cloud, stamp_ns);
    const cloud::PointCloud read = load_cloud(folder_.path() / "scan.las", stamp_ns);
    ASSERT_EQ(read.size(), cloud.size()) << draw;
    ASSERT_EQ(read.time_from_stamp_s.size(), cloud.time_from_stamp_s.size()) << draw;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      worst_m = std::max<double>(worst_m, (read.points[i] - cloud.points[i]).cwiseAbs().maxCoeff());
      ASSERT_EQ(read.intensity[i], intensity ? std::round(65535.0F * cloud.intensity[i]) : 0.0F) << draw;
      if (time) worst_s = std::max<double>(worst_s, std::abs(read.time_from_stamp_s[i] - cloud.time_from_stamp_s[i]));
    }
    points += cloud.size();
  }
  std::printf("200 clouds, %zu points, off by %.2e m and %.2e s at most\n", points, worst_m, worst_s);
  EXPECT_LT(worst_m, 0.00007) << "half of 0.1 mm, and what a float loses at 200 m";
  EXPECT_LT(worst_s, 1.1e-6);
}

TEST_F(las_file, damaged_files_are_refused_with_the_place) {
  const std::string good = las({});
  EXPECT_TRUE(contains(refused(good.substr(0, 100)), "byte 100: ends within the header"))
      << refused(good.substr(0, 100));
  EXPECT_TRUE(contains(refused(good.substr(0, good.size() - 1)), "byte 96: 2 points of 28 bytes"));
  const auto changed = [&](std::size_t at, auto value) {
    std::string bytes = good;
    put(bytes, at, value);
    return refused(bytes);
  };
  EXPECT_TRUE(contains(changed(25, std::uint8_t{5}), "is LAS 1.5, expected 1.0 to 1.4"));
  EXPECT_TRUE(contains(changed(104, std::uint8_t{11}), "point format 11"));
  EXPECT_TRUE(contains(changed(104, std::uint8_t{0x81}), "but no record behind the header says how"));
  EXPECT_TRUE(contains(changed(105, std::uint16_t{27}), "format 1 has at least 28"));
  EXPECT_TRUE(contains(changed(107, std::uint32_t{4'000'000'000}), "4000000000 points"));
  EXPECT_TRUE(contains(changed(131, 0.0), "the scale is 0"));
  EXPECT_TRUE(contains(changed(96, std::uint32_t{10}), "from byte 10"));
  LasOptions map;
  map.offset_m = 5'400'000.0;
  map.points = {{5'400'001, 5'400'002, 5'400'003}};
  EXPECT_TRUE(contains(refused(las(map)), "coordinates of a map (up to 5400003 m)")) << refused(las(map));
  EXPECT_TRUE(load(las({.points = {}})).points.empty());
}

TEST_F(las_file, is_a_scan_of_a_native_session) {
  folder_.write("scans/1600000000.0.las", las({}));
  folder_.write("scans/1600000000.1.las", las({}));
  folder_.write("poses.txt", "1600000000 0 0 0 0 0 0 1\n1600000001 1 0 0 0 0 0 1\n");
  folder_.write(
      "session.yaml",
      "format: remount-session/1\nname: las\nscans: {directory: scans, type: las, stamps: from-names, timing: "
      "instant}\nins_poses: {file: poses.txt, format: tum}\n");
  Progress progress;
  const drive::Session session = open_session(folder_.path(), progress);
  ASSERT_EQ(session.scans->size(), 2U);
  EXPECT_EQ(session.scans->load(1).size(), 2U);
}

}  // namespace
}  // namespace remount::formats
