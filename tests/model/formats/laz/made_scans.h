// Points of compressed scans, drawn so that every way of packing them comes up.
#pragma once

#include "tests/model/formats/laz/laz_bytes.h"
#include "tests/model/formats/random_values.h"

namespace remount::formats::laz {

/// What of the points of a scan stays or jumps.
struct Habits {
  bool flat = false, one_intensity = false, far_jumps = false;
};

inline double next_time(RandomValues& random, double time_s) {
  switch (random.below(8)) {
    case 0:
      return time_s;
    case 1:
      return 3e8 + 1e5 * static_cast<double>(random.below(40));
    case 2:
      return time_s - 1e-5 * static_cast<double>(random.below(20));
    case 3:
      return time_s + 1e-5 * static_cast<double>(random.below(700));
    default:
      return time_s + 1e-5;
  }
}

inline std::vector<Point> made_points(RandomValues& random, std::size_t count, int format, const Habits& habits) {
  std::vector<Point> points(count);
  std::array<std::int32_t, 3> at{1000, 2000, 3000};
  double time_s = 3e8;
  for (Point& point : points) {
    for (std::int32_t& axis : at)
      axis = habits.far_jumps && random.below(20) == 0
                 ? static_cast<std::int32_t>(random.below(std::uint64_t{1} << 32) - (std::uint64_t{1} << 31))
                 : wrapped_difference(axis, static_cast<std::int32_t>(random.below(2000)) - 1000);
    point.xyz = at;
    if (habits.flat) point.xyz[2] = 5;
    point.intensity = habits.one_intensity ? 7 : static_cast<std::uint16_t>(random.below(65536));
    point.time = time_s = next_time(random, time_s);
    point.count = static_cast<unsigned>(1 + random.below(format >= 6 ? 3 : 5));
    point.number = static_cast<unsigned>(1 + random.below(point.count));
    if (format >= 6 && random.below(5) == 0) point.channel = static_cast<unsigned>(random.below(4));
    point.user = static_cast<std::uint8_t>(random.below(256));
    point.extra = static_cast<std::uint8_t>(random.below(256));
    point.source = static_cast<std::uint16_t>(random.below(9) == 0 ? random.below(65536) : 1);
    for (std::uint16_t& part : point.colour) part = static_cast<std::uint16_t>(random.below(65536));
    if (random.flip()) point.colour[1] = point.colour[2] = point.colour[0];
  }
  return points;
}

/// A small scan for damaging and fuzzing.
inline std::string made_scan(int format) {
  RandomValues random(7);
  Options options;
  options.format = format;
  options.extra_bytes = 1;
  options.chunks = {format >= 6 ? 60U : 17U};
  return laz_of(made_points(random, 40, format, {}), options);
}

}  // namespace remount::formats::laz
