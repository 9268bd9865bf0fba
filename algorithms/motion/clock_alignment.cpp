#include "algorithms/motion/clock_alignment.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "algorithms/core/index.h"
#include "algorithms/core/stamps.h"
#include "messages/motion.h"

namespace remount::motion {

namespace {

constexpr double kNoRate = std::numeric_limits<double>::quiet_NaN();
constexpr double kCoarseStep_s = 0.1;
constexpr double kApart_s = 1.0;            ///< a rival peak is farther away than this
constexpr double kMinSpread_rad_s = 0.005;  ///< of the rates: below it nothing turns
constexpr double kMinCorrelation = 0.6;
constexpr double kMinMisfitRatio = 1.5;          ///< of the rival peak to the best one
constexpr double kMinLead = 0.005;               ///< of the best peak before its rival
constexpr std::size_t kMaxSamples = 20'000'000;  ///< of a grid: a longer stream has broken stamps

/// Rates of rotation on an even grid that starts at `start_ns`; NaN where there is no data.
struct RateGrid {
  std::int64_t start_ns = 0;
  double step_s = 0.0;
  std::vector<double> rate_rad_s;
};

/// Rotation at a time between two poses, or nothing across a gap.
class RotationTrack {
 public:
  RotationTrack(const RotationStream& stream, double max_gap_s) : stream_(stream), max_gap_s_(max_gap_s) {}

  /// Times must be asked for in ascending order: the search goes on from where it was.
  bool at(std::int64_t stamp_ns, Eigen::Quaterniond& rotation) {
    while (next_ < stream_.size() && stream_.stamp_ns(next_) < stamp_ns) ++next_;
    if (next_ >= stream_.size() || (next_ == 0 && stream_.stamp_ns(0) != stamp_ns)) return false;
    const Eigen::Quaterniond after = stream_.rotation(next_);
    if (stream_.stamp_ns(next_) == stamp_ns) {
      rotation = after;
      return true;
    }
    const std::int64_t before_ns = stream_.stamp_ns(next_ - 1);
    const double gap_s = seconds(stream_.stamp_ns(next_) - before_ns);
    if (gap_s > max_gap_s_) return false;
    rotation = stream_.rotation(next_ - 1).slerp(seconds(stamp_ns - before_ns) / gap_s, after);
    return true;
  }

 private:
  const RotationStream& stream_;
  double max_gap_s_;
  std::size_t next_ = 0;
};

double length_of_s(const RotationStream& stream) {
  return stream.empty() ? 0.0 : seconds(stream.stamp_ns(stream.size() - 1) - stream.stamp_ns(0));
}

RateGrid rates(const RotationStream& stream, double step_s, const ClockAlignmentOptions& options) {
  RateGrid grid;
  grid.step_s = step_s;
  if (stream.size() < 2) return grid;
  const double length_s = length_of_s(stream);
  if (length_s < options.window_s || length_s / step_s > static_cast<double>(kMaxSamples)) return grid;
  const auto half_window_ns = static_cast<std::int64_t>(options.window_s * 0.5e9);
  grid.start_ns = stream.stamp_ns(0) + half_window_ns;
  const auto count = static_cast<std::size_t>((length_s - options.window_s) / step_s) + 1;
  grid.rate_rad_s.assign(count, kNoRate);
  RotationTrack early(stream, options.max_gap_s), late(stream, options.max_gap_s);
  Eigen::Quaterniond before, after;
  for (std::size_t i = 0; i < count; ++i) {
    const std::int64_t stamp_ns = grid.start_ns + std::llround(static_cast<double>(i) * step_s * 1e9);
    const bool has_before = early.at(stamp_ns - half_window_ns, before),
               has_after = late.at(stamp_ns + half_window_ns, after);
    if (has_before && has_after) grid.rate_rad_s[i] = before.angularDistance(after) / options.window_s;
  }
  return grid;
}

struct Fit {
  double correlation = -1.0;
  std::size_t overlap = 0;
};

/// Correlation of other[i] with reference[i + shift] over the samples that both have.
Fit correlate(const std::vector<double>& reference, const std::vector<double>& other, std::int64_t shift,
              std::size_t min_overlap) {
  const std::int64_t n = static_cast<std::int64_t>(other.size()), m = static_cast<std::int64_t>(reference.size());
  double sum_r = 0.0, sum_o = 0.0, sum_rr = 0.0, sum_oo = 0.0, sum_ro = 0.0;
  Fit fit;
  for (std::int64_t i = std::max<std::int64_t>(0, -shift); i < std::min(n, m - shift); ++i) {
    const double r = reference[index_at(i + shift)], o = other[index_at(i)];
    if (std::isnan(r) || std::isnan(o)) continue;
    ++fit.overlap;
    sum_r += r, sum_o += o, sum_rr += r * r, sum_oo += o * o, sum_ro += r * o;
  }
  if (fit.overlap < min_overlap || fit.overlap < 3) return fit;
  const double count = static_cast<double>(fit.overlap);
  const double var_r = sum_rr - sum_r * sum_r / count, var_o = sum_oo - sum_o * sum_o / count;
  if (var_r < 1e-9 * count || var_o < 1e-9 * count) return fit;
  fit.correlation = (sum_ro - sum_r * sum_o / count) / std::sqrt(var_r * var_o);
  return fit;
}

double spread(const std::vector<double>& rate_rad_s) {
  double sum = 0.0, squares = 0.0, count = 0.0;
  for (const double rate : rate_rad_s)
    if (!std::isnan(rate)) sum += rate, squares += rate * rate, count += 1.0;
  return count < 2.0 ? 0.0 : std::sqrt(std::max(0.0, squares / count - sum * sum / (count * count)));
}

/// The part of a stream of at most `length_s` whose rate varies most.
RotationStream liveliest_part(const RotationStream& stream, double length_s, const ClockAlignmentOptions& options) {
  if (length_of_s(stream) <= length_s) return stream;
  const RateGrid grid = rates(stream, kCoarseStep_s, options);
  const auto window = static_cast<std::size_t>(length_s / grid.step_s);
  double best = -1.0;
  std::size_t best_start = 0;
  for (std::size_t start = 0; start + window <= grid.rate_rad_s.size(); start += std::max<std::size_t>(window / 4, 1)) {
    const auto from = grid.rate_rad_s.begin() + static_cast<std::ptrdiff_t>(start);
    const double activity = spread({from, from + static_cast<std::ptrdiff_t>(window)});
    if (activity > best) best = activity, best_start = start;
  }
  const std::int64_t from_ns = grid.start_ns + std::llround(static_cast<double>(best_start) * grid.step_s * 1e9);
  const std::int64_t to_ns = from_ns + std::llround(length_s * 1e9);
  return stream.between(from_ns, to_ns);
}

struct Peak {
  std::int64_t shift = 0;
  double correlation = -1.0, runner_up = -1.0;
};

Peak coarse_peak(const RateGrid& reference, const RateGrid& other, std::size_t min_overlap, double max_offset_s) {
  auto first = -static_cast<std::int64_t>(other.rate_rad_s.size()),
       last = static_cast<std::int64_t>(reference.rate_rad_s.size());
  if (std::isfinite(max_offset_s)) {
    const double unshifted_s = seconds(reference.start_ns - other.start_ns);
    first = std::max(first, static_cast<std::int64_t>(std::ceil((-max_offset_s - unshifted_s) / reference.step_s)));
    last = std::min(last, static_cast<std::int64_t>(std::floor((max_offset_s - unshifted_s) / reference.step_s)));
  }
  std::vector<double> correlations;
  Peak peak;
  for (std::int64_t shift = first; shift <= last; ++shift) {
    correlations.push_back(correlate(reference.rate_rad_s, other.rate_rad_s, shift, min_overlap).correlation);
    if (correlations.back() > peak.correlation) peak.correlation = correlations.back(), peak.shift = shift;
  }
  const auto apart = static_cast<std::int64_t>(kApart_s / reference.step_s);
  // A rival is another summit: while the flank of the best peak still falls, it is not one.
  const auto value = [&](std::int64_t shift) { return correlations[index_at(shift - first)]; };
  for (const int side : {-1, 1}) {
    std::int64_t shift = peak.shift + side * apart;
    while (shift > first && shift < last && value(shift + side) < value(shift)) shift += side;
    for (; shift >= first && shift <= last; shift += side) peak.runner_up = std::max(peak.runner_up, value(shift));
  }
  return peak;
}

/// Offset below one step from the parabola through the peak, and its sigma from the misfit and the peak's curvature.
/// docs/maths/clocks.md (K4)
void refine(const RateGrid& reference, const RateGrid& other, std::int64_t around, std::int64_t reach,
            std::size_t min_overlap, const ClockAlignmentOptions& options, ClockAlignment& result) {
  std::int64_t best = around;
  Fit best_fit;
  for (std::int64_t shift = around - reach; shift <= around + reach; ++shift) {
    const Fit fit = correlate(reference.rate_rad_s, other.rate_rad_s, shift, min_overlap);
    if (fit.correlation > best_fit.correlation) best_fit = fit, best = shift;
  }
  // Arms as long as half the window: there the summit is a parabola, and noise moves its three points less.
  const auto arm = std::max<std::int64_t>(1, std::llround(0.5 * options.window_s / reference.step_s));
  const double left = correlate(reference.rate_rad_s, other.rate_rad_s, best - arm, min_overlap).correlation;
  const double right = correlate(reference.rate_rad_s, other.rate_rad_s, best + arm, min_overlap).correlation;
  const double arm_s = static_cast<double>(arm) * reference.step_s;
  const double bend = left + right - 2.0 * best_fit.correlation;
  double within_s = 0.0;
  if (bend < 0.0) within_s = std::clamp(0.5 * (left - right) / bend, -1.0, 1.0) * arm_s;
  const double curvature = std::max(-bend / (arm_s * arm_s), 1e-12);
  result.correlation = best_fit.correlation;
  result.overlap_s = static_cast<double>(best_fit.overlap) * reference.step_s;
  const double independent = std::max(1.0, result.overlap_s / options.window_s);
  result.sigma_s = std::sqrt(2.0 * std::max(0.0, 1.0 - best_fit.correlation) / (independent * curvature)) + 1e-4;
  result.offset_s =
      seconds(reference.start_ns - other.start_ns) + static_cast<double>(best) * reference.step_s + within_s;
}

}  // namespace

RotationStream RotationStream::between(std::int64_t from_ns, std::int64_t to_ns) const {
  std::size_t first = 0, last = size();
  while (first < last && stamp_ns(first) < from_ns) ++first;
  while (last > first && stamp_ns(last - 1) > to_ns) --last;
  RotationStream part;
  if (samples_.empty())
    part.poses_ = poses_.subspan(first, last - first);
  else
    part.samples_ = samples_.subspan(first, last - first);
  return part;
}

ClockAlignment align_clocks(const RotationStream& reference, const RotationStream& other,
                            const ClockAlignmentOptions& options) {
  ClockAlignment result;
  const RotationStream part = liveliest_part(other, options.max_template_s, options);
  const RateGrid coarse_reference = rates(reference, kCoarseStep_s, options),
                 coarse_other = rates(part, kCoarseStep_s, options);
  const double shorter_s =
      static_cast<double>(std::min(coarse_reference.rate_rad_s.size(), coarse_other.rate_rad_s.size())) * kCoarseStep_s;
  const double overlap_s = std::max(options.min_overlap_s, 0.5 * shorter_s);
  if (shorter_s < options.min_overlap_s) {
    result.why = say::clock_stream_short({options.min_overlap_s});
    return result;
  }
  if (spread(coarse_reference.rate_rad_s) < kMinSpread_rad_s || spread(coarse_other.rate_rad_s) < kMinSpread_rad_s) {
    result.why = say::clock_stream_hardly_turns();
    return result;
  }
  const Peak peak = coarse_peak(coarse_reference, coarse_other, static_cast<std::size_t>(overlap_s / kCoarseStep_s),
                                options.max_offset_s);
  if (peak.correlation <= 0.0) {
    result.why = say::clock_rates_unlike();
    return result;
  }
  const RateGrid fine_reference = rates(reference, options.step_s, options),
                 fine_other = rates(part, options.step_s, options);
  const double coarse_offset_s = static_cast<double>(peak.shift) * kCoarseStep_s;
  refine(fine_reference, fine_other, std::llround(coarse_offset_s / options.step_s),
         std::llround(3.0 * kCoarseStep_s / options.step_s), static_cast<std::size_t>(0.9 * overlap_s / options.step_s),
         options, result);
  result.found = true;
  result.runner_up = peak.runner_up;
  const double misfit = std::max(1.0 - std::max(result.correlation, peak.correlation), 1e-6);
  result.ambiguous = result.correlation < kMinCorrelation || (1.0 - peak.runner_up) / misfit < kMinMisfitRatio ||
                     peak.correlation - peak.runner_up < kMinLead;
  if (result.correlation < kMinCorrelation)
    result.why = say::clock_rates_hardly_alike();
  else if (result.ambiguous)
    result.why = say::clock_another_offset();
  return result;
}

}  // namespace remount::motion
