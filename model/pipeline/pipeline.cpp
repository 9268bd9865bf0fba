#include "model/pipeline/pipeline.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

#include "algorithms/calibration/joint/pair_equation.h"
#include "algorithms/calibration/pairwise/moved_within.h"
#include "algorithms/core/error.h"
#include "algorithms/core/index.h"
#include "messages/methods.h"
#include "messages/pipeline.h"
#include "messages/stages.h"
#include "model/pipeline/as_solved_scans.h"
#include "model/pipeline/beam_report.h"
#include "model/pipeline/coarse_start.h"
#include "model/pipeline/ground_stage.h"
#include "model/pipeline/input_checks.h"
#include "model/pipeline/keep_finished.h"
#include "model/pipeline/position_lag.h"
#include "model/pipeline/scan_gathering.h"
#include "model/pipeline/scan_passes.h"
#include "model/pipeline/scan_times.h"
#include "model/pipeline/sharpness_stage.h"
#include "model/pipeline/solve_stage.h"
#include "model/pipeline/suspect_stage.h"
#include "model/results/disagreement.h"
#include "model/results/nominal_check.h"

namespace remount::pipeline {
namespace {

void check_nominal(const std::optional<RigidTransform>& nominal_ins_from_lidar, const calibration::SearchRange& range) {
  const Message problem = settings::nominal_problem(nominal_ins_from_lidar, range);
  if (!problem.empty()) throw Error(ErrorCode::Contract, "nominal mounting", problem);
}

void check_input(const PipelineInput& input) {
  if (input.sessions.empty()) throw Error(ErrorCode::Contract, "", say::method_no_session());
  settings::require_valid(input.settings);
  check_sessions(input.sessions);
  check_nominal(input.nominal_ins_from_lidar, input.settings.range);
}

std::vector<motion::Keyframe> all_keyframes(const DriveMotion& motion, const motion::KeyframeOptions& options,
                                            const std::vector<int>& session_frames,
                                            std::vector<drive::Finding>& findings) {
  std::vector<motion::Keyframe> keyframes;
  for (motion::SessionIndex s; s < motion.session_count(); ++s) {
    const std::vector<std::int64_t> stamps = motion.lidar_stamps_ns(s);
    const auto outside = static_cast<std::size_t>(std::count_if(
        stamps.begin(), stamps.end(), [&](std::int64_t stamp) { return !motion.local_from_ins(s, stamp); }));
    if (outside > 0)
      findings.push_back({outside == stamps.size() ? drive::Severity::Problem : drive::Severity::Warning,
                          "scan-without-ins", motion.session(s).name,
                          outside == stamps.size()
                              ? say::pipeline_all_scans_outside(outside, stamps.size(), why_not_covered(motion, s))
                              : say::pipeline_scans_outside(outside, stamps.size())});
    const motion::GatheredFrames frames{index_at(session_frames[s])};
    const std::vector<motion::Keyframe> chosen =
        motion::select_keyframes(s, stamps, motion.track(s), motion.offset_s(s), options, frames);
    motion::KeyframeOptions as_set = options;
    as_set.minimum = 0;
    report_closer_keyframes(
        motion.session(s), options,
        motion::select_keyframes(s, stamps, motion.track(s), motion.offset_s(s), as_set, frames).size(), chosen.size(),
        findings);
    keyframes.insert(keyframes.end(), chosen.begin(), chosen.end());
  }
  return keyframes;
}

std::vector<RigidTransform> poses_of(const std::vector<calibration::JointNode>& nodes) {
  std::vector<RigidTransform> poses;
  for (const calibration::JointNode& node : nodes) poses.push_back(node.local_from_ins);
  return poses;
}

// An estimate of the clocks stands and falls with X: residuals under a wrong one say nothing about them. An offset that
// was applied is no estimate any more but part of the pairs.
void drop_clock_of_failed(PipelineOutput& output) {
  calibration::CalibrationResult& result = output.result;
  // What the clock alone made unusable is known by it.
  const bool by_clock = output.clock_bias && result.status == calibration::Status::Degenerate;
  if (calibration::is_usable(result) || result.time_offset.applied || result.position_lag_applied || by_clock) return;
  drop_clock(result);
}

calibration::CalibrationResult without_start(const CoarseStart& coarse) {
  if (coarse.readable == 0 && coarse.unreadable > 0)
    return result_without_scans(coarse.unreadable, coarse.first_unreadable);
  calibration::CalibrationResult result;
  result.conclude(calibration::Status::NotConverged, say::pipeline_no_first_estimate(coarse.problem));
  result.advice.push_back(say::pipeline_give_nominal());
  return result;
}

// What was found until then is counted: it tells how far the run had come.
calibration::CalibrationResult cancelled_result(const std::vector<motion::Pair>& pairs) {
  calibration::CalibrationResult result;
  result.conclude(calibration::Status::Cancelled, say::method_cancelled());
  result.pairs_proposed = static_cast<int>(pairs.size());
  for (const motion::Pair& pair : pairs) {
    result.pairs_accepted += pair.state == motion::PairState::Accepted;
    result.pairs_rejected += pair.state == motion::PairState::Rejected;
  }
  return result;
}

bool any_scans(const PipelineInput& input) {
  return std::ranges::any_of(input.sessions, [](const auto& session) { return session->scans != nullptr; });
}

PipelineOutput output_of_readers(const PipelineInput& input, const DriveMotion& motion) {
  PipelineOutput output;
  for (motion::SessionIndex session; session < motion.session_count(); ++session) {
    const std::vector<drive::Finding>& read = motion.session(session).findings;
    output.findings.insert(output.findings.end(), read.begin(), read.end());
  }
  output.clock_told = std::ranges::all_of(
      input.sessions, [&](const auto& session) { return tells_clock(*session, input.settings.run.deskew); });
  output.known_beams = input.known_beams;
  output.beam_nodes = input.known_beams.nodes;
  output.mended_beams = input.known_beams.beam_errors();
  output.nominal_known = output.initial_known = input.nominal_ins_from_lidar.has_value();
  output.initial_ins_from_lidar = input.nominal_ins_from_lidar.value_or(RigidTransform::Identity());
  return output;
}

// False where there is none: the result says why.
bool take_start(const CoarseStart& coarse, const DriveMotion& motion, PipelineOutput& output,
                const Progress& progress) {
  if (!coarse.ins_from_lidar) {
    report_far_clocks(motion, coarse.far_clocks, output);
    output.result = progress.cancelled() ? cancelled_result(output.pairs) : without_start(coarse);
    blame_recording(output.findings, output.result, output.farthest_clock_s);
    return false;
  }
  output.initial_ins_from_lidar = *coarse.ins_from_lidar;
  output.initial_known = true;
  output.up_in_lidar = coarse.up_in_lidar;
  return true;
}

// Those whose scans have little of the field in common, as the mounting has it, are left to nearer ones.
void propose_all_pairs(const PipelineInput& input, const DriveMotion& motion, const SharedField& field,
                       const std::optional<RigidTransform>& ins_from_lidar, PipelineOutput& output) {
  std::function<bool(const motion::Pair&)> may_share;
  if (ins_from_lidar && field.any_narrow())
    may_share = [&](const motion::Pair& pair) {
      return field.share(output.keyframes[pair.keyframe_a].session,
                         calibration::predicted_lidar_motion(pair.ins_b_from_ins_a, *ins_from_lidar)) >= kLeastShare;
    };
  output.pairs = motion::propose_pairs(output.keyframes, poses_of(motion.nodes(output.keyframes)),
                                       input.settings.pairing, may_share);
  keep_independent_odometry(motion, output.keyframes, output.pairs);
}

// Sessions that hold poses of the LiDAR and no scans.
void calibrate_poses(const PipelineInput& input, DriveMotion& motion, PipelineOutput& output,
                     calibration::PairwiseDetails& details, Progress& progress) {
  output.map_check = MapCheck::NoScans;
  if (input.settings.measured.ins_height_sigma_m > 0.0) report_unseen_ground(output);
  use_odometry(motion, output.keyframes, input.odometry_untold, output.pairs);
  apply_verdicts(input.verdicts, output);
  progress.report(say::stage_solving, 0, 0);
  output.result = solve_with_clock(input, motion, output, details, progress);
}

}  // namespace

PipelineOutput run_pipeline(const PipelineInput& input, Progress& progress) {
  // 1. What was read.
  check_input(input);
  const std::vector<motion::Sweep> swept = swept_times(input.sessions, input.settings.run.deskew);
  DriveMotion motion(input.sessions, swept);
  PipelineOutput output = output_of_readers(input, motion);
  output.session_swept = swept;

  // 2. Pairs of keyframes that may share objects.
  output.session_frames = choose_gathering(motion, input.settings.keyframes, output.findings, progress);
  output.keyframes = all_keyframes(motion, input.settings.keyframes, output.session_frames, output.findings);
  const SharedField field(motion, progress);
  propose_all_pairs(input, motion, field, input.nominal_ins_from_lidar, output);
  if (output.pairs.empty()) {
    output.result = result_without_pairs(motion, output.keyframes, input.settings);
    return output;
  }

  // 3. A first mounting, where scans have to be compared and none is given.
  CoarseStart coarse;
  const bool scans = any_scans(input);
  if (scans && !input.nominal_ins_from_lidar) {
    coarse = find_coarse_start(motion, input.settings, input.threads, progress);
    if (!take_start(coarse, motion, output, progress)) return output;
    if (field.any_narrow()) propose_all_pairs(input, motion, field, output.initial_ins_from_lidar, output);
    if (output.pairs.empty()) {
      output.result = result_without_pairs(motion, output.keyframes, input.settings);
      return output;
    }
  }

  // 4. Objects, registrations and the mounting, twice where scans were bent by their motion.
  calibration::PairwiseDetails details;
  if (scans)
    calibrate_all_scans(input, motion, field, output, details, progress);
  else
    calibrate_poses(input, motion, output, details, progress);
  if (progress.cancelled()) output.result = cancelled_result(output.pairs);
  output.details = std::make_shared<const calibration::PairwiseDetails>(std::move(details));

  // 5. What is to be said of it.
  tell_beams(output);
  report_columns(motion, output);
  report_far_clocks(motion, coarse.far_clocks, output);
  if (calibration::is_solved(output.result.status))
    calibration::report_moved_within(solver_input(input, motion, output), output.pairs, progress, output.result);
  blame_recording(output.findings, output.result, output.farthest_clock_s);
  drop_clock_of_failed(output);
  report_clock(input, output.result, output.findings);
  report_sharpness(output.sharpness, output.findings);
  results::report_nominal(input.nominal_ins_from_lidar, output.result, output.findings);
  results::report_disagreement(output.result, output.findings);
  return output;
}

void compensate_as_solved(const PipelineInput& input, const PipelineOutput& output, ScanStore& scans) {
  scans.mend_beams(output.mended_beams);
  scans.gather(output.compensation_ins_from_lidar, output.session_frames);
  if (input.settings.run.deskew == settings::DeskewMode::Off) return;
  std::vector<bool> uses_sweep = output.session_uses_sweep;
  uses_sweep.resize(input.sessions.size(), false);
  scans.compensate_motion(output.compensation_ins_from_lidar, uses_sweep, output.session_sweeps);
}

bool solve_again(const PipelineInput& input, PipelineOutput& output, Progress& progress) {
  PipelineOutput solved = output;  // a cancelled call leaves the output as it was
  calibration::PairwiseDetails details;
  solved.result = solve_with_clock_again(input, solved, details, progress);
  solved.details = std::make_shared<const calibration::PairwiseDetails>(std::move(details));
  if (progress.cancelled() || solved.result.status == calibration::Status::Cancelled) return false;
  if (calibration::is_solved(solved.result.status))
    calibration::report_moved_within(solver_input(input, motion_as_solved(input, solved), solved), solved.pairs,
                                     progress, solved.result);
  blame_recording(solved.findings, solved.result, solved.farthest_clock_s);
  drop_clock_of_failed(solved);
  forget_sharpness(solved);
  std::erase_if(solved.findings, [](const drive::Finding& finding) {
    return finding.code == kClockOffset || finding.code == kPositionLag || finding.code == kPositionsApart;
  });
  report_clock(input, solved.result, solved.findings);
  tell_beams(solved);
  report_mended_beams(std::nullopt, solved);
  results::report_nominal(input.nominal_ins_from_lidar, solved.result, solved.findings);
  results::report_disagreement(solved.result, solved.findings);
  mark_if_cut_short(solved);
  output = std::move(solved);
  return true;
}

void check_map(const PipelineInput& input, PipelineOutput& output, Progress& progress) {
  if (!input.settings.run.map_check || !calibration::is_usable(output.result) || !any_scans(input)) return;
  const DriveMotion motion = motion_as_solved(input, output);
  const StageContext context{motion, input.settings, output.keyframes, output.initial_ins_from_lidar, input.threads};
  ScanStore scans(motion, input.settings.registration, 0);
  compensate_as_solved(input, output, scans);
  forget_sharpness(output);
  take_sharpness(context, scans, input.nominal_ins_from_lidar, output, progress);
  report_sharpness(output.sharpness, output.findings);
  report_mended_beams(thickness_of_beams(context, input, output, progress), output);
}

}  // namespace remount::pipeline
