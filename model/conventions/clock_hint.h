// Two recordings that do not meet in time: by how much, and why that usually happens.
#pragma once

#include <cstdint>

#include "algorithms/messages/message.h"

namespace remount::conventions {

/// First and last stamp of a stream, ns.
struct TimeSpan {
  std::int64_t first_ns = 0, last_ns = 0;
};

/// "the LiDAR's times end 8.000 s before the INS data begin, and the beginnings are 18.000 s apart. GPS time is 18 s
/// ahead of UTC ...": for spans without a common instant. `lidar` and `ins` are on clocks that should be one.
Message time_spans_apart(const TimeSpan& lidar, const TimeSpan& ins);

/// "GPS time is 18 s ahead of UTC ...": where a difference of clocks is that of two time scales to within `slack_s`;
/// empty where it is not.
Message leap_second_hint(double difference_s, double slack_s);

/// Tells which of two clocks counts from when it was switched on; empty where both do, or neither.
Message power_on_of(std::int64_t lidar_stamp_ns, std::int64_t other_stamp_ns);

/// Why a clock is known to be `apart_s` from the LiDAR's (time zone, leap seconds, since power-on), by which the first
/// stamps need not differ; empty where nothing is.
Message cause_of_apart_clocks(std::int64_t lidar_stamp_ns, std::int64_t other_stamp_ns, double apart_s);

/// Where a stream begins and ends by the same leap seconds before or after the other, which it should share its clock
/// with: what to suspect, and by how much; empty where the ends differ otherwise.
Message shifted_by_leap_seconds(const TimeSpan& lidar, const TimeSpan& ins);

/// "the beginnings are 18.000 s apart. GPS time is 18 s ahead of UTC ...": the same of any two streams.
Message clock_difference(const TimeSpan& stream, const TimeSpan& reference);

}  // namespace remount::conventions
