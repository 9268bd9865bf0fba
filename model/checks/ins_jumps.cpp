// Positions that no vehicle can have reached: jumps of the INS.
#include <cmath>

#include "algorithms/core/median.h"
#include "model/checks/builtin.h"
#include "model/checks/check_text.h"
#include "model/session_report.h"

namespace remount {
namespace {

constexpr double kFastestVehicle_mps = 100.0;
constexpr double kWindow_s = 0.3;       ///< over which the speed before and after is taken
constexpr double kLongestStep_s = 0.5;  ///< longer ones are gaps
constexpr double kLeastJump_m = 0.3;
constexpr double kTimesUsual = 10.0;

struct Jumps {
  std::size_t count = 0;
  double largest_m = 0.0;
  std::int64_t largest_ns = 0;
};

/// How far each step is from what the speeds before and after it make of it; NaN where they are not known.
std::vector<double> surprises(const MetricPoses& poses) {
  const auto position = [&](std::size_t i) { return Eigen::Vector3d(poses[i].pose.translation()); };
  const auto time_s = [&](std::size_t from, std::size_t to) {
    return seconds_between(poses[from].stamp_ns, poses[to].stamp_ns);
  };
  std::vector<double> surprise(poses.size(), std::nan(""));
  std::size_t before = 0, after = 0;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    while (before + 1 < i && time_s(before + 1, i - 1) >= kWindow_s) ++before;
    while (after + 1 < poses.size() && (after < i || time_s(i, after) < kWindow_s)) ++after;
    const double step_s = time_s(i - 1, i), before_s = time_s(before, i - 1), after_s = time_s(i, after);
    const bool known = step_s > 0.0 && step_s < kLongestStep_s && before_s >= 0.5 * kWindow_s &&
                       after_s >= 0.5 * kWindow_s && before_s < 2.0 * kWindow_s && after_s < 2.0 * kWindow_s;
    if (!known) continue;
    const Eigen::Vector3d speed_before = (position(i - 1) - position(before)) / before_s;
    const Eigen::Vector3d speed_after = (position(after) - position(i)) / after_s;
    surprise[i] = (position(i) - position(i - 1) - 0.5 * step_s * (speed_before + speed_after)).norm();
  }
  return surprise;
}

Jumps jumps_of(const MetricPoses& poses) {
  const std::vector<double> surprise = surprises(poses);
  std::vector<double> known;
  known.reserve(surprise.size());
  for (const double value : surprise)
    if (std::isfinite(value)) known.push_back(value);
  Jumps jumps;
  if (known.empty()) return jumps;
  const double limit_m = std::max(kLeastJump_m, kTimesUsual * median_of(std::move(known)));
  std::int64_t last_ns = 0;
  for (std::size_t i = 0; i < surprise.size(); ++i) {
    if (!(surprise[i] > limit_m)) continue;
    // The speeds beside a jump are wrong as well, there and back again within a window is one.
    if (jumps.count == 0 || seconds_between(last_ns, poses[i].stamp_ns) > kWindow_s) ++jumps.count;
    last_ns = poses[i].stamp_ns;
    if (surprise[i] > jumps.largest_m) jumps.largest_m = surprise[i], jumps.largest_ns = poses[i].stamp_ns;
  }
  return jumps;
}

/// Between poses 0.2 s apart: noise of the single sample must not pass for motion.
double fastest_mps(const MetricPoses& poses) {
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

void look(const CheckedSession& checked, std::vector<Finding>& findings, const Progress&) {
  const Jumps jumps = jumps_of(checked.poses);
  if (jumps.count > 0) {
    const std::string when = utc_text(jumps.largest_ns);
    findings.push_back({Severity::Warning, "ins-jump", "INS",
                        jumps.count == 1
                            ? check_text("The position jumps once, by %.2f m at %s.", jumps.largest_m, when.c_str())
                            : check_text("The position jumps %zu times, the farthest by %.2f m at %s.", jumps.count,
                                         jumps.largest_m, when.c_str())});
    return;
  }
  const double fastest = fastest_mps(checked.poses);
  if (fastest > kFastestVehicle_mps)
    findings.push_back(
        {Severity::Warning, "ins-jump", "INS",
         check_text("The INS moves at up to %.0f m/s: its position jumps, or its stamps are wrong.", fastest)});
}

}  // namespace

DataCheck ins_jump_check() {
  return {
      .kinds =
          {{"ins-jump", "A pair across a jump tells of a motion that never was; it is rejected where that shows.",
            "See whether RTK was lost there or the filter was reset; reject the pairs across it, or use a log that was "
            "processed afterwards (PPK)."}},
      .look = look};
}

}  // namespace remount
