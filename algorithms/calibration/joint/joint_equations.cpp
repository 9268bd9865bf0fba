#include "algorithms/calibration/joint/joint_equations.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "algorithms/calibration/joint/keyframe_blocks.h"
#include "algorithms/calibration/joint/pair_equation.h"

namespace remount::calibration {
namespace {

double position_lag_sigma_s(const JointProblem& problem, motion::SessionIndex session) {
  const std::vector<double>& sigmas_s = problem.session_position_lag_sigma_s;
  return session < sigmas_s.size() ? sigmas_s[session] : 0.0;
}

RigidTransform apply_errors(const JointNode& node, motion::KeyframeIndex index, const State& state,
                            const Layout& layout) {
  Vector6d step = state.errors[index];
  if (layout.drift) step += drift_in_body(node) * state.drifts[index];
  if (layout.bias) step.tail<3>() += state.shared.segment<3>(layout.bias_at(node.session));
  if (layout.clock) step += node.body_velocity * state.shared[layout.clock_at(node.session)];
  if (layout.lag) step += moved_by_lag(node) * state.shared[layout.lag_at(node.session)];
  return moved_in_body(node.local_from_ins, step);
}

// As the LiDAR would have it without what its beams err by.
RigidTransform motion_without_beam_errors(const JointTerm& term, const State& state, const Layout& layout) {
  if (layout.beams == 0) return term.lidar_b_from_lidar_a;
  return perturb(term.lidar_b_from_lidar_a, term.beam_response * state.shared.segment(layout.beams_at(), layout.beams));
}

// Of the directions that the matrix knows. One without information (a corridor's length) has no residual either: a
// floor in its place would pass for an exact measurement's, or grow and shrink with nothing.
double log_determinant(const Matrix6d& matrix) {
  constexpr double kLever_m = 10.0;  // makes rotations comparable
  constexpr double kNothing = 1e-12;
  Vector6d scale = Vector6d::Ones();
  scale.tail<3>().setConstant(1.0 / kLever_m);
  const Eigen::LDLT<Matrix6d> factors(scale.asDiagonal() * matrix * scale.asDiagonal());
  const double least = kNothing * factors.vectorD().maxCoeff();
  double sum = 0.0;
  for (const double pivot : factors.vectorD())
    if (pivot > least) sum += std::log(pivot);
  return sum;
}

// Jacobian of one term with respect to the shared unknowns.
Eigen::MatrixXd shared_jacobian(const PairEquation& equation, const JointTerm& term, const JointNode& a,
                                const JointNode& b, const Layout& layout) {
  Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(6, layout.size());
  jacobian.leftCols<6>() = equation.d_x;
  if (layout.bias) {
    jacobian.middleCols<3>(layout.bias_at(a.session)) += equation.d_a.rightCols<3>();
    jacobian.middleCols<3>(layout.bias_at(b.session)) += equation.d_b.rightCols<3>();
  }
  if (layout.clock) {
    jacobian.col(layout.clock_at(a.session)) += equation.d_a * a.body_velocity;
    jacobian.col(layout.clock_at(b.session)) += equation.d_b * b.body_velocity;
  }
  if (layout.lag) {
    jacobian.col(layout.lag_at(a.session)) += equation.d_a * moved_by_lag(a);
    jacobian.col(layout.lag_at(b.session)) += equation.d_b * moved_by_lag(b);
  }
  // The residual leads from the measured motion to the predicted one.
  if (layout.beams > 0) jacobian.middleCols(layout.beams_at(), layout.beams) -= term.beam_response;
  return jacobian;
}

// The drift walks from each keyframe to the next; that of a session's first is zero, for only differences matter.
void add_drift_prior(const JointProblem& problem, const NoiseModel& noise, const State& state, const Layout& layout,
                     NormalEquations& equations, KeyframeBlocks& blocks) {
  for (motion::KeyframeIndex k; k < problem.nodes.size(); ++k) {
    const bool first = is_first_of_session(problem, k);
    const Vector6d information = drift_step_information(problem, noise, k);
    const Vector6d change = first ? state.drifts[k] : Vector6d(state.drifts[k] - state.drifts[k - 1]);
    const Eigen::Index here = layout.node_at(k) + 6;
    blocks.at(k, k).bottomRightCorner<6, 6>().diagonal() += information;
    equations.keyframe_side.segment<6>(here) -= information.cwiseProduct(change);
    if (!first) {
      const motion::KeyframeIndex last(k - 1);
      const Eigen::Index before = layout.node_at(last) + 6;
      blocks.at(last, last).bottomRightCorner<6, 6>().diagonal() += information;
      blocks.at(k, last).bottomRightCorner<6, 6>().diagonal() -= information;
      equations.keyframe_side.segment<6>(before) += information.cwiseProduct(change);
    }
    equations.cost += change.dot(information.cwiseProduct(change));
    equations.log_information += information.array().log().sum();
  }
}

void add_priors(const JointProblem& problem, const NoiseModel& noise, const State& state, const Layout& layout,
                NormalEquations& equations, KeyframeBlocks& blocks) {
  for (motion::KeyframeIndex k; k < state.errors.size(); ++k) {
    const Eigen::LDLT<Matrix6d> covariance(node_covariance(problem, noise, k));
    const Matrix6d information = covariance.solve(Matrix6d::Identity());
    const Vector6d weighted = information * state.errors[k];
    const Eigen::Index at = layout.node_at(k);
    blocks.at(k, k).topLeftCorner<6, 6>() += information;
    equations.keyframe_side.segment<6>(at) -= weighted;
    equations.cost += state.errors[k].dot(weighted);
    equations.log_information -= covariance.vectorD().array().log().sum();
  }
  if (layout.drift) add_drift_prior(problem, noise, state, layout, equations, blocks);
  const auto prior = [&](Eigen::Index at, double sigma, double value) {
    const double information = 1.0 / (sigma * sigma);
    equations.shared(at, at) += information;
    equations.shared_side[at] -= information * value;
    equations.cost += information * value * value;
  };
  constexpr double kHeldSigma = 1e-9;  // rad, s; a session without an error beside one with: its columns stay regular
  for (motion::SessionIndex s; signed_of(s) < layout.sessions; ++s) {
    if (layout.bias) {
      const double sigma = std::max(kHeldSigma, problem.session_attitude_bias_sigma_rad[s]);
      const double tilt = std::hypot(sigma, tilt_sigma_rad(problem, s));
      for (int i = 0; i < 3; ++i)
        prior(layout.bias_at(s) + i, i < 2 ? tilt : sigma, state.shared[layout.bias_at(s) + i]);
    }
    if (layout.clock) prior(layout.clock_at(s), problem.time_offset_prior_sigma_s, state.shared[layout.clock_at(s)]);
    if (layout.lag)
      prior(layout.lag_at(s), std::max(kHeldSigma, position_lag_sigma_s(problem, s)), state.shared[layout.lag_at(s)]);
  }
  for (Eigen::Index i = 0; i < layout.beams; ++i)
    prior(layout.beams_at() + i, 1.0, state.shared[layout.beams_at() + i]);
  const Vector6d from_prior = difference(problem.prior_ins_from_lidar, state.ins_from_lidar);
  const Vector6d weighted = problem.prior_information * from_prior;
  equations.shared.topLeftCorner<6, 6>() += problem.prior_information;
  equations.shared_side.head<6>() -= weighted;
  equations.cost += from_prior.dot(weighted);
  for (const MeasuredRow& known : problem.measured.rows(state.ins_from_lidar)) {
    const double information = 1.0 / (known.sigma * known.sigma);
    equations.shared.topLeftCorner<6, 6>() += information * known.row * known.row.transpose();
    equations.shared_side.head<6>() += information * known.residual * known.row;
    equations.cost += information * known.residual * known.residual;
  }
}

NodePart node_part(const JointNode& node, motion::KeyframeIndex index, const Matrix6d& body_jacobian,
                   const Layout& layout) {
  NodePart part{layout.node_at(index), {}};
  part.jacobian.resize(6, layout.node_size());
  part.jacobian.leftCols<6>() = body_jacobian;
  if (layout.drift) part.jacobian.rightCols<6>() = body_jacobian * drift_in_body(node);
  return part;
}

// J' L J of a term's two keyframes.
void add_parts(const LinearTerm& linear, const Matrix6d& information, KeyframeBlocks& blocks) {
  const auto add = [&](motion::KeyframeIndex row, const NodePart& of_row, motion::KeyframeIndex column,
                       const NodePart& of_column) {
    const Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, 12> weighted = information * of_column.jacobian;
    blocks.at(row, column).noalias() += of_row.jacobian.transpose().lazyProduct(weighted);
  };
  const motion::KeyframeIndex a = linear.term->node_a, b = linear.term->node_b;
  add(a, linear.a, a, linear.a);
  add(b, linear.b, b, linear.b);
  if (a > b)
    add(a, linear.a, b, linear.b);
  else
    add(b, linear.b, a, linear.a);
}

void add_term(const LinearTerm& linear, const NoiseModel& noise, const Layout& layout, NormalEquations& equations,
              KeyframeBlocks& blocks) {
  const Matrix6d information = term_information(linear, noise);
  add_parts(linear, information, blocks);
  const Vector6d weighted = information * linear.residual;
  const Eigen::MatrixXd weighted_shared = information * linear.shared;
  for (const NodePart* part : {&linear.a, &linear.b}) {
    equations.coupling.middleRows(part->at, layout.node_size()).noalias() +=
        part->jacobian.transpose() * weighted_shared;
    equations.keyframe_side.segment(part->at, layout.node_size()).noalias() -= part->jacobian.transpose() * weighted;
  }
  equations.shared.noalias() += linear.shared.transpose() * weighted_shared;
  equations.shared_side.noalias() -= linear.shared.transpose() * weighted;
  equations.cost += linear.residual.dot(weighted);
  equations.log_information += log_determinant(information);
}

}  // namespace

Layout layout_of(const JointProblem& problem, const NoiseModel& noise) {
  Layout layout;
  layout.sessions = std::ssize(problem.session_attitude_bias_sigma_rad);
  for (const JointNode& node : problem.nodes) layout.sessions = std::max(layout.sessions, signed_of(node.session) + 1);
  for (const double sigma : problem.session_attitude_bias_sigma_rad) layout.bias = layout.bias || sigma > 0.0;
  for (const double sigma : problem.session_tilt_sigma_rad) layout.bias = layout.bias || sigma > 0.0;
  layout.clock = problem.estimate_time_offset;
  for (const double sigma : problem.session_position_lag_sigma_s) layout.lag = layout.lag || sigma > 0.0;
  layout.beams = problem.beams.basis.cols();
  layout.drift = noise.drifts();
  return layout;
}

double tilt_sigma_rad(const JointProblem& problem, motion::SessionIndex session) {
  const std::vector<double>& sigmas_rad = problem.session_tilt_sigma_rad;
  return session < sigmas_rad.size() ? sigmas_rad[session] : 0.0;
}

Vector6d moved_by_lag(const JointNode& node) {
  Vector6d moved = node.body_velocity;
  moved.tail<3>().setZero();
  return moved;
}

Matrix6d node_covariance(const JointProblem& problem, const NoiseModel& noise, motion::KeyframeIndex node) {
  Matrix6d covariance =
      noise.node_covariance(problem.nodes[node].scan_covariance) + problem.nodes[node].between_samples_covariance;
  const double tilt = tilt_sigma_rad(problem, problem.nodes[node].session);
  covariance.diagonal().segment<2>(3).array() += tilt * tilt;
  return covariance;
}

bool is_first_of_session(const JointProblem& problem, motion::KeyframeIndex node) {
  return node == 0 || problem.nodes[node - 1].session != problem.nodes[node].session;
}

Vector6d drift_step_information(const JointProblem& problem, const NoiseModel& noise, motion::KeyframeIndex node) {
  constexpr double kStart = 1e-6;           // m and rad: zero for all purposes
  constexpr double kLeastStep_s = 1e-3;     // keyframes at the same time
  constexpr double kLeastVariance = 1e-14;  // of a component that does not drift
  if (is_first_of_session(problem, node)) return Vector6d::Constant(1.0 / (kStart * kStart));
  const double step_s = std::max(kLeastStep_s, problem.nodes[node].time_s - problem.nodes[node - 1].time_s);
  return noise.drift_covariance(step_s).diagonal().cwiseMax(kLeastVariance).cwiseInverse();
}

Matrix6d term_information(const LinearTerm& linear, const NoiseModel& noise) {
  return linear.term->weight * noise.registration_information(linear.term->information, linear.share);
}

Matrix6d drift_in_body(const JointNode& node) {
  Matrix6d turn = Matrix6d::Identity();
  turn.topLeftCorner<3, 3>() = node.local_from_ins.linear().transpose();
  return turn;
}

State start_state(const JointProblem& problem, const Layout& layout, const RigidTransform& ins_from_lidar) {
  State state{ins_from_lidar,
              std::vector<Vector6d>(problem.nodes.size(), Vector6d::Zero()),
              {},
              Eigen::VectorXd::Zero(layout.size())};
  if (layout.drift) state.drifts = state.errors;
  return state;
}

std::vector<LinearTerm> linearise(const JointProblem& problem, const State& state, const Layout& layout) {
  std::vector<RigidTransform> poses;
  for (motion::KeyframeIndex k; k < problem.nodes.size(); ++k)
    poses.push_back(apply_errors(problem.nodes[k], k, state, layout));
  std::vector<LinearTerm> out;
  for (const JointTerm& term : problem.terms) {
    if (!(term.weight > 0.0)) continue;
    const motion::KeyframeIndex a = term.node_a, b = term.node_b;
    const PairEquation pair = linearise_pair(poses[b].inverse() * poses[a],
                                             motion_without_beam_errors(term, state, layout), state.ins_from_lidar);
    out.push_back({&term, pair.residual, node_part(problem.nodes[a], a, pair.d_a, layout),
                   node_part(problem.nodes[b], b, pair.d_b, layout),
                   shared_jacobian(pair, term, problem.nodes[a], problem.nodes[b], layout),
                   problem.nodes[a].scan_covariance.isZero(0.0) ? 1.0 : 1.0 - NoiseModel::kScanShare});
  }
  return out;
}

NormalEquations build(const JointProblem& problem, const std::vector<LinearTerm>& terms, const NoiseModel& noise,
                      const State& state, const Layout& layout) {
  const Eigen::Index unknowns = layout.nodes_size(problem.nodes.size());
  NormalEquations equations;
  equations.coupling = Eigen::MatrixXd::Zero(unknowns, layout.size());
  equations.shared = Eigen::MatrixXd::Zero(layout.size(), layout.size());
  equations.keyframe_side = Eigen::VectorXd::Zero(unknowns);
  equations.shared_side = Eigen::VectorXd::Zero(layout.size());
  equations.single_beams = state.shared.tail(problem.beams.of_single);
  std::vector<KeyframeBlocks::Link> links;
  for (const LinearTerm& term : terms) links.emplace_back(term.term->node_a, term.term->node_b);
  for (motion::KeyframeIndex k; layout.drift && k < problem.nodes.size(); ++k)
    if (!is_first_of_session(problem, k)) links.emplace_back(k - 1, k);
  KeyframeBlocks blocks(problem.nodes.size(), layout.node_size(), std::move(links));
  for (const LinearTerm& term : terms) add_term(term, noise, layout, equations, blocks);
  add_priors(problem, noise, state, layout, equations, blocks);
  Sparse summed = blocks.take();
  equations.keyframes.swap(summed);  // Eigen's move is a copy
  return equations;
}

// Registrations over ways of the same length see surfaces alike and err alike: of the errors of single beams, which
// many of them together seem to tell well, they tell less than independent ones would. What is left of their
// information on the beams counts by a part; on X, given the beams, in full. docs/maths/beams.md (B6)
void discount_beams(const Eigen::VectorXd& beams, Eigen::VectorXd& side, Eliminated& out) {
  constexpr double kTimes =
      9.0;  // three times the sigma: simulated streets and figures of eight, perfect beams, seeds 1 to 9
  const Eigen::Index count = beams.size(), rest = side.size() - count;
  const Eigen::MatrixXd coupling = out.whole.topRightCorner(rest, count);
  const Eigen::MatrixXd along_others = out.whole.topLeftCorner(rest, rest).ldlt().solve(coupling);
  const Eigen::MatrixXd by_others = coupling.transpose() * along_others,
                        prior = Eigen::MatrixXd::Identity(count, count);
  out.reduced.bottomRightCorner(count, count) =
      by_others + prior + (out.whole.bottomRightCorner(count, count) - prior - by_others) / kTimes;
  out.counted.bottomLeftCorner(count, rest) = (1.0 - 1.0 / kTimes) * along_others.transpose();
  out.counted.bottomRightCorner(count, count) = prior / kTimes;
  side.tail(count) += beams;  // the prior's part counts in full
  side = out.counted * side;
  side.tail(count) -= beams;
}

void eliminate(const NormalEquations& equations, Eliminated& out) {
  const Eigen::Index unknowns = equations.keyframes.cols(), entries = equations.keyframes.nonZeros();
  if (out.analysed_unknowns != unknowns || out.analysed_entries != entries)
    out.factors.analyzePattern(equations.keyframes);
  out.analysed_unknowns = unknowns, out.analysed_entries = entries;
  out.factors.factorize(equations.keyframes);
  out.valid = out.factors.info() == Eigen::Success && out.factors.vectorD().minCoeff() > 0.0;
  if (!out.valid) return;
  const Eigen::MatrixXd solved = out.factors.solve(equations.coupling);
  out.whole = equations.shared - equations.coupling.transpose() * solved;
  out.whole = 0.5 * (out.whole + out.whole.transpose().eval());
  out.reduced = out.whole;
  out.counted = Eigen::MatrixXd::Identity(out.whole.rows(), out.whole.cols());
  const Eigen::VectorXd solved_side = out.factors.solve(equations.keyframe_side);
  Eigen::VectorXd side = equations.shared_side - equations.coupling.transpose() * solved_side;
  const Eigen::LDLT<Eigen::MatrixXd> small(out.whole);
  out.shared_step = small.solve(side);
  out.keyframe_step = solved_side - solved * out.shared_step;
  out.valid = out.shared_step.allFinite() && out.keyframe_step.allFinite();
  // At this linearisation the minimum of the cost is known without taking the step.
  const double least_cost =
      equations.cost - equations.shared_side.dot(out.shared_step) - equations.keyframe_side.dot(out.keyframe_step);
  out.minus_two_log_likelihood = least_cost - equations.log_information +
                                 out.factors.vectorD().array().max(1e-300).log().sum() +
                                 small.vectorD().array().abs().max(1e-300).log().sum();
  if (equations.single_beams.size() == 0) return;
  discount_beams(equations.single_beams, side, out);
  out.shared_step = out.reduced.ldlt().solve(side);
  out.keyframe_step = solved_side - solved * out.shared_step;
  out.valid = out.shared_step.allFinite() && out.keyframe_step.allFinite();
}

}  // namespace remount::calibration
