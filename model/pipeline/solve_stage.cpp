#include "model/pipeline/solve_stage.h"

#include <algorithm>
#include <cmath>

#include "algorithms/calibration/observability.h"
#include "algorithms/core/error.h"
#include "messages/pipeline.h"
#include "messages/results.h"
#include "model/pipeline/offset_search.h"
#include "model/pipeline/position_lag.h"
#include "model/pipeline/scan_gathering.h"
#include "model/results/result_file.h"

namespace remount::pipeline {

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

DriveMotion motion_as_solved(const PipelineInput& input, const PipelineOutput& output) {
  DriveMotion motion(input.sessions, output.session_swept);
  const bool known = output.result.session_time_offset_s.size() == input.sessions.size();
  for (motion::SessionIndex s; output.result.time_offset.applied && known && s < motion.session_count(); ++s)
    motion.set_offset_s(s, output.result.session_time_offset_s[s]);
  const std::vector<double>& lags_s = output.result.session_position_lag_s;
  const bool lags_known = output.result.position_lag_applied && lags_s.size() == input.sessions.size();
  for (motion::SessionIndex s; lags_known && s < motion.session_count(); ++s) motion.set_position_lag_s(s, lags_s[s]);
  return motion;
}

namespace {

// As all sessions with scans agree.
cloud::LidarKind declared_lidar(const PipelineInput& input) {
  std::optional<cloud::LidarKind> declared;
  for (const auto& session : input.sessions)
    if (session->scans)
      declared = declared.value_or(session->lidar) == session->lidar ? session->lidar : cloud::LidarKind::Unknown;
  return declared.value_or(cloud::LidarKind::Perfect);
}

}  // namespace

cloud::BeamNodes choose_beam_nodes(const PipelineInput& input, const SharedField& field,
                                   const cloud::BeamEstimate& known) {
  const cloud::LidarKind asked = input.settings.beams.lidar;
  const cloud::LidarKind kind = asked == cloud::LidarKind::Auto ? declared_lidar(input) : asked;
  // Each ring errs for itself, also where the vehicle hides a part of the turn.
  cloud::BeamNodes nodes = kind == cloud::LidarKind::Spinning ? cloud::BeamNodes::all_around() : field.beam_nodes();
  if (known.empty()) return nodes;
  if (known.nodes.by_azimuth() != nodes.by_azimuth())
    throw Error(ErrorCode::Contract, input.settings.beams.file, say::beams_of_other_field());
  return known.nodes;
}

cloud::BeamPrior beams_believed(const PipelineInput& input, const PipelineOutput& output) {
  if (!output.known_beams.empty()) return cloud::believed_of_known(output.known_beams);
  return cloud::believed_of_beams(input.settings.beams, declared_lidar(input), output.beam_nodes);
}

calibration::PairwiseInput solver_input(const PipelineInput& input, const DriveMotion& motion,
                                        const PipelineOutput& output) {
  const std::vector<motion::Keyframe>& keyframes = output.keyframes;
  calibration::PairwiseInput out;
  out.nodes = motion.nodes(keyframes);
  add_drift_within_gathered(motion, keyframes, output.session_frames, out.nodes);
  out.sessions = motion.noise();
  for (const auto& session : input.sessions) out.session_names.push_back(session->name);
  out.nominal_ins_from_lidar = input.nominal_ins_from_lidar;
  if (output.initial_known) out.initial_ins_from_lidar = output.initial_ins_from_lidar;
  out.up_in_lidar = output.up_in_lidar;
  out.beams = beams_believed(input, output);
  // What was taken out of the scans is no truth, whatever the settings have become since.
  if (out.beams.empty() && !output.mended_beams.none())
    out.beams = cloud::believed_of_beams({}, cloud::LidarKind::Unknown, output.beam_nodes);
  out.mended_beams = output.mended_beams;
  out.narrow_field = output.beam_nodes.by_azimuth();
  out.sigma_factor = widening_of_gathered(motion, output.session_frames);
  out.range = input.settings.range;
  out.options = input.settings.solve;
  out.measured = calibration::Measured(input.settings.measured, output.ground);
  out.clock_bias = output.clock_bias;
  out.clock_is_unknown = is_moved(motion) || output.clock_is_unknown;
  return out;
}

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
                                                      calibration::PairwiseDetails& details, const Progress& progress) {
  const calibration::ClockOffsetUse use = input.settings.solve.apply_time_offset;
  const bool applied = output.result.time_offset.applied || output.result.position_lag_applied;
  if (!output.clock_told) {
    DriveMotion motion(input.sessions, output.session_swept);
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
  DriveMotion motion(input.sessions, output.session_swept);
  if (applied) {
    set_ins_motion(motion.nodes(output.keyframes), output.pairs);
    return solve_with_clock(input, motion, output, details, progress);
  }
  // How far the clock biases X hardly depends on a decision about pairs.
  std::vector<motion::Pair> pairs = output.pairs;
  const calibration::CalibrationResult result =
      calibration::solve_pairwise(solver_input(input, motion, output), pairs, details, progress);
  const double least_s = use == calibration::ClockOffsetUse::No ? kHarmlessOffset_s : kLeastOffset_s;
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
    if (!calibration::stands_out(offset_s, sigma_s, kLeastOffset_s)) continue;
    const auto stamps = offset_s > 0.0 ? say::pipeline_stamps_early : say::pipeline_stamps_late;
    findings.push_back({clock.applied ? drive::Severity::Note : drive::Severity::Warning, kClockOffset,
                        input.sessions[s]->name,
                        Message::sequence({stamps(Duration{std::abs(offset_s)}, Duration{sigma_s}), what_of_it})});
  }
  report_position_lag(input, result, findings);
}

}  // namespace remount::pipeline
