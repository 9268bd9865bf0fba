#include "algorithms/calibration/joint_solver.h"

#include <Eigen/Cholesky>
#include <Eigen/SparseCholesky>
#include <cmath>

#include "algorithms/calibration/pair_equation.h"

namespace remount {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

// The normal equations at one point, with the keyframes' block kept apart: [A B; B' C] [e; g] = [p; q].
struct NormalEquations {
  Sparse keyframes;          // A
  Eigen::MatrixXd coupling;  // B
  Eigen::MatrixXd shared;    // C: X, attitude biases, clock offsets
  Eigen::VectorXd keyframe_side, shared_side;
  double cost = 0.0;             // sum of squared residuals and priors
  double log_information = 0.0;  // sum of log |information| of all terms and priors
};

// Where the unknowns lie: of each keyframe its white error and, where the INS drifts, its drift; then what is shared.
struct Layout {
  int sessions = 0;
  bool bias = false, clock = false, drift = false;
  int node_size() const { return drift ? 12 : 6; }
  int node_at(std::size_t node) const { return node_size() * static_cast<int>(node); }
  int size() const { return 6 + (bias ? 3 * sessions : 0) + (clock ? sessions : 0); }
  int bias_at(int session) const { return 6 + 3 * session; }
  int clock_at(int session) const { return 6 + (bias ? 3 * sessions : 0) + session; }
};

Layout layout_of(const JointProblem& problem, const NoiseModel& noise) {
  Layout layout;
  layout.sessions = static_cast<int>(problem.session_attitude_bias_sigma_rad.size());
  for (const double sigma : problem.session_attitude_bias_sigma_rad) layout.bias = layout.bias || sigma > 0.0;
  layout.clock = problem.estimate_time_offset;
  layout.drift = noise.drifts();
  return layout;
}

struct State {
  RigidTransform ins_from_lidar;
  std::vector<Vector6d> errors;  // of each node, independent; body axes
  std::vector<Vector6d> drifts;  // of each node, local axes for position, body axes for attitude; empty without drift
  Eigen::VectorXd shared;        // biases and offsets; the first six are not used
};

// A drift in body axes: its position part is kept in the axes of the trajectory, where it accumulates.
Matrix6d drift_in_body(const JointNode& node) {
  Matrix6d turn = Matrix6d::Identity();
  turn.topLeftCorner<3, 3>() = node.local_from_ins.linear().transpose();
  return turn;
}

RigidTransform corrected(const JointNode& node, std::size_t index, const State& state, const Layout& layout) {
  Vector6d step = state.errors[index];
  if (layout.drift) step += drift_in_body(node) * state.drifts[index];
  if (layout.bias) step.tail<3>() += state.shared.segment<3>(layout.bias_at(node.session));
  if (layout.clock) step += node.body_velocity * state.shared[layout.clock_at(node.session)];
  return moved_in_body(node.local_from_ins, step);
}

double log_determinant(const Matrix6d& matrix) {
  const Eigen::LDLT<Matrix6d> factors(matrix);
  return factors.vectorD().array().max(1e-300).log().sum();
}

// Jacobian of one term with respect to the shared unknowns.
Eigen::MatrixXd shared_jacobian(const PairEquation& equation, const JointNode& a, const JointNode& b,
                                const Layout& layout) {
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
  return jacobian;
}

using Entries = std::vector<Eigen::Triplet<double>>;

void add_block(int row, int column, const Matrix6d& block, Entries& entries) {
  for (int c = 0; c < 6; ++c)
    for (int r = 0; r < 6; ++r) entries.emplace_back(row + r, column + c, block(r, c));
}

// The drift walks from each keyframe to the next; that of a session's first is zero, for only differences matter.
void add_drift_prior(const JointProblem& problem, const NoiseModel& noise, const State& state, const Layout& layout,
                     NormalEquations& equations, Entries& entries) {
  constexpr double kStart = 1e-6;           // m and rad: zero for all purposes
  constexpr double kLeastStep_s = 1e-3;     // keyframes at the same time
  constexpr double kLeastVariance = 1e-14;  // of a component that does not drift
  for (std::size_t k = 0; k < problem.nodes.size(); ++k) {
    const bool first = k == 0 || problem.nodes[k - 1].session != problem.nodes[k].session;
    Vector6d variances = Vector6d::Constant(kStart * kStart);
    if (!first)
      variances = noise.drift_covariance(std::max(kLeastStep_s, problem.nodes[k].time_s - problem.nodes[k - 1].time_s))
                      .diagonal()
                      .cwiseMax(kLeastVariance);
    const Vector6d information = variances.cwiseInverse();
    const Vector6d change = first ? state.drifts[k] : Vector6d(state.drifts[k] - state.drifts[k - 1]);
    const int here = layout.node_at(k) + 6;
    const Matrix6d block = information.asDiagonal();
    add_block(here, here, block, entries);
    equations.keyframe_side.segment<6>(here) -= information.cwiseProduct(change);
    if (!first) {
      const int before = layout.node_at(k - 1) + 6;
      add_block(before, before, block, entries);
      add_block(here, before, -block, entries);
      equations.keyframe_side.segment<6>(before) += information.cwiseProduct(change);
    }
    equations.cost += change.dot(information.cwiseProduct(change));
    equations.log_information += information.array().log().sum();
  }
}

void add_priors(const JointProblem& problem, const NoiseModel& noise, const State& state, const Layout& layout,
                NormalEquations& equations, Entries& entries) {
  for (std::size_t k = 0; k < state.errors.size(); ++k) {
    const Eigen::LDLT<Matrix6d> covariance(noise.node_covariance(problem.nodes[k].scan_covariance));
    const Matrix6d information = covariance.solve(Matrix6d::Identity());
    const Vector6d weighted = information * state.errors[k];
    const int at = layout.node_at(k);
    add_block(at, at, information, entries);
    equations.keyframe_side.segment<6>(at) -= weighted;
    equations.cost += state.errors[k].dot(weighted);
    equations.log_information -= covariance.vectorD().array().log().sum();
  }
  if (layout.drift) add_drift_prior(problem, noise, state, layout, equations, entries);
  const auto prior = [&](int at, double sigma, double value) {
    const double information = 1.0 / (sigma * sigma);
    equations.shared(at, at) += information;
    equations.shared_side[at] -= information * value;
    equations.cost += information * value * value;
  };
  constexpr double kHeldSigma_rad = 1e-9;  // a session without a bias beside one with: its columns stay regular
  for (int s = 0; s < layout.sessions; ++s) {
    if (layout.bias) {
      const double sigma =
          std::max(kHeldSigma_rad, problem.session_attitude_bias_sigma_rad[static_cast<std::size_t>(s)]);
      for (int i = 0; i < 3; ++i) prior(layout.bias_at(s) + i, sigma, state.shared[layout.bias_at(s) + i]);
    }
    if (layout.clock) prior(layout.clock_at(s), problem.time_offset_prior_sigma_s, state.shared[layout.clock_at(s)]);
  }
  const Vector6d from_prior = difference(problem.prior_ins_from_lidar, state.ins_from_lidar);
  const Vector6d weighted = problem.prior_information * from_prior;
  equations.shared.topLeftCorner<6, 6>() += problem.prior_information;
  equations.shared_side.head<6>() -= weighted;
  equations.cost += from_prior.dot(weighted);
}

// One keyframe's part in a pair: its block of unknowns and their Jacobian.
struct NodePart {
  int at;
  Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, 12> jacobian;
};

NodePart node_part(const JointNode& node, std::size_t index, const Matrix6d& body_jacobian, const Layout& layout) {
  NodePart part{layout.node_at(index), {}};
  part.jacobian.resize(6, layout.node_size());
  part.jacobian.leftCols<6>() = body_jacobian;
  if (layout.drift) part.jacobian.rightCols<6>() = body_jacobian * drift_in_body(node);
  return part;
}

// The lower triangle of J' L J for two parts.
void add_parts(const NodePart& row, const NodePart& column, const Matrix6d& information, Entries& entries) {
  const Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, 12> weighted = information * column.jacobian;
  const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 12, 12> block = row.jacobian.transpose() * weighted;
  for (int c = 0; c < block.cols(); ++c)
    for (int r = 0; r < block.rows(); ++r)
      if (row.at + r >= column.at + c) entries.emplace_back(row.at + r, column.at + c, block(r, c));
}

// A term at one state: what does not depend on the noise model, so that many models are compared at one linearisation.
struct LinearTerm {
  const JointTerm* term;
  Vector6d residual;
  NodePart a, b;
  Eigen::MatrixXd shared;
  double share;  // of the registration's variance that is its own
};

std::vector<LinearTerm> linearise(const JointProblem& problem, const State& state, const Layout& layout) {
  std::vector<RigidTransform> poses;
  for (std::size_t k = 0; k < problem.nodes.size(); ++k) poses.push_back(corrected(problem.nodes[k], k, state, layout));
  std::vector<LinearTerm> out;
  for (const JointTerm& term : problem.terms) {
    if (!(term.weight > 0.0)) continue;
    const auto a = static_cast<std::size_t>(term.node_a), b = static_cast<std::size_t>(term.node_b);
    const PairEquation pair =
        linearise_pair(poses[b].inverse() * poses[a], term.lidar_b_from_lidar_a, state.ins_from_lidar);
    out.push_back({&term, pair.residual, node_part(problem.nodes[a], a, pair.d_a, layout),
                   node_part(problem.nodes[b], b, pair.d_b, layout),
                   shared_jacobian(pair, problem.nodes[a], problem.nodes[b], layout),
                   problem.nodes[a].scan_covariance.isZero(0.0) ? 1.0 : 1.0 - NoiseModel::kScanShare});
  }
  return out;
}

void add_term(const LinearTerm& linear, const NoiseModel& noise, const Layout& layout, NormalEquations& equations,
              Entries& entries) {
  const Matrix6d information =
      linear.term->weight * noise.registration_information(linear.term->information, linear.share);
  add_parts(linear.a, linear.a, information, entries);
  add_parts(linear.b, linear.b, information, entries);
  const bool a_later = linear.a.at > linear.b.at;
  add_parts(a_later ? linear.a : linear.b, a_later ? linear.b : linear.a, information, entries);
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

NormalEquations build(const JointProblem& problem, const std::vector<LinearTerm>& terms, const NoiseModel& noise,
                      const State& state, const Layout& layout) {
  const int unknowns = layout.node_at(problem.nodes.size());
  NormalEquations equations;
  equations.coupling = Eigen::MatrixXd::Zero(unknowns, layout.size());
  equations.shared = Eigen::MatrixXd::Zero(layout.size(), layout.size());
  equations.keyframe_side = Eigen::VectorXd::Zero(unknowns);
  equations.shared_side = Eigen::VectorXd::Zero(layout.size());
  Entries entries;
  entries.reserve(terms.size() * 300 + problem.nodes.size() * 120);
  for (const LinearTerm& term : terms) add_term(term, noise, layout, equations, entries);
  add_priors(problem, noise, state, layout, equations, entries);
  equations.keyframes.resize(unknowns, unknowns);
  // Only the lower half is filled in: it is what the factorisation reads.
  equations.keyframes.setFromTriplets(entries.begin(), entries.end());
  return equations;
}

struct Eliminated {
  bool valid = false;
  Eigen::SimplicialLDLT<Sparse, Eigen::Lower> factors;
  Eigen::MatrixXd reduced;  // of the shared unknowns
  Eigen::VectorXd keyframe_step, shared_step;
  double minus_two_log_likelihood = 0.0;
};

void eliminate(const NormalEquations& equations, Eliminated& out) {
  out.factors.compute(equations.keyframes);
  out.valid = out.factors.info() == Eigen::Success;
  if (!out.valid) return;
  const Eigen::MatrixXd solved = out.factors.solve(equations.coupling);
  out.reduced = equations.shared - equations.coupling.transpose() * solved;
  out.reduced = 0.5 * (out.reduced + out.reduced.transpose().eval());
  const Eigen::VectorXd solved_side = out.factors.solve(equations.keyframe_side);
  const Eigen::LDLT<Eigen::MatrixXd> small(out.reduced);
  out.shared_step = small.solve(equations.shared_side - equations.coupling.transpose() * solved_side);
  out.keyframe_step = solved_side - solved * out.shared_step;
  out.valid = out.shared_step.allFinite() && out.keyframe_step.allFinite();
  // At this linearisation the minimum of the cost is known without taking the step.
  const double least_cost =
      equations.cost - equations.shared_side.dot(out.shared_step) - equations.keyframe_side.dot(out.keyframe_step);
  out.minus_two_log_likelihood = least_cost - equations.log_information +
                                 out.factors.vectorD().array().max(1e-300).log().sum() +
                                 small.vectorD().array().abs().max(1e-300).log().sum();
}

State start_state(const JointProblem& problem, const Layout& layout, const RigidTransform& start) {
  State state{
      start, std::vector<Vector6d>(problem.nodes.size(), Vector6d::Zero()), {}, Eigen::VectorXd::Zero(layout.size())};
  if (layout.drift) state.drifts = state.errors;
  return state;
}

void take_step(const Eliminated& step, const Layout& layout, State& state) {
  state.ins_from_lidar = perturbed(state.ins_from_lidar, step.shared_step.head<6>());
  state.shared.tail(state.shared.size() - 6) += step.shared_step.tail(state.shared.size() - 6);
  for (std::size_t k = 0; k < state.errors.size(); ++k) {
    state.errors[k] += step.keyframe_step.segment<6>(layout.node_at(k));
    if (layout.drift) state.drifts[k] += step.keyframe_step.segment<6>(layout.node_at(k) + 6);
  }
}

void describe(const JointProblem& problem, const Layout& layout, const State& state, const Eliminated& last,
              JointSolution& solution) {
  solution.ins_from_lidar = state.ins_from_lidar;
  solution.ins_from_lidar.linear() = nearest_rotation(state.ins_from_lidar.linear());
  const Eigen::MatrixXd covariance = last.reduced.ldlt().solve(Eigen::MatrixXd::Identity(layout.size(), layout.size()));
  solution.covariance = covariance.topLeftCorner<6, 6>();
  // Marginal information of X without its weak prior: the Schur complement over the sessions' unknowns, minus the
  // prior.
  Eigen::MatrixXd without_prior = last.reduced;
  without_prior.topLeftCorner<6, 6>() -= problem.prior_information;
  const int rest = layout.size() - 6;
  solution.information = without_prior.topLeftCorner<6, 6>();
  if (rest > 0)
    solution.information -=
        without_prior.topRightCorner(6, rest) *
        without_prior.bottomRightCorner(rest, rest).ldlt().solve(without_prior.bottomLeftCorner(rest, 6));
  solution.node_errors = state.errors;
  for (std::size_t k = 0; layout.drift && k < state.drifts.size(); ++k)
    solution.node_errors[k] += drift_in_body(problem.nodes[k]) * state.drifts[k];
  solution.minus_two_log_likelihood = last.minus_two_log_likelihood;
  for (int s = 0; s < layout.sessions; ++s) {
    if (layout.bias) solution.attitude_bias_rad.push_back(state.shared.segment<3>(layout.bias_at(s)));
    if (!layout.clock) continue;
    const int at = layout.clock_at(s);
    solution.time_offset_s.push_back(state.shared[at]);
    solution.time_offset_sigma_s.push_back(std::sqrt(std::max(0.0, covariance(at, at))));
  }
}

}  // namespace

JointSolution solve_joint(const JointProblem& problem, const NoiseModel& noise, const RigidTransform& start,
                          int max_iterations, const Progress& progress) {
  const Layout layout = layout_of(problem, noise);
  State state = start_state(problem, layout, start);
  JointSolution solution;
  solution.ins_from_lidar = start;
  Eliminated step;
  for (int iteration = 0; iteration < max_iterations && !progress.cancelled(); ++iteration) {
    eliminate(build(problem, linearise(problem, state, layout), noise, state, layout), step);
    if (!step.valid) return solution;
    take_step(step, layout, state);
    // In units of sigma: a direction that the data hardly show needs no more digits than it has.
    const double squared_sigmas = step.shared_step.dot(step.reduced * step.shared_step);
    solution.converged = squared_sigmas < 1e-3;
    if (squared_sigmas < 1e-8) break;
  }
  if (step.valid) describe(problem, layout, state, step, solution);
  return solution;
}

namespace {

std::array<double, 7> log_ratios(const NoiseModel& noise, const NoiseModel& expected) {
  const auto ratio = [](double value, double reference) { return reference > 0.0 ? std::log(value / reference) : 0.0; };
  return {ratio(noise.ins_position_sigma_m, expected.ins_position_sigma_m),
          ratio(noise.ins_attitude_sigma_rad, expected.ins_attitude_sigma_rad),
          ratio(noise.registration_scale, expected.registration_scale),
          ratio(noise.registration_floor_m, expected.registration_floor_m),
          ratio(noise.registration_floor_rad, expected.registration_floor_rad),
          ratio(noise.ins_position_drift, expected.ins_position_drift),
          ratio(noise.ins_attitude_drift, expected.ins_attitude_drift)};
}

}  // namespace

NoiseModel estimate_noise(const JointProblem& problem, const NoiseModel& expected,
                          const std::array<double, 7>& log_spread, const RigidTransform& ins_from_lidar,
                          const std::optional<NoiseModel>& start, const Progress& progress) {
  const Layout layout = layout_of(problem, expected);
  const State state = start_state(problem, layout, ins_from_lidar);
  const auto with = [&](const std::array<double, 7>& logs) {
    return NoiseModel{
        expected.ins_position_sigma_m * std::exp(logs[0]),   expected.ins_attitude_sigma_rad * std::exp(logs[1]),
        expected.registration_scale * std::exp(logs[2]),     expected.registration_floor_m * std::exp(logs[3]),
        expected.registration_floor_rad * std::exp(logs[4]), expected.ins_position_drift * std::exp(logs[5]),
        expected.ins_attitude_drift * std::exp(logs[6])};
  };
  const std::vector<LinearTerm> terms = linearise(problem, state, layout);
  const auto objective = [&](const std::array<double, 7>& logs) {
    double value = 0.0;
    for (std::size_t i = 0; i < logs.size(); ++i)
      if (log_spread[i] > 0.0) value += logs[i] * logs[i] / (log_spread[i] * log_spread[i]);
    Eliminated solved;
    eliminate(build(problem, terms, with(logs), state, layout), solved);
    return solved.valid ? value + solved.minus_two_log_likelihood : std::numeric_limits<double>::infinity();
  };
  // Coordinate search with shrinking steps: a few smooth, weakly coupled logarithms do not need more.
  std::array<double, 7> best = start ? log_ratios(*start, expected) : std::array<double, 7>{};
  double least = objective(best);
  for (double step = start ? 0.2 : 0.8; step > 0.04; step *= 0.5) {
    bool moved = true;
    for (int round = 0; moved && round < 6 && !progress.cancelled(); ++round) {
      moved = false;
      for (std::size_t i = 0; i < best.size(); ++i) {
        if (!(log_spread[i] > 0.0)) continue;
        for (const double direction : {step, -step}) {
          std::array<double, 7> trial = best;
          trial[i] += direction;
          const double value = objective(trial);
          if (value >= least) continue;
          least = value;
          best = trial;
          moved = true;
          break;
        }
      }
    }
  }
  return with(best);
}

}  // namespace remount
