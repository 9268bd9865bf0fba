#include "algorithms/calibration/pairwise.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "algorithms/calibration/pair_equation.h"
#include "algorithms/calibration/robust_start.h"
#include "algorithms/calibration/uncertainty.h"
#include "algorithms/search/candidates.h"
#include "algorithms/trajectory/screw.h"

namespace remount {
namespace {

constexpr int kFewestPairs = 3;
constexpr int kIterations = 30;  // of the joint solution; a handful where everything is observed

double known_or(double value, double otherwise) { return std::isfinite(value) ? value : otherwise; }

struct NoisePrior {
  NoiseModel expected;
  std::array<double, 7> log_spread{};
};

// Declared sigmas are believed within some 30%, assumed ones within a factor of three to five. Data that declare their
// white noise and no drift have none.
NoisePrior noise_prior(const PairwiseInput& input) {
  NoisePrior prior;
  NoiseModel sum;
  sum.ins_position_sigma_m = sum.ins_attitude_sigma_rad = 0.0;
  bool declared = true;
  for (const SessionNoise& session : input.sessions) {
    const bool here = std::isfinite(session.position_white_sigma_m) && std::isfinite(session.attitude_white_sigma_rad);
    declared = declared && here;
    const SolveOptions& assumed = input.options;
    sum.ins_position_sigma_m += known_or(session.position_white_sigma_m, assumed.ins_position_sigma_m);
    sum.ins_attitude_sigma_rad +=
        known_or(session.attitude_white_sigma_rad, degrees_to_radians(assumed.ins_attitude_sigma_deg));
    sum.ins_position_drift += known_or(session.position_drift, here ? 0.0 : assumed.ins_position_drift_m);
    sum.ins_attitude_drift +=
        known_or(session.attitude_drift, here ? 0.0 : degrees_to_radians(assumed.ins_attitude_drift_deg));
  }
  const double sessions = std::max<double>(1.0, static_cast<double>(input.sessions.size()));
  // No INS is exact, whatever its log says.
  constexpr double kLeastPosition_m = 1e-4, kLeastAttitude_rad = 1e-6;
  prior.expected.ins_position_sigma_m = std::max(kLeastPosition_m, sum.ins_position_sigma_m / sessions);
  prior.expected.ins_attitude_sigma_rad = std::max(kLeastAttitude_rad, sum.ins_attitude_sigma_rad / sessions);
  prior.expected.ins_position_drift = sum.ins_position_drift / sessions;
  prior.expected.ins_attitude_drift = sum.ins_attitude_drift / sessions;
  const double ins_spread = declared ? 0.3 : 1.5;
  const double position_drift_spread = prior.expected.ins_position_drift > 0.0 ? 0.7 : 0.0;
  const double attitude_drift_spread = prior.expected.ins_attitude_drift > 0.0 ? 0.7 : 0.0;
  prior.log_spread = {ins_spread, ins_spread, 1.0, 1.0, 1.0, position_drift_spread, attitude_drift_spread};
  return prior;
}

NoiseModel scaled(NoiseModel noise, double factor) {
  noise.ins_position_sigma_m *= factor;
  noise.ins_attitude_sigma_rad *= factor;
  noise.registration_scale *= factor;
  noise.registration_floor_m *= factor;
  noise.registration_floor_rad *= factor;
  noise.ins_position_drift *= factor;
  noise.ins_attitude_drift *= factor;
  return noise;
}

std::vector<int> usable_pairs(const std::vector<Pair>& pairs) {
  std::vector<int> usable;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const Pair& pair = pairs[i];
    if (pair.state == PairState::Rejected && pair.decided_by == DecidedBy::User) continue;
    if (!pair.registration.attempted || !pair.registration.failure.empty()) continue;
    usable.push_back(static_cast<int>(i));
  }
  return usable;
}

// Sigma of the two screw invariants from the noise of P and Q.
void test_screws(std::vector<Pair>& pairs, const std::vector<int>& usable, const NoiseModel& noise, double threshold) {
  const double rotation_sigma = std::hypot(std::sqrt(2.0) * noise.ins_attitude_sigma_rad, noise.registration_floor_rad);
  const double translation_sigma = std::hypot(std::sqrt(2.0) * noise.ins_position_sigma_m, noise.registration_floor_m);
  for (const int i : usable) {
    Pair& pair = pairs[static_cast<std::size_t>(i)];
    pair.screw =
        screw_test(pair.ins_b_from_ins_a, pair.lidar_b_from_lidar_a, rotation_sigma, translation_sigma, threshold);
  }
}

// Normal score of a chi-square distance of six degrees of freedom (Fisher).
double sigma_equivalent(double distance2) { return std::sqrt(2.0 * distance2) - std::sqrt(11.0); }

std::string outlier_reason(const Pair& pair, double score) {
  char text[200];
  std::snprintf(text, sizeof text, "contradicts the INS motion by %.3f m, %.3f deg (%.1f sigma)%s",
                pair.residual_translation_m, radians_to_degrees(pair.residual_rotation_rad), score,
                pair.screw.passed ? "" : "; screw test failed");
  return text;
}

// How much larger the typical residual of all usable pairs is than the noise model says, at least 1. Judging by the
// model alone would spiral: fewer pairs, less noise, fewer pairs.
double residual_scale2(const std::vector<double>& distances2) {
  constexpr double kMedianChi2 = 5.348;  // of six degrees of freedom
  std::vector<double> sorted = distances2;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  return std::max(1.0, *middle / kMedianChi2);
}

// Residuals, weights and, unless the user decided, states of all usable pairs under X. Returns how many states changed.
int judge_pairs(std::vector<Pair>& pairs, const std::vector<int>& usable, const RigidTransform& x,
                const NoiseModel& noise, double threshold) {
  int changed = 0;
  std::vector<double> distances2;
  for (const int i : usable) distances2.push_back(pair_distance2(pairs[static_cast<std::size_t>(i)], x, noise));
  const double scale2 = residual_scale2(distances2);
  for (std::size_t k = 0; k < usable.size(); ++k) {
    Pair& pair = pairs[static_cast<std::size_t>(usable[k])];
    const Vector6d residual = difference(pair.lidar_b_from_lidar_a, predicted_lidar_motion(pair.ins_b_from_ins_a, x));
    pair.residual_translation_m = residual.head<3>().norm();
    pair.residual_rotation_rad = residual.tail<3>().norm();
    const double score = sigma_equivalent(distances2[k] / scale2);
    pair.weight = pair.decided_by == DecidedBy::User ? 1.0 : score <= threshold ? 1.0 : 0.0;
    if (pair.decided_by == DecidedBy::User) continue;
    const PairState state = pair.weight > 0.0 ? PairState::Accepted : PairState::Rejected;
    changed += state != pair.state ? 1 : 0;
    pair.state = state;
    pair.decided_by = DecidedBy::Program;
    pair.reason = state == PairState::Accepted ? "" : outlier_reason(pair, score);
  }
  return changed;
}

// Error of an INS pose that a small motion of the lidar amounts to (both [nu; omega] in body axes).
Matrix6d ins_from_lidar_motion(const RigidTransform& ins_from_lidar) {
  Matrix6d out = Matrix6d::Zero();
  out.topLeftCorner<3, 3>() = out.bottomRightCorner<3, 3>() = ins_from_lidar.linear();
  out.topRightCorner<3, 3>() = skew(ins_from_lidar.translation()) * ins_from_lidar.linear();
  return out;
}

// Half of the mean covariance of each scan's registrations, as an error of its pose.
void set_scan_covariances(const std::vector<JointTerm>& terms, const RigidTransform& ins_from_lidar,
                          std::vector<JointNode>& nodes) {
  constexpr double kMost_m = 0.02, kMost_rad = 2e-3;  // where a registration does not determine a direction
  std::vector<int> counts(nodes.size(), 0);
  for (const JointTerm& term : terms) {
    Matrix6d information = term.information;
    information.diagonal().head<3>().array() += 1.0 / (kMost_m * kMost_m);
    information.diagonal().tail<3>().array() += 1.0 / (kMost_rad * kMost_rad);
    const Matrix6d half = 0.5 * information.ldlt().solve(Matrix6d::Identity());
    // A motion [nu; omega] of b changes Q by -[nu + omega x t; omega], one of a by R_Q [nu; omega].
    Matrix6d from_b = Matrix6d::Identity(), from_a = Matrix6d::Zero();
    from_b.topRightCorner<3, 3>() = skew(term.lidar_b_from_lidar_a.translation());
    from_a.topLeftCorner<3, 3>() = from_a.bottomRightCorner<3, 3>() = term.lidar_b_from_lidar_a.linear().transpose();
    for (const auto& [node, part] : {std::pair{term.node_a, from_a}, std::pair{term.node_b, from_b}}) {
      const Matrix6d to_ins = ins_from_lidar_motion(ins_from_lidar) * part;
      nodes[static_cast<std::size_t>(node)].scan_covariance += to_ins * half * to_ins.transpose();
      ++counts[static_cast<std::size_t>(node)];
    }
  }
  for (std::size_t k = 0; k < nodes.size(); ++k)
    if (counts[k] > 0) nodes[k].scan_covariance /= counts[k];
}

JointProblem make_problem(const PairwiseInput& input, const std::vector<Pair>& pairs, const std::vector<int>& usable,
                          const RigidTransform& prior_x, const RigidTransform& x) {
  JointProblem problem;
  problem.nodes = input.nodes;
  for (const int i : usable) {
    const Pair& pair = pairs[static_cast<std::size_t>(i)];
    if (pair.weight > 0.0)
      problem.terms.push_back(
          {pair.keyframe_a, pair.keyframe_b, pair.lidar_b_from_lidar_a, pair.registration.information, pair.weight});
  }
  if (input.pairs_share_scans) set_scan_covariances(problem.terms, x, problem.nodes);
  for (const SessionNoise& session : input.sessions)
    problem.session_attitude_bias_sigma_rad.push_back(
        known_or(session.attitude_bias_sigma_rad, degrees_to_radians(input.options.ins_attitude_bias_sigma_deg)));
  problem.prior_ins_from_lidar = prior_x;
  problem.prior_information = weak_prior();
  return problem;
}

void estimate_clock_offset(const JointProblem& problem, const PairwiseDetails& details, const Progress& progress,
                           CalibrationResult& result) {
  JointProblem with_clock = problem;
  with_clock.estimate_time_offset = true;
  const JointSolution solution =
      solve_joint(with_clock, details.noise, details.joint.ins_from_lidar, kIterations, progress);
  if (solution.time_offset_s.empty()) return;
  double information = 0.0, sum = 0.0;
  for (std::size_t s = 0; s < solution.time_offset_s.size(); ++s) {
    if (!(solution.time_offset_sigma_s[s] > 0.0)) return;
    const double weight = 1.0 / (solution.time_offset_sigma_s[s] * solution.time_offset_sigma_s[s]);
    information += weight;
    sum += weight * solution.time_offset_s[s];
  }
  result.time_offset.offset_s = sum / information;
  result.time_offset.sigma_s = 1.0 / std::sqrt(information);
  result.session_time_offset_s = solution.time_offset_s;
}

// Solves once more with the rotations that are not observed held at `kept`, for the others turn with them. Translations
// are not held: averaging over what they may be serves the others better than any single value, which may contradict
// the data where these say more than they are trusted with. They are reported as `kept`.
RigidTransform solve_with_held(JointProblem problem, const PairwiseDetails& details,
                               const std::array<bool, 6>& observed, const RigidTransform& kept,
                               const Progress& progress) {
  const SixParameters solved = six_from_rigid(details.joint.ins_from_lidar), held = six_from_rigid(kept);
  SixParameters start = solved;
  if (!observed[3]) start.yaw_rad = held.yaw_rad;
  if (!observed[4]) start.pitch_rad = held.pitch_rad;
  if (!observed[5]) start.roll_rad = held.roll_rad;
  const RigidTransform from = rigid_from_six(start);
  problem.prior_ins_from_lidar.linear() = from.linear();
  Matrix6d to_parameters = Matrix6d::Identity();
  to_parameters.bottomRightCorner<3, 3>() =
      yaw_pitch_roll_jacobian(yaw_pitch_roll_from_rotation(problem.prior_ins_from_lidar.linear()));
  constexpr double kHeld = 1e12;  // a micrometre, a microradian
  for (int i = 3; i < 6; ++i)
    if (!observed[static_cast<std::size_t>(i)])
      problem.prior_information += kHeld * to_parameters.row(i).transpose() * to_parameters.row(i);
  RigidTransform x = solve_joint(problem, details.noise, from, kIterations, progress).ins_from_lidar;
  for (int i = 0; i < 3; ++i)
    if (!observed[static_cast<std::size_t>(i)]) x.translation()[i] = kept.translation()[i];
  return x;
}

void count_pairs(const std::vector<Pair>& pairs, CalibrationResult& result) {
  result.pairs_proposed = static_cast<int>(pairs.size());
  result.pairs_accepted = result.pairs_rejected = 0;
  for (const Pair& pair : pairs) {
    result.pairs_accepted += pair.state == PairState::Accepted ? 1 : 0;
    result.pairs_rejected += pair.state == PairState::Rejected ? 1 : 0;
  }
}

void summarise_errors(const std::vector<Pair>& pairs, const SolveOptions& options, CalibrationResult& result) {
  std::vector<MotionPair> accepted;
  double rotation2 = 0.0, translation2 = 0.0;
  for (const Pair& pair : pairs) {
    if (pair.state != PairState::Accepted) continue;
    accepted.push_back({pair.ins_b_from_ins_a, pair.lidar_b_from_lidar_a, 1.0});
    const Vector6d residual =
        difference(pair.lidar_b_from_lidar_a, predicted_lidar_motion(pair.ins_b_from_ins_a, result.ins_from_lidar));
    translation2 += residual.head<3>().squaredNorm();
    rotation2 += residual.tail<3>().squaredNorm();
  }
  const double count = std::max<double>(1.0, static_cast<double>(accepted.size()));
  result.frobenius_sum = frobenius_sum(accepted, result.ins_from_lidar, options.characteristic_length_m);
  result.rotation_rms_rad = std::sqrt(rotation2 / count);
  result.translation_rms_m = std::sqrt(translation2 / count);
}

void list_candidates(const PairwiseInput& input, const std::vector<Pair>& pairs, const RigidTransform& nominal,
                     CalibrationResult& result) {
  std::vector<MotionPair> accepted;
  std::vector<int> names;
  for (std::size_t i = 0; i < pairs.size(); ++i)
    if (pairs[i].state == PairState::Accepted) {
      accepted.push_back({pairs[i].ins_b_from_ins_a, pairs[i].lidar_b_from_lidar_a, 1.0});
      names.push_back(static_cast<int>(i));
    }
  result.candidates = find_candidates(accepted, names, nominal, input.range, input.options);
  Candidate refined;
  refined.source = "refined";
  refined.ins_from_lidar = result.ins_from_lidar;
  result.candidates.push_back(refined);
  rank_candidates(result.candidates, accepted, input.range, input.options);
}

void trim_candidates(int limit, CalibrationResult& result) {
  // The refined X is what is exported: it stays in the list wherever it ranks.
  const auto most = static_cast<std::size_t>(limit);
  if (result.candidates.size() <= most) return;
  const auto refined = std::find_if(result.candidates.begin(), result.candidates.end(),
                                    [](const Candidate& candidate) { return candidate.source == "refined"; });
  if (static_cast<std::size_t>(refined - result.candidates.begin()) >= most) result.candidates[most - 1] = *refined;
  result.candidates.resize(most);
}

void set_status(const SearchRange& range, CalibrationResult& result) {
  const auto observed = static_cast<int>(std::count(result.observed.begin(), result.observed.end(), true));
  const std::string outside = outside_range(result.ins_from_lidar, range);
  if (observed == 0) {
    result.status = Status::Degenerate;
    result.message = "Nothing is observed: the motion of this drive does not determine any component of X.";
  } else if (!outside.empty()) {
    result.status = Status::OutOfRange;
    result.message = "The solution lies outside the search range: " + outside + ".";
  } else if (observed < 6) {
    result.status = Status::Degenerate;
    result.message = "Solved, but not everything is observed:";
    for (std::size_t i = 0; i < 6; ++i)
      if (!result.observed[i]) result.message += " " + std::string(kParameterNames[i]);
    result.message += ".";
  } else {
    result.status = Status::Ok;
    result.message = "Solved; all six parameters are observed.";
  }
}

CalibrationResult cancelled(CalibrationResult result) {
  result.status = Status::Cancelled;
  result.message = "Cancelled.";
  return result;
}

CalibrationResult too_few(std::vector<Pair>& pairs, std::size_t usable) {
  CalibrationResult result;
  count_pairs(pairs, result);
  result.status = Status::TooFewPairs;
  result.message =
      "Only " + std::to_string(usable) + " usable pairs; at least " + std::to_string(kFewestPairs) + " are needed.";
  result.advice.push_back(
      "Drive longer, take keyframes closer together, or relax the limits of pairing and registration.");
  return result;
}

}  // namespace

double pair_distance2(const Pair& pair, const RigidTransform& ins_from_lidar, const NoiseModel& noise) {
  const PairEquation equation = linearise_pair(pair.ins_b_from_ins_a, pair.lidar_b_from_lidar_a, ins_from_lidar);
  const double distance2 = equation.residual.dot(residual_information(pair, equation, noise) * equation.residual);
  return std::isfinite(distance2) ? std::max(0.0, distance2) : std::numeric_limits<double>::max();
}

CalibrationResult solve_pairwise(const PairwiseInput& input, std::vector<Pair>& pairs, PairwiseDetails& details,
                                 const Progress& progress) {
  const std::vector<int> usable = usable_pairs(pairs);
  if (usable.size() < kFewestPairs) return too_few(pairs, usable.size());
  const NoisePrior prior = noise_prior(input);
  details.noise = prior.expected;
  test_screws(pairs, usable, prior.expected, input.options.outlier_threshold + 1.0);
  const Eigen::Vector3d near_m = input.nominal_ins_from_lidar
                                     ? Eigen::Vector3d(input.nominal_ins_from_lidar->translation())
                                     : Eigen::Vector3d::Zero();
  RotationReference reference;
  if (const auto& known = input.nominal_ins_from_lidar ? input.nominal_ins_from_lidar : input.initial_ins_from_lidar)
    reference.ins_from_lidar = known->linear();
  const RobustStart start =
      robust_start(pairs, usable, prior.expected, input.nominal_ins_from_lidar, reference, near_m);
  RigidTransform prior_x = start.ins_from_lidar;
  prior_x.translation() = near_m;
  judge_pairs(pairs, usable, start.ins_from_lidar, scaled(prior.expected, start.noise_scale),
              input.options.outlier_threshold);

  RigidTransform x = start.ins_from_lidar;
  JointProblem problem;
  for (int round = 0; round < 4 && !progress.cancelled(); ++round) {
    problem = make_problem(input, pairs, usable, prior_x, x);
    if (problem.terms.size() < kFewestPairs) return too_few(pairs, problem.terms.size());
    details.noise = estimate_noise(problem, prior.expected, prior.log_spread, x,
                                   round == 0 ? std::nullopt : std::optional(details.noise), progress);
    details.joint = solve_joint(problem, details.noise, x, kIterations, progress);
    x = details.joint.ins_from_lidar;
    const int changed = judge_pairs(pairs, usable, x, details.noise, input.options.outlier_threshold);
    if (changed == 0) break;
  }

  CalibrationResult result;
  result.ins_from_lidar = x;
  result.noise = details.noise;
  if (progress.cancelled()) {
    count_pairs(pairs, result);
    return cancelled(result);
  }
  describe_uncertainty(input, pairs, problem, details, progress, result);
  if (!std::all_of(result.observed.begin(), result.observed.end(), [](bool seen) { return seen; }))
    result.ins_from_lidar =
        solve_with_held(problem, details, result.observed, input.nominal_ins_from_lidar.value_or(prior_x), progress);
  estimate_clock_offset(problem, details, progress, result);
  list_candidates(input, pairs, input.nominal_ins_from_lidar.value_or(x), result);
  trim_candidates(input.options.max_listed_candidates, result);
  count_pairs(pairs, result);
  summarise_errors(pairs, input.options, result);
  set_status(input.range, result);
  if (!details.joint.converged && result.status != Status::OutOfRange) {
    result.status = Status::NotConverged;
    result.message = "The joint solution did not converge.";
  }
  // A stop on the way leaves numbers that look complete and are not.
  if (progress.cancelled()) return cancelled(result);
  return result;
}

CalibrationResult solve_pairwise(const PairwiseInput& input, std::vector<Pair>& pairs, const Progress& progress) {
  PairwiseDetails details;
  return solve_pairwise(input, pairs, details, progress);
}

}  // namespace remount
