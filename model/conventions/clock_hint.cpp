#include "model/conventions/clock_hint.h"

#include <algorithm>
#include <cmath>

#include "messages/checks.h"

namespace remount::conventions {
namespace {

constexpr double kGpsEpoch_s = 315964800.0;  ///< Unix time of 6 January 1980

Message apart_by(double seconds) {
  const Duration time{seconds};
  if (seconds < 7200.0) return say::apart_by_seconds(time);
  return seconds < 2.0 * 86400.0 ? say::apart_by_hours(time) : say::apart_by_days(time);
}

/// What is known to make clocks differ by this much, to within `slack_s`; empty for nothing.
Message known_cause(double difference_s, double slack_s) {
  const double size_s = std::abs(difference_s);
  if (std::abs(size_s - kGpsEpoch_s) < 86400.0) return say::clock_of_gps_epoch();
  // Recorders start within seconds of each other; with the slack of a long drive any difference would do.
  if (const Message leap = leap_second_hint(difference_s, std::min(slack_s, 3.0)); !leap.empty()) return leap;
  const double hours = std::round(size_s / 1800.0) * 0.5;
  if (hours >= 0.5 && hours <= 14.0 && std::abs(size_s - hours * 3600.0) <= std::max(slack_s, 30.0))
    return say::clock_of_time_zone(Duration{3600.0 * hours});
  return {};
}

/// What makes clocks differ by this much; the drives' own lengths leave the difference uncertain by `slack_s`.
Message likely_cause(double difference_s, double slack_s) {
  if (Message known = known_cause(difference_s, slack_s); !known.empty()) return known;
  return std::abs(difference_s) > 86400.0 ? say::clock_of_other_drive_or_unit() : say::clock_of_other_drive();
}

}  // namespace

Message leap_second_hint(double difference_s, double slack_s) {
  const auto near = [&](double least_s, double most_s) {
    const double size_s = std::abs(difference_s);
    return size_s >= least_s - slack_s && size_s <= most_s + slack_s;
  };
  if (near(37.0, 37.0)) return say::clock_of_tai_by_utc();
  const bool utc = near(17.0, 18.0), tai = near(19.0, 19.0);
  if (utc && tai) return say::clock_of_utc_or_tai();
  if (utc) return say::clock_of_utc();
  if (tai) return say::clock_of_tai_by_gps();
  return {};
}

Message power_on_of(std::int64_t lidar_stamp_ns, std::int64_t other_stamp_ns) {
  constexpr std::int64_t kBooted_ns = 100'000'000'000'000'000;  // running for three years, or a date in 1973
  const bool lidar_booted = std::abs(lidar_stamp_ns) < kBooted_ns, other_booted = std::abs(other_stamp_ns) < kBooted_ns;
  if (lidar_booted && !other_booted) return say::clock_of_lidar_since_power_on();
  return other_booted && !lidar_booted ? say::clock_since_power_on() : Message();
}

Message cause_of_apart_clocks(std::int64_t lidar_stamp_ns, std::int64_t other_stamp_ns, double apart_s) {
  constexpr double kSlack_s = 1.0;  // delays of recorders
  Message power_on = power_on_of(lidar_stamp_ns, other_stamp_ns);
  return power_on.empty() ? known_cause(apart_s, kSlack_s) : power_on;
}

Message shifted_by_leap_seconds(const TimeSpan& lidar, const TimeSpan& ins) {
  // Streams of one recorder begin and end together, or within a second: one that covers the other is no suspect.
  constexpr double kTogether_s = 1.5;
  const double begins_s = 1e-9 * (static_cast<double>(lidar.first_ns) - static_cast<double>(ins.first_ns));
  const double ends_s = 1e-9 * (static_cast<double>(lidar.last_ns) - static_cast<double>(ins.last_ns));
  if (std::abs(begins_s - ends_s) > 2.0 * kTogether_s || begins_s * ends_s <= 0.0) return {};
  const double mean_s = 0.5 * (begins_s + ends_s);
  Message hint = leap_second_hint(mean_s, kTogether_s);
  if (hint.empty()) return {};
  const Duration begins{std::abs(begins_s)}, ends{std::abs(ends_s)};
  return begins_s > 0.0 ? say::lidar_later_by_leap_seconds(begins, ends, std::move(hint))
                        : say::lidar_earlier_by_leap_seconds(begins, ends, std::move(hint));
}

Message clock_difference(const TimeSpan& stream, const TimeSpan& reference) {
  // Recordings usually begin together: the difference of their beginnings is nearest to that of the clocks.
  const double difference_s = 1e-9 * (static_cast<double>(stream.first_ns) - static_cast<double>(reference.first_ns));
  const double length_s =
      1e-9 * std::min(static_cast<double>(stream.last_ns) - static_cast<double>(stream.first_ns),
                      static_cast<double>(reference.last_ns) - static_cast<double>(reference.first_ns));
  return say::beginnings_apart(apart_by(std::abs(difference_s)), likely_cause(difference_s, std::min(length_s, 600.0)));
}

Message time_spans_apart(const TimeSpan& lidar, const TimeSpan& ins) {
  const bool before = lidar.last_ns < ins.first_ns;
  const double apart_s = 1e-9 * (before ? static_cast<double>(ins.first_ns) - static_cast<double>(lidar.last_ns)
                                        : static_cast<double>(lidar.first_ns) - static_cast<double>(ins.last_ns));
  return before ? say::lidar_ends_before_ins(apart_by(apart_s), clock_difference(lidar, ins))
                : say::lidar_begins_after_ins(apart_by(apart_s), clock_difference(lidar, ins));
}

}  // namespace remount::conventions
