// Attitudes or positions, or one number of them, that are logged more often than they are computed: each value is
// repeated for a while, then jumps to the next.
#include <algorithm>
#include <cmath>
#include <optional>

#include "algorithms/core/median.h"
#include "algorithms/geometry/rotation.h"
#include "messages/checks.h"
#include "model/checks/builtin.h"
#include "model/checks/check_times.h"

namespace remount {
namespace {

constexpr double kSameAttitude_rad = 1e-8;  ///< interpolating between two that are the same rounds
constexpr double kWindow_s = 1.0;           ///< over which it is judged whether the vehicle turns or drives
constexpr double kTurning_rad = 3.0 * kPi / 180.0, kDriving_m = 1.0;  ///< in a window, at least
// What jumps by less may be rounding of the log; it moves nothing that is calibrated.
constexpr double kLeastTurn_rad = 0.15 * kPi / 180.0, kLeastStep_m = 0.1;
constexpr double kRepeated = 0.45;      ///< share of samples that repeat the one before: each value comes twice or more
constexpr std::size_t kFewSteps = 10;   ///< below this many nothing is said
constexpr double kLongestHold_s = 3.0;  ///< longer ones are stalls, not steps

/// What is typical of values that are held while the vehicle moves.
struct Steps {
  double hold_s = 0.0;   ///< from one new value to the next
  double samples = 0.0;  ///< that a value is repeated for, itself included
  double jump = 0.0;     ///< between successive values, rad or m
  /// Equal jumps after holds of unequal lengths: the values are rounded, and late by nothing.
  bool rounded = false;
};

/// From the tenth part to the ninetieth, as a share of the median.
double spread(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size()))];
  };
  return (at(0.9) - at(0.1)) / at(0.5);
}

/// `difference(a, b)` of the values of two samples; equal up to `same`. Samples count where the values change by more
/// than `moving` within a window.
template <class Difference>
std::optional<Steps> steps_of(const MetricPoses& poses, double same, double moving, double least_jump,
                              Difference&& difference) {
  std::vector<std::size_t> starts;  // of each new value
  starts.reserve(poses.size());
  for (std::size_t i = 0; i < poses.size(); ++i)
    if (starts.empty() || difference(starts.back(), i) > same) starts.push_back(i);
  const auto time_s = [&](std::size_t from, std::size_t to) {
    return seconds_between(poses[from].stamp_ns, poses[to].stamp_ns);
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
  const bool rounded = spread(jumps) < 0.5 * spread(lengths);
  const Steps steps{median_of(std::move(holds_s)), median_of(std::move(lengths)), median_of(std::move(jumps)), rounded};
  if (steps.samples < 2.0 || steps.jump < least_jump) return std::nullopt;
  return steps;
}

void add(std::vector<Finding>& findings, const char* code, Message explanation) {
  findings.push_back({Severity::Warning, code, "INS", std::move(explanation)});
}

double heading_rad(const Eigen::Quaterniond& q) {
  return std::atan2(2.0 * (q.w() * q.z() + q.x() * q.y()), 1.0 - 2.0 * (q.y() * q.y() + q.z() * q.z()));
}

void look_at_attitude(const CheckedSession& checked, std::vector<Finding>& findings) {
  const auto steps = [&](auto&& turned_rad) {
    return steps_of(checked.poses, kSameAttitude_rad, kTurning_rad, kLeastTurn_rad, turned_rad);
  };
  if (const auto all = steps([&](std::size_t a, std::size_t b) {
        return checked.logged_attitude(a).angularDistance(checked.logged_attitude(b));
      })) {
    add(findings, "ins-attitude-held", say::ins_attitude_held(Duration{all->hold_s}, all->samples, Angle{all->jump}));
    return;
  }
  // Headings may come from another receiver, of two antennas, than pitch and roll.
  if (const auto heading = steps([&](std::size_t a, std::size_t b) {
        return std::abs(
            wrap_angle_rad(heading_rad(checked.logged_attitude(a)) - heading_rad(checked.logged_attitude(b))));
      });
      heading && !heading->rounded)
    add(findings, "ins-attitude-held",
        say::ins_heading_held(Duration{heading->hold_s}, heading->samples, Angle{heading->jump}));
}

void look_at_position(const CheckedSession& checked, std::vector<Finding>& findings) {
  const MetricPoses& poses = checked.poses;
  const std::vector<InsSample>& ins = checked.session.ins;
  const bool geodetic = ins.size() == poses.size();
  const auto steps = [&](auto&& step_m) { return steps_of(poses, 0.0, kDriving_m, kLeastStep_m, step_m); };
  const auto step = [&](std::size_t a, std::size_t b) -> Eigen::Vector3d {
    return poses[a].pose.translation() - poses[b].pose.translation();
  };
  // Heights may come from elsewhere than the place.
  if (const auto all = steps([&](std::size_t a, std::size_t b) {
        if (!geodetic) return step(a, b).norm();
        const bool same = ins[a].latitude_rad == ins[b].latitude_rad && ins[a].longitude_rad == ins[b].longitude_rad;
        return same ? 0.0 : step(a, b).head<2>().norm();
      })) {
    add(findings, "ins-position-held", say::ins_position_held(Duration{all->hold_s}, all->samples, Length{all->jump}));
    return;
  }
  const auto look_at_number = [&](int axis, const Message& name, double InsSample::*angle_rad) {
    if (const auto one = steps([&](std::size_t a, std::size_t b) {
          return geodetic && ins[a].*angle_rad == ins[b].*angle_rad ? 0.0 : std::abs(step(a, b)[axis]);
        });
        one && !one->rounded)
      add(findings, "ins-position-held",
          say::ins_number_held(name, Duration{one->hold_s}, one->samples, Length{one->jump}));
  };
  look_at_number(1, geodetic ? say::check_latitude() : Message::verbatim("y"), &InsSample::latitude_rad);
  look_at_number(0, geodetic ? say::check_longitude() : Message::verbatim("x"), &InsSample::longitude_rad);
}

void look_for_held_parts(const CheckedSession& checked, std::vector<Finding>& findings, const Progress&) {
  look_at_attitude(checked, findings);
  look_at_position(checked, findings);
}

}  // namespace

DataCheck held_part_check() {
  return {.kinds = {{"ins-attitude-held", say::ins_attitude_held_meaning, say::ins_attitude_held_remedy},
                    {"ins-position-held", say::ins_position_held_meaning, say::ins_position_held_remedy}},
          .look = look_for_held_parts};
}

}  // namespace remount
