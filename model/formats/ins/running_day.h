// Times of day, on and on over midnight.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <optional>

namespace remount::formats {

/// Counts days from 0 as RunningWeek counts weeks: a time that falls by most of a day is on the next one where the step
/// over midnight is short. Other jumps by most of a day are broken times, unless another time follows that agrees with
/// them: then the log paused.
class RunningDay {
 public:
  /// Since the first midnight; nothing where the time is broken. What is just before midnight and comes behind it is
  /// late, and of the day before.
  std::optional<std::int64_t> running_ns(std::int64_t time_of_day_ns) {
    std::int64_t now_ns = days_ * kDay_ns + time_of_day_ns;
    const std::int64_t step_ns = latest_ns_ ? now_ns - *latest_ns_ : 0;
    if (step_ns > kDay_ns - kLate_ns) return now_ns - kDay_ns;
    if (std::abs(step_ns) > kDay_ns / 2) {
      const bool into_next = step_ns < 0 && step_ns + kDay_ns <= kLongestStep_ns;
      // The one before was broken, and counted a day.
      const bool back = step_ns > 0 && days_ > 0 && kDay_ns - step_ns <= kLongestStep_ns;
      if (!into_next && !back && !agrees(time_of_day_ns)) {
        broken_ns_ = time_of_day_ns;
        return std::nullopt;
      }
      if (back || step_ns < 0) days_ += back ? -1 : 1;
      now_ns = days_ * kDay_ns + time_of_day_ns;
      latest_ns_ = now_ns;
    }
    latest_ns_ = latest_ns_ ? std::max(*latest_ns_, now_ns) : now_ns;
    broken_ns_.reset();
    return now_ns;
  }
  /// Of the times so far that are not broken; nothing where there is none.
  std::optional<std::int64_t> latest_ns() const { return latest_ns_; }

  static constexpr std::int64_t kDay_ns = 86'400'000'000'000;

 private:
  static constexpr std::int64_t kLate_ns = 60'000'000'000;  ///< more than any sentence comes behind a later one
  static constexpr std::int64_t kLongestStep_ns = std::int64_t{3 * 3600} * 1'000'000'000;

  /// The sentences of one time may all be broken.
  bool agrees(std::int64_t time_of_day_ns) const {
    return broken_ns_ && time_of_day_ns != *broken_ns_ && std::abs(time_of_day_ns - *broken_ns_) <= kLongestStep_ns;
  }

  std::optional<std::int64_t> latest_ns_, broken_ns_;
  std::int64_t days_ = 0;
};

}  // namespace remount::formats
