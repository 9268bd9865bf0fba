// Motions that no vehicle makes: jumps of the INS.
#include <algorithm>
#include <cmath>
#include <string_view>

#include "algorithms/core/median.h"
#include "algorithms/geometry/rotation.h"
#include "messages/checks.h"
#include "messages/places.h"
#include "model/checks/builtin.h"
#include "model/checks/check_times.h"
#include "model/formats/files/time_stamp.h"

namespace remount::checks {
namespace {

constexpr double kFastestVehicle_mps = 100.0;
constexpr double kSpeedWindow_s = 0.3;  ///< over which the speed before and after is taken, at least,
constexpr double kLongestSide_s = 0.6;  ///< and at most
constexpr double kLongestStep_s = 0.5;  ///< longer ones are gaps
constexpr double kLeastJump_m = 0.3;
constexpr double kLeastJump_rad = 5.0 * kPi / 180.0;
constexpr double kTimesUsual = 10.0;
constexpr double kTimesHeld = 3.0;  ///< farther than values that are held jump as a rule

struct Jumps {
  std::size_t count = 0;
  double largest = 0.0;  ///< m or rad
  std::int64_t largest_ns = 0;
};

/// Accelerations of a vehicle, in units of the change per s^2, that are no jump where the speed is known on one side of
/// a step, or on both: none brakes and speeds up within a step of a slow log, but steering goes to and fro.
struct Hardest {
  double beside_one, between_two;
};
constexpr Hardest kHardest_mps2{10.0, 0.0}, kHardest_radps2{2.0, 2.0};

/// How far a step of the INS is from what the speeds before and after it make of it, in units of the change.
struct Surprise {
  double judged = std::nan("");  ///< by both, or by the one that is known, less what the vehicle may have sped up by
  double size = 0.0;             ///< by the speed that it fits better: the other may have a jump within
};

/// Of each step, by `change(a, b)` from one pose to another; the first, and those whose speed is not known, have NaN.
template <class Change>
std::vector<Surprise> surprises_of(const conventions::MetricPoses& poses, const Hardest& hardest, Change&& change) {
  const auto time_s = [&](std::size_t from, std::size_t to) {
    return seconds_between(poses[from].stamp_ns, poses[to].stamp_ns);
  };
  const auto tells = [](double side_s) { return side_s >= 0.5 * kSpeedWindow_s && side_s < kLongestSide_s; };
  const auto gap = [&](std::size_t from) { return time_s(from, from + 1) >= kLongestStep_s; };
  std::vector<Surprise> found(poses.size());
  std::size_t before = 0, after = 0;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const double step_s = time_s(i - 1, i);
    if (step_s >= kLongestStep_s) before = i;  // what lies beyond a gap tells no speed
    if (step_s <= 0.0 || step_s >= kLongestStep_s) continue;
    while (before + 1 < i && time_s(before + 1, i - 1) >= kSpeedWindow_s) ++before;
    if (after < i) after = i;
    while (after + 1 < poses.size() && time_s(i, after) < kSpeedWindow_s && !gap(after)) ++after;
    const double before_s = time_s(before, i - 1), after_s = time_s(i, after);
    const Eigen::Vector3d step = change(i - 1, i);
    const auto off = [&](std::size_t from, std::size_t to, double side_s) -> Eigen::Vector3d {
      return step - step_s / side_s * change(from, to);
    };
    const auto by_one = [&](double size, double side_s) -> Surprise {
      return {std::max(0.0, size - 0.5 * hardest.beside_one * step_s * (step_s + side_s)), size};
    };
    if (tells(before_s) && tells(after_s)) {
      const Eigen::Vector3d off_before = off(before, i - 1, before_s), off_after = off(i, after, after_s);
      const double sped_up = 0.25 * hardest.between_two * step_s * (step_s + std::min(before_s, after_s));
      found[i] = {std::max(0.0, 0.5 * (off_before + off_after).norm() - sped_up),
                  std::min(off_before.norm(), off_after.norm())};
    } else if (tells(before_s)) {
      found[i] = by_one(off(before, i - 1, before_s).norm(), before_s);
    } else if (tells(after_s)) {
      found[i] = by_one(off(i, after, after_s).norm(), after_s);
    }
  }
  return found;
}

/// NaN where no step is judged to be larger than `above`.
double median_above(const std::vector<Surprise>& surprises, double above) {
  std::vector<double> judged;
  judged.reserve(surprises.size());
  for (const Surprise& surprise : surprises)
    if (surprise.judged > above) judged.push_back(surprise.judged);
  return judged.empty() ? std::nan("") : median_of(std::move(judged));
}

/// What is `held` jumps at every new value, which is another fault: only what goes far beyond counts.
Jumps jumps_of(const conventions::MetricPoses& poses, const std::vector<Surprise>& surprises, double least, bool held) {
  const double usual = median_above(surprises, -1.0);
  Jumps jumps;
  if (std::isnan(usual)) return jumps;
  double limit = std::max(least, kTimesUsual * usual);
  if (held) limit = std::fmax(limit, kTimesHeld * median_above(surprises, limit));
  std::int64_t last_ns = 0;
  for (std::size_t i = 0; i < surprises.size(); ++i) {
    if (!(surprises[i].judged > limit)) continue;
    // The speeds beside a jump are wrong as well: there and back again within a window is one.
    if (jumps.count == 0 || seconds_between(last_ns, poses[i].stamp_ns) > kLongestSide_s) ++jumps.count;
    last_ns = poses[i].stamp_ns;
    if (surprises[i].size > jumps.largest) jumps.largest = surprises[i].size, jumps.largest_ns = poses[i].stamp_ns;
  }
  return jumps;
}

Jumps turns_of(const CheckedSession& checked, bool held) {
  // Twice the sine of half the angle, about its axis: cheaper than the angle, and grows with it.
  const auto chord = [&](std::size_t a, std::size_t b) -> Eigen::Vector3d {
    const Eigen::Quaterniond turn = checked.logged_attitude(a).conjugate() * checked.logged_attitude(b);
    return std::copysign(2.0, turn.w()) * turn.vec();
  };
  Jumps turns = jumps_of(checked.poses, surprises_of(checked.poses, kHardest_radps2, chord), kLeastJump_rad, held);
  turns.largest = 2.0 * std::asin(std::min(1.0, 0.5 * turns.largest));
  return turns;
}

Jumps steps_of(const conventions::MetricPoses& poses, bool held) {
  const auto way = [&](std::size_t a, std::size_t b) -> Eigen::Vector3d {
    return poses[b].pose.translation() - poses[a].pose.translation();
  };
  return jumps_of(poses, surprises_of(poses, kHardest_mps2, way), kLeastJump_m, held);
}

/// Between poses 0.2 s apart: noise of the single sample must not pass for motion.
double fastest_mps(const conventions::MetricPoses& poses) {
  double fastest = 0.0;
  for (std::size_t from = 0, i = 1; i < poses.size(); ++i) {
    const double step_s = seconds_between(poses[from].stamp_ns, poses[i].stamp_ns);
    if (step_s < 0.2 && i + 1 < poses.size()) continue;
    if (step_s > 0.0)
      fastest = std::max(fastest, (poses[i].pose.translation() - poses[from].pose.translation()).norm() / step_s);
    from = i;
  }
  return fastest;
}

void look_for_jumps(const CheckedSession& checked, std::vector<drive::Finding>& findings, const Progress&) {
  const auto held = [&](std::string_view code) {
    return std::any_of(findings.begin(), findings.end(), [&](const drive::Finding& one) { return one.code == code; });
  };
  const Jumps turns = turns_of(checked, held("ins-attitude-held"));
  if (turns.count > 0) {
    const std::string when = formats::utc_text(turns.largest_ns);
    findings.push_back({drive::Severity::Warning, "ins-attitude-jump", say::place_ins(),
                        turns.count == 1 ? say::ins_attitude_jump(Angle{turns.largest}, when)
                                         : say::ins_attitude_jumps(turns.count, Angle{turns.largest}, when)});
  }
  const Jumps jumps = steps_of(checked.poses, held("ins-position-held"));
  if (jumps.count > 0) {
    const std::string when = formats::utc_text(jumps.largest_ns);
    findings.push_back({drive::Severity::Warning, "ins-jump", say::place_ins(),
                        jumps.count == 1 ? say::ins_jump(Length{jumps.largest}, when)
                                         : say::ins_jumps(jumps.count, Length{jumps.largest}, when)});
    return;
  }
  const double fastest = fastest_mps(checked.poses);
  if (fastest > kFastestVehicle_mps)
    findings.push_back({drive::Severity::Warning, "ins-jump", say::place_ins(), say::ins_too_fast(Speed{fastest})});
}

}  // namespace

DataCheck ins_jump_check() {
  return {.kinds = {{"ins-jump", say::ins_jump_meaning, say::ins_jump_remedy},
                    {"ins-attitude-jump", say::ins_attitude_jump_meaning, say::ins_attitude_jump_remedy}},
          .look = look_for_jumps};
}

}  // namespace remount::checks
