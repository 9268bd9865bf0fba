// How long a step of known size still takes.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

namespace remount {

/// Counts down to the end of a step, or says nothing: a mean over all that is done says "about a minute" for minutes
/// where the items at the end take longer. An end is foreseen, and what is said counts down to it for as long as the
/// items that come in agree with it; where they do not, another is foreseen and must hold for a while before it is
/// said.
class RemainingTime {
 public:
  /// Seconds that are left, `elapsed_s` after the step began with nothing of `total` done. Nothing where that is not
  /// known. Times ascend.
  std::optional<double> left_s(double elapsed_s, double done, double total) {
    constexpr double kTooEarly_s = 1.5;
    if (elapsed_s < kTooEarly_s || done < 1.0 || done >= total) return std::nullopt;
    const double end_s = elapsed_s * total / done;
    if (!foreseen_s_ || std::abs(end_s - *foreseen_s_) > tolerance_s(end_s - elapsed_s)) {
      if (foreseen_s_) must_hold_s_ *= 2.0;  // who was wrong once is believed later
      foreseen_s_ = end_s;
      since_s_ = elapsed_s;
    }
    const double left_s = *foreseen_s_ - elapsed_s;
    const bool holds = elapsed_s - since_s_ >= must_hold_s_;
    return holds && left_s >= 0.5 ? std::optional(left_s) : std::nullopt;
  }

 private:
  static double tolerance_s(double left_s) { return std::max(2.0, 0.2 * left_s); }

  std::optional<double> foreseen_s_;  // end of the step, counted from its beginning
  double since_s_ = 0.0;              // since when that end is foreseen
  double must_hold_s_ = 1.0;
};

}  // namespace remount
