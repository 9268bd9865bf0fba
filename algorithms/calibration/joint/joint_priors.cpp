// What is believed of the unknowns of the joint problem before its terms.
#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "algorithms/calibration/joint/joint_equations.h"

namespace remount::calibration {
namespace {

double position_lag_sigma_s(const JointProblem& problem, motion::SessionIndex session) {
  const std::vector<double>& sigmas_s = problem.session_position_lag_sigma_s;
  return session < sigmas_s.size() ? sigmas_s[session] : 0.0;
}

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

// Where an error or a drift of a node stands, and what it does to the white error of that node.
struct WhiteUnknown {
  Eigen::Index at;
  Eigen::Index row;  // of the node among those taken at once
  Matrix6d jacobian;
};

// Of scans of several LiDARs that were taken at once.
void add_white_prior_at_once(const JointProblem& problem, const NoiseModel& noise, const State& state,
                             const Layout& layout, motion::KeyframeIndex first, std::size_t count,
                             NormalEquations& equations) {
  const Eigen::LDLT<Eigen::MatrixXd> factors(covariance_at_once(problem, noise, first, count));
  const Eigen::MatrixXd information = factors.solve(Eigen::MatrixXd::Identity(factors.rows(), factors.cols()));
  Eigen::VectorXd errors(factors.rows());  // less their drifts
  for (std::size_t i = 0; i < count; ++i)
    errors.segment<6>(signed_of(6 * i)) = white_error(problem, state, layout, motion::KeyframeIndex(first + i));
  const Eigen::VectorXd weighted = information * errors;
  equations.cost += errors.dot(weighted);
  equations.log_information -= factors.vectorD().array().log().sum();
  std::vector<WhiteUnknown> unknowns;
  for (std::size_t i = 0; i < count; ++i) {
    const motion::KeyframeIndex node(first + i);
    unknowns.push_back({layout.node_at(node), signed_of(6 * i), Matrix6d::Identity()});
    if (layout.drift)
      unknowns.push_back({layout.drift_at(node), signed_of(6 * i), -drift_in_body(problem.nodes[node])});
  }
  for (const WhiteUnknown& row : unknowns) {
    equations.keyframe_side.segment<6>(row.at) -= row.jacobian.transpose() * weighted.segment<6>(row.row);
    for (const WhiteUnknown& column : unknowns)
      if (row.at >= column.at)
        equations.keyframes.at(block_of(row.at), block_of(column.at)) +=
            row.jacobian.transpose() * information.block<6, 6>(row.row, column.row) * column.jacobian;
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
    for (motion::LidarIndex l; layout.clock && l < problem.lidars.size(); ++l)
      prior(layout.clock_at(s, l), problem.lidars[l].clock_known ? kHeldSigma : problem.time_offset_prior_sigma_s,
            state.shared[layout.clock_at(s, l)]);
    if (layout.lag)
      prior(layout.lag_at(s), std::max(kHeldSigma, position_lag_sigma_s(problem, s)), state.shared[layout.lag_at(s)]);
  }
  for (Eigen::Index i = 0; i < layout.beams; ++i)
    prior(layout.beams_at() + i, 1.0, state.shared[layout.beams_at() + i]);
  add_mounting_priors(problem, state, layout, equations);
}

}  // namespace

Eigen::MatrixXd covariance_at_once(const JointProblem& problem, const NoiseModel& noise, motion::KeyframeIndex first,
                                   std::size_t count) {
  constexpr double kApart = 1e-6;  // of the variance: scans without an error of their own
  const auto of_scan = [&](motion::KeyframeIndex node) {
    return Matrix6d(noise.node_covariance(problem.nodes[node].scan_covariance) - noise.ins_covariance());
  };
  const Matrix6d of_ins = node_covariance(problem, noise, first) - of_scan(first);
  Eigen::MatrixXd covariance(signed_of(6 * count), signed_of(6 * count));
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Index at = signed_of(6 * i);
    for (std::size_t j = 0; j < count; ++j) covariance.block<6, 6>(at, signed_of(6 * j)) = of_ins;
    covariance.block<6, 6>(at, at) += kApart * of_ins + of_scan(motion::KeyframeIndex(first + i));
  }
  return covariance;
}

std::size_t taken_at_once(const JointProblem& problem, motion::KeyframeIndex node) {
  std::size_t count = 1;
  while (node + count < problem.nodes.size() && problem.nodes[node + count].at_once_with_before) ++count;
  return count;
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

}  // namespace remount::calibration
