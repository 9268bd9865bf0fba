#include "algorithms/calibration/motion_agreement.h"

#include <cmath>

#include "algorithms/calibration/observability.h"
#include "algorithms/calibration/pair_equation.h"
#include "messages/calibration.h"
#include "messages/parameters.h"

namespace remount {
namespace {

bool is_solved_result(const CalibrationResult& result) {
  return result.status == Status::Ok || result.status == Status::Degenerate;
}

// X with the distances of the LiDAR divided by how many times too far they are. X takes a part of a wrong scale, so
// that what the first X shows of it falls short.
struct Rescaled {
  double lidar_per_ins = 1.0;
  RigidTransform ins_from_lidar;
};
Rescaled rescaled(const JointProblem& problem, std::vector<Pair> pairs, const PairwiseDetails& details,
                  double lidar_per_ins, const Progress& progress) {
  constexpr int kRounds = 3, kIterations = 10;
  Rescaled out{1.0, details.joint.ins_from_lidar};
  JointProblem shorter = problem;
  for (int round = 0; round < kRounds && !progress.cancelled(); ++round) {
    for (JointTerm& term : shorter.terms) term.lidar_b_from_lidar_a.translation() /= lidar_per_ins;
    for (Pair& pair : pairs) pair.lidar_b_from_lidar_a.translation() /= lidar_per_ins;
    out.lidar_per_ins *= lidar_per_ins;
    out.ins_from_lidar = solve_joint(shorter, details.noise, out.ins_from_lidar, kIterations, progress).ins_from_lidar;
    lidar_per_ins = motion_agreement(pairs, out.ins_from_lidar).lidar_per_ins;
  }
  return out;
}

}  // namespace

MotionAgreement motion_agreement(const std::vector<Pair>& pairs, const RigidTransform& ins_from_lidar) {
  double count = 0.0, travelled2 = 0.0, along = 0.0, moved2 = 0.0;
  for (const Pair& pair : pairs) {
    if (pair.state != PairState::Accepted || !pair.registration.undetermined.empty()) continue;
    const Eigen::Vector3d by_ins = predicted_lidar_motion(pair.ins_b_from_ins_a, ins_from_lidar).translation();
    const Eigen::Vector3d by_lidar = pair.lidar_b_from_lidar_a.translation();
    ++count;
    travelled2 += by_ins.squaredNorm();
    along += by_ins.dot(by_lidar);
    moved2 += by_lidar.squaredNorm();
  }
  MotionAgreement out;
  out.lidar_per_ins_sigma = std::numeric_limits<double>::infinity();
  if (count < 3.0 || !(travelled2 > 0.0)) return out;
  out.travel_m = std::sqrt(travelled2 / count);
  out.apart_m = std::sqrt(std::max(0.0, moved2 - 2.0 * along + travelled2) / count);
  out.lidar_per_ins = along / travelled2;
  const double left2 = std::max(0.0, moved2 - along * along / travelled2);
  out.lidar_per_ins_sigma = std::sqrt(left2 / (3.0 * count - 1.0) / travelled2);
  return out;
}

void judge_motions(const JointProblem& problem, const std::vector<Pair>& pairs, const PairwiseDetails& details,
                   const SolveOptions& options, const Progress& progress, CalibrationResult& result) {
  constexpr double kApart_m = 0.3, kApartShare = 0.15, kScale = 0.002, kSigmas = 5.0;
  const MotionAgreement motions = motion_agreement(pairs, details.joint.ins_from_lidar);
  if (motions.apart_m > std::max(kApart_m, kApartShare * motions.travel_m)) {
    if (!is_solved_result(result)) return;
    result.status = Status::Inconsistent;
    result.message = say::motions_contradict({motions.apart_m}, {motions.travel_m});
    claim_nothing(say::unknown_motions_contradict(), result);
    result.advice = {say::look_at_ins_and_poses()};
    return;
  }
  const double scale_error = std::abs(motions.lidar_per_ins - 1.0);
  if (!is_solved_result(result) || !(scale_error > std::max(kScale, kSigmas * motions.lidar_per_ins_sigma))) return;
  const Rescaled fitting = rescaled(problem, pairs, details, motions.lidar_per_ins, progress);
  add_doubt(difference(details.joint.ins_from_lidar, fitting.ins_from_lidar), say::unknown_distances_differ(), options,
            result);
  result.advice.push_back(say::distances_bias_x(fitting.lidar_per_ins));
}

}  // namespace remount
