#include "model/formats/clouds/point_times.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

namespace remount::formats {
namespace {

constexpr std::int64_t kScanStamp_ns = 1'600'000'000'123'456'789;
constexpr double kStamp_s = 1'600'000'000.123456789;

/// As drivers write a sweep, in the unit of the column: from `start` on, at random within `sweep`.
std::vector<double> sweep_of(double start, double sweep, std::size_t points) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  std::vector<double> times{start, start + sweep};
  while (times.size() < points) times.push_back(start + sweep * share(random));
  return times;
}

enum class On { Stamp, SensorClock };

struct Driver {
  const char* what;
  ScalarType type;
  double start, sweep;  ///< in the unit of the column
  double unit_s;
  On clock;
};

constexpr Driver kDrivers[] = {
    {"Velodyne, s", ScalarType::F32, 0.0, 0.0999, 1.0, On::Stamp},
    {"Velodyne stamped at the end, s", ScalarType::F32, -0.0999, 0.0999, 1.0, On::Stamp},
    {"20 Hz centred, s", ScalarType::F32, -0.025, 0.05, 1.0, On::Stamp},
    {"Ouster, uint32 ns", ScalarType::U32, 0.0, 99.9e6, 1e-9, On::Stamp},
    {"Ouster at 20 Hz, uint32 ns", ScalarType::U32, 12e3, 49.9e6, 1e-9, On::Stamp},
    {"relative ms", ScalarType::F32, 0.0, 100.0, 1e-3, On::Stamp},
    {"relative us", ScalarType::F32, 0.0, 99'000.0, 1e-6, On::Stamp},
    {"relative us, int32", ScalarType::I32, -50'000.0, 100'000.0, 1e-6, On::Stamp},
    {"relative ns", ScalarType::F64, 0.0, 1e8, 1e-9, On::Stamp},
    {"relative ms, uint16", ScalarType::U16, 0.0, 100.0, 1e-3, On::Stamp},
    {"one turn a second, s", ScalarType::F32, 0.0, 0.999, 1.0, On::Stamp},
    {"Hesai, s since 1970", ScalarType::F64, kStamp_s, 0.0999, 1.0, On::Stamp},
    {"RoboSense stamped at the end", ScalarType::F64, kStamp_s - 0.1, 0.1, 1.0, On::Stamp},
    {"local time, s", ScalarType::F64, kStamp_s - 8 * 3600 - 0.1, 0.1, 1.0, On::Stamp},
    {"ms since 1970", ScalarType::F64, kStamp_s * 1e3, 100.0, 1e-3, On::Stamp},
    {"us since 1970", ScalarType::U64, kStamp_s * 1e6, 1e5, 1e-6, On::Stamp},
    {"Livox, ns since 1970", ScalarType::F64, kStamp_s * 1e9, 1e8, 1e-9, On::Stamp},
    {"several turns since 1970, s", ScalarType::F64, kStamp_s, 5.0, 1.0, On::Stamp},
    {"Hesai since power-up, s", ScalarType::F64, 1234.5, 0.1, 1.0, On::SensorClock},
    {"the same for twelve days", ScalarType::F64, 1.04e6, 0.1, 1.0, On::SensorClock},
    {"float seconds since power-up", ScalarType::F32, 1234.5, 0.1, 1.0, On::SensorClock},
    {"Livox since power-up, ns", ScalarType::F64, 2.0e11, 1e8, 1e-9, On::SensorClock},
    {"the same for half an hour", ScalarType::F64, 1.6e12, 1e8, 1e-9, On::SensorClock},
    {"the same for twenty days", ScalarType::F64, 1.7e15, 1e8, 1e-9, On::SensorClock},
    {"Livox at 100 Hz since power-up, ns", ScalarType::F64, 2.0e11, 1e7, 1e-9, On::SensorClock},
    {"us since power-up", ScalarType::U64, 2.0e9, 1e5, 1e-6, On::SensorClock},
    {"us of the hour, uint32", ScalarType::U32, 3.1e9, 1e5, 1e-6, On::SensorClock},
    {"ms since power-up", ScalarType::F64, 2.0e6, 100.0, 1e-3, On::SensorClock},
    {"s since 2000 without GNSS", ScalarType::F64, 946'684'900.0, 0.1, 1.0, On::SensorClock},
    {"TAI, 37 s off", ScalarType::F64, kStamp_s + 37.0, 0.1, 1.0, On::SensorClock},
    {"another year, ns", ScalarType::F64, 1.5e18, 1e8, 1e-9, On::SensorClock},
};

/// Of a full scan and of one of few points.
TEST(point_times, have_the_unit_that_drivers_mean_on_every_clock) {
  std::size_t right = 0;
  for (const Driver& driver : kDrivers)
    for (const std::size_t points : {std::size_t{2000}, std::size_t{driver.type == ScalarType::U32 ? 300U : 3U}}) {
      const PointTimeScale scale =
          find_time_scale(sweep_of(driver.start, driver.sweep, points), points, {driver.type, {}}, kScanStamp_ns);
      EXPECT_EQ(scale.unit_s, driver.unit_s) << driver.what << ", " << points << " points";
      EXPECT_EQ(scale.another_clock, driver.clock == On::SensorClock) << driver.what << ", " << points << " points";
      right += scale.unit_s == driver.unit_s;
    }
  std::printf("%zu of %zu scans have the right unit\n", right, 2 * std::size(kDrivers));
}

TEST(point_times, of_no_scan_are_left_out_and_decide_nothing) {
  std::size_t scans = 0;
  for (const Driver& driver : kDrivers)
    for (const double wild : {0.0, -1e15, 1e300, driver.start + 1e4 * driver.sweep})
      for (const std::size_t count : {1U, 40U}) {
        const bool far = std::abs(wild - driver.start) > 300.0 * driver.sweep;
        if (!far) continue;  // a zero is where the sweep begins
        std::vector<double> times = sweep_of(driver.start, driver.sweep, 400);
        times.insert(times.begin() + 17, count, wild);
        const PointTimeScale scale = find_time_scale(times, times.size(), {driver.type, {}}, kScanStamp_ns);
        const auto kept = std::count_if(times.begin(), times.end(),
                                        [&](double time) { return time >= scale.low && time <= scale.high; });
        EXPECT_EQ(scale.unit_s, driver.unit_s) << driver.what << ", " << wild;
        EXPECT_EQ(scale.another_clock, driver.clock == On::SensorClock) << driver.what << ", " << wild;
        EXPECT_EQ(kept, 400) << driver.what << ", " << wild;
        ++scans;
      }
  std::printf("%zu scans with wild times\n", scans);
}

TEST(point_times, without_a_sweep_are_near_the_stamp) {
  for (const double time : {0.0, 0.05, 1234.5, 2.0e11, kStamp_s, kStamp_s * 1e9, -0.1, 5e7})
    for (const ScalarType type : {ScalarType::F32, ScalarType::F64, ScalarType::U32})
      for (const std::size_t points : {1U, 500U}) {
        const PointTimeScale scale =
            find_time_scale(std::vector<double>(points, time), points, {type, {}}, kScanStamp_ns);
        EXPECT_TRUE(time >= scale.low && time <= scale.high);
        const double from_stamp_s = (time - scale.zero.value_or(time)) * scale.unit_s;
        EXPECT_LE(std::abs(from_stamp_s), 1.0) << time;
      }
  const PointTimeScale dated = find_time_scale({kStamp_s + 0.05}, 1, {ScalarType::F64, {}}, kScanStamp_ns);
  ASSERT_TRUE(dated.zero);
  EXPECT_NEAR(kStamp_s + 0.05 - *dated.zero, 0.05, 1e-6);
}

TEST(point_times, of_the_first_columns_of_ouster_are_nanoseconds) {
  for (const double second : {48'828.0, 97'656.0, 1e6})
    EXPECT_EQ(find_time_scale({0.0, second}, 2, {ScalarType::U32, {}}, kScanStamp_ns).unit_s, 1e-9);
}

// A scan of which little is left must not be smeared over the sweep, nor seem to have another clock.
TEST(point_times, of_a_column_or_two_are_in_the_unit_of_a_whole_sweep) {
  struct Columns {
    ScalarType type;
    double first, step, unit_s;
  };
  for (const Columns& columns : {Columns{ScalarType::F32, 50'000.0, 55.0, 1e-6},
                                 {ScalarType::F64, 5.0e7, 55'000.0, 1e-9},
                                 {ScalarType::F32, 50.0, 0.055, 1e-3},
                                 {ScalarType::F32, 0.05, 55e-6, 1.0}}) {
    const PointTimeScale scale =
        find_time_scale({columns.first, columns.first + columns.step}, 64, {columns.type, {}}, kScanStamp_ns);
    EXPECT_EQ(scale.unit_s, columns.unit_s) << columns.first;
    EXPECT_FALSE(scale.another_clock) << columns.first;
    ASSERT_TRUE(scale.zero) << columns.first;
    EXPECT_NEAR((columns.first - *scale.zero) * scale.unit_s, 0.05, 1e-9);
  }
}

TEST(point_times, on_the_clock_of_a_stamp_since_power_up_are_from_it) {
  const PointTimeScale scale =
      find_time_scale(sweep_of(1234.5, 0.1, 500), 500, {ScalarType::F64, {}}, 1'234'500'000'000);
  EXPECT_FALSE(scale.another_clock);
  ASSERT_TRUE(scale.zero);
  EXPECT_NEAR(*scale.zero, 1234.5, 1e-9);
}

}  // namespace
}  // namespace remount::formats
