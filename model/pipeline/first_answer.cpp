#include "model/pipeline/first_answer.h"

#include <algorithm>

#include "algorithms/calibration/pairwise/joint_problem.h"
#include "algorithms/calibration/pairwise/pair_judgement.h"
#include "algorithms/search/candidates.h"
#include "model/pipeline/sharpness_stage.h"
#include "model/pipeline/solve_stage.h"
#include "model/results/result_file.h"

namespace remount::pipeline {
namespace {

void describe(const RigidTransform& x, PipelineOutput& output) {
  calibration::CalibrationResult& result = output.result;
  forget_sharpness(output);
  std::erase_if(result.candidates, [](const calibration::Candidate& candidate) {
    return candidate.source == calibration::MountingSource::JointClouds;
  });
  result.pairs_accepted = result.pairs_rejected = 0;
  for (const motion::Pair& pair : output.pairs) {
    result.pairs_accepted += pair.state == motion::PairState::Accepted;
    result.pairs_rejected += pair.state == motion::PairState::Rejected;
  }
  answer_with(x, output);
}

}  // namespace

void answer_with(const RigidTransform& ins_from_lidar, PipelineOutput& output) {
  calibration::CalibrationResult& result = output.result;
  result.mounting.reference_from_sensor = ins_from_lidar;
  calibration::set_residuals(output.pairs, ins_from_lidar);
  double rotation2 = 0.0, translation2 = 0.0;
  for (const motion::Pair& pair : output.pairs) {
    if (pair.state != motion::PairState::Accepted || !motion::unusable_reason(pair).empty()) continue;
    translation2 += pair.residual_translation_m * pair.residual_translation_m;
    rotation2 += pair.residual_rotation_rad * pair.residual_rotation_rad;
  }
  const double count = std::max(1, result.pairs_accepted);
  result.translation_rms_m = std::sqrt(translation2 / count);
  result.rotation_rms_rad = std::sqrt(rotation2 / count);
}

void rank_again(const PipelineInput& input, PipelineOutput& output) {
  search::rank_candidates(output.result.candidates, calibration::accepted_motions(output.pairs), input.settings.range,
                          input.settings.solve);
}

bool solve_at_once(const PipelineInput& input, PipelineOutput& output, const Progress& progress) {
  constexpr int kIterations = 10;
  if (!calibration::is_usable(output.result)) return false;
  std::vector<motion::Pair> pairs = output.pairs;
  for (motion::Pair& pair : pairs)
    if (pair.decided_by == motion::DecidedBy::User) pair.weight = pair.state == motion::PairState::Accepted ? 1.0 : 0.0;
  const std::vector<motion::PairIndex> usable = calibration::usable_pairs(pairs);
  const DriveMotion motion = motion_as_solved(input, output);
  const calibration::PairwiseInput solver = solver_input(input, motion, output);
  const RigidTransform start = output.result.mounting.ins_from_lidar();
  RigidTransform prior = start;
  if (input.nominal_ins_from_lidar) prior.translation() = input.nominal_ins_from_lidar->translation();
  const calibration::JointProblem problem = calibration::make_joint_problem(solver, pairs, usable, prior, start);
  if (problem.terms.size() < 3) return false;
  const calibration::JointSolution solution =
      calibration::solve_joint(problem, output.result.noise, start, kIterations, progress);
  if (!solution.converged) return false;
  describe(calibration::with_kept(solution.ins_from_lidar, start, ~output.result.observed()), output);
  return true;
}

}  // namespace remount::pipeline
