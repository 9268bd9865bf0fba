#include "model/pipeline/solve_stage.h"

#include <algorithm>
#include <cmath>

#include "algorithms/calibration/observability.h"
#include "messages/pipeline.h"
#include "model/pipeline/position_lag.h"
#include "model/results/result_file.h"

namespace remount::pipeline {

namespace {

constexpr double kSettled_s = 5e-4;
constexpr double kLeast_s = 0.002;  ///< smaller offsets are not worth a word: as an unknown they do no harm
constexpr double kHarmless_s = 1e-4;

/// 1-sigma of a session's offset; of results that do not say, as if all sessions were alike.
double session_sigma_s(const calibration::CalibrationResult& result, std::size_t session) {
  if (session < result.session_time_offset_sigma_s.size()) return result.session_time_offset_sigma_s[session];
  return result.time_offset.sigma_s * std::sqrt(static_cast<double>(result.session_time_offset_s.size()));
}

bool any_stands_out(const calibration::CalibrationResult& result, double least_s) {
  if (calibration::stands_out(result.time_offset.offset_s, result.time_offset.sigma_s, least_s)) return true;
  // Those of several sessions may cancel in the mean.
  for (std::size_t s = 0; s < result.session_time_offset_s.size(); ++s)
    if (calibration::stands_out(result.session_time_offset_s[s], session_sigma_s(result, s), least_s)) return true;
  return false;
}

bool clock_is_moved(const DriveMotion& motion) {
  for (motion::SessionIndex s; s < motion.session_count(); ++s)
    if (motion.offset_s(s) != 0.0) return true;
  return false;
}

bool has_lag(const DriveMotion& motion) {
  for (motion::SessionIndex s; s < motion.session_count(); ++s)
    if (motion.position_lag_s(s) != 0.0) return true;
  return false;
}

bool is_moved(const DriveMotion& motion) { return clock_is_moved(motion) || has_lag(motion); }

void set_ins_motion(const std::vector<calibration::JointNode>& nodes, std::vector<motion::Pair>& pairs) {
  for (motion::Pair& pair : pairs)
    pair.ins_b_from_ins_a = nodes[pair.keyframe_b].local_from_ins.inverse() * nodes[pair.keyframe_a].local_from_ins;
}

/// A solution, and what it is a solution of.
struct Solved {
  DriveMotion motion;
  std::vector<motion::Pair> pairs;
  calibration::PairwiseDetails details;
  calibration::CalibrationResult result;
};

void solve_at_present_offsets(const PipelineInput& input, PipelineOutput& output, Solved& solved,
                              const Progress& progress) {
  const calibration::PairwiseInput solver = solver_input(input, solved.motion, output);
  set_ins_motion(solver.nodes, solved.pairs);
  solved.result = calibration::solve_pairwise(solver, solved.pairs, solved.details, progress);
}

/// Whether what was taken out is still found, by half at least: it stays out then, though its sigma is another one once
/// it is an unknown. Near the limit each solution would take back what the one before did, for ever.
bool stays_out(double whole_s, double taken_out_s) { return taken_out_s != 0.0 && whole_s / taken_out_s >= 0.5; }

/// The offset of a session in all, and whether it is one that X is to be solved with.
struct WholeOffset {
  double offset_s = 0.0;
  bool counts = false;
};

WholeOffset whole_offset(const Solved& solved, motion::SessionIndex session, calibration::ClockOffsetUse use) {
  const double whole_s = solved.motion.offset_s(session) + solved.result.session_time_offset_s[session];
  // What X is not to be solved with biases it also where it is small.
  const double least_s = use == calibration::ClockOffsetUse::No ? kHarmless_s : kLeast_s;
  return {whole_s, use == calibration::ClockOffsetUse::Yes || stays_out(whole_s, solved.motion.offset_s(session)) ||
                       calibration::stands_out(whole_s, session_sigma_s(solved.result, session), least_s)};
}

/// Whether lags were found at all: a solution beside them need not converge.
bool tells_lags(const Solved& solved) {
  const std::size_t count = solved.motion.session_count();
  return solved.result.session_position_lag_s.size() == count &&
         solved.result.session_position_lag_sigma_s.size() == count;
}

/// Likewise of the lag of its positions.
double whole_lag_s(const Solved& solved, motion::SessionIndex session) {
  if (!tells_lags(solved)) return 0.0;
  const double whole_s = solved.motion.position_lag_s(session) + solved.result.session_position_lag_s[session];
  const double sigma_s = solved.result.session_position_lag_sigma_s[session];
  const bool counts = stays_out(whole_s, solved.motion.position_lag_s(session)) ||
                      calibration::position_lag_stands_out(whole_s, sigma_s);
  return counts ? whole_s : 0.0;
}

/// Moves the INS poses by the estimated clock offset, and their positions by their lag, and solves again until no
/// offset is left: a single estimate falls short, for what the offset distorts also passes for noise. Sessions whose
/// offset does not count stay, or go back. False where the offset does not settle.
bool solve_without_offset(const PipelineInput& input, PipelineOutput& output, Solved& solved,
                          const Progress& progress) {
  constexpr int kMostRounds = 6;
  const calibration::ClockOffsetUse use = input.settings.solve.apply_time_offset;
  for (int round = 0; round < kMostRounds && !progress.cancelled(); ++round) {
    if (solved.result.session_time_offset_s.size() != input.sessions.size()) return false;
    if (has_lag(solved.motion) && !tells_lags(solved)) return false;
    double largest_s = 0.0;
    for (motion::SessionIndex s; s < solved.motion.session_count(); ++s) {
      const WholeOffset whole = whole_offset(solved, s, use);
      const double to_s = whole.counts && output.clock_told ? whole.offset_s : 0.0;
      const double lag_s = whole_lag_s(solved, s);
      largest_s = std::max(
          {largest_s, std::abs(to_s - solved.motion.offset_s(s)), std::abs(lag_s - solved.motion.position_lag_s(s))});
      solved.motion.set_offset_s(s, to_s);
      solved.motion.set_position_lag_s(s, lag_s);
    }
    solve_at_present_offsets(input, output, solved, progress);
    if (largest_s < kSettled_s) return !has_lag(solved.motion) || tells_lags(solved);
  }
  return false;
}

/// What was applied is the offset; what is left is noise of the estimate. That of all is the mean of the sessions, each
/// alike, and so is its sigma.
void state_offsets(const DriveMotion& motion, bool applied, calibration::CalibrationResult& result) {
  const auto count = static_cast<double>(motion.session_count());
  double mean_s = 0.0, variance_s2 = 0.0;
  result.session_time_offset_s.assign(motion.session_count(), 0.0);
  for (motion::SessionIndex s; s < motion.session_count(); ++s) {
    const double sigma_s = session_sigma_s(result, s) / count;
    result.session_time_offset_s[s] = motion.offset_s(s);
    mean_s += motion.offset_s(s) / count;
    variance_s2 += sigma_s * sigma_s;
  }
  result.time_offset = {mean_s, std::sqrt(variance_s2), applied, false};
}

void adopt(Solved&& solved, DriveMotion& motion, PipelineOutput& output, calibration::PairwiseDetails& details) {
  motion = std::move(solved.motion);
  output.pairs = std::move(solved.pairs);
  details = std::move(solved.details);
}

void keep_lags(const calibration::CalibrationResult& found, calibration::CalibrationResult& result) {
  result.session_position_lag_s = found.session_position_lag_s;
  result.session_position_lag_sigma_s = found.session_position_lag_sigma_s;
}

/// The offset was found and stays in X: how far it moves X joins the sigmas.
void state_bias(const PipelineInput& input, const Solved& shifted, Solved& unmoved, PipelineOutput& output,
                const Progress& progress) {
  if (calibration::is_usable(unmoved.result)) {
    output.clock_bias = difference(unmoved.details.joint.ins_from_lidar, shifted.details.joint.ins_from_lidar);
    solve_at_present_offsets(input, output, unmoved, progress);
  }
  unmoved.result.time_offset = shifted.result.time_offset;
  unmoved.result.session_time_offset_sigma_s = shifted.result.session_time_offset_sigma_s;
  keep_lags(shifted.result, unmoved.result);
  state_offsets(shifted.motion, false, unmoved.result);
  state_position_lags(shifted.motion, false, unmoved.result);
}

}  // namespace

void drop_offsets(calibration::CalibrationResult& result) {
  result.time_offset = {};
  result.session_time_offset_s.clear();
  result.session_time_offset_sigma_s.clear();
}

void drop_clock(calibration::CalibrationResult& result) {
  drop_offsets(result);
  result.session_position_lag_s.clear();
  result.session_position_lag_sigma_s.clear();
  result.position_lag_applied = false;
}

void keep_clock(const calibration::CalibrationResult& found, calibration::CalibrationResult& result) {
  result.time_offset = found.time_offset;
  result.session_time_offset_s = found.session_time_offset_s;
  result.session_time_offset_sigma_s = found.session_time_offset_sigma_s;
  keep_lags(found, result);
  result.position_lag_applied = found.position_lag_applied;
}

void doubt_sweeps(const std::vector<Vector6d>& doubts, const calibration::SolveOptions& options,
                  calibration::CalibrationResult& result) {
  if (doubts.empty() || !calibration::is_usable(result)) return;
  for (const Vector6d& doubt : doubts) calibration::add_doubt(doubt, say::pipeline_sweeps_not_known(), options, result);
  result.advice.push_back(say::pipeline_sweeps_bias_x());
  judge_again(say::pipeline_nothing_known_sweeps(), result);
}

void judge_again(const Message& nothing_known, calibration::CalibrationResult& result) {
  const calibration::Status status = result.observed().is_all() ? result.status : calibration::Status::Degenerate;
  const bool usable = calibration::is_solved(status) && !result.observed().empty();
  result.conclude(status, usable ? calibration::solved_message(result) : nothing_known);
}

bool clock_differs(const calibration::CalibrationResult& result) { return any_stands_out(result, kLeast_s); }

bool clock_is_determined(const calibration::CalibrationResult& result) {
  constexpr double kWell_s = 5e-4;
  if (!calibration::is_usable(result) && result.status != calibration::Status::OutOfRange) return false;
  for (std::size_t s = 0; s < result.session_time_offset_s.size(); ++s)
    if (session_sigma_s(result, s) < kWell_s) return true;
  return false;
}

DriveMotion motion_as_solved(const PipelineInput& input, const PipelineOutput& output) {
  DriveMotion motion(input.sessions);
  const bool known = output.result.session_time_offset_s.size() == input.sessions.size();
  for (motion::SessionIndex s; output.result.time_offset.applied && known && s < motion.session_count(); ++s)
    motion.set_offset_s(s, output.result.session_time_offset_s[s]);
  const std::vector<double>& lags_s = output.result.session_position_lag_s;
  const bool lags_known = output.result.position_lag_applied && lags_s.size() == input.sessions.size();
  for (motion::SessionIndex s; lags_known && s < motion.session_count(); ++s) motion.set_position_lag_s(s, lags_s[s]);
  return motion;
}

calibration::PairwiseInput solver_input(const PipelineInput& input, const DriveMotion& motion,
                                        const PipelineOutput& output) {
  const std::vector<motion::Keyframe>& keyframes = output.keyframes;
  calibration::PairwiseInput out;
  out.nodes = motion.nodes(keyframes);
  out.sessions = motion.noise();
  for (const auto& session : input.sessions) out.session_names.push_back(session->name);
  out.nominal_ins_from_lidar = input.nominal_ins_from_lidar;
  if (output.initial_known) out.initial_ins_from_lidar = output.initial_ins_from_lidar;
  out.up_in_lidar = output.up_in_lidar;
  out.range = input.settings.range;
  out.options = input.settings.solve;
  out.measured = calibration::Measured(input.settings.measured, output.ground);
  out.clock_bias = output.clock_bias;
  out.clock_is_unknown = is_moved(motion) || output.clock_is_unknown;
  return out;
}

namespace {

// Offsets of the clocks count only where the times of the scans are told; lags of positions always.
calibration::CalibrationResult solve_with_offsets(const PipelineInput& input, DriveMotion& motion,
                                                  PipelineOutput& output, calibration::PairwiseDetails& details,
                                                  const Progress& progress) {
  const calibration::ClockOffsetUse use = input.settings.solve.apply_time_offset;
  output.clock_bias.reset();
  const bool told = output.clock_told;
  output.clock_is_unknown = told && use != calibration::ClockOffsetUse::No;
  Solved shifted{motion, output.pairs, {}, {}};
  shifted.result =
      calibration::solve_pairwise(solver_input(input, motion, output), shifted.pairs, shifted.details, progress);
  const auto take = [&](Solved&& solved) {
    calibration::CalibrationResult result = solved.result;
    adopt(std::move(solved), motion, output, details);
    return result;
  };
  const bool moved = is_moved(motion);
  const auto differs = [&](const calibration::CalibrationResult& result) {
    const bool clocks =
        use == calibration::ClockOffsetUse::No ? any_stands_out(result, kHarmless_s) : clock_differs(result);
    return (told && clocks) || calibration::position_lag_differs(result);
  };
  if ((use == calibration::ClockOffsetUse::No || !told) && !moved && !differs(shifted.result))
    return take(std::move(shifted));
  if (use == calibration::ClockOffsetUse::Auto && !moved && !differs(shifted.result)) {
    if (clock_is_determined(shifted.result)) return take(std::move(shifted));
    // A clock that the drive does not show would leave X as open as itself.
    output.clock_is_unknown = false;
    shifted.pairs = output.pairs;
    solve_at_present_offsets(input, output, shifted, progress);
    if (!differs(shifted.result)) return take(std::move(shifted));
  }
  Solved unmoved = shifted;
  const bool settled = solve_without_offset(input, output, shifted, progress);
  // What did not converge beside lags says nothing of them: their errors are those of the solution before.
  if (!tells_lags(shifted)) keep_lags(unmoved.result, shifted.result);
  const bool known =
      (calibration::is_usable(shifted.result) || shifted.result.status == calibration::Status::OutOfRange) &&
      is_moved(shifted.motion);
  if (use == calibration::ClockOffsetUse::Yes || (use == calibration::ClockOffsetUse::Auto && settled && known)) {
    if (told && (use == calibration::ClockOffsetUse::Yes || clock_is_moved(shifted.motion)))
      state_offsets(shifted.motion, true, shifted.result);
    state_position_lags(shifted.motion, true, shifted.result);
    return take(std::move(shifted));
  }
  // What stood out by chance and is gone when it is looked for again changes nothing of what is known of the clocks.
  if (use == calibration::ClockOffsetUse::Auto && settled && !is_moved(shifted.motion) && !differs(shifted.result) &&
      clock_is_determined(shifted.result))
    return take(std::move(shifted));
  if (use == calibration::ClockOffsetUse::Auto && !moved && !known && output.clock_is_unknown &&
      !clock_differs(unmoved.result) && clock_is_determined(unmoved.result))
    return take(std::move(unmoved));
  output.clock_is_unknown = false;
  if (moved || use == calibration::ClockOffsetUse::Auto) {
    unmoved.motion = DriveMotion(input.sessions);
    solve_at_present_offsets(input, output, unmoved, progress);
  }
  // An attempt that left nothing usable still tells how far X may be off.
  if (is_moved(shifted.motion) && shifted.details.joint.ins_from_lidar.matrix().allFinite())
    state_bias(input, shifted, unmoved, output, progress);
  return take(std::move(unmoved));
}

}  // namespace

calibration::CalibrationResult solve_with_clock(const PipelineInput& input, DriveMotion& motion, PipelineOutput& output,
                                                calibration::PairwiseDetails& details, const Progress& progress) {
  calibration::CalibrationResult result = solve_with_offsets(input, motion, output, details, progress);
  if (output.clock_told) return result;
  // Positions and attitudes are of the INS alone, whenever the scans were taken: what is found of those stays.
  drop_offsets(result);
  doubt_sweeps(output.sweep_doubts, input.settings.solve, result);
  return result;
}

calibration::CalibrationResult solve_with_clock_again(const PipelineInput& input, PipelineOutput& output,
                                                      const Progress& progress) {
  const calibration::ClockOffsetUse use = input.settings.solve.apply_time_offset;
  calibration::PairwiseDetails details;
  const bool applied = output.result.time_offset.applied || output.result.position_lag_applied;
  if (!output.clock_told) {
    DriveMotion motion(input.sessions);
    if (applied) set_ins_motion(motion.nodes(output.keyframes), output.pairs);
    return solve_with_clock(input, motion, output, details, progress);
  }
  if (applied && use != calibration::ClockOffsetUse::No) {
    const DriveMotion motion = motion_as_solved(input, output);
    calibration::CalibrationResult result =
        calibration::solve_pairwise(solver_input(input, motion, output), output.pairs, details, progress);
    keep_clock(output.result, result);
    return result;
  }
  DriveMotion motion(input.sessions);
  if (applied) {
    set_ins_motion(motion.nodes(output.keyframes), output.pairs);
    return solve_with_clock(input, motion, output, details, progress);
  }
  // How far the clock biases X hardly depends on a decision about pairs.
  std::vector<motion::Pair> pairs = output.pairs;
  const calibration::CalibrationResult result =
      calibration::solve_pairwise(solver_input(input, motion, output), pairs, details, progress);
  const double least_s = use == calibration::ClockOffsetUse::No ? kHarmless_s : kLeast_s;
  const bool lags = calibration::position_lag_differs(result);
  const bool as_before = (any_stands_out(result, least_s) || lags) == output.clock_bias.has_value();
  const bool may_apply = use == calibration::ClockOffsetUse::Yes ||
                         (use == calibration::ClockOffsetUse::Auto && (clock_differs(result) || lags));
  const bool other_unknowns = use == calibration::ClockOffsetUse::No
                                  ? output.clock_is_unknown
                                  : !output.clock_is_unknown && clock_is_determined(result);
  if (!as_before || may_apply || other_unknowns) return solve_with_clock(input, motion, output, details, progress);
  output.pairs = std::move(pairs);
  return result;
}

void report_clock(const PipelineInput& input, const calibration::CalibrationResult& result,
                  std::vector<drive::Finding>& findings) {
  const calibration::TimeOffset& clock = result.time_offset;
  const bool may_apply = input.settings.solve.apply_time_offset != calibration::ClockOffsetUse::No;
  const Message what_of_it = clock.applied ? say::pipeline_offset_applied()
                             : may_apply   ? say::pipeline_offset_does_not_settle()
                                           : say::pipeline_offset_not_applied();
  for (std::size_t s = 0; s < std::min(result.session_time_offset_s.size(), input.sessions.size()); ++s) {
    const double offset_s = result.session_time_offset_s[s], sigma_s = session_sigma_s(result, s);
    if (!calibration::stands_out(offset_s, sigma_s, kLeast_s)) continue;
    const auto stamps = offset_s > 0.0 ? say::pipeline_stamps_early : say::pipeline_stamps_late;
    findings.push_back({clock.applied ? drive::Severity::Note : drive::Severity::Warning, kClockOffset,
                        input.sessions[s]->name,
                        Message::sequence({stamps(Duration{std::abs(offset_s)}, Duration{sigma_s}), what_of_it})});
  }
  report_position_lag(input, result, findings);
}

}  // namespace remount::pipeline
