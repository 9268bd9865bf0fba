#include "model/pipeline/scan_passes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "algorithms/calibration/joint/pair_equation.h"
#include "algorithms/search/candidates.h"
#include "messages/pipeline.h"
#include "messages/stages.h"
#include "model/pipeline/as_solved_scans.h"
#include "model/pipeline/beam_report.h"
#include "model/pipeline/chosen_pairs.h"
#include "model/pipeline/ground_stage.h"
#include "model/pipeline/input_checks.h"
#include "model/pipeline/offset_search.h"
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
  for (std::size_t k = 0; k < objects.size(); ++k) {
    if (objects[k].failure.empty()) continue;
    drive::Finding skipped = skipped_scan(motion.session(keyframes[k].session), objects[k].failure);
    if (!is_named(skipped, findings)) findings.push_back(std::move(skipped));
  }
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
  solver.noise_before = details.noise;  // a pair that was aligned wrongly does not pass for what is expected of the INS
  calibration::PairwiseDetails of_joint;
  calibration::CalibrationResult joint = calibration::solve_pairwise(solver, relinearised, of_joint, progress);
  if (!calibration::is_solved(joint.status)) return;  // a good solution is not given up for a worse one
  details = std::move(of_joint);
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

// The pairs at `places`, worked at apart from the others.
template <class Work>
void work_at(const std::vector<motion::PairIndex>& places, std::vector<motion::Pair>& pairs, Work&& work) {
  std::vector<motion::Pair> these;
  for (const motion::PairIndex i : places) these.push_back(std::move(pairs[i]));
  work(these);
  for (std::size_t i = 0; i < places.size(); ++i) pairs[places[i]] = std::move(these[i]);
}

std::vector<motion::PairIndex> all_of(const std::vector<motion::Pair>& pairs) {
  std::vector<motion::PairIndex> places;
  for (motion::PairIndex i; i < pairs.size(); ++i) places.push_back(i);
  return places;
}

// Objects, registration, solution and joint alignment of sessions with scans. Scans are compensated for motion through
// the initial X, and a second time through the X found, so that an inaccurate nominal leaves no trace; of many pairs
// more are registered once X holds still, until it is known as well as all would tell.
class ScanCalibration {
 public:
  ScanCalibration(const PipelineInput& input, DriveMotion& motion, const SharedField& field, PipelineOutput& output,
                  calibration::PairwiseDetails& details, Progress& progress)
      : input_(input),
        settings_(input.settings),
        motion_(motion),
        field_(field),
        output_(output),
        details_(details),
        progress_(progress),
        chosen_(input, motion, output),
        passes_left_(any_gathered(output) ? 5 : 1),
        to_match_(all_of(output.pairs)),
        to_register_(to_match_),
        x_(output.initial_ins_from_lidar) {
    output.beam_nodes = choose_beam_nodes(input, field, output.known_beams);
    if (!beams_believed(input, output).empty()) settings_.registration.beam_nodes = output.beam_nodes;
    if (compensates()) choose_compensation(input, output);
  }

  /// What there was before the step that was under way is in `before` where it is cancelled.
  void run(std::optional<PipelineOutput>& before) {
    while (!progress_.cancelled()) {
      const StageContext context{motion_, settings_, output_.keyframes, x_, input_.threads, &field_};
      ScanStore scans(motion_, input_.settings.registration,
                      static_cast<std::size_t>(input_.settings.run.cache_mb) << 20);
      output_.compensation_ins_from_lidar = x_;
      compensate_as_solved(input_, output_, scans);
      if (!register_new(context, scans)) return;
      if (input_.settings.measured.ins_height_sigma_m > 0.0) use_ground(context, scans, output_, progress_);
      progress_.report(say::stage_solving, 0, 0);
      output_.result = solve_with_clock(input_, motion_, output_, details_, progress_);
      if (progress_.cancelled()) return;
      tell_so_far();
      if (goes_on(before)) continue;
      if (calibration::is_solved(output_.result.status)) finish(context, scans);
      return;
    }
  }

 private:
  bool compensates() const { return input_.settings.run.deskew != settings::DeskewMode::Off; }

  // Once for each number of pairs: scans that are compensated anew are no news to who waits.
  void tell_so_far() {
    if (!input_.tell_so_far || !chosen_.any_left() || !calibration::is_usable(output_.result)) return;
    if (std::exchange(told_pairs_, output_.pairs.size()) != output_.pairs.size())
      input_.tell_so_far(chosen_.so_far(output_.result));
  }

  // False where no scan can be read: the result says so.
  bool register_new(const StageContext& context, ScanStore& scans) {
    work_at(to_match_, output_.pairs, [&](std::vector<motion::Pair>& pairs) {
      find_keyframe_objects(context, scans, pairs, objects_, progress_);
      match_pairs(context, objects_, pairs, progress_);
    });
    report_bad_scans(output_.keyframes, objects_, motion_, output_.findings);
    std::size_t needed = 0;
    const Message unreadable = all_scans_unreadable(objects_, output_.keyframes, output_.pairs, motion_, needed);
    // Where some are left, their scans may be sound.
    if (!unreadable.empty() && !chosen_.any_left()) {
      output_.result = result_without_scans(needed, unreadable);
      return false;
    }
    work_at(to_register_, output_.pairs,
            [&](std::vector<motion::Pair>& pairs) { register_pairs(context, scans, objects_, pairs, progress_); });
    use_odometry(motion_, output_.keyframes, input_.odometry_untold, output_.pairs);
    apply_verdicts(input_.verdicts, output_);
    return true;
  }

  // Prepares the next step: the same pairs, where scans have to be compensated otherwise, or more of them.
  bool goes_on(std::optional<PipelineOutput>& before) {
    const bool beams_err = beams_stand_out();
    if (passes_left_ > 0 && calibration::is_solved(output_.result.status) && (beams_err || scans_are_bent())) {
      before = output_;
      --passes_left_;
      x_ = output_.result.mounting.ins_from_lidar();
      if (beams_err) output_.mended_beams = {output_.beam_nodes, output_.result.beams.errors};
      to_match_.clear();
      to_register_ = all_of(output_.pairs);
      reconsider(output_.pairs);
      return true;
    }
    if (!chosen_.any_left()) return false;
    before = output_;
    to_match_ = to_register_ = chosen_.take_more(input_, motion_, details_, output_, objects_, progress_);
    if (to_match_.empty()) return false;
    if (is_moved(motion_)) set_ins_motion(motion_.nodes(output_.keyframes), output_.pairs);
    reconsider(output_.pairs);
    return true;
  }

  // Whether scans that were compensated or gathered through the X found would be others.
  bool scans_are_bent() const {
    const bool bent = (compensates() && any_distortion(input_, output_.session_uses_sweep)) || any_gathered(output_);
    return bent && (moved_much(x_, output_.result.mounting.ins_from_lidar(), any_gathered(output_)) ||
                    output_.result.position_lag_applied);
  }

  // A drive that leaves a part of X open takes errors of its INS for those of beams (nearly straight KITTI drives).
  bool beams_stand_out() const {
    return output_.result.status == calibration::Status::Ok && output_.result.beams.stands_out_of(output_.mended_beams);
  }

  void finish(const StageContext& context, ScanStore& scans) {
    if (input_.settings.solve.joint_clouds)
      align_all_clouds(context, input_, motion_, scans, objects_, details_, output_, progress_);
    if (!calibration::is_solved(output_.result.status)) return;
    chosen_.report(output_.findings);
    take_sharpness(context, scans, input_.nominal_ins_from_lidar, output_, progress_);
    report_mended_beams(thickness_of_beams(context, input_, output_, progress_), output_);
  }

  const PipelineInput& input_;
  settings::Settings settings_;
  DriveMotion& motion_;
  const SharedField& field_;
  PipelineOutput& output_;
  calibration::PairwiseDetails& details_;
  Progress& progress_;
  ChosenPairs chosen_;
  int passes_left_;
  std::size_t told_pairs_ = 0;
  std::vector<motion::PairIndex> to_match_, to_register_;
  RigidTransform x_ = RigidTransform::Identity();
  std::vector<KeyframeObjects> objects_;
};

}  // namespace

void calibrate_all_scans(const PipelineInput& input, DriveMotion& motion, const SharedField& field,
                         PipelineOutput& output, calibration::PairwiseDetails& details, Progress& progress) {
  std::optional<PipelineOutput> before;
  ScanCalibration(input, motion, field, output, details, progress).run(before);
  if (progress.cancelled() && before) output = std::move(*before);
}

}  // namespace remount::pipeline
