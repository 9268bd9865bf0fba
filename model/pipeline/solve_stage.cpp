#include "model/pipeline/solve_stage.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "algorithms/calibration/observability.h"
#include "model/result_file.h"

namespace remount {
namespace {

void update_ins_motion(const std::vector<JointNode>& nodes, std::vector<Pair>& pairs) {
  for (Pair& pair : pairs)
    pair.ins_b_from_ins_a = nodes[static_cast<std::size_t>(pair.keyframe_b)].local_from_ins.inverse() *
                            nodes[static_cast<std::size_t>(pair.keyframe_a)].local_from_ins;
}

// Moves the INS poses by the estimated clock offset and solves again until no offset is left. A single estimate falls
// short: what the offset distorts also passes for noise.
CalibrationResult solve_without_offset(const PipelineInput& input, DriveMotion& motion, PipelineOutput& output,
                                       CalibrationResult result, PairwiseDetails& details, const Progress& progress) {
  for (int round = 0; round < 4 && result.session_time_offset_s.size() == input.sessions.size(); ++round) {
    double largest_s = 0.0;
    for (int s = 0; s < motion.session_count(); ++s) {
      const double more_s = result.session_time_offset_s[static_cast<std::size_t>(s)];
      motion.set_offset_s(s, motion.offset_s(s) + more_s);
      largest_s = std::max(largest_s, std::abs(more_s));
    }
    const PairwiseInput solver = solver_input(input, motion, output);
    update_ins_motion(solver.nodes, output.pairs);
    result = solve_pairwise(solver, output.pairs, details, progress);
    if (largest_s < 5e-4) break;
  }
  // What was applied is the offset; what is left is noise of the estimate.
  double mean_s = 0.0;
  for (int s = 0; s < motion.session_count(); ++s) mean_s += motion.offset_s(s) / motion.session_count();
  result.time_offset.offset_s = mean_s;
  result.time_offset.applied = true;
  for (std::size_t s = 0; s < result.session_time_offset_s.size(); ++s)
    result.session_time_offset_s[s] = motion.offset_s(static_cast<int>(s));
  return result;
}

}  // namespace

void drop_clock(CalibrationResult& result) {
  result.time_offset = {};
  result.session_time_offset_s.clear();
}

void doubt_sweeps(const std::vector<Vector6d>& doubts, const SolveOptions& options, CalibrationResult& result) {
  if (doubts.empty() || !is_usable(result)) return;
  for (const Vector6d& doubt : doubts)
    add_doubt(doubt, "how the scans are bent by motion is not known", options, result);
  result.advice.emplace_back(
      "How the scans are bent by motion is not known, which biases X; the sigmas include it. Record scans with the "
      "times of their points, or declare how they were swept.");
  if (!std::ranges::all_of(result.observed, [](bool observed) { return observed; })) result.status = Status::Degenerate;
  result.message =
      is_usable(result)
          ? solved_message(result)
          : "Nothing is known: how the scans are bent by motion makes more of a difference than X can bear.";
}

bool clock_differs(const CalibrationResult& result) {
  const TimeOffset& clock = result.time_offset;
  const auto stands_out = [](double offset_s, double sigma_s) {
    return std::isfinite(offset_s) && std::abs(offset_s) >= std::max(4.0 * sigma_s, 0.002);
  };
  if (stands_out(clock.offset_s, clock.sigma_s)) return true;
  // Those of several sessions may cancel in the mean.
  const double sessions = static_cast<double>(result.session_time_offset_s.size());
  return std::any_of(result.session_time_offset_s.begin(), result.session_time_offset_s.end(),
                     [&](double offset_s) { return stands_out(offset_s, clock.sigma_s * std::sqrt(sessions)); });
}

DriveMotion motion_as_solved(const PipelineInput& input, const PipelineOutput& output) {
  DriveMotion motion(input.sessions);
  const bool known = output.result.session_time_offset_s.size() == input.sessions.size();
  for (int s = 0; output.result.time_offset.applied && known && s < motion.session_count(); ++s)
    motion.set_offset_s(s, output.result.session_time_offset_s[static_cast<std::size_t>(s)]);
  return motion;
}

PairwiseInput solver_input(const PipelineInput& input, const DriveMotion& motion, const PipelineOutput& output) {
  const std::vector<Keyframe>& keyframes = output.keyframes;
  PairwiseInput out;
  out.nodes = motion.nodes(keyframes);
  out.sessions = motion.noise();
  for (const auto& session : input.sessions) out.session_names.push_back(session->name);
  out.nominal_ins_from_lidar = input.nominal_ins_from_lidar;
  if (output.initial_known) out.initial_ins_from_lidar = output.initial_ins_from_lidar;
  out.up_in_lidar = output.up_in_lidar;
  out.range = input.settings.range;
  out.options = input.settings.solve;
  out.measured = Measured(input.settings.measured, output.ground);
  out.clock_bias = output.clock_bias;
  return out;
}

CalibrationResult solve_with_clock(const PipelineInput& input, DriveMotion& motion, PipelineOutput& output,
                                   PairwiseDetails& details, const Progress& progress) {
  output.clock_bias.reset();
  CalibrationResult result = solve_pairwise(solver_input(input, motion, output), output.pairs, details, progress);
  if (!output.clock_told) {
    drop_clock(result);
    doubt_sweeps(output.sweep_doubts, input.settings.solve, result);
    return result;
  }
  if (input.settings.solve.apply_time_offset)
    return solve_without_offset(input, motion, output, std::move(result), details, progress);
  if (!clock_differs(result)) return result;
  // Only the estimate is wanted, and how far it moves X: the pairs and the solution stay without it.
  DriveMotion shifted = motion;
  PipelineOutput copy = output;
  PairwiseDetails shifted_details;
  const CalibrationResult estimate = solve_without_offset(input, shifted, copy, result, shifted_details, progress);
  if (!is_usable(estimate)) return result;
  if (is_usable(result)) {
    output.clock_bias = difference(details.joint.ins_from_lidar, shifted_details.joint.ins_from_lidar);
    result = solve_pairwise(solver_input(input, motion, output), output.pairs, details, progress);
  }
  result.time_offset = estimate.time_offset;
  result.time_offset.applied = false;
  result.session_time_offset_s = estimate.session_time_offset_s;
  return result;
}

void report_clock(const CalibrationResult& result, std::vector<Finding>& findings) {
  const TimeOffset& clock = result.time_offset;
  if (clock.applied || !clock_differs(result)) return;
  char text[240];
  std::snprintf(text, sizeof text,
                "The lidar's stamps are %s by %.1f ms (sigma %.1f ms) against the INS. X is biased by it while the "
                "vehicle turns: "
                "set solve.apply_time_offset to correct it.",
                clock.offset_s > 0.0 ? "early" : "late", std::abs(clock.offset_s) * 1e3, clock.sigma_s * 1e3);
  findings.push_back({Severity::Warning, kClockOffset, "lidar and INS", text});
}

}  // namespace remount
