// Two recordings that do not meet in time: by how much, and why that usually happens.
#pragma once

#include <cstdint>
#include <string>

namespace remount {

/// First and last stamp of a stream, ns.
struct TimeSpan {
  std::int64_t first_ns = 0, last_ns = 0;
};

/// "the scans end 17.8 s before the INS data begin; ... leap seconds": for spans without a common instant. `lidar` and
/// `ins` are on clocks that should be one.
std::string time_spans_apart(const TimeSpan& lidar, const TimeSpan& ins);

}  // namespace remount
