// Seconds of a GPS week without the week, on and on over its end.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <optional>

namespace remount::formats {

inline constexpr std::int64_t kGpsWeek_ns = std::int64_t{604'800} * 1'000'000'000;
/// Times run on where a recording goes over the end of a week; none goes on for a month.
inline constexpr std::int64_t kLatestInWeek_ns = 5 * kGpsWeek_ns;

/// Counts weeks from 0: a time that falls by most of a week is in the next one where the step over the end of the week
/// is short. Other jumps by most of a week are broken times, unless the next time agrees with them: then those before
/// were broken.
class RunningWeek {
 public:
  /// Nothing where the time is broken.
  std::optional<std::int64_t> running_ns(std::int64_t in_week_ns) {
    const std::int64_t step_ns = last_ns_ ? in_week_ns - *last_ns_ : 0;
    const bool agrees = broken_ns_ && std::abs(in_week_ns - *broken_ns_) <= kLongestStep_ns;
    if (std::abs(step_ns) > kGpsWeek_ns / 2 && !agrees) {
      const bool into_next = step_ns < 0 && std::abs(step_ns + kGpsWeek_ns) <= kLongestStep_ns;
      // The one before was broken, and counted a week.
      const bool back = step_ns > 0 && weeks_ > 0 && std::abs(step_ns - kGpsWeek_ns) <= kLongestStep_ns;
      if (!into_next && !back) {
        broken_ns_ = in_week_ns;
        return std::nullopt;
      }
      weeks_ += into_next ? 1 : -1;
    }
    broken_ns_.reset();
    last_ns_ = in_week_ns;
    return in_week_ns + weeks_ * kGpsWeek_ns;
  }

 private:
  /// Over the end of a week, or between times that agree.
  static constexpr std::int64_t kLongestStep_ns = std::int64_t{3 * 3600} * 1'000'000'000;

  std::optional<std::int64_t> last_ns_, broken_ns_;
  std::int64_t weeks_ = 0;
};

}  // namespace remount::formats
