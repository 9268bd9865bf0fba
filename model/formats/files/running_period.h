// Times that begin anew with every day or week, on and on over its end.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <optional>

namespace remount::formats {

inline constexpr std::int64_t kUtcDay_ns = std::int64_t{86'400} * 1'000'000'000;
inline constexpr std::int64_t kGpsWeek_ns = 7 * kUtcDay_ns;
/// Receivers count weeks in ten bits.
inline constexpr std::int64_t kGpsWeeksOfTurn = 1024;
/// Times run on where a recording goes over the end of a week; none goes on for a month.
inline constexpr std::int64_t kLatestInWeek_ns = 5 * kGpsWeek_ns;

/// Counts periods from 0: a time that falls by most of a period is in the next one where the step over the end is
/// short. Other jumps by most of a period are broken times, until another time follows that agrees with them.
class RunningPeriod {
 public:
  /// What is true where a time has fallen far from the end of a period and others agree with it.
  enum class Fall {
    Paused,        ///< the log went on in the next period: people pause over midnight
    BeforeBroken,  ///< those before were broken: over the end of a week nothing pauses
  };

  /// @param late_ns what is before the end of a period and comes behind it by no more is late, and of the period before
  constexpr RunningPeriod(std::int64_t period_ns, std::int64_t late_ns, Fall fall)
      : period_ns_(period_ns), late_ns_(late_ns), fall_(fall) {}

  /// Since the begin of period 0; nothing where the time is broken.
  std::optional<std::int64_t> running_ns(std::int64_t in_period_ns) {
    const std::int64_t now_ns = periods_ * period_ns_ + in_period_ns;
    const std::int64_t step_ns = latest_ns_ ? now_ns - *latest_ns_ : 0;
    if (step_ns > period_ns_ - late_ns_ && step_ns < period_ns_) return now_ns - period_ns_;
    if (std::abs(step_ns) > period_ns_ / 2) return running_behind_jump(in_period_ns, step_ns);
    latest_ns_ = std::max(latest_ns_.value_or(now_ns), now_ns);
    broken_ns_.reset();
    return now_ns;
  }
  /// Of the times so far that are not broken; nothing where there is none.
  std::optional<std::int64_t> latest_ns() const { return latest_ns_; }

 private:
  static constexpr std::int64_t kLongestStep_ns = std::int64_t{3 * 3600} * 1'000'000'000;

  std::optional<std::int64_t> running_behind_jump(std::int64_t in_period_ns, std::int64_t step_ns) {
    const bool into_next = step_ns < 0 && std::abs(step_ns + period_ns_) <= kLongestStep_ns;
    // The one before was broken, and counted a period.
    const bool back = step_ns > 0 && periods_ > 0 && std::abs(step_ns - period_ns_) <= kLongestStep_ns;
    if (!into_next && !back && !agrees(in_period_ns)) {
      broken_ns_ = in_period_ns;
      return std::nullopt;
    }
    if (back) --periods_;
    if (into_next || (step_ns < 0 && fall_ == Fall::Paused)) ++periods_;
    broken_ns_.reset();
    latest_ns_ = periods_ * period_ns_ + in_period_ns;
    return latest_ns_;
  }
  /// With the broken one before. The same again does not: the lines of one time may all be broken.
  bool agrees(std::int64_t in_period_ns) const {
    return broken_ns_ && in_period_ns != *broken_ns_ && std::abs(in_period_ns - *broken_ns_) <= kLongestStep_ns;
  }

  std::int64_t period_ns_, late_ns_;
  Fall fall_;
  std::optional<std::int64_t> latest_ns_, broken_ns_;
  std::int64_t periods_ = 0;
};

/// Of logs whose lines come in groups of one time, and may be behind those of the next.
constexpr RunningPeriod count_days() {
  constexpr std::int64_t kLate_ns = std::int64_t{60} * 1'000'000'000;  // more than any sentence comes late
  return {kUtcDay_ns, kLate_ns, RunningPeriod::Fall::Paused};
}

/// Of tables and records, which are in order.
constexpr RunningPeriod count_weeks() { return {kGpsWeek_ns, 0, RunningPeriod::Fall::BeforeBroken}; }

}  // namespace remount::formats
