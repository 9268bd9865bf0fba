#include "algorithms/calibration/pairwise/uncertainty.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <set>

#include "algorithms/calibration/joint/shared_errors.h"
#include "algorithms/calibration/linear_solutions.h"
#include "algorithms/calibration/observability.h"
#include "algorithms/calibration/pairwise/bootstrap.h"
#include "algorithms/calibration/pairwise/clock_estimate.h"
#include "algorithms/calibration/pairwise/few_pairs.h"
#include "algorithms/calibration/pairwise/noise_prior.h"
#include "algorithms/calibration/pairwise/open_rotation.h"
#include "algorithms/calibration/pairwise/session_agreement.h"
#include "algorithms/calibration/pairwise/sigma_budget.h"
#include "messages/calibration.h"
#include "messages/parameters.h"

namespace remount::calibration {
namespace {

// Mean of [v]x' M [v]x over isotropic noise v of unit variance. docs/maths/covariance.md (C9)
Eigen::Matrix3d cross_noise(const Eigen::Matrix3d& m) { return m.trace() * Eigen::Matrix3d::Identity() - m; }

// Logs that do not state their errors come from vehicles with springs, flexing mounts and filters: turns this small
// follow the braking and steering that cause them too closely to show a lever arm.
constexpr double kUndeclaredAttitude_rad = 0.005;

// Square of the turns that may not be what they seem (rad^2, each axis). Motions computed elsewhere, perhaps exactly,
// are doubted as far as they contradict each other.
double doubtful_attitude2(const PairwiseInput& input, const std::vector<motion::Pair>& pairs, const RigidTransform& x) {
  if (input.motions_only) {
    double sum = 0.0, count = 0.0;
    for (const motion::Pair& pair : pairs) {
      if (!(pair.weight > 0.0) || pair.state != motion::PairState::Accepted) continue;
      sum += motion_residual(pair.ins_b_from_ins_a, pair.lidar_b_from_lidar_a, x).tail<3>().squaredNorm() / 3.0;
      count += 1.0;
    }
    return count > 0.0 ? sum / count : 0.0;
  }
  const bool declared = std::all_of(input.sessions.begin(), input.sessions.end(), [](const SessionNoise& session) {
    return std::isfinite(session.attitude_white_sigma_rad);
  });
  return declared ? 0.0 : kUndeclaredAttitude_rad * kUndeclaredAttitude_rad;
}

SpuriousInformation spurious_information(const PairwiseInput& input, const std::vector<motion::Pair>& pairs,
                                         const RigidTransform& x, const NoiseModel& noise) {
  SpuriousInformation out;
  const Matrix6d white = 2.0 * noise.ins_covariance();
  const double doubtful2 = doubtful_attitude2(input, pairs, x);
  const PairTilts tilts_rad = assumed_tilts_rad(input, pairs);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const motion::Pair& pair = pairs[i];
    if (!(pair.weight > 0.0) || pair.state != motion::PairState::Accepted) continue;
    const PairEquation equation = linearise_pair(pair.ins_b_from_ins_a, pair.lidar_b_from_lidar_a, x);
    const Matrix6d information = residual_information(pair, equation, noise, tilts_rad[i]);
    out.apparent += equation.d_x.transpose() * information * equation.d_x;
    const Eigen::Matrix3d to_ins = x.linear();
    const Eigen::Matrix3d translation = to_ins * information.topLeftCorner<3, 3>() * to_ins.transpose();
    const Eigen::Matrix3d rotation = to_ins * information.bottomRightCorner<3, 3>() * to_ins.transpose();
    const Matrix6d errors = white + noise.drift_covariance(std::abs(pair.gap_s));
    const double position2 = errors(0, 0), attitude2 = std::max(errors(3, 3), doubtful2);
    out.spurious.topLeftCorner<3, 3>() += attitude2 * cross_noise(translation);
    out.spurious.bottomRightCorner<3, 3>() += attitude2 * cross_noise(rotation) + position2 * cross_noise(translation);
  }
  return out;
}

// Where resampling whole blocks of time scatters X more than the noise model allows, errors are correlated in ways that
// the model does not hold: what they scatter counts then.
Matrix6d inflated_by_bootstrap(const Matrix6d& covariance, const Matrix6d& bootstrap) {
  const Vector6d factors = bootstrap.diagonal().cwiseQuotient(covariance.diagonal()).cwiseMax(1.0).cwiseSqrt();
  return factors.asDiagonal() * covariance * factors.asDiagonal();
}

// Of `pairs`, and what is common to all of them. docs/maths/covariance.md (C19)
Matrix6d with_common_to_all_pairs(const Matrix6d& pairs, const Eigen::MatrixXd& responses, bool narrow_field,
                                  std::size_t sessions, SigmaBudget& budget) {
  // Surroundings of other drives are others.
  Matrix6d covariance =
      pairs + registration_limits(narrow_field) / static_cast<double>(std::max<std::size_t>(1, sessions));
  budget.reach(covariance, say::sigma_part_surroundings());
  covariance += responses.leftCols<1>() * responses.leftCols<1>().transpose();
  budget.reach(covariance, say::sigma_part_range_scale());
  const Eigen::MatrixXd shared = responses.rightCols(responses.cols() - 1);
  covariance += shared * shared.transpose();
  budget.reach(covariance, say::sigma_part_shared());
  return covariance;
}

// By how much the errors of X are larger than what the pairs' own say.
struct Widenings {
  double gathered = 1.0, by_few = 1.0, by_sessions = 1.0;
  double all() const { return gathered * by_few * by_sessions; }
};

// The covariance that pairs give with what is known beside them.
Matrix6d covariance_by_steps(const JointProblem& problem, const PairwiseDetails& details, const Matrix6d& trusted,
                             const Matrix6d& beside_pairs, const Widenings& wider, const Progress& progress,
                             SigmaBudget& budget) {
  const auto widened = [&](const Matrix6d& information, double factor) {
    return symmetric_inverse(Matrix6d(information / (factor * factor) + beside_pairs));
  };
  begin_with_sources(problem, details, widened(details.joint.information, 1.0), progress, budget);
  budget.reach(widened(trusted, 1.0), say::sigma_part_small_turns());
  budget.reach(widened(trusted, wider.gathered), say::sigma_part_gathered());
  budget.reach(widened(trusted, wider.gathered * wider.by_few), say::sigma_part_few());
  const Matrix6d covariance = widened(trusted, wider.all());
  budget.reach(covariance, say::sigma_part_sessions());
  return covariance;
}

// Lags that are unknowns of X move it by more than the solution says. docs/maths/clocks.md (K13)
Matrix6d of_doubtful_lags(const JointProblem& problem, const JointSolution& joint) {
  Matrix6d covariance = Matrix6d::Zero();
  for (motion::SessionIndex s; s < joint.moved_by_position_lag.size(); ++s) {
    const double sigma_s = joint.position_lag_sigma_s[s];
    const double doubted_s = doubted_lag_sigma_s(problem.nodes, s, sigma_s, problem.session_position_lag_sigma_s[s],
                                                 problem.lidar().narrow_field);
    const Vector6d& moved = joint.moved_by_position_lag[s];
    covariance += (doubted_s * doubted_s - sigma_s * sigma_s) * moved * moved.transpose();
  }
  return covariance;
}

// Sessions that a pair was accepted of.
std::size_t sessions_used(const JointProblem& problem) {
  std::set<motion::SessionIndex> sessions;
  for (const JointTerm& term : problem.terms)
    if (term.weight > 0.0) sessions.insert(problem.nodes[term.node_a].session);
  return sessions.size();
}

// How X moves where all distances that the lidar measures are too long by `kScale`. docs/maths/covariance.md (C19)
Vector6d response_to_scale(const JointProblem& problem, const PairwiseDetails& details, const Progress& progress) {
  constexpr double kScale = 1.5e-5, kEnlarged = 1e-3;
  JointProblem longer = problem;
  for (JointTerm& term : longer.terms) term.lidar_b_from_lidar_a.translation() *= 1.0 + kEnlarged;
  const JointSolution solution = solve_joint(longer, details.noise, details.joint.ins_from_lidar, 8, progress);
  return kScale / kEnlarged * difference(details.joint.ins_from_lidar, solution.ins_from_lidar);
}

// How X moves with what is wrong alike in all that the lidar says; columns of 1 sigma each.
Eigen::MatrixXd responses_to_common_errors(const PairwiseInput& input, const JointProblem& problem,
                                           const PairwiseDetails& details, const Progress& progress) {
  const Vector6d scale = response_to_scale(problem, details, progress);
  if (!input.pairs_share_scans) return scale;
  Eigen::MatrixXd responses(6, 13);
  responses << scale, shared_errors(problem, details.noise, details.joint).responses;
  return responses;
}

void add_disagreement_advice(CalibrationResult& result) {
  if (!(result.session_disagreement > kSessionsContradict)) return;
  result.advice.push_back(say::sessions_contradict(result.session_disagreement));
}

void add_advice_on_few(double by_few, int motions, CalibrationResult& result) {
  constexpr double kWorthAWord = 1.2;
  if (!(by_few > kWorthAWord)) return;
  result.advice.push_back(say::few_pairs_widen_sigma(motions, by_few));
}

}  // namespace

// Measured on simulated drives (docs/adr/0006-honest-sigma.md). Most about the direction of travel, across which the
// least ground is seen; a LiDAR that looks one way sees little of it in any other. docs/maths/covariance.md (C19)
Matrix6d registration_limits(bool narrow_field) {
  constexpr double kNarrow_rad = 6e-5, kYaw_rad = 1.75e-5;
  const double displaced_m = narrow_field ? 1.2e-3 : 3.6e-4;
  const double roll_rad = narrow_field ? kNarrow_rad : 3e-5, pitch_rad = narrow_field ? kNarrow_rad : 1.4e-5;
  Vector6d sigmas;
  sigmas << displaced_m, displaced_m, displaced_m, roll_rad, pitch_rad, kYaw_rad;
  return sigmas.cwiseAbs2().asDiagonal();
}

Matrix6d residual_information(const motion::Pair& pair, const PairEquation& equation, const NoiseModel& noise,
                              double tilt_rad) {
  Matrix6d ins = noise.ins_covariance();
  ins.diagonal().segment<2>(3).array() += tilt_rad * tilt_rad;
  const Matrix6d ins_and_drift = ins + noise.drift_covariance(std::abs(pair.gap_s));
  const Matrix6d from_ins =
      equation.d_a * ins * equation.d_a.transpose() + equation.d_b * ins_and_drift * equation.d_b.transpose();
  const Matrix6d ins_information = symmetric_inverse(from_ins);
  const Matrix6d sum = ins_information + noise.registration_information(pair.registration.information);
  return ins_information - ins_information * symmetric_solution(sum, ins_information);
}

bool settles_where_observed(const PairwiseInput& input, const std::vector<motion::Pair>& pairs,
                            const PairwiseDetails& details) {
  constexpr double kSettled2 = 1e-3;  // squared sigmas, as in the joint solution
  const JointSolution& joint = details.joint;
  if (!joint.information.allFinite() || joint.information.isZero(0.0)) return false;
  const Vector6d step = joint.last_step.cwiseQuotient(observation_limits(input.options));
  double left2 = 0.0;
  for (const ObservabilityDirection& direction :
       observed_directions(joint.information, spurious_information(input, pairs, joint.ins_from_lidar, details.noise),
                           summarise_motion(pairs), input.options)) {
    const double along = direction.direction.dot(step) / direction.sigma;
    if (direction.observed) left2 += along * along;
  }
  return left2 < kSettled2;
}

Matrix6d describe_uncertainty(const PairwiseInput& input, const std::vector<motion::Pair>& pairs,
                              const JointProblem& problem, const std::vector<SessionAnswer>& answers,
                              PairwiseDetails& details, const Progress& progress, CalibrationResult& result) {
  const RigidTransform& x = details.joint.ins_from_lidar;
  MotionSummary motion = summarise_motion(pairs);
  const AssumedTilt tilt = assumed_tilt_of(input.sessions);
  motion.tilt_assumed = tilt.least_rad > 0.0;
  result.directions = observed_directions(details.joint.information,
                                          spurious_information(input, pairs, x, details.noise), motion, input.options);
  const SessionScatter scatter = session_scatter(answers, input.options);
  result.session_disagreement = scatter.ratio;
  const double log_spread = noise_prior(input).log_spread.front();
  const int motions = independent_motions(problem);
  const double by_few = widening_of_few(motions, log_spread);
  const Widenings widenings{input.sigma_factor, by_few, widening(scatter, log_spread)};
  const double wider = widenings.all();
  const Matrix6d trusted = trusted_information(result.directions, input.options);
  const Matrix6d by_pairs = trusted / (wider * wider);
  const Matrix6d prior = weak_prior(input.nominal_ins_from_lidar.has_value());
  const Matrix6d beside_pairs = prior + input.measured.information(x);
  SigmaBudget budget(x);
  Matrix6d covariance = covariance_by_steps(problem, details, trusted, beside_pairs, widenings, progress, budget);
  if (tilt.most_rad > 0.0) covariance += beyond_first_order(x, covariance, tilt.most_rad);
  budget.reach(covariance, say::sigma_part_tilt());
  covariance += of_doubtful_lags(problem, details.joint);
  budget.reach(covariance, say::sigma_part_lags());
  const MeasurementPulls pulls(problem, details.noise, details.joint, progress);
  const Matrix6d bootstrap = bootstrap_covariance(blocks_of_time(input, pulls.of_mounting()), 6);
  details.pairs_covariance = inflated_by_bootstrap(covariance, bootstrap);
  budget.reach(details.pairs_covariance, say::sigma_part_blocks());
  const Matrix6d with_common =
      with_common_to_all_pairs(details.pairs_covariance, responses_to_common_errors(input, problem, details, progress),
                               input.narrow_field, sessions_used(problem), budget);
  details.common_covariance = with_common - details.pairs_covariance;
  judge_parameters(with_common, motion, input.options, result);
  budget.write(result);
  // Where the INS is taken to be level, that is what the distrust of small turns is about; its error is in the
  // solution.
  const Matrix6d by_turns = motion.tilt_assumed ? Matrix6d(details.joint.information / (wider * wider)) : by_pairs;
  if (!input.nominal_ins_from_lidar)
    widen_angles(
        turned_by_open_rotation(x, by_turns + input.measured.information(x) + level_information(input.up_in_lidar, x)),
        input.options, result);
  add_disagreement_advice(result);
  add_advice_on_few(by_few, motions, result);
  // Resampling pairs says nothing of what only a measurement tells.
  const Matrix6d pairs_alone = parameter_covariance(x, symmetric_inverse(by_pairs + prior));
  const Matrix6d parameters = parameter_covariance(x, bootstrap);
  const Vector6d limits = observation_limits(input.options);
  for (const Parameter parameter : kParameters) {
    const int i = row_of(parameter);
    Knowledge& known = result.known[parameter];
    const bool seen_by_pairs = known.observed && pairs_alone(i, i) < limits[i] * limits[i];
    known.bootstrap_sigma =
        seen_by_pairs && parameters(i, i) > 0.0 ? std::optional(std::sqrt(parameters(i, i))) : std::nullopt;
  }
  return covariance;
}

void add_doubts(const PairwiseInput& input, const Matrix6d& believed, PairwiseDetails& details,
                CalibrationResult& result) {
  Matrix6d covariance = believed;
  // A tape that is right does not contradict pairs that are known to be biased.
  if (input.clock_bias) covariance += *input.clock_bias * input.clock_bias->transpose();
  const Vector6d by_north = turned_by_north(details.joint.ins_from_lidar, north_sigma_of(input.sessions));
  covariance += by_north * by_north.transpose();
  for (const Contradiction& one :
       contradictions(input.measured, details.joint.ins_from_lidar, details.joint.covariance, covariance)) {
    add_doubt(one.doubt, say::unknown_measured_contradicts(), input.options, result);
    details.doubts += one.doubt * one.doubt.transpose();
    result.advice.push_back(one.text);
  }
  if (!by_north.isZero(0.0)) add_doubt(by_north, say::unknown_north(), input.options, result);
  if (!input.clock_bias) return;
  add_doubt(*input.clock_bias, say::unknown_clocks_differ(), input.options, result);
  details.doubts += *input.clock_bias * input.clock_bias->transpose();
  result.advice.push_back(input.options.apply_time_offset == ClockOffsetUse::No ? say::clocks_bias_x()
                                                                                : say::clocks_do_not_settle());
}

}  // namespace remount::calibration
