#include "model/clock_hint.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace remount {
namespace {

constexpr double kGpsEpoch_s = 315964800.0;  ///< Unix time of 6 January 1980

std::string duration(double seconds) {
  char text[64];
  if (seconds < 7200.0)
    std::snprintf(text, sizeof text, "%.3f s", seconds);
  else if (seconds < 2.0 * 86400.0)
    std::snprintf(text, sizeof text, "%.2f hours", seconds / 3600.0);
  else
    std::snprintf(text, sizeof text, "%.1f days", seconds / 86400.0);
  return text;
}

/// What is known to make clocks differ by this much, to within `slack_s`; empty for nothing.
std::string known_cause(double difference_s, double slack_s) {
  const double size_s = std::abs(difference_s);
  if (std::abs(size_s - kGpsEpoch_s) < 86400.0)
    return "That is the time between the epochs of Unix and GPS: one of them counts from 1980; declare its time scale.";
  // Recorders start within seconds of each other; with the slack of a long drive any difference would do.
  if (const std::string leap = leap_second_hint(difference_s, std::min(slack_s, 3.0)); !leap.empty()) return leap;
  const double hours = std::round(size_s / 1800.0) * 0.5;
  if (hours >= 0.5 && hours <= 14.0 && std::abs(size_s - hours * 3600.0) <= std::max(slack_s, 30.0)) {
    char text[120];
    std::snprintf(text, sizeof text, "That is about %g hours: likely a time zone; both must be in UTC.", hours);
    return text;
  }
  return {};
}

/// What makes clocks differ by this much; the drives' own lengths leave the difference uncertain by `slack_s`.
std::string likely_cause(double difference_s, double slack_s) {
  if (std::string known = known_cause(difference_s, slack_s); !known.empty()) return known;
  const double size_s = std::abs(difference_s);
  if (size_s > 86400.0) return "They belong to different drives, or a clock or its unit is wrong.";
  return "They belong to different drives, or one clock is not synchronised.";
}

}  // namespace

std::string leap_second_hint(double difference_s, double slack_s) {
  const auto near = [&](double least_s, double most_s) {
    const double size_s = std::abs(difference_s);
    return size_s >= least_s - slack_s && size_s <= most_s + slack_s;
  };
  if (near(37.0, 37.0))
    return "TAI is 37 s ahead of UTC since 2017: likely a clock that PTP sets to TAI; declare the time scale.";
  const bool utc = near(17.0, 18.0), tai = near(19.0, 19.0);
  if (utc && tai)
    return "GPS time is 18 s ahead of UTC since 2017 (17 s before), and TAI 19 s ahead of GPS time: likely leap "
           "seconds, or a clock that PTP sets to TAI; declare the time scale.";
  if (utc)
    return "GPS time is 18 s ahead of UTC since 2017 (17 s before): likely leap seconds; declare the time scale.";
  if (tai) return "TAI is 19 s ahead of GPS time: likely a clock that PTP sets to TAI; declare the time scale.";
  return {};
}

std::string cause_of_apart_clocks(std::int64_t lidar_stamp_ns, std::int64_t other_stamp_ns, double apart_s) {
  constexpr double kSlack_s = 1.0;                              // delays of recorders
  constexpr std::int64_t kBooted_ns = 100'000'000'000'000'000;  // running for three years, or a date in 1973
  const bool lidar_booted = std::abs(lidar_stamp_ns) < kBooted_ns, other_booted = std::abs(other_stamp_ns) < kBooted_ns;
  if (lidar_booted && !other_booted) return "The LiDAR's clock counts from when it was switched on, not from 1970.";
  if (other_booted && !lidar_booted) return "That clock counts from when it was switched on, not from 1970.";
  return known_cause(apart_s, kSlack_s);
}

std::string shifted_by_leap_seconds(const TimeSpan& lidar, const TimeSpan& ins) {
  // Streams of one recorder begin and end together, or within a second: one that covers the other is no suspect.
  constexpr double kTogether_s = 1.5;
  const double begins_s = 1e-9 * static_cast<double>(lidar.first_ns - ins.first_ns);
  const double ends_s = 1e-9 * static_cast<double>(lidar.last_ns - ins.last_ns);
  if (std::abs(begins_s - ends_s) > 2.0 * kTogether_s || begins_s * ends_s <= 0.0) return {};
  const double mean_s = 0.5 * (begins_s + ends_s);
  const std::string hint = leap_second_hint(mean_s, kTogether_s);
  if (hint.empty()) return {};
  char text[200];
  std::snprintf(text, sizeof text, "The LiDAR's times begin %.3f s %s those of the INS, and end %.3f s %s them. ",
                std::abs(begins_s), begins_s > 0.0 ? "after" : "before", std::abs(ends_s),
                ends_s > 0.0 ? "after" : "before");
  return text + hint;
}

std::string clock_difference(const TimeSpan& stream, const TimeSpan& reference) {
  // Recordings usually begin together: the difference of their beginnings is nearest to that of the clocks.
  const double difference_s = 1e-9 * (static_cast<double>(stream.first_ns) - static_cast<double>(reference.first_ns));
  const double length_s =
      1e-9 * std::min(static_cast<double>(stream.last_ns) - static_cast<double>(stream.first_ns),
                      static_cast<double>(reference.last_ns) - static_cast<double>(reference.first_ns));
  return "the beginnings are " + duration(std::abs(difference_s)) + " apart. " +
         likely_cause(difference_s, std::min(length_s, 600.0));
}

std::string time_spans_apart(const TimeSpan& lidar, const TimeSpan& ins) {
  const bool before = lidar.last_ns < ins.first_ns;
  const double apart_s = 1e-9 * (before ? static_cast<double>(ins.first_ns) - static_cast<double>(lidar.last_ns)
                                        : static_cast<double>(lidar.first_ns) - static_cast<double>(ins.last_ns));
  const std::string where = before ? " before the INS data begin" : " after the INS data end";
  return "the LiDAR's times " + std::string(before ? "end " : "begin ") + duration(apart_s) + where + ", and " +
         clock_difference(lidar, ins);
}

}  // namespace remount
