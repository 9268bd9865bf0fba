#include "model/pipeline/pipeline.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "algorithms/calibration/joint/pair_equation.h"
#include "algorithms/calibration/pairwise/pairwise.h"
#include "algorithms/core/error.h"
#include "algorithms/search/candidates.h"
#include "messages/methods.h"
#include "messages/pipeline.h"
#include "messages/stages.h"
#include "model/pipeline/as_solved_scans.h"
#include "model/pipeline/coarse_start.h"
#include "model/pipeline/ground_stage.h"
#include "model/pipeline/input_checks.h"
#include "model/pipeline/keep_finished.h"
#include "model/pipeline/position_lag.h"
#include "model/pipeline/register_stage.h"
#include "model/pipeline/scan_times.h"
#include "model/pipeline/sharpness_stage.h"
#include "model/pipeline/solve_stage.h"
#include "model/pipeline/suspect_stage.h"
#include "model/pipeline/watched_scans.h"
#include "model/results/nominal_check.h"
#include "model/results/result_file.h"

namespace remount {
namespace {

void check_nominal(const std::optional<RigidTransform>& nominal_ins_from_lidar, const SearchRange& range) {
  const Message problem = nominal_problem(nominal_ins_from_lidar, range);
  if (!problem.empty()) throw Error(ErrorCode::Contract, "nominal mounting", problem);
}

void check_input(const PipelineInput& input) {
  if (input.sessions.empty()) throw Error(ErrorCode::Contract, "", say::method_no_session());
  require_valid(input.settings);
  check_sessions(input.sessions);
  check_nominal(input.nominal_ins_from_lidar, input.settings.range);
}

std::vector<Keyframe> all_keyframes(const DriveMotion& motion, const KeyframeOptions& options,
                                    std::vector<Finding>& findings) {
  std::vector<Keyframe> keyframes;
  for (int s = 0; s < motion.session_count(); ++s) {
    const std::vector<std::int64_t> stamps = motion.lidar_stamps_ns(s);
    const auto outside = static_cast<std::size_t>(std::count_if(
        stamps.begin(), stamps.end(), [&](std::int64_t stamp) { return !motion.local_from_ins(s, stamp); }));
    if (outside > 0)
      findings.push_back({outside == stamps.size() ? Severity::Problem : Severity::Warning, "scan-without-ins",
                          motion.session(s).name,
                          outside == stamps.size()
                              ? say::pipeline_all_scans_outside(outside, stamps.size(), why_not_covered(motion, s))
                              : say::pipeline_scans_outside(outside, stamps.size())});
    const std::vector<Keyframe> chosen = select_keyframes(s, stamps, motion.track(s), motion.offset_s(s), options);
    KeyframeOptions as_set = options;
    as_set.minimum = 0;
    report_closer_keyframes(motion.session(s), options,
                            select_keyframes(s, stamps, motion.track(s), motion.offset_s(s), as_set).size(),
                            chosen.size(), findings);
    keyframes.insert(keyframes.end(), chosen.begin(), chosen.end());
  }
  return keyframes;
}

std::vector<RigidTransform> poses_of(const std::vector<JointNode>& nodes) {
  std::vector<RigidTransform> poses;
  for (const JointNode& node : nodes) poses.push_back(node.local_from_ins);
  return poses;
}

// Which sessions' scans are compensated by a sweep, and by which.
void choose_compensation(const PipelineInput& input, PipelineOutput& output) {
  output.session_uses_sweep.clear();
  output.session_sweeps.clear();
  for (const auto& session : input.sessions) {
    const std::optional<SweepModel> sweep = sweep_of(*session, input.settings.run.deskew);
    output.session_uses_sweep.push_back(sweep.has_value());
    output.session_sweeps.push_back(sweep.value_or(session->sweep));
  }
}

void report_bad_scans(const std::vector<Keyframe>& keyframes, const std::vector<KeyframeObjects>& objects,
                      const DriveMotion& motion, std::vector<Finding>& findings) {
  for (std::size_t k = 0; k < objects.size(); ++k)
    if (!objects[k].failure.empty())
      findings.push_back(skipped_scan(motion.session(keyframes[k].session), objects[k].failure));
}

// An estimate of the clocks stands and falls with X: residuals under a wrong one say nothing about them. An offset that
// was applied is no estimate any more but part of the pairs.
void drop_clock_of_failed(PipelineOutput& output) {
  CalibrationResult& result = output.result;
  // What the clock alone made unusable is known by it.
  const bool by_clock = output.clock_bias && result.status == Status::Degenerate;
  if (is_usable(result) || result.time_offset.applied || result.position_lag_applied || by_clock) return;
  drop_clock(result);
}

// The X that is exported stays in the list wherever it ranks.
void trim_candidates(int limit, const MountingSource& exported, std::vector<Candidate>& candidates) {
  const auto most = static_cast<std::size_t>(limit);
  if (candidates.size() <= most) return;
  const auto found = std::find_if(candidates.begin() + static_cast<std::ptrdiff_t>(most), candidates.end(),
                                  [&](const Candidate& candidate) { return candidate.source == exported; });
  if (found != candidates.end()) candidates[most - 1] = *found;
  candidates.resize(most);
}

void align_all_clouds(const StageContext& context, const PipelineInput& input, DriveMotion& motion, ScanStore& scans,
                      const std::vector<KeyframeObjects>& objects, PairwiseDetails& details, PipelineOutput& output,
                      Progress& progress) {
  const std::vector<JointNode> nodes = motion.nodes(output.keyframes);
  std::vector<RigidTransform> predicted(output.pairs.size(), RigidTransform::Identity());
  for (std::size_t i = 0; i < output.pairs.size(); ++i) {
    const Pair& pair = output.pairs[i];
    const auto a = static_cast<std::size_t>(pair.keyframe_a), b = static_cast<std::size_t>(pair.keyframe_b);
    const auto corrected = [&](std::size_t k) {
      return moved_in_body(nodes[k].local_from_ins, details.joint.node_errors[k]);
    };
    predicted[i] = predicted_lidar_motion(corrected(b).inverse() * corrected(a), details.joint.ins_from_lidar);
  }
  std::vector<Pair> relinearised = output.pairs;
  relinearise_pairs(context, scans, objects, predicted, relinearised, progress);
  if (progress.cancelled()) return;
  const CalibrationResult before = output.result;
  PairwiseInput solver = solver_input(input, motion, output);
  CalibrationResult joint = solve_pairwise(solver, relinearised, details, progress);
  if (!is_solved(joint.status)) return;  // a good solution is not given up for a worse one
  keep_clock(before, joint);
  for (Candidate& candidate : joint.candidates)
    if (candidate.source == MountingSource::Refined) candidate.source = MountingSource::JointClouds;
  Candidate refined;
  refined.source = MountingSource::Refined;
  refined.ins_from_lidar = before.mounting.ins_from_lidar();
  joint.candidates.push_back(refined);
  std::vector<MotionPair> accepted;
  for (const Pair& pair : relinearised)
    if (pair.state == PairState::Accepted) accepted.push_back({pair.ins_b_from_ins_a, pair.lidar_b_from_lidar_a, 1.0});
  rank_candidates(joint.candidates, accepted, input.settings.range, input.settings.solve);
  trim_candidates(input.settings.solve.max_listed_candidates, MountingSource::JointClouds, joint.candidates);
  output.pairs = std::move(relinearised);
  output.result = std::move(joint);
}

bool any_distortion(const PipelineInput& input, const std::vector<bool>& session_uses_sweep) {
  for (std::size_t s = 0; s < input.sessions.size(); ++s)
    if (input.sessions[s]->scan_timing == ScanTiming::PerPoint || session_uses_sweep[s]) return true;
  return false;
}

// Pairs that the registration, the solution or a verdict turned down get another chance, the verdicts theirs after
// that; those without shared objects do not.
void reconsider(std::vector<Pair>& pairs) {
  for (Pair& pair : pairs)
    if (pair.registration.attempted) {
      pair.state = PairState::Proposed;
      pair.decided_by = DecidedBy::Nobody;
      pair.reason = {};
    }
}

// Whether X moved so far that compensating the scans through the old one leaves an error worth a second pass.
bool moved_much(const RigidTransform& from, const RigidTransform& to) {
  return rotation_angle_between_rad(from, to) > degrees_to_radians(0.05) ||
         (to.translation() - from.translation()).norm() > 0.02;
}

void use_ground(const StageContext& context, const ScanStore& scans, PipelineOutput& output, Progress& progress) {
  output.ground = observe_ground(context, scans, progress);
  if (!output.ground && !progress.cancelled()) report_unseen_ground(output);
}

// What is proposed becomes pairs with shared objects; false where no scan can be read: the result says so.
bool match_objects_of_pairs(const StageContext& context, const ScanStore& scans, PipelineOutput& output,
                            std::vector<KeyframeObjects>& objects, Progress& progress) {
  objects = find_keyframe_objects(context, scans, output.pairs, progress);
  report_bad_scans(output.keyframes, objects, context.motion, output.findings);
  std::size_t needed = 0;
  const Message unreadable = all_scans_unreadable(objects, output.keyframes, output.pairs, context.motion, needed);
  if (!unreadable.empty()) {
    output.result = result_without_scans(needed, unreadable);
    return false;
  }
  match_pairs(context, objects, output.pairs, progress);
  return true;
}

// Objects, registration, solution and joint alignment of sessions with scans. Scans are compensated for motion through
// the initial X, and a second time through the X found, so that an inaccurate nominal leaves no trace; `first_pass` is
// what there was before that.
void calibrate_scans(const PipelineInput& input, DriveMotion& motion, PipelineOutput& output, PairwiseDetails& details,
                     std::optional<PipelineOutput>& first_pass, Progress& progress) {
  RigidTransform x = output.initial_ins_from_lidar;
  std::vector<KeyframeObjects> objects;
  const std::vector<bool>& uses_sweep = output.session_uses_sweep;
  for (int pass = 0; pass < 2 && !progress.cancelled(); ++pass) {
    const StageContext context{motion, input.settings, output.keyframes, x, input.threads};
    ScanStore scans(motion, input.settings.registration, static_cast<std::size_t>(input.settings.run.cache_mb) << 20);
    const bool compensate = input.settings.run.deskew != DeskewMode::Off;
    if (compensate && pass == 0) choose_compensation(input, output);
    if (compensate) scans.compensate_motion(x, uses_sweep, output.session_sweeps);
    output.compensation_ins_from_lidar = x;
    if (pass == 0 && !match_objects_of_pairs(context, scans, output, objects, progress)) return;
    register_pairs(context, scans, objects, output.pairs, progress);
    use_odometry(motion, output.keyframes, input.odometry_untold, output.pairs);
    apply_verdicts(input.verdicts, output);
    if (input.settings.measured.ins_height_sigma_m > 0.0) use_ground(context, scans, output, progress);
    progress.report(say::stage_solving, 0, 0);
    output.result = solve_with_clock(input, motion, output, details, progress);
    if (!is_solved(output.result.status)) return;
    const bool bent_otherwise =
        moved_much(x, output.result.mounting.ins_from_lidar()) || output.result.position_lag_applied;
    if (pass == 0 && compensate && any_distortion(input, uses_sweep) && bent_otherwise) {
      x = output.result.mounting.ins_from_lidar();
      first_pass = output;
      reconsider(output.pairs);
      continue;
    }
    if (input.settings.solve.joint_clouds)
      align_all_clouds(context, input, motion, scans, objects, details, output, progress);
    if (is_solved(output.result.status)) take_sharpness(context, scans, input.nominal_ins_from_lidar, output, progress);
    return;
  }
}

CalibrationResult without_start(const CoarseStart& coarse) {
  if (coarse.readable == 0 && coarse.unreadable > 0)
    return result_without_scans(coarse.unreadable, coarse.first_unreadable);
  CalibrationResult result;
  result.status = Status::TooFewPairs;
  result.message = say::pipeline_no_first_estimate(coarse.problem);
  result.advice.push_back(say::pipeline_give_nominal());
  return result;
}

// What was found until then is counted: it tells how far the run had come.
CalibrationResult cancelled_result(const std::vector<Pair>& pairs) {
  CalibrationResult result;
  result.status = Status::Cancelled;
  result.message = say::method_cancelled();
  result.pairs_proposed = static_cast<int>(pairs.size());
  for (const Pair& pair : pairs) {
    result.pairs_accepted += pair.state == PairState::Accepted;
    result.pairs_rejected += pair.state == PairState::Rejected;
  }
  return result;
}

bool any_scans(const PipelineInput& input) {
  return std::ranges::any_of(input.sessions, [](const auto& session) { return session->scans != nullptr; });
}

}  // namespace

PipelineOutput run_pipeline(const PipelineInput& input, Progress& progress) {
  check_input(input);
  DriveMotion motion(input.sessions);
  PipelineOutput output;
  for (int session = 0; session < motion.session_count(); ++session) {
    const std::vector<Finding>& read = motion.session(session).findings;
    output.findings.insert(output.findings.end(), read.begin(), read.end());
  }
  output.clock_told = std::ranges::all_of(
      input.sessions, [&](const auto& session) { return tells_clock(*session, input.settings.run.deskew); });
  output.keyframes = all_keyframes(motion, input.settings.keyframes, output.findings);
  output.pairs = propose_pairs(output.keyframes, poses_of(motion.nodes(output.keyframes)), input.settings.pairing);
  keep_independent_odometry(motion, output.keyframes, output.pairs);
  output.nominal_known = output.initial_known = input.nominal_ins_from_lidar.has_value();
  output.initial_ins_from_lidar = input.nominal_ins_from_lidar.value_or(RigidTransform::Identity());
  if (output.pairs.empty()) {
    output.result = result_without_pairs(motion, output.keyframes, input.settings);
    return output;
  }

  PairwiseDetails details;
  CoarseStart coarse;
  if (any_scans(input)) {
    if (!input.nominal_ins_from_lidar) {
      coarse = find_coarse_start(motion, input.settings, input.threads, progress);
      if (!coarse.ins_from_lidar) {
        report_far_clocks(motion, coarse.far_clocks, output);
        output.result = progress.cancelled() ? cancelled_result(output.pairs) : without_start(coarse);
        blame_recording(output.findings, output.result, output.farthest_clock_s);
        return output;
      }
      output.initial_ins_from_lidar = *coarse.ins_from_lidar;
      output.initial_known = true;
      output.up_in_lidar = coarse.up_in_lidar;
    }
    std::optional<PipelineOutput> first_pass;
    calibrate_scans(input, motion, output, details, first_pass, progress);
    // Half of the pairs of each pass do not go together.
    if (progress.cancelled() && first_pass) output = std::move(*first_pass);
  } else {
    output.map_check = MapCheck::NoScans;
    if (input.settings.measured.ins_height_sigma_m > 0.0) report_unseen_ground(output);
    use_odometry(motion, output.keyframes, input.odometry_untold, output.pairs);
    apply_verdicts(input.verdicts, output);
    progress.report(say::stage_solving, 0, 0);
    output.result = solve_with_clock(input, motion, output, details, progress);
  }
  if (progress.cancelled()) output.result = cancelled_result(output.pairs);
  report_columns(motion, output);
  report_far_clocks(motion, coarse.far_clocks, output);
  blame_recording(output.findings, output.result, output.farthest_clock_s);
  drop_clock_of_failed(output);
  report_clock(input, output.result, output.findings);
  report_sharpness(output.sharpness, output.findings);
  report_nominal(input.nominal_ins_from_lidar, output.result, output.findings);
  return output;
}

void compensate_as_solved(const PipelineInput& input, const PipelineOutput& output, ScanStore& scans) {
  if (input.settings.run.deskew == DeskewMode::Off) return;
  std::vector<bool> uses_sweep = output.session_uses_sweep;
  uses_sweep.resize(input.sessions.size(), false);
  scans.compensate_motion(output.compensation_ins_from_lidar, uses_sweep, output.session_sweeps);
}

bool solve_again(const PipelineInput& input, PipelineOutput& output, Progress& progress) {
  PipelineOutput solved = output;  // a cancelled call leaves the output as it was
  solved.result = solve_with_clock_again(input, solved, progress);
  if (progress.cancelled() || solved.result.status == Status::Cancelled) return false;
  blame_recording(solved.findings, solved.result, solved.farthest_clock_s);
  drop_clock_of_failed(solved);
  forget_sharpness(solved);
  std::erase_if(solved.findings, [](const Finding& finding) {
    return finding.code == kClockOffset || finding.code == kPositionLag || finding.code == kPositionsApart;
  });
  report_clock(input, solved.result, solved.findings);
  report_nominal(input.nominal_ins_from_lidar, solved.result, solved.findings);
  mark_if_cut_short(solved);
  output = std::move(solved);
  return true;
}

void check_map(const PipelineInput& input, PipelineOutput& output, Progress& progress) {
  if (!input.settings.run.map_check || !is_usable(output.result) || !any_scans(input)) return;
  const DriveMotion motion = motion_as_solved(input, output);
  const StageContext context{motion, input.settings, output.keyframes, output.initial_ins_from_lidar, input.threads};
  ScanStore scans(motion, input.settings.registration, 0);
  compensate_as_solved(input, output, scans);
  forget_sharpness(output);
  take_sharpness(context, scans, input.nominal_ins_from_lidar, output, progress);
  report_sharpness(output.sharpness, output.findings);
}

PairClouds load_pair_clouds(const PipelineInput& input, const PipelineOutput& output, int pair_index) {
  const Pair& pair = output.pairs.at(static_cast<std::size_t>(pair_index));
  const Keyframe& a = output.keyframes[static_cast<std::size_t>(pair.keyframe_a)];
  const Keyframe& b = output.keyframes[static_cast<std::size_t>(pair.keyframe_b)];
  PairClouds clouds;
  if (!input.sessions.at(static_cast<std::size_t>(a.session))->scans) return clouds;
  const DriveMotion motion = motion_as_solved(input, output);
  const StageContext context{motion, input.settings, output.keyframes, output.initial_ins_from_lidar, input.threads};
  ScanStore scans(motion, input.settings.registration, 0);
  compensate_as_solved(input, output, scans);
  clouds.cloud_a = scans.load(a);
  clouds.cloud_b = scans.load(b);
  clouds.objects_a = find_objects(clouds.cloud_a, up_in_lidar(context, a), input.settings.objects);
  clouds.objects_b = find_objects(clouds.cloud_b, up_in_lidar(context, b), input.settings.objects);
  clouds.matches = match_objects(clouds.objects_a, clouds.objects_b,
                                 predicted_lidar_motion(pair.ins_b_from_ins_a, output.initial_ins_from_lidar),
                                 input.settings.objects);
  return clouds;
}

}  // namespace remount
