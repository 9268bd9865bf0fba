#include "model/pipeline/offset_search.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "model/pipeline/position_lag.h"
#include "model/pipeline/solve_stage.h"

namespace remount::pipeline {

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

bool clock_differs(const calibration::CalibrationResult& result) { return any_stands_out(result, kLeastOffset_s); }

bool clock_is_determined(const calibration::CalibrationResult& result) {
  constexpr double kWell_s = 5e-4;
  if (!calibration::is_usable(result) && result.status != calibration::Status::OutOfRange) return false;
  for (std::size_t s = 0; s < result.session_time_offset_s.size(); ++s)
    if (session_sigma_s(result, s) < kWell_s) return true;
  return false;
}

namespace {

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

}  // namespace

bool is_moved(const DriveMotion& motion) { return clock_is_moved(motion) || has_lag(motion); }

void set_ins_motion(const std::vector<calibration::JointNode>& nodes, std::vector<motion::Pair>& pairs) {
  for (motion::Pair& pair : pairs)
    pair.ins_b_from_ins_a = nodes[pair.keyframe_b].local_from_ins.inverse() * nodes[pair.keyframe_a].local_from_ins;
}

void keep_lags(const calibration::CalibrationResult& found, calibration::CalibrationResult& result) {
  result.session_position_lag_s = found.session_position_lag_s;
  result.session_position_lag_sigma_s = found.session_position_lag_sigma_s;
}

namespace {

constexpr double kSettled_s = 5e-4;

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
  const double least_s = use == calibration::ClockOffsetUse::No ? kHarmlessOffset_s : kLeastOffset_s;
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

/// What was applied is the offset; what is left is noise of the estimate.
void state_offsets(const DriveMotion& motion, bool applied, calibration::CalibrationResult& result) {
  result.session_time_offset_s.clear();
  for (motion::SessionIndex s; s < motion.session_count(); ++s)
    result.session_time_offset_s.push_back(motion.offset_s(s));
  std::vector<double> sigmas_s;
  for (motion::SessionIndex s; s < motion.session_count(); ++s) sigmas_s.push_back(session_sigma_s(result, s));
  result.time_offset = calibration::mean_time_offset(result.session_time_offset_s, sigmas_s);
  result.time_offset.applied = applied;
}

void adopt(Solved&& solved, DriveMotion& motion, PipelineOutput& output, calibration::PairwiseDetails& details) {
  motion = std::move(solved.motion);
  output.pairs = std::move(solved.pairs);
  details = std::move(solved.details);
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

/// X with the offsets of the clocks and the lags of positions that stand out taken out, or with what they may do to it
/// in its sigmas. Clocks count only where the times of the scans are told; lags of positions always.
class OffsetSearch {
 public:
  OffsetSearch(const PipelineInput& input, DriveMotion& motion, PipelineOutput& output,
               calibration::PairwiseDetails& details, const Progress& progress)
      : input_(input),
        use_(input.settings.solve.apply_time_offset),
        told_(output.clock_told),
        moved_(is_moved(motion)),
        motion_(motion),
        output_(output),
        details_(details),
        progress_(progress) {}

  calibration::CalibrationResult solve() {
    Solved found = solve_as_given();
    if (needs_no_search(found)) return take(std::move(found));
    Solved before = found;
    const bool settled = solve_without_offset(input_, output_, found, progress_);
    // What did not converge beside lags says nothing of them: their errors are those of the solution before.
    if (!tells_lags(found)) keep_lags(before.result, found.result);
    if (is_to_apply(found, settled)) return apply(std::move(found));
    if (was_chance(found, settled)) return take(std::move(found));
    if (knows_clock_all_the_same(before, found)) return take(std::move(before));
    return solve_with_bias(found, std::move(before));
  }

 private:
  Solved solve_as_given() {
    output_.clock_bias.reset();
    output_.clock_is_unknown = told_ && use_ != calibration::ClockOffsetUse::No;
    Solved found{motion_, output_.pairs, {}, {}};
    found.result =
        calibration::solve_pairwise(solver_input(input_, motion_, output_), found.pairs, found.details, progress_);
    return found;
  }

  /// Nothing stands out. A clock that the drive does not show would leave X as open as itself: `found` is then solved
  /// without it.
  bool needs_no_search(Solved& found) {
    if (moved_ || differs(found.result)) return false;
    if (use_ == calibration::ClockOffsetUse::No || !told_) return true;
    if (use_ == calibration::ClockOffsetUse::Yes) return false;
    if (clock_is_determined(found.result)) return true;
    output_.clock_is_unknown = false;
    found.pairs = output_.pairs;
    solve_at_present_offsets(input_, output_, found, progress_);
    return !differs(found.result);
  }

  bool differs(const calibration::CalibrationResult& result) const {
    const bool clocks =
        use_ == calibration::ClockOffsetUse::No ? any_stands_out(result, kHarmlessOffset_s) : clock_differs(result);
    return (told_ && clocks) || calibration::position_lag_differs(result);
  }

  static bool was_found(const Solved& found) {
    return (calibration::is_usable(found.result) || found.result.status == calibration::Status::OutOfRange) &&
           is_moved(found.motion);
  }

  bool is_to_apply(const Solved& found, bool settled) const {
    return use_ == calibration::ClockOffsetUse::Yes ||
           (use_ == calibration::ClockOffsetUse::Auto && settled && was_found(found));
  }

  /// What stood out and is gone when it is looked for again changes nothing of what is known of the clocks.
  bool was_chance(const Solved& found, bool settled) const {
    return use_ == calibration::ClockOffsetUse::Auto && settled && !is_moved(found.motion) && !differs(found.result) &&
           clock_is_determined(found.result);
  }

  /// A lag alone stood out, and was not found: the clocks are unknowns of the solution before as they were.
  bool knows_clock_all_the_same(const Solved& before, const Solved& found) const {
    return use_ == calibration::ClockOffsetUse::Auto && !moved_ && !was_found(found) && output_.clock_is_unknown &&
           !clock_differs(before.result) && clock_is_determined(before.result);
  }

  calibration::CalibrationResult apply(Solved&& found) {
    if (told_ && (use_ == calibration::ClockOffsetUse::Yes || clock_is_moved(found.motion)))
      state_offsets(found.motion, true, found.result);
    state_position_lags(found.motion, true, found.result);
    return take(std::move(found));
  }

  calibration::CalibrationResult solve_with_bias(const Solved& found, Solved&& unmoved) {
    output_.clock_is_unknown = false;
    if (moved_ || use_ == calibration::ClockOffsetUse::Auto) {
      unmoved.motion = DriveMotion(input_.sessions, output_.session_swept);
      solve_at_present_offsets(input_, output_, unmoved, progress_);
    }
    // An attempt that left nothing usable still tells how far X may be off.
    if (is_moved(found.motion) && found.details.joint.ins_from_lidar.matrix().allFinite())
      state_bias(input_, found, unmoved, output_, progress_);
    return take(std::move(unmoved));
  }

  calibration::CalibrationResult take(Solved&& solved) {
    calibration::CalibrationResult result = solved.result;
    adopt(std::move(solved), motion_, output_, details_);
    return result;
  }

  const PipelineInput& input_;
  const calibration::ClockOffsetUse use_;
  const bool told_, moved_;
  DriveMotion& motion_;
  PipelineOutput& output_;
  calibration::PairwiseDetails& details_;
  const Progress& progress_;
};

}  // namespace

calibration::CalibrationResult solve_with_offsets(const PipelineInput& input, DriveMotion& motion,
                                                  PipelineOutput& output, calibration::PairwiseDetails& details,
                                                  const Progress& progress) {
  return OffsetSearch(input, motion, output, details, progress).solve();
}

}  // namespace remount::pipeline
