// Values that are logged more often than they are computed: each is repeated for a while, then jumps to the next.
#pragma once

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "algorithms/core/median.h"
#include "algorithms/core/stamps.h"
#include "model/conventions/metric_poses.h"

namespace remount::conventions {

/// What is typical of values that are held while the vehicle moves.
struct HeldSteps {
  double hold_s = 0.0;   ///< from one new value to the next
  double samples = 0.0;  ///< that a value is repeated for, itself included
  double jump = 0.0;     ///< between successive values, rad or m
  bool even = false;     ///< all are held equally long, but for some
  /// Equal jumps after holds of unequal lengths: the values are rounded, and late by nothing.
  bool rounded = false;
};

/// From the tenth part to the ninetieth, as a share of the median.
inline double relative_spread(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size()))];
  };
  return (at(0.9) - at(0.1)) / at(0.5);
}

/// Numbers of the samples at which a new value begins; the first sample among them.
template <class Difference>
std::vector<std::size_t> starts_of_values(std::size_t samples, double same, Difference&& difference) {
  std::vector<std::size_t> starts;
  starts.reserve(samples);
  for (std::size_t i = 0; i < samples; ++i)
    if (starts.empty() || difference(starts.back(), i) > same) starts.push_back(i);
  return starts;
}

/// Nothing where values are not held.
/// @param difference of the values of two samples, by their numbers; equal up to `same`
/// @param moving samples count where the values change by more than this within a second
template <class Difference>
std::optional<HeldSteps> held_steps(const MetricPoses& poses, double same, double moving, double least_jump,
                                    Difference&& difference) {
  constexpr double kWindow_s = 1.0;       // over which it is judged whether the vehicle turns or drives
  constexpr double kRepeated = 0.45;      // share of samples that repeat the one before: each value comes twice or more
  constexpr std::size_t kFewSteps = 10;   // below this many nothing is said
  constexpr double kLongestHold_s = 3.0;  // longer ones are stalls, not steps
  constexpr double kUneven = 0.5;
  const std::vector<std::size_t> starts = starts_of_values(poses.size(), same, difference);
  const auto time_s = [&](std::size_t from, std::size_t to) {
    return seconds(poses[to].stamp_ns - poses[from].stamp_ns);
  };
  const auto for_each_hold = [&](auto&& visit) {
    for (std::size_t k = 0, before = 0, after = 0; k + 1 < starts.size(); ++k) {
      const std::size_t from = starts[k], to = starts[k + 1];
      while (before < k && time_s(starts[before + 1], from) >= 0.5 * kWindow_s) ++before;
      while (after + 1 < starts.size() && time_s(from, starts[after]) < 0.5 * kWindow_s) ++after;
      const double window_s = time_s(starts[before], starts[after]), hold_s = time_s(from, to);
      const double change = difference(starts[before], starts[after]);
      if (window_s > 0.0 && hold_s <= kLongestHold_s && change >= moving * std::max(1.0, window_s / kWindow_s))
        visit(from, to);
    }
  };
  // Counted first: most logs hold nothing, and lists of every sample would take more memory than all that is known of
  // it.
  std::size_t holds = 0, samples = 0;
  for_each_hold([&](std::size_t from, std::size_t to) { ++holds, samples += to - from; });
  if (holds < kFewSteps || static_cast<double>(samples - holds) < kRepeated * static_cast<double>(samples))
    return std::nullopt;
  std::vector<double> holds_s, lengths, jumps;
  for_each_hold([&](std::size_t from, std::size_t to) {
    holds_s.push_back(time_s(from, to));
    lengths.push_back(static_cast<double>(to - from));
    jumps.push_back(difference(from, to));
  });
  const double uneven = relative_spread(lengths);
  const bool rounded = relative_spread(jumps) < 0.5 * uneven;
  const HeldSteps steps{median_of(std::move(holds_s)), median_of(std::move(lengths)), median_of(std::move(jumps)),
                        uneven < kUneven, rounded};
  if (steps.samples < 2.0 || steps.jump < least_jump) return std::nullopt;
  return steps;
}

}  // namespace remount::conventions
