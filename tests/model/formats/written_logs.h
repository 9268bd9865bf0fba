// What tests of logs write: moments, places and numbers as devices print them.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "algorithms/geometry/rotation.h"
#include "model/formats/files/time_stamp.h"
#include "tests/model/formats/random_values.h"

namespace remount::formats {

inline constexpr std::int64_t kSecond_ns = 1'000'000'000, kDay_ns = 86'400 * kSecond_ns, kWeek_ns = 7 * kDay_ns;
inline constexpr std::int64_t kLeap_ns = 18 * kSecond_ns;  // since 2017

inline std::string fixed(double value, int decimals) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}
/// What is lost by so many decimals, with a little for doubles.
inline double lost(int decimals) { return 0.501 * std::pow(10.0, -decimals) + 1e-14; }

/// "12.345" of so many decimals, which the time must have no more of.
inline std::string seconds_text(std::int64_t time_ns, int decimals) {
  char text[48];
  std::snprintf(text, sizeof text, "%lld.%09lld", static_cast<long long>(time_ns / kSecond_ns),
                static_cast<long long>(time_ns % kSecond_ns));
  const std::string all = text;
  return all.substr(0, all.find('.') + (decimals > 0 ? 1 + static_cast<std::size_t>(decimals) : 0));
}

/// The worst of all draws, and which of them was beyond what its digits lose.
class Worst {
 public:
  explicit Worst(std::string what) : what_(std::move(what)) {}
  ~Worst() { std::printf("worst %s: %.2g; of what its digits lose: %.3f\n", what_.c_str(), worst_, worst_share_); }
  Worst(const Worst&) = delete;
  Worst& operator=(const Worst&) = delete;
  void add(double off, double allowed) {
    worst_ = std::max(worst_, off);
    worst_share_ = std::max(worst_share_, off / allowed);
    EXPECT_LE(off, allowed) << what_;
  }

 private:
  std::string what_;
  double worst_ = 0.0, worst_share_ = 0.0;
};

/// Stamps that have so many decimals of seconds, at a rate of 1 Hz or more, about a moment of interest.
inline std::vector<std::int64_t> stamps(RandomValues& random, std::int64_t middle_ns, std::int64_t unit_ns,
                                        double fastest_hz) {
  const double rate_hz = std::exp(random.between(0.0, std::log(fastest_hz)));
  const std::int64_t step_ns = std::max<std::int64_t>(std::llround(1e9 / rate_hz) / unit_ns, 1) * unit_ns;
  std::vector<std::int64_t> list(2 + random.below(30));
  std::int64_t stamp_ns = middle_ns - static_cast<std::int64_t>(random.below(list.size())) * step_ns;
  for (std::int64_t& one : list) one = stamp_ns += step_ns;
  return list;
}

inline std::int64_t moment(RandomValues& random) {
  const std::int64_t day = 17'500 + static_cast<std::int64_t>(random.below(4000));  // 2017 to 2028
  const std::int64_t week = 1'950 + static_cast<std::int64_t>(random.below(600));
  if (random.flip()) return day * kDay_ns;                                              // midnight
  if (random.flip()) return kGpsEpoch_ns + week * kWeek_ns - kLeap_ns;                  // a new GPS week
  return day * kDay_ns + static_cast<std::int64_t>(random.below(86'400)) * kSecond_ns;  // any
}

struct Site {
  double latitude_deg = 0.0, longitude_deg = 0.0;
};
inline Site place(RandomValues& random) {
  const Site kinds[] = {{random.between(-80, 80), random.between(-180, 180)},
                        {random.between(-80, 80), random.flip() ? 179.99995 : -179.99995},
                        {random.between(-1e-5, 1e-5), random.between(-1e-5, 1e-5)}};
  return kinds[random.below(3)];
}
inline Site beside(RandomValues& random, Site at) {
  at.latitude_deg += random.between(-1e-4, 1e-4);
  at.longitude_deg = std::remainder(at.longitude_deg + random.between(-1e-4, 1e-4), 360.0);
  return at;
}
inline double apart_deg(double read_rad, double written_deg) {
  return std::abs(std::remainder(radians_to_degrees(read_rad) - written_deg, 360.0));
}

struct InsLine {
  std::int64_t stamp_ns = 0;
  Site at;
  double height_m = 0.0, undulation_m = 0.0, heading_deg = 0.0, pitch_deg = 0.0, roll_deg = 0.0;
};
inline std::vector<InsLine> ins_lines(RandomValues& random, const std::vector<std::int64_t>& stamps_ns) {
  const Site start = place(random);
  const double undulation_m = random.between(-105.0, 85.0);
  std::vector<InsLine> lines;
  for (const std::int64_t stamp_ns : stamps_ns)
    lines.push_back({stamp_ns, beside(random, start), random.between(-430.0, 5000.0), undulation_m,
                     random.between(0.0, 359.9), random.between(-80.0, 80.0), random.between(-179.0, 179.0)});
  return lines;
}

}  // namespace remount::formats
