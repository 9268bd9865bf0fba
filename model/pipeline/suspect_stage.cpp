#include "model/pipeline/suspect_stage.h"

#include <algorithm>
#include <cmath>

#include "algorithms/calibration/observability.h"
#include "algorithms/core/median.h"
#include "algorithms/core/stamps.h"
#include "algorithms/motion/clock_alignment.h"
#include "messages/pipeline.h"
#include "model/conventions/attitude_check.h"
#include "model/conventions/attitude_columns.h"
#include "model/conventions/clock_hint.h"
#include "model/drive/session_frames.h"
#include "model/results/result_file.h"

namespace remount::pipeline {
namespace {

constexpr const char* kFarClock = "clock-far";
constexpr double kFar_s = 0.2;  ///< the solution estimates what is less

/// An offset that was applied and is another than the one that was found bridges nothing.
bool is_bridged(const calibration::CalibrationResult& result, double farthest_clock_s) {
  constexpr double kSame_s = 0.15;
  const std::vector<double>& applied_s = result.session_time_offset_s;
  return calibration::is_usable(result) && result.time_offset.applied &&
         std::any_of(applied_s.begin(), applied_s.end(), [&](double offset_s) {
           return std::abs(offset_s) > std::max(kFar_s, farthest_clock_s - kSame_s);
         });
}

/// Between UTC, GPS time and TAI.
constexpr double kTimeScales_s[] = {17.0, 18.0, 19.0, 37.0};

/// Misfit of how far the LiDAR turned between the scans of registered pairs to how far the INS did `offset_s` later,
/// over that at their own stamps, in the median; nothing where too few pairs tell, for the INS must have turned by
/// another angle then: of a straight, or an even bend, the ratio would be one of noise.
std::optional<double> misfit_ratio(const DriveMotion& motion, const PipelineOutput& output,
                                   motion::SessionIndex session, double offset_s) {
  constexpr std::size_t kFewest = 8;
  constexpr double kTold_rad = 0.01;
  // What is asked for counts from the stamps as they were logged.
  const std::int64_t applied_ns = std::llround(1e9 * motion.offset_s(session));
  std::vector<double> now_rad, then_rad;
  for (const motion::Pair& pair : output.pairs) {
    const motion::Keyframe& a = output.keyframes[pair.keyframe_a];
    const motion::Keyframe& b = output.keyframes[pair.keyframe_b];
    if (a.session != session || !pair.registration.attempted || !motion::unusable_reason(pair).empty()) continue;
    const double turned_rad = so3_log(pair.lidar_b_from_lidar_a.linear()).norm();
    const auto ins_turned_rad = [&](std::int64_t shift_ns) -> std::optional<double> {
      const auto at_a = motion.local_from_ins(session, a.stamp_ns + shift_ns);
      const auto at_b = motion.local_from_ins(session, b.stamp_ns + shift_ns);
      if (!at_a || !at_b) return std::nullopt;
      return rotation_angle_between_rad(*at_a, *at_b);
    };
    const auto now = ins_turned_rad(-applied_ns), then = ins_turned_rad(std::llround(1e9 * offset_s) - applied_ns);
    if (!now || !then || std::abs(*now - *then) < kTold_rad) continue;
    now_rad.push_back(std::abs(turned_rad - *now));
    then_rad.push_back(std::abs(turned_rad - *then));
  }
  if (now_rad.size() < kFewest) return std::nullopt;
  return median_of(std::move(then_rad)) / std::max(1e-9, median_of(std::move(now_rad)));
}

constexpr double kClearlyBetter = 0.5;  ///< ratio of misfits

/// Of the differences between time scales that are as large as that between the beginnings of scans and INS, the one
/// under which the turns fit best; nothing where none fits clearly better than none at all.
std::optional<double> offset_of_time_scales(const DriveMotion& motion, const PipelineOutput& output,
                                            motion::SessionIndex session) {
  constexpr double kTogether_s = 2.0;  ///< recorders begin within
  const std::vector<std::int64_t> scans_ns = motion.lidar_stamps_ns(session);
  const std::vector<motion::StampedPose>& ins = motion.track(session).samples();
  if (scans_ns.empty() || ins.empty()) return std::nullopt;
  const double begins_s = seconds(ins.front().stamp_ns - scans_ns.front());
  std::optional<double> best_s;
  double least = kClearlyBetter;
  for (const double size_s : kTimeScales_s) {
    const double offset_s = std::copysign(size_s, begins_s);
    if (std::abs(offset_s - begins_s) > kTogether_s) continue;
    const double ratio = misfit_ratio(motion, output, session, offset_s).value_or(1.0);
    if (ratio < least) best_s = offset_s;
    least = std::min(least, ratio);
  }
  return best_s;
}

/// What is said, and leap seconds where they explain the offset.
Message with_leap_seconds(const Message& said, double offset_s) {
  return Message::sequence({said, conventions::leap_second_hint(offset_s, 0.5)});
}

}  // namespace

std::optional<FarClock> find_far_clock(const DriveMotion& motion, motion::SessionIndex session,
                                       const std::vector<motion::StampedPose>& first_from_lidar) {
  constexpr double kTooFar_s = 0.3;  ///< pairs are proposed, and objects looked for, in the wrong places then
  constexpr double kNear_s = 3.0;
  constexpr double kAlike = 0.8;  ///< correlation of the rates
  const std::string& name = motion.session(session).name;
  // A road that winds evenly looks the same some way on: what is near is taken where it fits hardly worse.
  motion::ClockAlignmentOptions within;
  within.max_offset_s = kNear_s;
  const std::vector<motion::StampedPose>& ins = motion.track(session).samples();
  const motion::ClockAlignment near = motion::align_clocks(ins, first_from_lidar, within),
                               any = motion::align_clocks(ins, first_from_lidar);
  const bool near_will_do = near.found && 1.0 - near.correlation < 3.0 * (1.0 - any.correlation) + 0.02;
  const motion::ClockAlignment& clock = near_will_do ? near : any;
  if (near_will_do && std::abs(near.offset_s) > 0.9 * kNear_s) return {};  // no summit, only the rim
  const double apart_s = std::abs(clock.offset_s);
  if (!clock.found || clock.ambiguous || clock.correlation < kAlike || apart_s < std::max(kFar_s, 5.0 * clock.sigma_s))
    return {};
  // Scans that are bent by their motion are of no one instant: to a part of their sweep it is not known better.
  const auto turn = clock.offset_s > 0.0 ? say::pipeline_scans_turn_later : say::pipeline_scans_turn_earlier;
  return FarClock{session,
                  clock.offset_s,
                  {apart_s < kTooFar_s ? drive::Severity::Warning : drive::Severity::Problem, kFarClock, name,
                   with_leap_seconds(turn(Duration{apart_s}, clock.correlation), clock.offset_s)}};
}

void report_far_clocks(const DriveMotion& motion, const std::vector<FarClock>& found, PipelineOutput& output) {
  const auto take = [&output](double offset_s, drive::Finding finding) {
    output.findings.push_back(std::move(finding));
    output.farthest_clock_s = std::max(output.farthest_clock_s, std::abs(offset_s));
  };
  for (const FarClock& far : found)
    if (misfit_ratio(motion, output, far.session, far.offset_s).value_or(0.0) < 1.0 / kClearlyBetter)
      take(far.offset_s, far.finding);
  for (motion::SessionIndex s; s < motion.session_count(); ++s) {
    const std::string& name = motion.session(s).name;
    const auto named = [&](const char* code) {
      return std::any_of(output.findings.begin(), output.findings.end(),
                         [&](const drive::Finding& finding) { return finding.code == code && finding.where == name; });
    };
    if (!named("clock-leap-seconds") || named(kFarClock)) continue;
    const std::optional<double> offset_s = offset_of_time_scales(motion, output, s);
    if (!offset_s) continue;
    const auto turned = *offset_s > 0.0 ? say::pipeline_pairs_turn_later : say::pipeline_pairs_turn_earlier;
    take(*offset_s, {drive::Severity::Problem, kFarClock, name,
                     with_leap_seconds(turned(Duration{std::abs(*offset_s)}), *offset_s)});
  }
}

void blame_recording(const std::vector<drive::Finding>& findings, calibration::CalibrationResult& result,
                     double farthest_clock_s) {
  bool named = false, too_far = false;
  for (const drive::Finding& finding : findings) {
    if (finding.code != kFarClock) continue;
    named = true;
    too_far = too_far || finding.severity == drive::Severity::Problem;
  }
  if (named && result.status != calibration::Status::Cancelled) {
    if (!calibration::is_usable(result) || (too_far && !is_bridged(result, farthest_clock_s))) {
      result.conclude(calibration::Status::Inconsistent, say::pipeline_compared_other_instant());
      calibration::claim_nothing(say::pipeline_clocks_apart(), result);
      result.advice.clear();
    }
    result.advice.insert(result.advice.begin(), say::pipeline_bring_clocks_together());
  }
  conventions::blame_attitude(findings, result);
  const bool of_antenna = std::any_of(findings.begin(), findings.end(),
                                      [](const drive::Finding& finding) { return finding.code == "antenna-position"; });
  if (of_antenna && calibration::is_usable(result)) result.advice.push_back(say::pipeline_of_antenna());
}

void report_columns(const DriveMotion& motion, PipelineOutput& output) {
  for (motion::SessionIndex s; s < motion.session_count(); ++s) {
    const drive::Session& session = motion.session(s);
    if (session.ins.empty()) continue;
    const bool known = std::any_of(output.findings.begin(), output.findings.end(), [&](const drive::Finding& finding) {
      return finding.where == session.name &&
             (finding.code.starts_with("attitude-") || finding.code == "position-columns");
    });
    if (known) continue;
    const Eigen::Matrix3d ins_from_level = drive::forward_left_up_from(session.ins_axes).linear().transpose();
    std::vector<conventions::SharedTurn> turns;
    for (const motion::Pair& pair : output.pairs) {
      const motion::Keyframe& a = output.keyframes[pair.keyframe_a];
      const motion::Keyframe& b = output.keyframes[pair.keyframe_b];
      if (a.session != s || !pair.registration.attempted || !motion::unusable_reason(pair).empty()) continue;
      const auto at_a = motion.local_from_ins(s, a.stamp_ns), at_b = motion.local_from_ins(s, b.stamp_ns);
      if (at_a && at_b)
        turns.push_back(
            {at_a->linear() * ins_from_level, at_b->linear() * ins_from_level, pair.lidar_b_from_lidar_a.linear()});
    }
    if (std::optional<drive::Finding> finding = conventions::attitude_column_finding(turns, session.name))
      output.findings.push_back(std::move(*finding));
  }
}

}  // namespace remount::pipeline
