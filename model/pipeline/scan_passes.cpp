#include "model/pipeline/scan_passes.h"

#include <algorithm>
#include <cmath>

#include "algorithms/calibration/joint/pair_equation.h"
#include "algorithms/search/candidates.h"
#include "messages/pipeline.h"
#include "messages/stages.h"
#include "model/pipeline/as_solved_scans.h"
#include "model/pipeline/beam_report.h"
#include "model/pipeline/ground_stage.h"
#include "model/pipeline/input_checks.h"
#include "model/pipeline/register_stage.h"
#include "model/pipeline/scan_times.h"
#include "model/pipeline/sharpness_stage.h"
#include "model/pipeline/solve_stage.h"
#include "model/pipeline/watched_scans.h"

namespace remount::pipeline {
namespace {

// Which sessions' scans are compensated by a sweep, and by which.
void choose_compensation(const PipelineInput& input, PipelineOutput& output) {
  output.session_uses_sweep.clear();
  output.session_sweeps.clear();
  for (const auto& session : input.sessions) {
    const std::optional<drive::SweepModel> sweep = sweep_of(*session, input.settings.run.deskew);
    output.session_uses_sweep.push_back(sweep.has_value());
    output.session_sweeps.push_back(sweep.value_or(session->sweep));
  }
}

void report_bad_scans(const std::vector<motion::Keyframe>& keyframes, const std::vector<KeyframeObjects>& objects,
                      const DriveMotion& motion, std::vector<drive::Finding>& findings) {
  for (std::size_t k = 0; k < objects.size(); ++k)
    if (!objects[k].failure.empty())
      findings.push_back(skipped_scan(motion.session(keyframes[k].session), objects[k].failure));
}

// The X that is exported stays in the list wherever it ranks.
void trim_candidates(int limit, const calibration::MountingSource& exported,
                     std::vector<calibration::Candidate>& candidates) {
  const auto most = static_cast<std::size_t>(limit);
  if (candidates.size() <= most) return;
  const auto found =
      std::find_if(candidates.begin() + static_cast<std::ptrdiff_t>(most), candidates.end(),
                   [&](const calibration::Candidate& candidate) { return candidate.source == exported; });
  if (found != candidates.end()) candidates[most - 1] = *found;
  candidates.resize(most);
}

void align_all_clouds(const StageContext& context, const PipelineInput& input, DriveMotion& motion, ScanStore& scans,
                      const std::vector<KeyframeObjects>& objects, calibration::PairwiseDetails& details,
                      PipelineOutput& output, Progress& progress) {
  const std::vector<calibration::JointNode> nodes = motion.nodes(output.keyframes);
  std::vector<RigidTransform> predicted(output.pairs.size(), RigidTransform::Identity());
  for (std::size_t i = 0; i < output.pairs.size(); ++i) {
    const motion::Pair& pair = output.pairs[i];
    const motion::KeyframeIndex a = pair.keyframe_a, b = pair.keyframe_b;
    const auto corrected = [&](motion::KeyframeIndex k) {
      return calibration::moved_in_body(nodes[k].local_from_ins, details.joint.node_errors[k]);
    };
    predicted[i] =
        calibration::predicted_lidar_motion(corrected(b).inverse() * corrected(a), details.joint.ins_from_lidar);
  }
  std::vector<motion::Pair> relinearised = output.pairs;
  relinearise_pairs(context, scans, objects, predicted, relinearised, progress);
  if (progress.cancelled()) return;
  const calibration::CalibrationResult before = output.result;
  calibration::PairwiseInput solver = solver_input(input, motion, output);
  calibration::CalibrationResult joint = calibration::solve_pairwise(solver, relinearised, details, progress);
  if (!calibration::is_solved(joint.status)) return;  // a good solution is not given up for a worse one
  keep_clock(before, joint);
  for (calibration::Candidate& candidate : joint.candidates)
    if (candidate.source == calibration::MountingSource::Refined)
      candidate.source = calibration::MountingSource::JointClouds;
  calibration::Candidate refined;
  refined.source = calibration::MountingSource::Refined;
  refined.ins_from_lidar = before.mounting.ins_from_lidar();
  joint.candidates.push_back(refined);
  std::vector<search::MotionPair> accepted;
  for (const motion::Pair& pair : relinearised)
    if (pair.state == motion::PairState::Accepted)
      accepted.push_back({pair.ins_b_from_ins_a, pair.lidar_b_from_lidar_a, 1.0});
  search::rank_candidates(joint.candidates, accepted, input.settings.range, input.settings.solve);
  trim_candidates(input.settings.solve.max_listed_candidates, calibration::MountingSource::JointClouds,
                  joint.candidates);
  output.pairs = std::move(relinearised);
  output.result = std::move(joint);
}

bool any_distortion(const PipelineInput& input, const std::vector<bool>& session_uses_sweep) {
  for (std::size_t s = 0; s < input.sessions.size(); ++s)
    if (input.sessions[s]->scan_timing == drive::ScanTiming::PerPoint || session_uses_sweep[s]) return true;
  return false;
}

// Pairs that the registration, the solution or a verdict turned down get another chance, the verdicts theirs after
// that; those without shared objects do not.
void reconsider(std::vector<motion::Pair>& pairs) {
  for (motion::Pair& pair : pairs)
    if (pair.registration.attempted) {
      pair.state = motion::PairState::Proposed;
      pair.decided_by = motion::DecidedBy::Nobody;
      pair.reason = {};
    }
}

bool any_gathered(const PipelineOutput& output) {
  return std::ranges::any_of(output.session_frames, [](int frames) { return frames > 1; });
}

// Whether X moved so far that compensating the scans through the old one leaves an error worth a second pass.
// Gathered scans bear out a part of what they were gathered through, however little that is off.
bool moved_much(const RigidTransform& from, const RigidTransform& to, bool gathered) {
  const double most_rad = degrees_to_radians(gathered ? 0.002 : 0.05), most_m = gathered ? 1e-3 : 0.02;
  return rotation_angle_between_rad(from, to) > most_rad || (to.translation() - from.translation()).norm() > most_m;
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
void calibrate_scans(const PipelineInput& input, DriveMotion& motion, const SharedField& field, PipelineOutput& output,
                     calibration::PairwiseDetails& details, std::optional<PipelineOutput>& first_pass,
                     Progress& progress) {
  settings::Settings settings = input.settings;
  settings.registration.tell_beam_response = !beams_believed(input).empty();
  RigidTransform x = output.initial_ins_from_lidar;
  std::vector<KeyframeObjects> objects;
  const std::vector<bool>& uses_sweep = output.session_uses_sweep;
  const int passes = any_gathered(output) ? 6 : 2;
  for (int pass = 0; pass < passes && !progress.cancelled(); ++pass) {
    const StageContext context{motion, settings, output.keyframes, x, input.threads, &field};
    ScanStore scans(motion, input.settings.registration, static_cast<std::size_t>(input.settings.run.cache_mb) << 20);
    const bool compensate = input.settings.run.deskew != settings::DeskewMode::Off;
    if (compensate && pass == 0) choose_compensation(input, output);
    output.compensation_ins_from_lidar = x;
    compensate_as_solved(input, output, scans);
    if (pass == 0 && !match_objects_of_pairs(context, scans, output, objects, progress)) return;
    register_pairs(context, scans, objects, output.pairs, progress);
    use_odometry(motion, output.keyframes, input.odometry_untold, output.pairs);
    apply_verdicts(input.verdicts, output);
    if (input.settings.measured.ins_height_sigma_m > 0.0) use_ground(context, scans, output, progress);
    progress.report(say::stage_solving, 0, 0);
    output.result = solve_with_clock(input, motion, output, details, progress);
    if (!calibration::is_solved(output.result.status)) return;
    const bool bent_otherwise = moved_much(x, output.result.mounting.ins_from_lidar(), any_gathered(output)) ||
                                output.result.position_lag_applied;
    const bool bent = (compensate && any_distortion(input, uses_sweep)) || any_gathered(output);
    // A drive that leaves a part of X open takes errors of its INS for those of beams (nearly straight KITTI drives).
    const bool beams_err =
        output.result.status == calibration::Status::Ok && output.result.beams.stands_out_of(output.mended_beams);
    if (pass + 1 < passes && (beams_err || (bent && bent_otherwise))) {
      x = output.result.mounting.ins_from_lidar();
      first_pass = output;
      if (beams_err) output.mended_beams = output.result.beams.errors;
      reconsider(output.pairs);
      continue;
    }
    if (input.settings.solve.joint_clouds)
      align_all_clouds(context, input, motion, scans, objects, details, output, progress);
    if (!calibration::is_solved(output.result.status)) return;
    take_sharpness(context, scans, input.nominal_ins_from_lidar, output, progress);
    report_mended_beams(thickness_of_beams(context, input, output, progress), output);
    return;
  }
}

}  // namespace

void calibrate_all_scans(const PipelineInput& input, DriveMotion& motion, const SharedField& field,
                         PipelineOutput& output, calibration::PairwiseDetails& details, Progress& progress) {
  std::optional<PipelineOutput> first_pass;
  calibrate_scans(input, motion, field, output, details, first_pass, progress);
  if (progress.cancelled() && first_pass) output = std::move(*first_pass);
}

}  // namespace remount::pipeline
