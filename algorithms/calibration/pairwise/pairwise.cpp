#include "algorithms/calibration/pairwise/pairwise.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "algorithms/calibration/joint/pair_equation.h"
#include "algorithms/calibration/observability.h"
#include "algorithms/calibration/out_of_range.h"
#include "algorithms/calibration/pairwise/clock_estimate.h"
#include "algorithms/calibration/pairwise/joint_problem.h"
#include "algorithms/calibration/pairwise/motion_agreement.h"
#include "algorithms/calibration/pairwise/noise_prior.h"
#include "algorithms/calibration/pairwise/pair_judgement.h"
#include "algorithms/calibration/pairwise/robust_start.h"
#include "algorithms/calibration/pairwise/session_agreement.h"
#include "algorithms/calibration/pairwise/uncertainty.h"
#include "algorithms/search/candidates.h"
#include "messages/calibration.h"
#include "messages/pairs.h"
#include "messages/parameters.h"

namespace remount::calibration {

Message title_of_session(const PairwiseInput& input, motion::SessionIndex session) {
  return session < input.session_names.size() ? say::session_named(session + 1, input.session_names[session])
                                              : say::session_number(session + 1);
}

using motion::Pair;

namespace {

constexpr int kFewestPairs = 3;

// Solves once more with the rotations that are not observed held at `kept`, for the others turn with them. Translations
// are not held: averaging over what they may be serves the others better than any single value, which may contradict
// the data where these say more than they are trusted with. They are reported as `kept`.
RigidTransform solve_with_held(JointProblem problem, const PairwiseDetails& details, ParameterSet observed,
                               const RigidTransform& kept, const Progress& progress) {
  const RigidTransform from = with_kept(details.joint.ins_from_lidar, kept, ~observed & kAttitudeParameters);
  problem.lidar().prior_ins_from_lidar.linear() = from.linear();
  Matrix6d to_parameters = Matrix6d::Identity();
  to_parameters.bottomRightCorner<3, 3>() =
      yaw_pitch_roll_jacobian(yaw_pitch_roll_from_rotation(problem.lidar().prior_ins_from_lidar.linear()));
  constexpr double kHeld = 1e12;  // a microradian
  for (const Parameter angle : {Parameter::Yaw, Parameter::Pitch, Parameter::Roll})
    if (const int i = row_of(angle); !observed.contains(angle))
      problem.lidar().prior_information += kHeld * to_parameters.row(i).transpose() * to_parameters.row(i);
  RigidTransform x = solve_joint(problem, details.noise, from, kJointIterations, progress).ins_from_lidar;
  for (const Parameter axis : {Parameter::X, Parameter::Y, Parameter::Z})
    if (const int i = row_of(axis); !observed.contains(axis)) x.translation()[i] = kept.translation()[i];
  return x;
}

void count_pairs(const std::vector<Pair>& pairs, CalibrationResult& result) {
  result.pairs_proposed = static_cast<int>(pairs.size());
  result.pairs_accepted = result.pairs_rejected = 0;
  for (const Pair& pair : pairs) {
    result.pairs_accepted += pair.state == motion::PairState::Accepted ? 1 : 0;
    result.pairs_rejected += pair.state == motion::PairState::Rejected ? 1 : 0;
  }
}

void summarise_errors(const std::vector<Pair>& pairs, const SolveOptions& options, CalibrationResult& result) {
  const RigidTransform& x = result.mounting.ins_from_lidar();
  double rotation2 = 0.0, translation2 = 0.0;
  for (const Pair& pair : pairs) {
    if (pair.state != motion::PairState::Accepted) continue;
    const Vector6d residual = motion_residual(pair.ins_b_from_ins_a, pair.lidar_b_from_lidar_a, x);
    translation2 += residual.head<3>().squaredNorm();
    rotation2 += residual.tail<3>().squaredNorm();
  }
  const std::vector<search::MotionPair> accepted = accepted_motions(pairs);
  const double count = std::max<double>(1.0, static_cast<double>(accepted.size()));
  result.frobenius_sum = search::frobenius_sum(accepted, x, options.characteristic_length_m);
  result.rotation_rms_rad = std::sqrt(rotation2 / count);
  result.translation_rms_m = std::sqrt(translation2 / count);
}

void list_candidates(const PairwiseInput& input, const std::vector<Pair>& pairs, const RigidTransform& nominal,
                     const Progress& progress, CalibrationResult& result) {
  const std::vector<search::MotionPair> accepted = accepted_motions(pairs);
  std::vector<motion::PairIndex> names;
  for (motion::PairIndex i; i < pairs.size(); ++i)
    if (pairs[i].state == motion::PairState::Accepted) names.push_back(i);
  result.candidates = search::find_candidates(accepted, names, nominal, input.range, input.options, progress);
  Candidate refined;
  refined.source = MountingSource::Refined;
  refined.ins_from_lidar = result.mounting.ins_from_lidar();
  result.candidates.push_back(refined);
  search::rank_candidates(result.candidates, accepted, input.range, input.options);
}

void trim_candidates(int limit, CalibrationResult& result) {
  // The refined X is what is exported: it stays in the list wherever it ranks.
  const auto most = static_cast<std::size_t>(limit);
  if (result.candidates.size() <= most) return;
  const auto refined = std::find_if(result.candidates.begin(), result.candidates.end(), [](const Candidate& candidate) {
    return candidate.source == MountingSource::Refined;
  });
  if (static_cast<std::size_t>(refined - result.candidates.begin()) >= most) result.candidates[most - 1] = *refined;
  result.candidates.resize(most);
}

void set_status(const PairwiseInput& input, const Message& lost, CalibrationResult& result) {
  const ParameterSet observed = result.observed();
  Message outside = outside_range(result.mounting.ins_from_lidar(), input.range);
  if (observed.empty()) {
    result.conclude(Status::Degenerate, input.clock_bias ? say::nothing_known_clocks()
                                        : lost.empty()   ? say::nothing_observed()
                                                         : lost);
  } else if (!outside.empty()) {
    refuse_out_of_range(std::move(outside), result);
  } else {
    result.conclude(observed.is_all() ? Status::Ok : Status::Degenerate, solved_message(result));
  }
}

void claim_nothing_unconverged(const PairwiseInput& input, CalibrationResult& result) {
  claim_nothing(say::unknown_not_converged(), result);
  if (result.status == Status::OutOfRange) return;
  result.conclude(Status::NotConverged, say::joint_not_converged());
  result.advice.insert(result.advice.begin(), input.nominal_ins_from_lidar ? say::look_at_clocks_pairs_nominal()
                                                                           : say::look_at_clocks_pairs());
}

CalibrationResult cancelled(CalibrationResult result) {
  result.conclude(Status::Cancelled, say::calibration_cancelled());
  return result;
}

CalibrationResult too_few(std::vector<Pair>& pairs, std::size_t usable) {
  CalibrationResult result;
  count_pairs(pairs, result);
  result.conclude(Status::TooFewPairs, say::too_few_usable_pairs(usable, kFewestPairs));
  result.advice.push_back(say::drive_longer());
  refuse_other_unit(pairs, result);
  return result;
}

struct Context {
  const PairwiseInput& input;
  const NoisePrior& prior;
  const RigidTransform& prior_x;  // centre of the weak prior
  const PairTilts& tilts_rad;
  const Progress& progress;
};

// Noise, solution and judgement of the pairs in turn, until no pair changes its state. Fewer than kFewestPairs terms in
// what is returned: nothing was solved.
JointProblem solve_and_judge(const Context& context, const RigidTransform& start,
                             const std::vector<motion::PairIndex>& usable, std::vector<Pair>& pairs,
                             PairwiseDetails& details) {
  const auto& [input, prior, prior_x, tilts_rad, progress] = context;
  constexpr int kMostRounds = 4;
  RigidTransform x = start;
  JointProblem problem;
  for (int round = 0; round < kMostRounds && !progress.cancelled(); ++round) {
    problem = make_joint_problem(input, pairs, usable, prior_x, x);
    if (problem.terms.size() < kFewestPairs) break;
    details.noise = estimate_noise(problem, prior.expected, prior.log_spread, x,
                                   round == 0 ? input.noise_before : std::optional(details.noise), progress);
    details.noise = with_declared_drift(details.noise, prior);
    details.joint = solve_joint(problem, details.noise, x, kJointIterations, progress);
    if (!details.joint.converged && !progress.cancelled())
      details.joint.converged = settles_where_observed(input, pairs, details);
    x = details.joint.ins_from_lidar;
    details.beams = estimate_beams(input.beams, input.mended_beams, problem.lidar().beams, details.joint.beams,
                                   details.joint.beams_covariance);
    // After the last round the pairs stay as they were solved with.
    if (round + 1 == kMostRounds) break;
    if (judge_pairs(pairs, usable, x, details.noise, input.options.outlier_threshold, tilts_rad) == 0) break;
  }
  return problem;
}

// Where all other sessions agree against one, its pairs are rejected and the others solved alone. Returns what each
// session says in the end.
std::vector<SessionAnswer> leave_out_outlier_session(const Context& context, std::vector<motion::PairIndex>& usable,
                                                     std::vector<Pair>& pairs, PairwiseDetails& details,
                                                     JointProblem& problem, CalibrationResult& result) {
  const PairwiseInput& input = context.input;
  const Progress& progress = context.progress;
  if (problem.terms.size() < kFewestPairs || progress.cancelled()) return {};
  std::vector<SessionAnswer> answers = session_answers(problem, details, progress);
  const std::optional<OutlierSession> outlier = outlier_session(answers, input.options);
  if (!outlier || progress.cancelled()) return answers;
  std::erase_if(usable, [&](motion::PairIndex i) {
    Pair& pair = pairs[i];
    if (input.nodes[pair.keyframe_a].session != outlier->session) return false;
    if (pair.decided_by == motion::DecidedBy::User) return false;
    pair.state = motion::PairState::Rejected;
    pair.decided_by = motion::DecidedBy::Program;
    pair.weight = 0.0;
    pair.reason = say::pair_of_outlier_session(outlier->disagreement);
    return true;
  });
  const RigidTransform start = perturb(details.joint.ins_from_lidar, outlier->common);
  problem = solve_and_judge(context, start, usable, pairs, details);
  result.advice.push_back(say::session_contradicts_others(title_of_session(input, outlier->session)));
  return session_answers(problem, details, progress);
}

// Whether the accepted pairs are so few of all that they may agree by chance: a first X that is far off makes nearly
// all registrations fail.
bool chance_few(const std::vector<Pair>& pairs) {
  constexpr double kLeastShare = 0.05;
  int accepted = 0, judged = 0;
  for (const Pair& pair : pairs) {
    if (pair.state == motion::PairState::Rejected &&
        (pair.decided_by == motion::DecidedBy::User || motion::is_not_reached(pair) || motion::repeats_another(pair)))
      continue;
    ++judged;
    accepted += pair.state == motion::PairState::Accepted ? 1 : 0;
  }
  return accepted < kLeastShare * judged;
}

// Without a nominal, X may lie far from where it was linearised: what is stated of the parameters then holds at one
// place only. Returns why nothing is known; empty where something is.
Message claim_nothing_where_lost(const std::vector<Pair>& pairs, CalibrationResult& result) {
  if (chance_few(pairs)) {
    claim_nothing(say::unknown_too_few_together(), result);
    result.advice.push_back(say::chance_few_need_nominal());
    return say::nothing_known_pairs();
  }
  if (yaw_is_open(result)) {
    claim_nothing(say::unknown_yaw_open(), result);
    result.advice.push_back(say::open_yaw_needs_nominal());
    return say::nothing_known_yaw();
  }
  return {};
}

// Two mountings in one calibration have no common X; a session that is bad in itself can be left out.
void report_rejected_sessions(const Context& context, const std::vector<motion::PairIndex>& usable,
                              const std::vector<Pair>& pairs, CalibrationResult& result) {
  const SessionVerdicts verdicts =
      judge_sessions(context.input, pairs, usable, context.prior.expected, context.progress);
  for (const RejectedSession& one : verdicts.rejected) {
    const Message title = title_of_session(context.input, one.session);
    result.advice.push_back(one.coherent ? say::session_of_other_mounting(title)
                                         : say::session_contradicts_itself(title));
    // One against one: nobody can tell which is right.
    if (one.coherent && verdicts.kept < 2 && is_solved(result.status)) {
      result.conclude(Status::Inconsistent, say::sessions_of_other_mountings(title));
      claim_nothing(say::unknown_mountings_differ(), result);
    }
  }
}

}  // namespace

PairTilts assumed_tilts_rad(const PairwiseInput& input, const std::vector<Pair>& pairs) {
  PairTilts tilts_rad(pairs.size(), 0.0);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const motion::KeyframeIndex node = pairs[i].keyframe_a;
    const std::size_t session = node < input.nodes.size() ? input.nodes[node].session : input.sessions.size();
    if (session < input.sessions.size()) tilts_rad[i] = input.sessions[session].assumed_tilt_sigma_rad;
  }
  return tilts_rad;
}

CalibrationResult solve_pairwise(const PairwiseInput& input, std::vector<Pair>& pairs, PairwiseDetails& details,
                                 const Progress& progress) {
  refuse_unusable(pairs);
  std::vector<motion::PairIndex> usable = usable_pairs(pairs);
  if (usable.size() < kFewestPairs) return too_few(pairs, usable.size());
  const NoisePrior prior = noise_prior(input);
  details.noise = prior.expected;
  const PairTilts tilts_rad = assumed_tilts_rad(input, pairs);
  test_screws(pairs, usable, prior.expected, input.options.outlier_threshold + 1.0, tilts_rad);
  const Eigen::Vector3d near_m = input.nominal_ins_from_lidar
                                     ? Eigen::Vector3d(input.nominal_ins_from_lidar->translation())
                                     : Eigen::Vector3d::Zero();
  RotationReference reference;
  if (const auto& known = input.nominal_ins_from_lidar ? input.nominal_ins_from_lidar : input.initial_ins_from_lidar)
    reference.ins_from_lidar = known->linear();
  const RobustStart start =
      robust_start(pairs, usable, prior.expected, input.nominal_ins_from_lidar, reference, near_m, progress, tilts_rad);
  RigidTransform prior_x = start.ins_from_lidar;
  prior_x.translation() = near_m;
  judge_pairs(pairs, usable, start.ins_from_lidar, input.noise_before.value_or(prior.expected.times(start.noise_scale)),
              input.options.outlier_threshold, tilts_rad);

  const Context context{input, prior, prior_x, tilts_rad, progress};
  JointProblem problem = solve_and_judge(context, start.ins_from_lidar, usable, pairs, details);
  CalibrationResult result;
  const std::vector<SessionAnswer> answers =
      leave_out_outlier_session(context, usable, pairs, details, problem, result);
  result.mounting.reference_from_sensor = details.joint.ins_from_lidar;
  result.noise = details.noise;
  result.beams = details.beams;
  result.set_measured(input.measured.parameters());
  if (progress.cancelled()) {
    count_pairs(pairs, result);
    return cancelled(result);
  }
  if (problem.terms.size() < kFewestPairs) return too_few(pairs, problem.terms.size());
  const std::size_t advised = result.advice.size();
  const Matrix6d believed = describe_uncertainty(input, pairs, problem, answers, details, progress, result);
  // What the drive lacks is told from a solution that holds; more turns would not make another one.
  if (!details.joint.converged) result.advice.resize(advised);
  const Message lost = input.nominal_ins_from_lidar ? Message() : claim_nothing_where_lost(pairs, result);
  if (!result.observed().is_all())
    result.mounting.reference_from_sensor =
        solve_with_held(problem, details, result.observed(), input.nominal_ins_from_lidar.value_or(prior_x), progress);
  add_doubts(input, believed, details, result);
  estimate_clock_offset(input, problem, details, progress, result);
  list_candidates(input, pairs, input.nominal_ins_from_lidar.value_or(details.joint.ins_from_lidar), progress, result);
  trim_candidates(input.options.max_listed_candidates, result);
  count_pairs(pairs, result);
  tell_residuals(pairs, usable, details.joint.ins_from_lidar, result.mounting.ins_from_lidar(), details.noise,
                 input.options.outlier_threshold, tilts_rad);
  summarise_errors(pairs, input.options, result);
  set_status(input, lost, result);
  if (!details.joint.converged) claim_nothing_unconverged(input, result);
  judge_motions(problem, pairs, details, input.options, progress, result);
  report_rejected_sessions(context, usable, pairs, result);
  // A stop on the way leaves numbers that look complete and are not.
  if (progress.cancelled()) return cancelled(result);
  return result;
}

CalibrationResult solve_pairwise(const PairwiseInput& input, std::vector<Pair>& pairs, const Progress& progress) {
  PairwiseDetails details;
  return solve_pairwise(input, pairs, details, progress);
}

}  // namespace remount::calibration
