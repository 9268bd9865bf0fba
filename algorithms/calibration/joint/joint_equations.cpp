#include "algorithms/calibration/joint/joint_equations.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "algorithms/calibration/joint/shared_block.h"
#include "algorithms/calibration/linear_solutions.h"

namespace remount::calibration {
namespace {

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

void add_term(const LinearTerm& linear, const NoiseModel& noise, NormalEquations& equations, SharedBlock& shared) {
  const Matrix6d information = term_information(linear, noise);
  const bool a_behind_b = linear.a.at > linear.b.at;
  const NodePart& row = a_behind_b ? linear.a : linear.b;
  const NodePart& column = a_behind_b ? linear.b : linear.a;
  const Matrix6d weighted_row = information * row.jacobian, weighted_column = information * column.jacobian;
  const std::size_t row_block = block_of(row.at), column_block = block_of(column.at);
  KeyframeBlocks& blocks = equations.keyframes;
  blocks.at(row_block, row_block).noalias() += row.jacobian.transpose() * weighted_row;
  blocks.at(column_block, column_block).noalias() += column.jacobian.transpose() * weighted_column;
  blocks.at(row_block, column_block).noalias() += row.jacobian.transpose() * weighted_column;
  equations.coupling.middleRows<6>(row.at).noalias() += weighted_row.transpose() * linear.shared;
  equations.coupling.middleRows<6>(column.at).noalias() += weighted_column.transpose() * linear.shared;
  equations.keyframe_side.segment<6>(row.at).noalias() -= weighted_row.transpose() * linear.residual;
  equations.keyframe_side.segment<6>(column.at).noalias() -= weighted_column.transpose() * linear.residual;
  const Eigen::Matrix<double, 6, Eigen::Dynamic> weighted_shared = information * linear.shared;
  shared.add(linear.shared, weighted_shared);
  equations.shared_side.noalias() -= weighted_shared.transpose() * linear.residual;
  equations.cost += linear.residual.dot(information * linear.residual);
  equations.log_information += log_determinant(information);
}

BlockPattern pattern_of(const JointProblem& problem, const std::vector<LinearTerm>& terms, const Layout& layout) {
  std::vector<BlockPattern::Link> links;
  const auto link = [&](Eigen::Index one, Eigen::Index other) { links.emplace_back(block_of(one), block_of(other)); };
  for (const LinearTerm& term : terms) link(term.a.at, term.b.at);
  for (motion::KeyframeIndex k; layout.drift && k < problem.nodes.size(); ++k) {
    link(layout.node_at(k), layout.drift_at(k));
    if (!is_first_of_session(problem, k)) link(layout.drift_at(motion::KeyframeIndex(k - 1)), layout.drift_at(k));
  }
  for (motion::KeyframeIndex k; k < problem.nodes.size(); ++k)
    for (motion::KeyframeIndex other(k + 1); other < k + taken_at_once(problem, k); ++other) {
      link(layout.node_at(k), layout.node_at(other));
      if (!layout.drift) continue;
      link(layout.drift_at(k), layout.node_at(other));
      link(layout.node_at(k), layout.drift_at(other));
      link(layout.drift_at(k), layout.drift_at(other));
    }
  return {block_of(layout.nodes_size(problem.nodes.size())), std::move(links)};
}

void place_beams(const JointProblem& problem, Layout& layout) {
  Eigen::Index at = layout.beams_at();
  for (const JointLidar& lidar : problem.lidars) {
    Layout::Beams beams;
    beams.single = lidar.beams.of_single;
    beams.common = lidar.beams.basis.cols() - beams.single;
    beams.common_at = at;
    at += beams.common;
    layout.beams += beams.count();
    layout.beams_of.push_back(beams);
  }
  for (Layout::Beams& beams : layout.beams_of) {
    beams.single_at = at;
    at += beams.single;
  }
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
  layout.drift = noise.drifts();
  layout.lidars = std::ssize(problem.lidars);
  place_beams(problem, layout);
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

Vector6d white_error(const JointProblem& problem, const State& state, const Layout& layout,
                     motion::KeyframeIndex node) {
  if (!layout.drift) return state.errors[node];
  return state.errors[node] - drift_in_body(problem.nodes[node]) * state.drifts[node];
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
  if (linear.term->whole) return linear.term->weight * linear.term->information;
  return linear.term->weight * noise.registration_information(linear.term->information, linear.share);
}

Matrix6d drift_in_body(const JointNode& node) {
  Matrix6d turn = Matrix6d::Identity();
  turn.topLeftCorner<3, 3>() = node.local_from_ins.linear().transpose();
  return turn;
}

State start_state(const JointProblem& problem, const Layout& layout, std::vector<RigidTransform> ins_from_lidars) {
  State state{std::move(ins_from_lidars),
              std::vector<Vector6d>(problem.nodes.size(), Vector6d::Zero()),
              {},
              Eigen::VectorXd::Zero(layout.size())};
  if (layout.drift) state.drifts = state.errors;
  return state;
}

NormalEquations sum_terms(const JointProblem& problem, const std::vector<LinearTerm>& terms, const NoiseModel& noise,
                          const Layout& layout) {
  const Eigen::Index unknowns = layout.nodes_size(problem.nodes.size());
  NormalEquations equations;
  equations.keyframes = KeyframeBlocks(pattern_of(problem, terms, layout));
  equations.coupling = Eigen::MatrixXd::Zero(unknowns, layout.size());
  equations.shared = Eigen::MatrixXd::Zero(layout.size(), layout.size());
  equations.keyframe_side = Eigen::VectorXd::Zero(unknowns);
  equations.shared_side = Eigen::VectorXd::Zero(layout.size());
  SharedBlock shared(equations.shared);
  for (const LinearTerm& term : terms) add_term(term, noise, equations, shared);
  shared.finish();
  return equations;
}

bool same_terms(const NoiseModel& one, const NoiseModel& other) {
  return one.registration_scale == other.registration_scale && one.registration_floor_m == other.registration_floor_m &&
         one.registration_floor_rad == other.registration_floor_rad;
}

NormalEquations build(const JointProblem& problem, const std::vector<LinearTerm>& terms, const NoiseModel& noise,
                      const State& state, const Layout& layout) {
  NormalEquations equations = sum_terms(problem, terms, noise, layout);
  add_priors(problem, noise, state, layout, equations);
  Eigen::Index single = 0;
  for (const Layout::Beams& beams : layout.beams_of) single += beams.single;
  equations.single_beams = state.shared.tail(single);
  return equations;
}

// Registrations over ways of the same length see surfaces alike and err alike: of the errors of single beams, which
// many of them together seem to tell well, they tell less than independent ones would. What is left of their
// information on the beams counts by a part; on X, given the beams, in full. docs/maths/beams.md (B6)
// What was measured of X tells nothing of the beams but through X, and counts in full.
void discount_beams(const NormalEquations& equations, Eigen::VectorXd& side, Eliminated& out) {
  // Three times the sigma: simulated streets and figures of eight with perfect beams, seeds 1 to 9.
  constexpr double kTimes = 9.0;
  const Eigen::VectorXd& beams = equations.single_beams;
  const Eigen::Index count = beams.size(), rest = side.size() - count;
  const Eigen::MatrixXd coupling = out.whole.topRightCorner(rest, count);
  Eigen::MatrixXd others = out.whole.topLeftCorner(rest, rest);
  const Eigen::Index mountings = equations.measured.rows();
  others.topLeftCorner(mountings, mountings) -= equations.measured;
  const Eigen::MatrixXd along_others = symmetric_solution(others, coupling);
  const Eigen::MatrixXd by_others = coupling.transpose() * along_others,
                        prior = Eigen::MatrixXd::Identity(count, count);
  out.reduced.bottomRightCorner(count, count) =
      by_others + prior + (out.whole.bottomRightCorner(count, count) - prior - by_others) / kTimes;
  out.counted.bottomLeftCorner(count, rest) = (1.0 - 1.0 / kTimes) * along_others.transpose();
  out.counted.bottomRightCorner(count, count) = prior / kTimes;
  side.tail(count) += beams;  // the prior's part counts in full
  side.head(mountings) -= equations.measured_side;
  side = out.counted * side;
  side.head(mountings) += equations.measured_side;
  side.tail(count) -= beams;
}

void eliminate(const NormalEquations& equations, Eliminated& out) {
  out.valid = out.factors.factorize(equations.keyframes);
  if (!out.valid) return;
  const Eigen::Index shared = equations.shared.rows();
  Eigen::MatrixXd sides(equations.coupling.rows(), shared + 1);
  sides << equations.coupling, equations.keyframe_side;
  const Eigen::MatrixXd halves = out.factors.solve_lower(sides);
  const Eigen::MatrixXd products = halves * halves.topRows(shared).transpose();  // with B and with p, of B
  out.whole = equations.shared - products.topRows(shared);
  out.whole = 0.5 * (out.whole + out.whole.transpose().eval());
  Eigen::VectorXd side = equations.shared_side - products.bottomRows(1).transpose();
  const auto take_step = [&](const Eigen::LDLT<Eigen::MatrixXd>& factors) {
    out.shared_step = factors.solve(side);
    const Eigen::MatrixXd half_step = halves.bottomRows(1) - out.shared_step.transpose() * halves.topRows(shared);
    out.keyframe_step = out.factors.solve_upper(half_step);
    out.valid = out.shared_step.allFinite() && out.keyframe_step.allFinite();
  };
  const Eigen::LDLT<Eigen::MatrixXd> small(out.whole);
  take_step(small);
  // At this linearisation the minimum of the cost is known without taking the step.
  const double least_cost =
      equations.cost - equations.shared_side.dot(out.shared_step) - equations.keyframe_side.dot(out.keyframe_step);
  out.minus_two_log_likelihood = least_cost - equations.log_information + out.factors.log_determinant() +
                                 small.vectorD().array().abs().max(1e-300).log().sum();
  out.reduced = out.whole;
  out.counted = Eigen::MatrixXd::Identity(shared, shared);
  out.whole_shared_step = out.shared_step, out.whole_keyframe_step = out.keyframe_step;
  if (equations.single_beams.size() == 0) return;
  discount_beams(equations, side, out);
  take_step(out.reduced.ldlt());
}

}  // namespace remount::calibration
