// The terms of the joint problem at one state, with their Jacobians.
#include <cmath>

#include "algorithms/calibration/joint/joint_equations.h"
#include "algorithms/calibration/joint/pair_equation.h"

namespace remount::calibration {
namespace {

RigidTransform apply_errors(const JointNode& node, motion::KeyframeIndex index, const State& state,
                            const Layout& layout) {
  Vector6d step = state.errors[index];
  if (layout.bias) step.tail<3>() += state.shared.segment<3>(layout.bias_at(node.session));
  if (layout.clock) step += node.body_velocity * state.shared[layout.clock_at(node.session, node.lidar)];
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
    jacobian.col(layout.clock_at(a.session, a.lidar)) += equation.d_a * a.body_velocity;
    jacobian.col(layout.clock_at(b.session, b.lidar)) += equation.d_b * b.body_velocity;
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

NodePart node_part(motion::KeyframeIndex index, const Matrix6d& body_jacobian, const Layout& layout) {
  return {layout.node_at(index), body_jacobian};
}

}  // namespace

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

}  // namespace remount::calibration
