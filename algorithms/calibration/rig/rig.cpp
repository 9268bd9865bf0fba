#include "algorithms/calibration/rig/rig.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "algorithms/calibration/joint/pair_equation.h"
#include "algorithms/calibration/linear_solutions.h"
#include "algorithms/calibration/observability.h"
#include "algorithms/calibration/out_of_range.h"
#include "algorithms/calibration/rig/rig_covariance.h"
#include "messages/pairs.h"

namespace remount::calibration {
namespace {

using LidarPair = std::pair<std::size_t, std::size_t>;

LidarPair lidars_of(const CrossPair& cross) { return {cross.lidar_a, cross.lidar_b}; }

// Squared Mahalanobis distance of a cross pair's residual, errors of both INS poses and of the registration included,
// in a form that stands directions that the registration leaves open.
double distance2(const std::vector<RigLidar>& lidars, const CrossPair& cross, const RigProblem& problem,
                 const std::vector<RigidTransform>& x, Vector6d& residual) {
  const RigLidar &a = lidars[cross.lidar_a], &b = lidars[cross.lidar_b];
  const motion::Pair& pair = cross.pair;
  const CrossEquation equation =
      linearise_cross_pair(pair.ins_b_from_ins_a, pair.lidar_b_from_lidar_a, x[cross.lidar_a], x[cross.lidar_b]);
  residual = equation.residual;
  Matrix6d information =
      noise_across(a.details.noise, b.details.noise).registration_information(pair.registration.information);
  const motion::Sweep of_a = sweep_of(a, a.input.nodes[pair.keyframe_a].session),
                      of_b = sweep_of(b, b.input.nodes[pair.keyframe_b].session);
  const double b_after_a_s =
      1e-9 * static_cast<double>(b.keyframe_stamps_ns[pair.keyframe_b] - a.keyframe_stamps_ns[pair.keyframe_a]);
  if (!is_at_once(a, of_a, b, of_b, b_after_a_s)) {
    const Matrix6d of_ins = problem.noise.ins_covariance();
    const Matrix6d at_a = of_ins + a.input.nodes[pair.keyframe_a].between_samples_covariance;
    const Matrix6d at_b = of_ins + b.input.nodes[pair.keyframe_b].between_samples_covariance;
    const Matrix6d in_common = equation.d_a *
                               common_variance(common_share(of_a, of_b, b_after_a_s), at_a, at_b).asDiagonal() *
                               equation.d_b.transpose();
    const Matrix6d by_ins =
        equation.d_a * at_a * equation.d_a.transpose() +
        equation.d_b * (at_b + problem.noise.drift_covariance(pair.gap_s)) * equation.d_b.transpose() + in_common +
        in_common.transpose();
    const Matrix6d sum = symmetric_inverse(by_ins) + information;
    information -= (information * symmetric_solution(sum, information)).eval();
  }
  return std::max(0.0, residual.dot(information * residual));
}

// Squared distances of the cross pairs that can be used, and of every two LiDARs how much larger they are than the
// noise says.
struct CrossDistances {
  std::vector<double> squared;  // of each cross pair; 0 where it cannot be used
  std::map<LidarPair, double> scales2;
};

CrossDistances measure_distances(const std::vector<RigLidar>& lidars, const RigProblem& problem,
                                 const std::vector<RigidTransform>& x, std::vector<CrossPair>& cross_pairs) {
  CrossDistances distances{std::vector<double>(cross_pairs.size(), 0.0), {}};
  std::map<LidarPair, std::vector<double>> by_lidars;
  for (std::size_t i = 0; i < cross_pairs.size(); ++i) {
    motion::Pair& pair = cross_pairs[i].pair;
    if (!motion::unusable_reason(pair).empty()) continue;
    Vector6d residual;
    distances.squared[i] = distance2(lidars, cross_pairs[i], problem, x, residual);
    pair.residual_translation_m = residual.head<3>().norm();
    pair.residual_rotation_rad = residual.tail<3>().norm();
    by_lidars[lidars_of(cross_pairs[i])].push_back(distances.squared[i]);
  }
  for (auto& [two, values] : by_lidars) distances.scales2[two] = residual_scale2(values);
  return distances;
}

void decide(motion::PairState state, Message reason, motion::Pair& pair) {
  pair.state = state;
  pair.decided_by = motion::DecidedBy::Program;
  pair.reason = std::move(reason);
}

// Gives a pair that can be used its weight and, unless the user decided, its state.
void judge_by_score(double score, double threshold, motion::Pair& pair) {
  const bool by_user = pair.decided_by == motion::DecidedBy::User;
  const bool fits = by_user || score <= threshold;
  pair.weight = fits ? 1.0 : 0.0;
  if (by_user) return;
  if (fits)
    decide(motion::PairState::Accepted, {}, pair);
  else
    decide(motion::PairState::Rejected,
           say::pair_contradicts_other_lidar({pair.residual_translation_m}, {pair.residual_rotation_rad}, score), pair);
}

// Gives each cross pair residual, weight, state and reason under the mountings; true where a state or a scale changed.
bool judge_cross_pairs(const std::vector<RigLidar>& lidars, const RigProblem& problem,
                       const std::vector<RigidTransform>& x, std::vector<CrossPair>& cross_pairs,
                       std::vector<double>& scale2) {
  CrossDistances distances = measure_distances(lidars, problem, x, cross_pairs);
  bool changed = false;
  for (std::size_t i = 0; i < cross_pairs.size(); ++i) {
    motion::Pair& pair = cross_pairs[i].pair;
    pair.weight = 0.0;
    const Message unusable = motion::unusable_reason(pair);
    const bool by_user = pair.decided_by == motion::DecidedBy::User;
    if (!unusable.empty() && !by_user && pair.state != motion::PairState::Rejected)
      decide(motion::PairState::Rejected, unusable, pair);
    if (!unusable.empty() || (by_user && pair.state == motion::PairState::Rejected)) continue;
    const double scale = distances.scales2[lidars_of(cross_pairs[i])];
    constexpr double kSame = 0.02;
    const motion::PairState before = pair.state;
    judge_by_score(sigma_equivalent(distances.squared[i] / scale),
                   lidars[cross_pairs[i].lidar_a].input.options.outlier_threshold, pair);
    changed = changed || pair.state != before || std::abs(scale - scale2[i]) > kSame * scale;
    scale2[i] = scale;
  }
  return changed;
}

// Whole steps along heights that hardly show may go to and fro for ever, and mean nothing.
bool only_heights_move(const Eigen::VectorXd& step, Eigen::Index lidars) {
  constexpr double kSettled_m = 1e-4, kSettled_rad = 1e-6;
  for (Eigen::Index l = 0; l < lidars; ++l) {
    const Vector6d of_lidar = step.segment<6>(6 * l);
    if (of_lidar.head<2>().norm() > kSettled_m || of_lidar.tail<3>().norm() > kSettled_rad) return false;
  }
  return true;
}

bool solve_from(const RigProblem& problem, const Progress& progress, State& state) {
  const Layout layout = layout_of(problem.joint, problem.noise);
  Eliminated step;
  state = start_state(problem.joint, layout, std::move(state.ins_from_lidars));
  const bool converged =
      solve_by_gauss_newton(problem.joint, problem.noise, layout, kJointIterations, progress, state, step);
  return step.valid && !progress.cancelled() && (converged || only_heights_move(step.shared_step, layout.lidars));
}

std::vector<std::vector<motion::LidarIndex>> joined_groups(std::size_t lidars,
                                                           const std::vector<CrossPair>& cross_pairs) {
  std::vector<std::size_t> group_of(lidars);
  std::iota(group_of.begin(), group_of.end(), std::size_t{0});
  for (const CrossPair& cross : cross_pairs) {
    if (!(cross.pair.weight > 0.0)) continue;
    const std::size_t kept = group_of[cross.lidar_a], joined = group_of[cross.lidar_b];
    std::replace(group_of.begin(), group_of.end(), joined, kept);
  }
  std::map<std::size_t, std::vector<motion::LidarIndex>> groups;
  for (motion::LidarIndex l; l < lidars; ++l) groups[group_of[l]].push_back(l);
  std::vector<std::vector<motion::LidarIndex>> out;
  for (auto& [first, group] : groups) out.push_back(std::move(group));
  return out;
}

Eigen::Matrix<double, 12, 12> covariance_of_two(const Eigen::MatrixXd& covariance, std::size_t a, std::size_t b) {
  const Eigen::Index at_a = signed_of(6 * a), at_b = signed_of(6 * b);
  Eigen::Matrix<double, 12, 12> two;
  two << covariance.block<6, 6>(at_a, at_a), covariance.block<6, 6>(at_a, at_b), covariance.block<6, 6>(at_b, at_a),
      covariance.block<6, 6>(at_b, at_b);
  return two;
}

Eigen::MatrixXd without_correlations(const Eigen::MatrixXd& covariance) {
  Eigen::MatrixXd blocks = Eigen::MatrixXd::Zero(covariance.rows(), covariance.cols());
  for (Eigen::Index at = 0; at < covariance.rows(); at += 6)
    blocks.block<6, 6>(at, at) = covariance.block<6, 6>(at, at);
  return blocks;
}

// What cross pairs say of two LiDARs against what the INS does: of two independent answers the better and the mean of
// both are known. What the INS does wrong to both may cancel between them, what registrations do does not, and nobody
// knows their shares: half of each. docs/maths/rig.md (G8)
RigAgreement agreement_of(std::size_t a, std::size_t b, const std::vector<RigidTransform>& by_ins,
                          const std::vector<RigidTransform>& by_all, const RigCovariance& covariance) {
  RigAgreement agreement{motion::LidarIndex(a), motion::LidarIndex(b)};
  const auto jacobian = relative_jacobian(by_all[a], by_all[b]);
  const Vector6d moved = difference(relative_mounting(by_ins[a], by_ins[b]), relative_mounting(by_all[a], by_all[b]));
  const auto variances = [&](const Eigen::MatrixXd& of) {
    return Vector6d((jacobian * covariance_of_two(of, a, b) * jacobian.transpose()).diagonal());
  };
  const Vector6d ins = variances(covariance.within), all = variances(covariance.all),
                 ins_apart = 0.5 * (ins + variances(without_correlations(covariance.within)));
  for (int i = 0; i < 6; ++i) {
    const double gain = 1.0 - all[i] / ins[i];
    constexpr double kLeastGain = 0.05;  // cross pairs say next to nothing beside the INS
    if (!(gain > kLeastGain)) {
      agreement.sigma[i] = std::numeric_limits<double>::infinity();
      continue;
    }
    agreement.difference[i] = moved[i] / gain;
    agreement.sigma[i] = std::sqrt(ins_apart[i] + all[i] / gain);
    agreement.most_sigmas = std::max(agreement.most_sigmas, std::abs(agreement.difference[i]) / agreement.sigma[i]);
  }
  return agreement;
}

// What a LiDAR's own result withdrew although its pairs tell it: by a clock, sweeps, a tape that contradicts. Others
// bear it with the same scans, and do not mend it.
void withdraw_doubted(const RigLidar& lidar, CalibrationResult& result) {
  const Vector6d limits = observation_limits(lidar.input.options);
  const Matrix6d by_pairs = parameter_covariance(lidar.alone.mounting.ins_from_lidar(),
                                                 lidar.details.pairs_covariance + lidar.details.common_covariance);
  for (const Parameter parameter : kParameters) {
    const Knowledge& alone = lidar.alone.known[parameter];
    const int row = row_of(parameter);
    if (!alone.observed && by_pairs(row, row) < limits[row] * limits[row])
      result.withdraw(parameter, alone.why_not_observed);
  }
}

// Where no height of LiDARs that are joined is known, they stay about where each has it: what is left of the drive's
// own word moves all of them alike, and is worth nothing.
void keep_open_heights(const std::vector<RigLidar>& lidars, const RigCovariance& covariance, RigSolution& solution) {
  for (const std::vector<motion::LidarIndex>& group : solution.groups) {
    double away_m = 0.0;
    bool known = false;
    for (const motion::LidarIndex l : group) {
      const Eigen::Index z = signed_of(6 * l + 2);
      const double limit_m = lidars[l].input.options.max_translation_sigma_m;
      known = known || covariance.all(z, z) < limit_m * limit_m;
      away_m +=
          solution.ins_from_lidars[l].translation().z() - lidars[l].alone.mounting.ins_from_lidar().translation().z();
    }
    if (known) continue;
    for (const motion::LidarIndex l : group)
      solution.ins_from_lidars[l].translation().z() -= away_m / static_cast<double>(group.size());
  }
}

// What was measured of a LiDAR that it is joined to tells what a LiDAR's own drive does not.
ParameterSet told_by_measured(const std::vector<RigLidar>& lidars, const std::vector<motion::LidarIndex>& joined,
                              const RigLidar& lidar, const CalibrationResult& joint) {
  ParameterSet told = lidar.alone.measured();
  for (const Parameter parameter : kParameters)
    if (joint.known[parameter].observed && !lidar.alone.known[parameter].observed &&
        std::ranges::any_of(joined, [&](motion::LidarIndex l) { return lidars[l].alone.known[parameter].measured; }))
      told.insert(parameter);
  return told;
}

CalibrationResult result_of(const std::vector<RigLidar>& lidars, const std::vector<motion::LidarIndex>& joined,
                            motion::LidarIndex l, const RigidTransform& ins_from_lidar, const Matrix6d& covariance) {
  const RigLidar& lidar = lidars[l];
  CalibrationResult result = lidar.alone;
  // What to drive follows from what is observed jointly; what a clock or a tape withdraws, no drive mends.
  std::erase_if(result.advice, is_advice_on_motion);
  result.mounting.reference_from_sensor =
      make_rigid(nearest_rotation(ins_from_lidar.linear()), ins_from_lidar.translation());
  MotionSummary motion = summarise_motion(lidar.pairs);
  motion.tilt_assumed = assumed_tilt_of(lidar.input.sessions).least_rad > 0.0;
  judge_parameters(covariance, motion, lidar.input.options, result);
  withdraw_doubted(lidar, result);
  result.set_measured(told_by_measured(lidars, joined, lidar, result));
  const Status status = result.observed().is_all() ? Status::Ok : Status::Degenerate;
  if (is_solved(result.status)) result.conclude(status, solved_message(result));
  if (Message outside = outside_range(result.mounting.ins_from_lidar(), lidar.input.range); !outside.empty())
    refuse_out_of_range(std::move(outside), result);
  return result;
}

void describe_rig(const std::vector<RigLidar>& lidars, const RigCovariance& covariance, RigSolution& solution) {
  const std::vector<RigidTransform>& x = solution.ins_from_lidars;
  solution.covariance = covariance.all;
  for (motion::LidarIndex l; l < lidars.size(); ++l) {
    const Eigen::Index at = signed_of(6 * l);
    const auto joined = std::ranges::find_if(
        solution.groups, [&](const auto& group) { return std::ranges::find(group, l) != group.end(); });
    solution.results.push_back(result_of(lidars, *joined, l, x[l], covariance.all.block<6, 6>(at, at)));
  }
  for (motion::LidarIndex a; a < lidars.size(); ++a)
    for (motion::LidarIndex b(a + 1); b < lidars.size(); ++b) {
      solution.relatives.push_back(describe_relative(x[a], x[b], covariance_of_two(covariance.all, a, b),
                                                     observation_limits(lidars[a].input.options)));
      solution.relatives.back().lidar_a = a;
      solution.relatives.back().lidar_b = b;
    }
}

RigidTransform predicted_motion(const CrossPair& cross, const RigProblem& problem, const State& state) {
  const auto corrected = [&](motion::KeyframeIndex node) {
    return moved_in_body(problem.joint.nodes[node].local_from_ins, state.errors[node]);
  };
  const RigidTransform a = corrected(problem.nodes_of[cross.lidar_a][cross.pair.keyframe_a]),
                       b = corrected(problem.nodes_of[cross.lidar_b][cross.pair.keyframe_b]);
  return predicted_cross_motion(b.inverse() * a, state.ins_from_lidars[cross.lidar_a],
                                state.ins_from_lidars[cross.lidar_b]);
}

}  // namespace

RigSolution solve_rig(const std::vector<RigLidar>& lidars, std::vector<CrossPair>& cross_pairs,
                      const Progress& progress) {
  RigSolution solution;
  State state;
  for (const RigLidar& lidar : lidars) state.ins_from_lidars.push_back(lidar.alone.mounting.ins_from_lidar());
  RigProblem problem = make_rig_problem(lidars, cross_pairs, state.ins_from_lidars);
  if (!solve_from(problem, progress, state)) return solution;
  const std::vector<RigidTransform> by_ins = state.ins_from_lidars;
  std::vector<double> scale2(cross_pairs.size(), 0.0);
  constexpr int kMostRounds = 8;
  for (int round = 0; round < kMostRounds; ++round) {
    if (!judge_cross_pairs(lidars, problem, state.ins_from_lidars, cross_pairs, scale2)) break;
    put_cross_terms(lidars, cross_pairs, scale2, problem);
    if (!solve_from(problem, progress, state)) return solution;
  }
  const std::optional<RigInformation> information = rig_information(problem, state);
  if (!information || progress.cancelled()) return solution;
  const RigCovariance covariance = rig_covariance(lidars, problem, *information, by_ins, state.ins_from_lidars);
  for (std::size_t l = 0; l < lidars.size(); ++l)
    solution.ins_from_lidars.push_back(
        perturb(state.ins_from_lidars[l], covariance.moved.segment<6>(signed_of(6 * l))));
  solution.groups = joined_groups(lidars.size(), cross_pairs);
  keep_open_heights(lidars, covariance, solution);
  describe_rig(lidars, covariance, solution);
  std::map<LidarPair, std::size_t> used;
  for (const CrossPair& cross : cross_pairs) used[lidars_of(cross)] += cross.pair.weight > 0.0 ? 1 : 0;
  for (const auto& [two, count] : used)
    if (count > 0)
      solution.agreements.push_back(agreement_of(two.first, two.second, by_ins, solution.ins_from_lidars, covariance));

  for (const CrossPair& cross : cross_pairs) solution.cross_motions.push_back(predicted_motion(cross, problem, state));
  solution.solved = true;
  return solution;
}

}  // namespace remount::calibration
