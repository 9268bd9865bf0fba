#include "algorithms/calibration/joint/joint_equations.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "algorithms/calibration/joint/pair_equation.h"
#include "algorithms/calibration/joint/shared_block.h"

namespace remount::calibration {
namespace {

double position_lag_sigma_s(const JointProblem& problem, motion::SessionIndex session) {
  const std::vector<double>& sigmas_s = problem.session_position_lag_sigma_s;
  return session < sigmas_s.size() ? sigmas_s[session] : 0.0;
}

RigidTransform apply_errors(const JointNode& node, motion::KeyframeIndex index, const State& state,
                            const Layout& layout) {
  Vector6d step = state.errors[index];
  if (layout.bias) step.tail<3>() += state.shared.segment<3>(layout.bias_at(node.session));
  if (layout.clock) step += node.body_velocity * state.shared[layout.clock_at(node.session)];
  if (layout.lag) step += moved_by_lag(node) * state.shared[layout.lag_at(node.session)];
  return moved_in_body(node.local_from_ins, step);
}

// What moves a registered motion by errors of beams of one of its LiDARs.
struct BeamPart {
  const Eigen::Matrix<double, 6, Eigen::Dynamic>& response;
  const Layout::Beams& at;
};

// Those of a term that are not empty.
std::vector<BeamPart> beam_parts(const JointTerm& term, const JointProblem& problem, const Layout& layout) {
  std::vector<BeamPart> parts;
  const auto add = [&](const Eigen::Matrix<double, 6, Eigen::Dynamic>& response, motion::KeyframeIndex node) {
    if (response.cols() > 0) parts.push_back({response, layout.beams_of[problem.nodes[node].lidar]});
  };
  if (layout.beams == 0) return parts;
  add(term.beam_response, term.node_a);
  add(term.beam_response_b, term.node_b);
  return parts;
}

Eigen::VectorXd beams_of(const State& state, const Layout::Beams& at) {
  Eigen::VectorXd beams(at.count());
  beams << state.shared.segment(at.common_at, at.common), state.shared.segment(at.single_at, at.single);
  return beams;
}

// As the LiDARs would have it without what their beams err by.
RigidTransform motion_without_beam_errors(const JointTerm& term, const std::vector<BeamPart>& beams,
                                          const State& state) {
  RigidTransform motion = term.lidar_b_from_lidar_a;
  for (const BeamPart& part : beams) motion = perturb(motion, part.response * beams_of(state, part.at));
  return motion;
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

// Of a keyframe's INS pose that is off, and of the mountings: a term at one state.
struct Equation {
  Vector6d residual;
  Matrix6d d_a, d_b;
  Eigen::Matrix<double, 6, Eigen::Dynamic> d_mountings;
};

Equation linearise_motion(const RigidTransform& ins_b_from_ins_a, const RigidTransform& lidar_b_from_lidar_a,
                          motion::LidarIndex lidar_a, motion::LidarIndex lidar_b, const State& state,
                          const Layout& layout) {
  Equation out;
  out.d_mountings.setZero(6, layout.mountings_size());
  if (lidar_a == lidar_b) {
    const PairEquation pair = linearise_pair(ins_b_from_ins_a, lidar_b_from_lidar_a, state.ins_from_lidars[lidar_a]);
    out.residual = pair.residual, out.d_a = pair.d_a, out.d_b = pair.d_b;
    out.d_mountings.middleCols<6>(layout.mounting_at(lidar_a)) = pair.d_x;
    return out;
  }
  const CrossEquation pair = linearise_cross_pair(ins_b_from_ins_a, lidar_b_from_lidar_a,
                                                  state.ins_from_lidars[lidar_a], state.ins_from_lidars[lidar_b]);
  out.residual = pair.residual, out.d_a = pair.d_a, out.d_b = pair.d_b;
  out.d_mountings.middleCols<6>(layout.mounting_at(lidar_a)) = pair.d_x_a;
  out.d_mountings.middleCols<6>(layout.mounting_at(lidar_b)) = pair.d_x_b;
  return out;
}

// Jacobian of one term with respect to the shared unknowns.
Eigen::MatrixXd shared_jacobian(const Equation& equation, const std::vector<BeamPart>& beams, const JointNode& a,
                                const JointNode& b, const Layout& layout) {
  Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(6, layout.size());
  jacobian.leftCols(layout.mountings_size()) = equation.d_mountings;
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
  for (const auto& [response, at] : beams) {
    jacobian.middleCols(at.common_at, at.common) -= response.leftCols(at.common);
    jacobian.middleCols(at.single_at, at.single) -= response.rightCols(at.single);
  }
  return jacobian;
}

// Of a keyframe's error or drift in the keyframes' block.
std::size_t block_of(Eigen::Index unknown) { return static_cast<std::size_t>(unknown / 6); }

// The drift walks from each keyframe to the next; that of a session's first is zero, for only differences matter.
void add_drift_prior(const JointProblem& problem, const NoiseModel& noise, const State& state, const Layout& layout,
                     NormalEquations& equations) {
  for (motion::KeyframeIndex k; k < problem.nodes.size(); ++k) {
    const bool first = is_first_of_session(problem, k);
    const Vector6d information = drift_step_information(problem, noise, k);
    const Vector6d change = first ? state.drifts[k] : Vector6d(state.drifts[k] - state.drifts[k - 1]);
    const Eigen::Index here = layout.drift_at(k);
    KeyframeBlocks& blocks = equations.keyframes;
    blocks.at(block_of(here), block_of(here)).diagonal() += information;
    equations.keyframe_side.segment<6>(here) -= information.cwiseProduct(change);
    if (!first) {
      const Eigen::Index before = layout.drift_at(motion::KeyframeIndex(k - 1));
      blocks.at(block_of(before), block_of(before)).diagonal() += information;
      blocks.at(block_of(here), block_of(before)).diagonal() -= information;
      equations.keyframe_side.segment<6>(before) += information.cwiseProduct(change);
    }
    equations.cost += change.dot(information.cwiseProduct(change));
    equations.log_information += information.array().log().sum();
  }
}

// Of what is independent from keyframe to keyframe.
void add_white_prior(const JointProblem& problem, const NoiseModel& noise, const State& state, const Layout& layout,
                     motion::KeyframeIndex node, NormalEquations& equations) {
  const Eigen::LDLT<Matrix6d> covariance(node_covariance(problem, noise, node));
  const Matrix6d information = covariance.solve(Matrix6d::Identity());
  const Vector6d error = white_error(problem, state, layout, node);
  const Vector6d weighted = information * error;
  const Eigen::Index at = layout.node_at(node);
  equations.keyframes.at(block_of(at), block_of(at)) += information;
  equations.keyframe_side.segment<6>(at) -= weighted;
  equations.cost += error.dot(weighted);
  equations.log_information -= covariance.vectorD().array().log().sum();
  if (!layout.drift) return;
  const Eigen::Index drift_at = layout.drift_at(node);
  const Matrix6d in_body = drift_in_body(problem.nodes[node]);
  const Matrix6d of_drift = in_body.transpose() * information;
  equations.keyframes.at(block_of(drift_at), block_of(at)) -= of_drift;
  equations.keyframes.at(block_of(drift_at), block_of(drift_at)) += of_drift * in_body;
  equations.keyframe_side.segment<6>(drift_at) += in_body.transpose() * weighted;
}

// How many nodes from this on were taken at once.
std::size_t taken_at_once(const JointProblem& problem, motion::KeyframeIndex node) {
  std::size_t count = 1;
  while (node + count < problem.nodes.size() && problem.nodes[node + count].at_once_with_before) ++count;
  return count;
}

// Of scans of several LiDARs that were taken at once: the INS's part of what is independent from time to time is the
// same in all of them, the scans' is not. docs/maths/rig.md (G2)
void add_white_prior_at_once(const JointProblem& problem, const NoiseModel& noise, const State& state,
                             const Layout& layout, motion::KeyframeIndex first, std::size_t count,
                             NormalEquations& equations) {
  constexpr double kApart = 1e-6;  // of the variance: scans without an error of their own
  const Eigen::Index size = signed_of(6 * count);
  Matrix6d common = node_covariance(problem, noise, first);
  common -= noise.node_covariance(problem.nodes[first].scan_covariance) - noise.ins_covariance();
  Eigen::MatrixXd covariance(size, size);
  Eigen::VectorXd errors(size);
  for (std::size_t i = 0; i < count; ++i) {
    const motion::KeyframeIndex node(first + i);
    for (std::size_t j = 0; j < count; ++j) covariance.block<6, 6>(signed_of(6 * i), signed_of(6 * j)) = common;
    covariance.block<6, 6>(signed_of(6 * i), signed_of(6 * i)) +=
        kApart * common + noise.node_covariance(problem.nodes[node].scan_covariance) - noise.ins_covariance();
    errors.segment<6>(signed_of(6 * i)) = white_error(problem, state, layout, node);
  }
  const Eigen::LDLT<Eigen::MatrixXd> factors(covariance);
  const Eigen::MatrixXd information = factors.solve(Eigen::MatrixXd::Identity(size, size));
  const Eigen::VectorXd weighted = information * errors;
  equations.cost += errors.dot(weighted);
  equations.log_information -= factors.vectorD().array().log().sum();
  // A white error is the node's error, less its drift.
  struct Unknown {
    Eigen::Index at;
    std::size_t node;
    Matrix6d jacobian;
  };
  std::vector<Unknown> unknowns;
  for (std::size_t i = 0; i < count; ++i) {
    const motion::KeyframeIndex node(first + i);
    unknowns.push_back({layout.node_at(node), i, Matrix6d::Identity()});
    if (layout.drift) unknowns.push_back({layout.drift_at(node), i, -drift_in_body(problem.nodes[node])});
  }
  for (const Unknown& row : unknowns) {
    equations.keyframe_side.segment<6>(row.at) -=
        row.jacobian.transpose() * weighted.segment<6>(signed_of(6 * row.node));
    for (const Unknown& column : unknowns)
      if (row.at >= column.at)
        equations.keyframes.at(block_of(row.at), block_of(column.at)) +=
            row.jacobian.transpose() * information.block<6, 6>(signed_of(6 * row.node), signed_of(6 * column.node)) *
            column.jacobian;
  }
}

// Of the mountings, and what was measured of them.
void add_mounting_priors(const JointProblem& problem, const State& state, const Layout& layout,
                         NormalEquations& equations) {
  equations.measured.setZero(layout.mountings_size(), layout.mountings_size());
  equations.measured_side.setZero(layout.mountings_size());
  for (motion::LidarIndex l; l < problem.lidars.size(); ++l) {
    const JointLidar& lidar = problem.lidars[l];
    const Eigen::Index at = layout.mounting_at(l);
    const Vector6d from_prior = difference(lidar.prior_ins_from_lidar, state.ins_from_lidars[l]);
    const Vector6d weighted = lidar.prior_information * from_prior;
    equations.shared.block<6, 6>(at, at) += lidar.prior_information;
    equations.shared_side.segment<6>(at) -= weighted;
    equations.cost += from_prior.dot(weighted);
    for (const MeasuredRow& known : lidar.measured.rows(state.ins_from_lidars[l])) {
      const double information = 1.0 / (known.sigma * known.sigma);
      equations.measured.block<6, 6>(at, at) += information * known.row * known.row.transpose();
      equations.measured_side.segment<6>(at) += information * known.residual * known.row;
      equations.cost += information * known.residual * known.residual;
    }
  }
  equations.shared.topLeftCorner(layout.mountings_size(), layout.mountings_size()) += equations.measured;
  equations.shared_side.head(layout.mountings_size()) += equations.measured_side;
}

void add_shared_priors(const JointProblem& problem, const State& state, const Layout& layout,
                       NormalEquations& equations) {
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
  add_mounting_priors(problem, state, layout, equations);
}

NodePart node_part(motion::KeyframeIndex index, const Matrix6d& body_jacobian, const Layout& layout) {
  return {layout.node_at(index), body_jacobian};
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

}  // namespace

namespace {

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

std::vector<LinearTerm> linearise(const JointProblem& problem, const State& state, const Layout& layout) {
  std::vector<RigidTransform> poses;
  for (motion::KeyframeIndex k; k < problem.nodes.size(); ++k)
    poses.push_back(apply_errors(problem.nodes[k], k, state, layout));
  std::vector<LinearTerm> out;
  for (const JointTerm& term : problem.terms) {
    if (!(term.weight > 0.0)) continue;
    const motion::KeyframeIndex a = term.node_a, b = term.node_b;
    const std::vector<BeamPart> beams = beam_parts(term, problem, layout);
    const Equation pair =
        linearise_motion(poses[b].inverse() * poses[a], motion_without_beam_errors(term, beams, state),
                         problem.nodes[a].lidar, problem.nodes[b].lidar, state, layout);
    out.push_back({&term, pair.residual, node_part(a, pair.d_a, layout), node_part(b, pair.d_b, layout),
                   shared_jacobian(pair, beams, problem.nodes[a], problem.nodes[b], layout),
                   problem.nodes[a].scan_covariance.isZero(0.0) ? 1.0 : 1.0 - NoiseModel::kScanShare});
  }
  return out;
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

void add_priors(const JointProblem& problem, const NoiseModel& noise, const State& state, const Layout& layout,
                NormalEquations& equations) {
  for (motion::KeyframeIndex k; k < state.errors.size();) {
    const std::size_t count = taken_at_once(problem, k);
    if (count == 1)
      add_white_prior(problem, noise, state, layout, k, equations);
    else
      add_white_prior_at_once(problem, noise, state, layout, k, count, equations);
    k = motion::KeyframeIndex(k + count);
  }
  if (layout.drift) add_drift_prior(problem, noise, state, layout, equations);
  add_shared_priors(problem, state, layout, equations);
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
  const Eigen::MatrixXd along_others = others.ldlt().solve(coupling);
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
