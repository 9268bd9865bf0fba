#include "model/formats/clouds/sweep_misfit.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <string_view>
#include <vector>

#include "algorithms/cloud/sweep_order.h"
#include "messages/sessions.h"
#include "model/formats/clouds/cloud_fields.h"
#include "model/formats/files/input_file.h"

namespace remount::formats {

namespace {

/// As messages name it: the first of those that are known among "x y z time".
Message time_column_words(const std::string& columns) {
  std::vector<std::string_view> names;
  split_blanks(columns, names);
  for (const std::string_view known : kTimeColumns)
    for (const std::string_view name : names)
      for (const std::string_view prefix : {"", "scalar_", "sf_"})
        if (name.starts_with(prefix) && name.substr(prefix.size()) == known)
          return say::times_column(std::string(name));
  return say::times_unnamed_column();
}

/// The step of times that are all multiples of one too coarse for a sweep; 0 where they are not. 32-bit floats have 24
/// bits: seconds of a week come in steps of up to a 32nd.
double coarse_step_s(const std::vector<float>& times_s) {
  constexpr std::size_t kTurn = 256;
  constexpr double kNear = 1e-3;  // of a step
  if (times_s.size() < kTurn) return 0.0;
  const float low_s = *std::min_element(times_s.begin(), times_s.end());
  const float high_s = *std::max_element(times_s.begin(), times_s.end());
  for (const double step_s : {1.0, 0.5, 0.25, 0.125, 0.0625, 0.03125, 0.015625}) {
    const bool all = high_s > low_s && std::all_of(times_s.begin(), times_s.end(), [&](float time_s) {
                       const double steps = (static_cast<double>(time_s) - static_cast<double>(low_s)) / step_s;
                       return std::abs(steps - std::round(steps)) < kNear;
                     });
    if (all) return step_s;
  }
  return 0.0;
}

}  // namespace

Message coarse_times(const ReadCloud& read) {
  const double step_s = coarse_step_s(read.cloud.time_from_stamp_s);
  if (!(step_s > 0.0)) return {};
  return say::times_coarse(time_column_words(read.columns), Duration{step_s});
}

Message sweep_misfit(const ReadCloud& read, double interval_s) {
  // Clouds of two sensors that are not in step span up to two turns; a recording may leave scans out.
  constexpr double kLongest = 2.1, kShortest = 0.25, kShortestTurn_s = 0.025;
  const std::vector<float>& times_s = read.cloud.time_from_stamp_s;
  if (times_s.empty() || !(interval_s > 0.0)) return {};
  const auto [low, high] = std::minmax_element(times_s.begin(), times_s.end());
  const double span_s = static_cast<double>(*high) - static_cast<double>(*low);
  const bool short_turn =
      span_s < kShortest * interval_s && span_s < kShortestTurn_s && cloud::looks_around(read.cloud);
  if (span_s <= kLongest * interval_s && !short_turn) return {};
  return say::times_span(time_column_words(read.columns), Duration{span_s}, Duration{interval_s});
}

drive::TimesCount times_count(const cloud::PointCloud& cloud) {
  const std::vector<float>& times_s = cloud.time_from_stamp_s;
  if (times_s.size() != cloud.size() || !cloud::looks_around(cloud)) return drive::TimesCount::Forwards;
  std::vector<std::size_t> order(cloud.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return times_s[a] < times_s[b]; });
  cloud::PointCloud by_time;
  for (const std::size_t i : order) by_time.points.push_back(cloud.points[i]);
  const std::optional<cloud::SweepOrder> timed = cloud::sweep_order(by_time), stored = cloud::sweep_order(cloud);
  if (!timed) return drive::TimesCount::Forwards;
  return timed->clockwise == (!stored || stored->clockwise) ? drive::TimesCount::Forwards : drive::TimesCount::Open;
}

}  // namespace remount::formats
