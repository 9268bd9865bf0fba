#include "algorithms/calibration/trajectory/trajectory_answer.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "algorithms/calibration/linear_solutions.h"
#include "algorithms/calibration/observability.h"
#include "algorithms/calibration/pairwise/open_rotation.h"
#include "algorithms/calibration/pairwise/uncertainty.h"
#include "algorithms/calibration/trajectory/trajectory_spread.h"
#include "messages/calibration.h"
#include "messages/parameters.h"
#include "messages/quantities.h"

namespace remount::calibration {
namespace {

// What the description of one solution is made from.
struct Evidence {
  const TrajectoryProblem& problem;
  const TrajectoryOptions& options;
  const SolveOptions& judged_by;
  const TrajectorySolution& solution;
  const TrajectoryPrior& prior;
  WeightedTerms weighted;
  TrajectoryEquations equations;
  SharedMatrix information, spurious;
  SharedMatrix scatter = SharedMatrix::Zero();  // of the shared unknowns, as blocks of time show it
};

MotionSummary motion_of(const TrajectoryProblem& problem) {
  std::vector<motion::Pair> turns;
  for (const TrajectorySession& session : problem.sessions) {
    std::vector<RigidTransform> poses = session.past.odometry_from_lidar;
    for (const TrajectoryEpoch& epoch : session.epochs) poses.push_back(epoch.odometry_from_lidar);
    for (const RigidTransform& pose : poses) {
      motion::Pair turn;
      turn.state = motion::PairState::Accepted;
      turn.ins_b_from_ins_a = poses.front().inverse() * pose;
      turns.push_back(turn);
    }
  }
  return summarise_motion(turns);
}

// What drives do to X that no residual shows: each drive its own.
Matrix6d unseen_covariance(const TrajectoryProblem& problem) {
  Matrix6d sum = Matrix6d::Zero();
  double count = 0.0;
  for (const TrajectorySession& session : problem.sessions) {
    if (session.epochs.empty()) continue;
    sum += session.unseen;
    count += 1.0;
  }
  return count > 0.0 ? Matrix6d(sum / (count * count)) : sum;
}

// Blocks of the options' length, shorter for a short drive.
double block_length_s(const Evidence& evidence) {
  double total_s = 0.0;
  for (const TrajectorySession& session : evidence.problem.sessions) {
    total_s += session.past.duration_s;
    if (!session.epochs.empty()) total_s += session.epochs.back().time_s - session.epochs.front().time_s;
  }
  return std::clamp(total_s / kBootstrapBlocks, 1e-3, std::max(1e-3, evidence.judged_by.bootstrap_block_s));
}

// Sigmas as large as blocks of time scatter, where that is more.
Matrix6d widen(const Matrix6d& covariance, const Matrix6d& scatter) {
  const Vector6d factors = scatter.diagonal().cwiseQuotient(covariance.diagonal()).cwiseMax(1.0).cwiseSqrt();
  return factors.asDiagonal() * covariance * factors.asDiagonal();
}

SharedMatrix block_scatter(const Evidence& evidence) {
  return scatter_of_blocks(evidence.problem, evidence.solution, evidence.weighted, evidence.equations,
                           evidence.prior.information, block_length_s(evidence));
}

// Along directions that are not observed, X stays where the prior has it.
Matrix6d held(const std::vector<ObservabilityDirection>& directions, const SolveOptions& options) {
  constexpr double kHeld = 1e6;
  const Vector6d inverse_limits = observation_limits(options).cwiseInverse();
  Matrix6d sum = Matrix6d::Zero();
  for (const ObservabilityDirection& direction : directions) {
    if (direction.observed) continue;
    const Vector6d row = inverse_limits.cwiseProduct(direction.direction);
    sum += kHeld * row * row.transpose();
  }
  return sum;
}

void set_bootstrap(const Matrix6d& parameters, CalibrationResult& result) {
  for (const Parameter parameter : kParameters) {
    const double variance = parameters(row_of(parameter), row_of(parameter));
    Knowledge& known = result.known[parameter];
    known.bootstrap_sigma = known.observed && variance > 0.0 ? std::optional(std::sqrt(variance)) : std::nullopt;
  }
}

// Information of what is observed. Of other directions noise makes a tenth of a radian out of nothing.
Matrix6d clear_information(std::vector<ObservabilityDirection> directions, const SolveOptions& options) {
  std::erase_if(directions, [](const ObservabilityDirection& direction) { return !direction.observed; });
  return trusted_information(directions, options);
}

// Without a nominal, what turns with a rotation that the drive leaves open is no better known.
void widen_by_open_rotation(const Evidence& evidence, const Matrix6d& by_turns, CalibrationResult& result) {
  const TrajectoryProblem& problem = evidence.problem;
  if (problem.nominal_ins_from_lidar) return;
  const RigidTransform& x = result.mounting.ins_from_lidar();
  const Matrix6d known = by_turns + problem.measured.information(x) + level_information(problem.up_in_lidar, x);
  widen_angles(turned_by_open_rotation(x, known), evidence.judged_by, result);
}

void describe_x(const Evidence& evidence, bool thorough, TrajectoryAnswer& answer) {
  CalibrationResult& result = answer.result;
  const RigidTransform& x = result.mounting.reference_from_sensor = evidence.solution.state.ins_from_lidar;
  MotionSummary motion = motion_of(evidence.problem);
  const AssumedTilt tilt = assumed_tilt_of(evidence.problem.sessions);
  motion.tilt_assumed = tilt.least_rad > 0.0;
  const Matrix6d apparent = information_of_x(evidence.information, evidence.prior.information);
  const Matrix6d spurious = evidence.spurious.topLeftCorner<6, 6>();
  result.directions = observed_directions(apparent, {apparent, spurious}, motion, evidence.judged_by);
  answer.hold.topLeftCorner<6, 6>() = held(result.directions, evidence.judged_by);
  Matrix6d information = trusted_information(result.directions, evidence.judged_by);
  if (thorough) {
    constexpr double kBelieved = 0.5;  // 1-sigma of the logarithm of the noise, before sessions are compared
    const SessionScatter scatter =
        session_scatter(trajectory_session_answers(evidence.problem, evidence.solution, evidence.weighted,
                                                   evidence.equations, evidence.prior.information),
                        evidence.judged_by);
    result.session_disagreement = scatter.ratio;
    const double wider = widening(scatter, kBelieved);
    information /= wider * wider;
  }
  const Matrix6d prior = weak_prior(evidence.problem.nominal_ins_from_lidar.has_value());
  const Matrix6d scatter = evidence.scatter.topLeftCorner<6, 6>();
  const Measured& measured = evidence.problem.measured;
  const Matrix6d beside = prior + measured.information(x);
  Matrix6d covariance = widen(inverse_by_lu(information + beside), scatter) + unseen_covariance(evidence.problem);
  if (tilt.most_rad > 0.0) covariance += beyond_first_order(x, covariance, tilt.most_rad);
  const Vector6d by_north = turned_by_north(x, north_sigma_of(evidence.problem.sessions));
  covariance += by_north * by_north.transpose();
  result.set_measured(measured.parameters());
  judge_parameters(covariance, motion, evidence.judged_by, result);
  // Where the INS is taken to be level, that is what leaves directions open, and not noise.
  widen_by_open_rotation(
      evidence, motion.tilt_assumed ? information : clear_information(result.directions, evidence.judged_by), result);
  set_bootstrap(parameter_covariance(x, scatter), result);
  const Matrix6d joint = inverse_by_lu(apparent + evidence.prior.information.topLeftCorner<6, 6>());
  for (const Contradiction& one : contradictions(measured, x, joint, covariance)) {
    add_doubt(one.doubt, say::unknown_measured_contradicts(), evidence.judged_by, result);
    result.advice.push_back(one.text);
  }
}

// The antenna's lever arm as six-dimensional information: nothing about axes.
Matrix6d as_translation(const Eigen::Matrix3d& information) {
  Matrix6d out = Matrix6d::Zero();
  out.topLeftCorner<3, 3>() = information;
  return out;
}

struct JudgedAntenna {
  std::vector<ObservabilityDirection> directions;
  Eigen::Matrix3d covariance;
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
};

JudgedAntenna judge_antenna(const Evidence& evidence) {
  JudgedAntenna out;
  const Matrix6d apparent = as_translation(information_of_antenna(evidence.information, evidence.prior.information));
  const Matrix6d spurious = as_translation(evidence.spurious.bottomRightCorner<3, 3>());
  out.directions = observed_directions(apparent, {apparent, spurious}, motion_of(evidence.problem), evidence.judged_by);
  const Eigen::Matrix3d trusted = trusted_information(out.directions, evidence.judged_by).topLeftCorner<3, 3>();
  const double reach = evidence.options.antenna_reach_m;
  out.covariance = (trusted + Eigen::Matrix3d::Identity() / (reach * reach)).inverse();
  out.scatter = evidence.scatter.bottomRightCorner<3, 3>();
  const Eigen::Vector3d factors =
      out.scatter.diagonal().cwiseQuotient(out.covariance.diagonal()).cwiseMax(1.0).cwiseSqrt();
  out.covariance = (factors.asDiagonal() * out.covariance * factors.asDiagonal()).eval();
  out.covariance += unseen_covariance(evidence.problem).topLeftCorner<3, 3>();
  return out;
}

// A quantity has a sigma where that is below `limit`. Above the limit the data do not tell the quantity, and a sigma
// would look as if they did.
NamedQuantity judged_quantity(std::string id, Message name, double value, double sigma, std::string unit,
                              double limit) {
  NamedQuantity quantity{std::move(id), std::move(name), value, sigma, std::move(unit), sigma < limit};
  if (!quantity.observed) quantity.sigma = std::numeric_limits<double>::quiet_NaN();
  return quantity;
}

void add_lever_arm(const Evidence& evidence, const JudgedAntenna& judged, TrajectoryAnswer& answer) {
  constexpr Message (*kNames[])() = {say::quantity_lever_arm_x, say::quantity_lever_arm_y, say::quantity_lever_arm_z};
  for (int i = 0; i < 3; ++i)
    answer.quantities.push_back(
        judged_quantity(lever_arm_id(i), kNames[i](), evidence.solution.state.antenna_in_lidar[i],
                        std::sqrt(judged.covariance(i, i)), "m", evidence.judged_by.max_translation_sigma_m));
}

Mounting lidar_at_antenna(const TrajectoryState& state) {
  return {BodyFrame::Antenna, BodyFrame::Lidar, make_rigid(Eigen::Matrix3d::Identity(), -state.antenna_in_lidar)};
}

// Positions alone: X is where the LiDAR is from the antenna, in the LiDAR's own axes.
void describe_antenna(const Evidence& evidence, const JudgedAntenna& judged, TrajectoryAnswer& answer) {
  constexpr double kNoAxes_rad2 = 1e4;
  CalibrationResult& result = answer.result;
  const MotionSummary motion = motion_of(evidence.problem);
  result.mounting = lidar_at_antenna(evidence.solution.state);
  result.directions = judged.directions;
  Matrix6d covariance = kNoAxes_rad2 * Matrix6d::Identity();
  covariance.topLeftCorner<3, 3>() = judged.covariance;
  judge_parameters(covariance, motion, evidence.judged_by, result);
  result.advice.clear();
  Matrix6d scatter = Matrix6d::Zero();
  scatter.topLeftCorner<3, 3>() = judged.scatter;
  set_bootstrap(scatter, result);
  for (ObservabilityDirection& direction : result.directions)
    if (direction.direction.tail<3>().norm() > 0.5) direction.words = say::direction_of_antenna();
  for (const Parameter angle : {Parameter::Yaw, Parameter::Pitch, Parameter::Roll})
    result.withdraw(angle, say::direction_of_antenna());
  const bool level_shown = result.known[Parameter::X].observed && result.known[Parameter::Y].observed;
  if (!level_shown) result.advice.push_back(say::lever_arm_needs_turns());
  if (!result.known[Parameter::Z].observed) result.advice.push_back(say::lever_arm_needs_tilt());
  result.advice.push_back(say::positions_show_no_attitude());
}

// Heading of the first session's odometry frame in ENU, from the covariance of its first pose.
void add_odometry_heading(const Evidence& evidence, TrajectoryAnswer& answer) {
  const TrajectorySession& session = evidence.problem.sessions.front();
  if (session.epochs.empty()) return;
  const RigidTransform& first = evidence.solution.state.enu_from_lidar.front().front();
  Eigen::Matrix3d covariance;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<ChainVector> sides = zero_sides(evidence.problem);
    sides.front().poses.front()[3 + axis] = 1.0;
    covariance.col(axis) =
        evidence.equations.solve(std::move(sides), SharedVector::Zero()).front().poses.front().tail<3>();
  }
  const Eigen::Matrix3d rotation = first.linear() * session.epochs.front().odometry_from_lidar.linear().transpose();
  const YawPitchRoll angles = yaw_pitch_roll_from_rotation(rotation);
  const Eigen::Matrix3d by_turn = yaw_pitch_roll_jacobian(angles) * first.linear();
  const Eigen::Vector3d sigma = (by_turn * covariance * by_turn.transpose()).diagonal().cwiseSqrt();
  const double values[] = {angles.yaw_rad, angles.pitch_rad, angles.roll_rad};
  constexpr const char* kIds[] = {"odometry yaw", "odometry pitch", "odometry roll"};
  constexpr Message (*kNames[])() = {say::quantity_odometry_yaw, say::quantity_odometry_pitch,
                                     say::quantity_odometry_roll};
  const double limit_rad = degrees_to_radians(evidence.judged_by.max_rotation_sigma_deg);
  for (int i = 0; i < 3; ++i)
    answer.quantities.push_back(judged_quantity(kIds[i], kNames[i](), values[i], sigma[i], "rad", limit_rad));
}

std::string scale_id(std::size_t session) {
  return "odometry scale" + (session > 0 ? " " + std::to_string(session + 1) : std::string());
}

Message scale_name(std::size_t session) {
  return session > 0 ? say::quantity_odometry_scale_of(session + 1) : say::quantity_odometry_scale();
}

// Scales and clocks of the sessions. What a drive leaves as the prior had it is no observation.
void add_own_unknowns(const Evidence& evidence, TrajectoryAnswer& answer) {
  constexpr double kShown = 0.5;  // of the prior's sigma
  const TrajectoryProblem& problem = evidence.problem;
  const OwnVector prior_sigma = evidence.equations.own_prior().cwiseInverse().cwiseSqrt();
  double weights = 0.0;
  for (std::size_t s = 0; s < problem.sessions.size(); ++s) {
    const bool empty = problem.sessions[s].epochs.empty();
    const auto sigma = [&](int at) {
      std::vector<ChainVector> sides = zero_sides(problem);
      sides[s].border[at] = 1.0;
      return std::sqrt(evidence.equations.solve(std::move(sides), SharedVector::Zero())[s].border[at]);
    };
    if (evidence.options.odometry_scale_percent > 0.0 && !empty)
      answer.quantities.push_back(
          judged_quantity(scale_id(s), scale_name(s), 0.0, sigma(kScaleAt), "", kShown * prior_sigma[0]));
    if (problem.position_lag_sigma_s > 0.0 && !empty) {
      answer.result.session_position_lag_s.resize(problem.sessions.size(), 0.0);
      answer.result.session_position_lag_sigma_s.resize(problem.sessions.size(), prior_sigma[kLagAt - kSharedSize]);
      answer.result.session_position_lag_s[s] = evidence.solution.state.own(s)[kLagAt - kSharedSize];
      answer.result.session_position_lag_sigma_s[s] = sigma(kLagAt);
    }
    for (int i = 0; problem.estimate_odometry_drift && !empty && i < 3; ++i) {
      constexpr double kLeast = 1e-3;  // a millimetre on a metre
      const double drift = evidence.solution.state.own(s)[kDriftAt - kSharedSize + i];
      if (stands_out(drift, sigma(kDriftAt + i), kLeast))
        answer.odometry_drift = std::max(answer.odometry_drift, std::abs(drift));
    }
    if (!problem.estimate_clock) continue;
    const double clock_sigma_s = empty ? prior_sigma[1] : sigma(kClockAt);
    const bool seen = clock_sigma_s < kShown * prior_sigma[1];
    answer.clock_weights.push_back(seen ? 1.0 / (clock_sigma_s * clock_sigma_s) : 0.0);
    weights += answer.clock_weights.back();
  }
  answer.result.session_time_offset_s.resize(answer.clock_weights.size());
  if (!(weights > 0.0)) return;
  for (double& weight : answer.clock_weights) weight /= weights;
  answer.result.time_offset = {0.0, 1.0 / std::sqrt(weights), true};
}

void set_status(bool with_ins, TrajectoryAnswer& answer) {
  CalibrationResult& result = answer.result;
  const ParameterSet observed = result.observed();
  const Status status = observed.is_all() ? Status::Ok : Status::Degenerate;
  if (observed.empty()) {
    result.conclude(status, say::nothing_observed());
  } else if (with_ins) {
    result.conclude(status, solved_message(result));
  } else {
    std::vector<Message> missing = parameter_words(~observed & kPositionParameters);
    result.conclude(status,
                    missing.empty() ? say::lever_arm_solved() : say::lever_arm_solved_but_for(std::move(missing)));
  }
}

void set_residuals(const Evidence& evidence, CalibrationResult& result) {
  double squares[2] = {0.0, 0.0}, weights[2] = {0.0, 0.0};
  for (std::size_t s = 0; s < evidence.weighted.terms.size(); ++s)
    for (std::size_t k = 0; k < evidence.weighted.terms[s].size(); ++k) {
      const TrajectoryTerm& term = evidence.weighted.terms[s][k];
      const TrajectoryEpoch& epoch = evidence.problem.sessions[s].epochs[term.epoch];
      const double weight = evidence.weighted.weights[s][k];
      double sigma = 0.0;
      if (term.kind == TermKind::InsPosition) sigma = epoch.ins->position_sigma_m;
      if (term.kind == TermKind::InsAttitude) sigma = epoch.ins->attitude_sigma_rad;
      if (term.kind == TermKind::Antenna) sigma = std::sqrt(epoch.antenna->covariance_enu_m2.trace() / 3.0);
      if (sigma == 0.0) continue;
      const int kind = term.kind == TermKind::InsAttitude ? 1 : 0;
      squares[kind] += weight * sigma * sigma * term.residual.squaredNorm();
      weights[kind] += weight;
    }
  if (weights[0] > 0.0) result.translation_rms_m = std::sqrt(squares[0] / weights[0]);
  if (weights[1] > 0.0) result.rotation_rms_rad = std::sqrt(squares[1] / weights[1]);
}

}  // namespace

TrajectoryAnswer describe_trajectory(const TrajectoryProblem& problem, const TrajectoryOptions& options,
                                     const SolveOptions& judged_by, const TrajectorySolution& solution,
                                     const TrajectoryPrior& prior, bool thorough) {
  TrajectoryAnswer answer;
  WeightedTerms weighted = weighted_terms(problem, options, solution.state, solution.noise);
  TrajectoryEquations equations(problem, options, weighted, solution.noise, prior.information);
  if (!equations.solvable()) {
    answer.result.conclude(Status::NotConverged, say::trajectory_no_solution());
    return answer;
  }
  SharedMatrix information = equations.information();
  SharedMatrix spurious =
      spurious_trajectory_information(problem, options, solution, weighted, equations, prior.information);
  Evidence evidence{problem,     options, judged_by, solution, prior, std::move(weighted), std::move(equations),
                    information, spurious};
  evidence.scatter = block_scatter(evidence);
  const bool with_ins = has_ins(problem), with_antenna = has_antenna(problem);
  if (with_ins) describe_x(evidence, thorough, answer);
  if (with_antenna) {
    const JudgedAntenna judged = judge_antenna(evidence);
    add_lever_arm(evidence, judged, answer);
    // Beside an INS the antenna follows X: what both leave open one by one, they know of each other.
    if (!with_ins) {
      describe_antenna(evidence, judged, answer);
      answer.hold.bottomRightCorner<3, 3>() = held(judged.directions, judged_by).topLeftCorner<3, 3>();
    }
  }
  set_status(with_ins, answer);
  if (!with_ins) add_odometry_heading(evidence, answer);
  add_own_unknowns(evidence, answer);
  set_residuals(evidence, answer.result);
  set_values(solution.state, answer);
  return answer;
}

void set_values(const TrajectoryState& state, TrajectoryAnswer& answer) {
  CalibrationResult& result = answer.result;
  const bool at_antenna = result.mounting.reference == BodyFrame::Antenna;
  result.mounting = at_antenna ? lidar_at_antenna(state) : Mounting{.reference_from_sensor = state.ins_from_lidar};
  for (NamedQuantity& quantity : answer.quantities) {
    for (int i = 0; i < 3; ++i)
      if (quantity.id == lever_arm_id(i)) quantity.value = state.antenna_in_lidar[i];
    for (std::size_t s = 0; s < state.scale.size(); ++s)
      if (quantity.id == scale_id(s)) quantity.value = 1.0 + state.scale[s];
  }
  double offset_s = 0.0;
  for (std::size_t s = 0; s < answer.clock_weights.size(); ++s) {
    result.session_time_offset_s[s] = state.clock_s[s];
    offset_s += answer.clock_weights[s] * state.clock_s[s];
  }
  if (result.time_offset.applied) result.time_offset.offset_s = offset_s;
}

}  // namespace remount::calibration
