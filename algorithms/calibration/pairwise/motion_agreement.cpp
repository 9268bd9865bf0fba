#include "algorithms/calibration/pairwise/motion_agreement.h"

#include <algorithm>
#include <cmath>

#include "algorithms/calibration/joint/pair_equation.h"
#include "algorithms/calibration/observability.h"
#include "messages/calibration.h"
#include "messages/parameters.h"

namespace remount::calibration {
namespace {

// X with the distances of the LiDAR divided by how many times too far they are. X takes a part of a wrong scale, so
// that what the first X shows of it falls short.
struct Rescaled {
  double lidar_per_ins = 1.0;
  RigidTransform ins_from_lidar = RigidTransform::Identity();
};
Rescaled solve_with_scale(const JointProblem& problem, std::vector<motion::Pair> pairs, const PairwiseDetails& details,
                          double lidar_per_ins, const Progress& progress) {
  constexpr int kRounds = 3, kIterations = 10;
  Rescaled out{1.0, details.joint.ins_from_lidar};
  JointProblem shorter = problem;
  for (int round = 0; round < kRounds && !progress.cancelled(); ++round) {
    for (JointTerm& term : shorter.terms) term.lidar_b_from_lidar_a.translation() /= lidar_per_ins;
    for (motion::Pair& pair : pairs) pair.lidar_b_from_lidar_a.translation() /= lidar_per_ins;
    out.lidar_per_ins *= lidar_per_ins;
    out.ins_from_lidar = solve_joint(shorter, details.noise, out.ins_from_lidar, kIterations, progress).ins_from_lidar;
    lidar_per_ins = motion_agreement(pairs, out.ins_from_lidar).lidar_per_ins;
  }
  return out;
}

void refuse_apart(const MotionAgreement& motions, CalibrationResult& result) {
  result.conclude(Status::Inconsistent, say::motions_contradict({motions.apart_m}, {motions.travel_m}));
  claim_nothing(say::unknown_motions_contradict(), result);
  result.advice = {say::look_at_ins_and_poses()};
}

}  // namespace

double lidar_per_ins_way(const std::vector<motion::Pair>& pairs) {
  constexpr std::size_t kFewest = 8;
  constexpr double kAlike = 0.25, kOtherUnit = 1.25;    // of the middle half, as a share; as in trajectory alignment
  constexpr double kLongestArm_m = 5.0, kByArm = 0.25;  // what a turn adds to a way, as a share of it
  constexpr double kShort = 0.3;                        // of the longest motion: shorter ones may be noise
  double longest_m = 0.0;
  for (const motion::Pair& pair : pairs) longest_m = std::max(longest_m, pair.ins_b_from_ins_a.translation().norm());
  std::vector<double> ratios;
  for (const motion::Pair& pair : pairs) {
    if (!pair.registration.converged || !pair.registration.undetermined.empty()) continue;
    const double by_ins_m = pair.ins_b_from_ins_a.translation().norm(),
                 by_lidar_m = pair.lidar_b_from_lidar_a.translation().norm(),
                 by_arm_m = kLongestArm_m * so3_log(pair.ins_b_from_ins_a.linear()).norm();
    if (by_ins_m > kShort * longest_m && by_arm_m < kByArm * std::max(by_ins_m, by_lidar_m))
      ratios.push_back(by_lidar_m / by_ins_m);
  }
  if (ratios.size() < kFewest) return 1.0;
  std::sort(ratios.begin(), ratios.end());
  const double middle = ratios[ratios.size() / 2];
  const bool alike = ratios[3 * ratios.size() / 4] - ratios[ratios.size() / 4] < kAlike * middle;
  return alike && std::abs(std::log(middle)) > std::log(kOtherUnit) ? middle : 1.0;
}

bool refuse_other_unit(const std::vector<motion::Pair>& pairs, CalibrationResult& result) {
  const double lidar_per_ins = lidar_per_ins_way(pairs);
  if (lidar_per_ins == 1.0 || result.status == Status::Cancelled) return false;
  result.conclude(Status::Inconsistent, lidar_per_ins > 1.0
                                            ? say::motions_of_another_unit_lidar_longer(lidar_per_ins)
                                            : say::motions_of_another_unit_ins_longer(1.0 / lidar_per_ins));
  claim_nothing(say::unknown_other_scales(), result);
  result.advice = {say::look_at_units_of_motions()};
  return true;
}

MotionAgreement motion_agreement(const std::vector<motion::Pair>& pairs, const RigidTransform& ins_from_lidar) {
  double count = 0.0, travelled2 = 0.0, along = 0.0, moved2 = 0.0;
  for (const motion::Pair& pair : pairs) {
    if (pair.state != motion::PairState::Accepted || !pair.registration.undetermined.empty()) continue;
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

void judge_motions(const JointProblem& problem, const std::vector<motion::Pair>& pairs, const PairwiseDetails& details,
                   const SolveOptions& options, const Progress& progress, CalibrationResult& result) {
  constexpr double kApart_m = 0.3, kApartShare = 0.15, kScale = 0.002, kSigmas = 5.0;
  const MotionAgreement motions = motion_agreement(pairs, details.joint.ins_from_lidar);
  const bool apart = motions.apart_m > std::max(kApart_m, kApartShare * motions.travel_m);
  if (apart || !is_solved(result.status)) {
    if (!refuse_other_unit(pairs, result) && is_solved(result.status)) refuse_apart(motions, result);
    return;
  }
  const double scale_error = std::abs(motions.lidar_per_ins - 1.0);
  if (!(scale_error > std::max(kScale, kSigmas * motions.lidar_per_ins_sigma))) return;
  const Rescaled fitting = solve_with_scale(problem, pairs, details, motions.lidar_per_ins, progress);
  add_doubt(difference(details.joint.ins_from_lidar, fitting.ins_from_lidar), say::unknown_distances_differ(), options,
            result);
  // Where nothing is known of X the scale is none that could be trusted either: a wrong INS looks like one.
  result.advice.push_back(is_usable(result) ? say::distances_bias_x(fitting.lidar_per_ins)
                                            : say::look_at_ins_and_poses());
}

}  // namespace remount::calibration
