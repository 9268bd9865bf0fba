#include "algorithms/calibration/pairwise/joint_problem.h"

#include <Eigen/Cholesky>
#include <cmath>

#include "algorithms/calibration/linear_solutions.h"
#include "algorithms/calibration/observability.h"
#include "algorithms/calibration/pairwise/noise_prior.h"

namespace remount::calibration {
namespace {

// Error of an INS pose that a small motion of the lidar amounts to (both [nu; omega] in body axes).
Matrix6d ins_from_lidar_motion(const RigidTransform& ins_from_lidar) {
  Matrix6d out = Matrix6d::Zero();
  out.topLeftCorner<3, 3>() = out.bottomRightCorner<3, 3>() = ins_from_lidar.linear();
  out.topRightCorner<3, 3>() = skew(ins_from_lidar.translation()) * ins_from_lidar.linear();
  return out;
}

// Half of the mean covariance of each scan's registrations, as an error of its pose. docs/maths/covariance.md (C2)
void set_scan_covariances(const std::vector<JointTerm>& terms, const RigidTransform& ins_from_lidar,
                          std::vector<JointNode>& nodes) {
  constexpr double kMost_m = 0.02, kMost_rad = 2e-3;  // where a registration does not determine a direction
  std::vector<int> counts(nodes.size(), 0);
  for (const JointTerm& term : terms) {
    Matrix6d information = term.information;
    information.diagonal().head<3>().array() += 1.0 / (kMost_m * kMost_m);
    information.diagonal().tail<3>().array() += 1.0 / (kMost_rad * kMost_rad);
    const Matrix6d half = 0.5 * symmetric_inverse(information);
    // A motion [nu; omega] of b changes Q by -[nu + omega x t; omega], one of a by R_Q [nu; omega].
    Matrix6d from_b = Matrix6d::Identity(), from_a = Matrix6d::Zero();
    from_b.topRightCorner<3, 3>() = skew(term.lidar_b_from_lidar_a.translation());
    from_a.topLeftCorner<3, 3>() = from_a.bottomRightCorner<3, 3>() = term.lidar_b_from_lidar_a.linear().transpose();
    for (const auto& [node, part] : {std::pair{term.node_a, from_a}, std::pair{term.node_b, from_b}}) {
      const Matrix6d to_ins = ins_from_lidar_motion(ins_from_lidar) * part;
      nodes[node].scan_covariance += to_ins * half * to_ins.transpose();
      ++counts[node];
    }
  }
  for (std::size_t k = 0; k < nodes.size(); ++k)
    if (counts[k] > 0) nodes[k].scan_covariance /= counts[k];
}

JointTerm term_of(const motion::Pair& pair, const BeamUnknowns& beams) {
  const motion::BeamResponse& response = pair.registration.beam_response;
  JointTerm term{pair.keyframe_a, pair.keyframe_b, pair.lidar_b_from_lidar_a, pair.registration.information,
                 pair.weight};
  term.beam_response.setZero(6, beams.basis.cols());
  if (response.cols() == 0 || beams.basis.cols() == 0) return term;
  const Eigen::MatrixXd whole = response_of(pair, beams.basis.rows());
  term.beam_response = whole * beams.basis;
  term.lidar_b_from_lidar_a = perturb(term.lidar_b_from_lidar_a, whole * beams.mean);
  return term;
}

}  // namespace

JointProblem make_joint_problem(const PairwiseInput& input, const std::vector<motion::Pair>& pairs,
                                const std::vector<motion::PairIndex>& usable,
                                const RigidTransform& prior_ins_from_lidar, const RigidTransform& ins_from_lidar,
                                const Eigen::MatrixXd& beam_information_beside) {
  JointProblem problem;
  problem.nodes = input.nodes;
  problem.lidar().beams = choose_beam_unknowns(input.beams, input.mended_beams, pairs, usable, beam_information_beside);
  for (const motion::PairIndex i : usable)
    if (pairs[i].weight > 0.0) problem.terms.push_back(term_of(pairs[i], problem.lidar().beams));
  if (input.pairs_share_scans) set_scan_covariances(problem.terms, ins_from_lidar, problem.nodes);
  for (const SessionNoise& session : input.sessions)
    problem.session_attitude_bias_sigma_rad.push_back(std::hypot(
        known_or(session.attitude_bias_sigma_rad, degrees_to_radians(input.options.ins_attitude_bias_sigma_deg)),
        session.lasting_rounding_rad));
  for (const SessionNoise& session : input.sessions)
    problem.session_tilt_sigma_rad.push_back(session.assumed_tilt_sigma_rad);
  for (const SessionNoise& session : input.sessions)
    problem.session_position_lag_sigma_s.push_back(session.position_lag_sigma_s);
  problem.lidar().prior_ins_from_lidar = prior_ins_from_lidar;
  problem.lidar().prior_information = weak_prior(input.nominal_ins_from_lidar.has_value());
  problem.lidar().measured = input.measured;
  problem.lidar().narrow_field = input.narrow_field;
  problem.estimate_time_offset = input.clock_is_unknown;
  return problem;
}

}  // namespace remount::calibration
