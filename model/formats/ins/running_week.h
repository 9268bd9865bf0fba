// Seconds of a GPS week without the week, on and on over its end.
#pragma once

#include <cstdint>
#include <optional>

namespace remount::formats {

inline constexpr std::int64_t kGpsWeek_ns = std::int64_t{604'800} * 1'000'000'000;
/// Times run on where a recording goes over the end of a week; none goes on for a month.
inline constexpr std::int64_t kLatestInWeek_ns = 5 * kGpsWeek_ns;

/// Counts weeks from 0: a time that falls by most of a week is in the next one.
class RunningWeek {
 public:
  std::int64_t running_ns(std::int64_t in_week_ns) {
    if (last_ns_ && in_week_ns < *last_ns_ - kGpsWeek_ns / 2) ++weeks_;
    if (last_ns_ && in_week_ns > *last_ns_ + kGpsWeek_ns / 2 && weeks_ > 0) --weeks_;  // the one before was broken
    last_ns_ = in_week_ns;
    return in_week_ns + weeks_ * kGpsWeek_ns;
  }

 private:
  std::optional<std::int64_t> last_ns_;
  std::int64_t weeks_ = 0;
};

}  // namespace remount::formats
