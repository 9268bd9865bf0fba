#include "algorithms/search/certified_search.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <queue>

#include "algorithms/core/index.h"
#include "algorithms/core/symmetric_eigen.h"
#include "algorithms/search/boxed_form.h"
#include "algorithms/search/relaxation.h"
#include "messages/search.h"

namespace remount::search {
namespace {

using Eigen::Vector3d;
using Vector13d = QuadraticForm::Vector13d;

// The canonical angles of the range. Drawn in for the X that are found, by less than any use of them can tell, so that
// rounding does not put an optimum on the edge outside; at pitch +-90 deg the canonical yaw jumps, so that these stay
// just short of it.
AngleBox angle_box(const calibration::SearchRange& range, bool drawn_in) {
  const double most_pitch_rad = kPi / 2.0 - (drawn_in ? 2e-9 : 0.0);
  const Vector3d limit(kPi, most_pitch_rad, kPi);
  AngleBox box;
  box.low = Vector3d(range.yaw_min_rad, range.pitch_min_rad, range.roll_min_rad).cwiseMax(-limit);
  box.high = Vector3d(range.yaw_max_rad, range.pitch_max_rad, range.roll_max_rad).cwiseMin(limit);
  if (box.empty() || !drawn_in) return box;
  const Vector3d margin = (0.25 * (box.high - box.low)).cwiseMin(1e-10);
  box.low += margin;
  box.high -= margin;
  return box;
}

Vector13d constant(double value) { return value * Vector13d::Unit(12); }

// An angle a that shows in entries of R as w cos a and w sin a, its weight w >= 0 known within linear bounds.
struct Wedge {
  Vector13d cosine, sine;
  double low = 0.0, high = 0.0;
  Vector13d least;           // w >= least
  double most_factor = 1.0;  // most_factor * w <= most
  Vector13d most;
};

void add_wedge(const Wedge& wedge, RelaxedRegion& region) {
  if (wedge.high - wedge.low >= kPi) return;  // not convex
  const int first = static_cast<int>(region.half_spaces.size());
  region.half_spaces.push_back(std::cos(wedge.low) * wedge.sine - std::sin(wedge.low) * wedge.cosine);
  region.half_spaces.push_back(std::sin(wedge.high) * wedge.cosine - std::cos(wedge.high) * wedge.sine);
  region.products.emplace_back(first, first + 1);
  // Along the middle direction: beyond the chord, within the arc.
  const double middle = 0.5 * (wedge.low + wedge.high), half = 0.5 * (wedge.high - wedge.low);
  const Vector13d along = std::cos(middle) * wedge.cosine + std::sin(middle) * wedge.sine;
  region.half_spaces.push_back(along - std::cos(half) * wedge.least);
  region.half_spaces.push_back(wedge.most - wedge.most_factor * along);
  region.products.emplace_back(first + 2, first + 3);
}

// Angles as conditions on the entries of R = Rz(yaw) Ry(pitch) Rx(roll). Near pitch +-90 deg yaw and roll lose their
// meaning one by one; their difference or sum, in other entries, keeps it. Bounds on the weights as tight as linear
// ones can be make the relaxation's error fall with the square of a region's width. docs/maths/search.md (S12)
void add_angles(const AngleBox& box, RelaxedRegion& region) {
  const Vector13d sine_pitch = -rotation_entry(2, 0);
  const double low = box.low[1], high = box.high[1], middle = 0.5 * (low + high);
  const double chord = high > low ? (std::cos(high) - std::cos(low)) / (std::sin(high) - std::sin(low)) : 0.0;
  const Vector13d cosine_least = constant(std::cos(low) - chord * std::sin(low)) + chord * sine_pitch;
  const Vector13d cosine_most = constant(1.0) - std::sin(middle) * sine_pitch;
  const Vector13d one_plus = constant(1.0) + sine_pitch, one_minus = constant(1.0) - sine_pitch;
  add_wedge({rotation_entry(0, 0), rotation_entry(1, 0), box.low[0], box.high[0], cosine_least, std::cos(middle),
             cosine_most},
            region);
  add_wedge({rotation_entry(2, 2), rotation_entry(2, 1), box.low[2], box.high[2], cosine_least, std::cos(middle),
             cosine_most},
            region);
  add_wedge({rotation_entry(1, 1) + rotation_entry(0, 2), rotation_entry(1, 2) - rotation_entry(0, 1),
             box.low[0] - box.high[2], box.high[0] - box.low[2], one_plus, 1.0, one_plus},
            region);
  add_wedge({rotation_entry(1, 1) - rotation_entry(0, 2), -rotation_entry(1, 2) - rotation_entry(0, 1),
             box.low[0] + box.low[2], box.high[0] + box.high[2], one_minus, 1.0, one_minus},
            region);
  if (high - low >= kPi) return;
  const int first = static_cast<int>(region.half_spaces.size());
  region.half_spaces.push_back(sine_pitch - constant(std::sin(low)));
  region.half_spaces.push_back(constant(std::sin(high)) - sine_pitch);
  region.products.emplace_back(first, first + 1);
}

RelaxedRegion region_of(const AngleBox& box, const BoxedForm& form) {
  // Limits of no width are widened by less than anyone can measure, because the relaxation needs an inside. The bound
  // of an angle held to less than that is valid, but falls short by what this costs.
  constexpr double kLeastHalfWidth_m = 1e-9, kLeastHalfWidth_rad = 1e-6;
  RelaxedRegion region;
  const Vector3d half = 0.5 * (form.t_high_m() - form.t_low_m());
  const Vector3d middle = form.t_low_m() + half;
  region.t_half_width_m = half.cwiseMax(kLeastHalfWidth_m);
  for (int axis = 0; axis < 3; ++axis) {
    const int first = static_cast<int>(region.half_spaces.size());
    const double width = region.t_half_width_m[axis];
    region.half_spaces.push_back(Vector13d::Unit(9 + axis) + constant(width - middle[axis]));
    region.half_spaces.push_back(constant(width + middle[axis]) - Vector13d::Unit(9 + axis));
    region.products.emplace_back(first, first + 1);
  }
  AngleBox wide = box;
  for (int i = 0; i < 3; ++i)
    if (wide.high[i] - wide.low[i] < kLeastHalfWidth_rad) {
      wide.low[i] -= kLeastHalfWidth_rad;
      wide.high[i] += kLeastHalfWidth_rad;
    }
  // Beyond the pole the sine of pitch turns back.
  wide.low[1] = std::max(wide.low[1], -0.5 * kPi);
  wide.high[1] = std::min(wide.high[1], 0.5 * kPi);
  add_angles(wide, region);
  return region;
}

struct OpenRegion {
  AngleBox box;
  double lower_bound = 0.0;
  int order = 0;  // breaks ties, so that the search is the same everywhere
  bool operator<(const OpenRegion& other) const {
    return lower_bound != other.lower_bound ? lower_bound > other.lower_bound : order > other.order;
  }
};

class Search {
 public:
  Search(const QuadraticForm& form, const calibration::SearchRange& range, const RigidTransform& near,
         const SearchOptions& options, const Progress& progress)
      : boxed_(form, range, near.translation()),
        matrix_(form.matrix()),
        range_box_(angle_box(range, false)),
        inner_box_(angle_box(range, true)),
        options_(options) {
    // Some hundred roundings of entries as large as these.
    constexpr double kRounding = 1e-14;
    const Vector3d reach = boxed_.t_low_m().cwiseAbs().cwiseMax(boxed_.t_high_m().cwiseAbs()).cwiseMin(1.0);
    least_gap_ = kRounding * (matrix_.topLeftCorner<9, 9>().trace() + matrix_(12, 12) +
                              matrix_.diagonal().segment<3>(9).dot(reach.cwiseAbs2()));
    start(near.linear(), progress);
  }

  SearchResult run(const Progress& progress) {
    std::priority_queue<OpenRegion> open;
    open.push({range_box_, 0.0, 0});
    int order = 0;
    double proved = std::numeric_limits<double>::infinity();  // of the regions that are done with
    SearchOutcome outcome = SearchOutcome::Certified;
    while (!open.empty()) {
      if (value_ - open.top().lower_bound <= allowed_gap()) break;
      if (progress.cancelled() || regions_ >= options_.most_regions) {
        outcome = progress.cancelled() ? SearchOutcome::Cancelled : SearchOutcome::GapOpen;
        break;
      }
      OpenRegion region = open.top();
      open.pop();
      ++regions_;
      const RelaxedMinimum relaxed =
          relaxed_minimum(matrix_, region_of(region.box, boxed_), best_, value_ - allowed_gap(), progress);
      region.lower_bound = std::max(region.lower_bound, relaxed.lower_bound);
      if (value_ - region.lower_bound <= allowed_gap()) {
        proved = std::min(proved, region.lower_bound);
        continue;
      }
      try_start(relaxed.nearest.linear());
      for (const AngleBox& half : halves(region.box)) open.push({half, region.lower_bound, ++order});
    }
    if (!open.empty()) proved = std::min(proved, open.top().lower_bound);
    return result(outcome, proved);
  }

 private:
  double allowed_gap() const { return std::max(options_.relative_gap * value_, least_gap_); }

  static std::array<AngleBox, 2> halves(const AngleBox& box) {
    int widest = 0;
    (box.high - box.low).maxCoeff(&widest);
    std::array<AngleBox, 2> out{box, box};
    out[0].high[widest] = out[1].low[widest] = 0.5 * (box.low[widest] + box.high[widest]);
    return out;
  }

  bool in_range(const Eigen::Matrix3d& rotation) const {
    const YawPitchRoll angles = yaw_pitch_roll_from_rotation(rotation);
    const Eigen::Array3d all(angles.yaw_rad, angles.pitch_rad, angles.roll_rad);
    return (all >= range_box_.low.array()).all() && (all <= range_box_.high.array()).all();
  }

  void consider(const RigidTransform& x) {
    const double value = std::max(0.0, boxed_.value(x));
    if (found_.empty() || value < value_) {
      best_ = x;
      value_ = value;
    }
    found_.push_back(x);
  }

  // The minimum that a start leads to, inside the range or on its edge.
  void try_start(const Eigen::Matrix3d& rotation) {
    const RigidTransform free = boxed_.minimise(rotation);
    if (in_range(free.linear())) return consider(free);
    consider(boxed_.minimise(free.linear(), inner_box_));
    consider(boxed_.minimise(rotation, inner_box_));
  }

  // A coarse net of the range, of which the best few are followed.
  void start(const Eigen::Matrix3d& near, const Progress& progress) {
    constexpr int kNet = 6, kFollowed = 6;
    std::vector<std::pair<double, Eigen::Matrix3d>> net;
    for (int i = 0; i < kNet; ++i)
      for (int j = 0; j < kNet; ++j)
        for (int k = 0; k < kNet; ++k) {
          const Vector3d share = (Vector3d(i, j, k).array() + 0.5) / kNet;
          const Vector3d angles = inner_box_.low + share.cwiseProduct(inner_box_.high - inner_box_.low);
          const Eigen::Matrix3d rotation = rotation_from_yaw_pitch_roll({angles[0], angles[1], angles[2]});
          net.emplace_back(boxed_.value(boxed_.best_at(rotation)), rotation);
        }
    std::stable_sort(net.begin(), net.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    try_start(near);
    for (int i = 0; i < kFollowed && !progress.cancelled(); ++i) try_start(net[index_at(i)].second);
  }

  bool in_box(const RigidTransform& x) const {
    return in_range(x.linear()) && (x.translation().array() >= boxed_.t_low_m().array()).all() &&
           (x.translation().array() <= boxed_.t_high_m().array()).all();
  }

  // Does another X of the range score the same: a step along any main direction, or another minimum?
  bool unique() const {
    constexpr double kApart = 0.01;  // m, rad
    const double tie = value_ + allowed_gap();
    const auto eigen = symmetric_eigen(Matrix6d(boxed_.curvature(best_)));
    for (int i = 0; i < 6; ++i)
      for (const double step : {kApart, -kApart}) {
        const RigidTransform other = perturb(best_, step * eigen.eigenvectors().col(i));
        if (in_box(other) && boxed_.value(other) <= tie) return false;
      }
    return std::none_of(found_.begin(), found_.end(), [&](const RigidTransform& other) {
      return boxed_.value(other) <= tie && difference(best_, other).norm() > kApart;
    });
  }

  SearchResult result(SearchOutcome outcome, double proved) const {
    SearchResult out;
    out.outcome = outcome;
    out.ins_from_lidar = best_;
    out.value = value_;
    out.lower_bound = std::clamp(proved, 0.0, std::max(0.0, value_));
    out.allowed_gap = allowed_gap();
    out.unique = unique();
    out.regions = regions_;
    Message what = outcome == SearchOutcome::Certified ? say::search_certified()
                   : outcome == SearchOutcome::GapOpen ? say::search_gap_open()
                                                       : say::search_cut_short();
    out.message =
        (out.unique ? say::search_unique : say::search_not_unique)(std::move(what), out.gap(), value_, regions_);
    return out;
  }

  BoxedForm boxed_;
  const QuadraticForm::Matrix13d& matrix_;
  AngleBox range_box_, inner_box_;
  SearchOptions options_;
  RigidTransform best_ = RigidTransform::Identity();
  double value_ = 0.0, least_gap_ = 0.0;
  std::vector<RigidTransform> found_;
  int regions_ = 0;
};

bool finite(const calibration::SearchRange& range) {
  bool all = true;
  calibration::SearchRange::visit(range, [&](const OptionInfo&, double value) { all = all && std::isfinite(value); });
  return all;
}

}  // namespace

SearchResult certified_search(const QuadraticForm& form, const calibration::SearchRange& range,
                              const RigidTransform& near, const SearchOptions& options, const Progress& progress) {
  SearchResult out;
  if (!form.matrix().allFinite() || !finite(range) || !near.matrix().allFinite()) {
    out.message = say::search_not_finite();
    return out;
  }
  const bool t_empty = range.x_min_m > range.x_max_m || range.y_min_m > range.y_max_m || range.z_min_m > range.z_max_m;
  if (t_empty || angle_box(range, false).empty()) {
    out.outcome = SearchOutcome::EmptyRange;
    out.message = say::search_empty_range();
    return out;
  }
  if (progress.cancelled()) {
    out.outcome = SearchOutcome::Cancelled;
    out.message = say::search_cancelled();
    return out;
  }
  return Search(form, range, near, options, progress).run(progress);
}

}  // namespace remount::search
