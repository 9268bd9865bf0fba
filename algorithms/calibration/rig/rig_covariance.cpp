#include "algorithms/calibration/rig/rig_covariance.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "algorithms/calibration/linear_solutions.h"
#include "algorithms/calibration/observability.h"
#include "algorithms/calibration/pairwise/uncertainty.h"
#include "algorithms/core/symmetric_eigen.h"

namespace remount::calibration {
namespace {

// Without what is negative: rounding, or what two discounts of beams leave of a difference.
Eigen::MatrixXd positive_part(const Eigen::MatrixXd& matrix) {
  const auto eigen = symmetric_eigen(Eigen::MatrixXd(0.5 * (matrix + matrix.transpose())));
  return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0.0).asDiagonal() * eigen.eigenvectors().transpose();
}

std::optional<Eigen::MatrixXd> marginal_information(const JointProblem& problem, const NoiseModel& noise,
                                                    const State& state) {
  const Layout layout = layout_of(problem, noise);
  const NormalEquations equations = build(problem, linearise(problem, state, layout), noise, state, layout);
  Eliminated step;
  eliminate(equations, step);
  if (!step.valid) return {};
  const Eigen::Index size = layout.mountings_size(), rest = layout.size() - size;
  Eigen::MatrixXd information = step.reduced.topLeftCorner(size, size) - equations.measured;
  for (motion::LidarIndex l; l < problem.lidars.size(); ++l) {
    const Eigen::Index at = layout.mounting_at(l);
    information.block<6, 6>(at, at) -= problem.lidars[l].prior_information;
  }
  if (rest > 0)
    information -= step.reduced.topRightCorner(size, rest) *
                   symmetric_solution(Eigen::MatrixXd(step.reduced.bottomRightCorner(rest, rest)),
                                      step.reduced.bottomLeftCorner(rest, size));
  return positive_part(information);
}

// Of a LiDAR's own calibration: what makes of the information of its pairs the part that it is trusted with, so that
// pairs across LiDARs keep theirs. docs/maths/rig.md (G4)
Matrix6d trust_of(const RigLidar& lidar, const RigidTransform& ins_from_lidar) {
  const Vector6d limits = observation_limits(lidar.input.options);
  const auto scaled = [&](const Matrix6d& information) {
    return Matrix6d(limits.asDiagonal() * information * limits.asDiagonal());
  };
  const Matrix6d apparent = scaled(lidar.details.joint.information);
  const Matrix6d beside =
      weak_prior(lidar.input.nominal_ins_from_lidar.has_value()) + lidar.input.measured.information(ins_from_lidar);
  const Matrix6d trusted = scaled(symmetric_inverse(lidar.details.pairs_covariance) - beside);
  const auto eigen = symmetric_eigen(apparent);
  constexpr double kNothing = 1e-6;  // in units of the limits: no part of the information to speak of
  const Vector6d roots = eigen.eigenvalues().cwiseMax(0.0).cwiseSqrt();
  const Vector6d inverse_roots =
      (roots.array() > kNothing).select(roots.cwiseMax(kNothing).cwiseInverse(), Vector6d::Zero());
  const Matrix6d& axes = eigen.eigenvectors();
  const auto shares = symmetric_eigen(
      Matrix6d(inverse_roots.asDiagonal() * axes.transpose() * trusted * axes * inverse_roots.asDiagonal()));
  const Matrix6d root_of_shares = shares.eigenvectors() *
                                  shares.eigenvalues().cwiseMax(0.0).cwiseMin(1.0).cwiseSqrt().asDiagonal() *
                                  shares.eigenvectors().transpose();
  const Matrix6d trust = axes * inverse_roots.asDiagonal() * root_of_shares * roots.asDiagonal() * axes.transpose();
  return limits.asDiagonal() * trust * limits.cwiseInverse().asDiagonal();
}

// How the mountings move with errors of `information` that are alike in all pairs of a LiDAR, as its own X moves.
void add_common(const Eigen::MatrixXd& covariance, const Eigen::MatrixXd& information,
                const std::vector<Matrix6d>& of_lidars, Eigen::MatrixXd& sum) {
  for (std::size_t l = 0; l < of_lidars.size(); ++l) {
    const Eigen::MatrixXd moved = covariance * information.middleCols<6>(signed_of(6 * l));
    sum += moved * of_lidars[l] * moved.transpose();
  }
}

// What a LiDAR's own result says beyond its pairs, what is common to these and the north: doubts of clocks, sweeps and
// scales, under `perturb`. Nothing of what it does not observe.
Matrix6d doubts_of(const RigLidar& lidar) {
  const RigidTransform& x = lidar.alone.mounting.ins_from_lidar();
  const Vector6d by_north = turned_by_north(x, north_sigma_of(lidar.input.sessions));
  const Matrix6d told = parameter_covariance(
      x, lidar.details.pairs_covariance + lidar.details.common_covariance + by_north * by_north.transpose());
  Matrix6d to_parameters = Matrix6d::Identity();
  to_parameters.bottomRightCorner<3, 3>() = yaw_pitch_roll_jacobian(yaw_pitch_roll_from_rotation(x.linear()));
  Vector6d untold = Vector6d::Zero();
  for (const Parameter parameter : kParameters) {
    const int row = row_of(parameter);
    if (lidar.alone.known[parameter].observed)
      untold[row] = std::max(0.0, lidar.alone.covariance(row, row) - told(row, row));
  }
  const Matrix6d from_parameters = inverse_by_lu(to_parameters);
  return from_parameters * untold.asDiagonal() * from_parameters.transpose();
}

std::vector<Matrix6d> common_errors(const std::vector<RigLidar>& lidars) {
  std::vector<Matrix6d> errors;
  for (const RigLidar& lidar : lidars) errors.push_back(lidar.details.common_covariance + doubts_of(lidar));
  return errors;
}

// The north of the INS turns all mountings alike.
Eigen::VectorXd turned_by_common_north(const std::vector<RigLidar>& lidars,
                                       const std::vector<RigidTransform>& ins_from_lidars) {
  double north_rad = 0.0;
  for (const RigLidar& lidar : lidars) north_rad = std::max(north_rad, north_sigma_of(lidar.input.sessions));
  Eigen::VectorXd turned(signed_of(6 * lidars.size()));
  for (std::size_t l = 0; l < lidars.size(); ++l)
    turned.segment<6>(signed_of(6 * l)) = turned_by_north(ins_from_lidars[l], north_rad);
  return turned;
}

}  // namespace

std::optional<RigInformation> rig_information(const RigProblem& problem, const State& state) {
  JointProblem within = problem.joint;
  within.terms.resize(problem.pairs_within);
  const auto by_within = marginal_information(within, problem.noise, state);
  const auto by_all = marginal_information(problem.joint, problem.noise, state);
  if (!by_within || !by_all) return {};
  return RigInformation{*by_within, positive_part(*by_all - *by_within)};
}

namespace {

// What errors of a LiDAR's beams do to its place as others see it, beyond what the unknowns of beams hold of them: half
// of a range and of an angle as these are known after its own drive. Within a LiDAR most of them cancel.
Matrix6d seen_by_others(const RigLidar& lidar) {
  Matrix6d covariance = registration_limits(lidar.input.narrow_field);
  const cloud::BeamPrior& believed = lidar.input.beams;
  if (believed.empty()) return covariance;
  constexpr double kShare = 0.5;
  const cloud::BeamEstimate& told = lidar.details.beams;
  const Eigen::VectorXd& sigmas =
      told.sigmas.size() == believed.untold_sigmas.size() ? told.sigmas : believed.untold_sigmas;
  const Eigen::Index count = believed.nodes.count();
  const auto variance = [&](Eigen::Index first) {
    return kShare * kShare * sigmas.segment(first, count).squaredNorm() / static_cast<double>(count);
  };
  covariance.diagonal().head<3>().array() += variance(believed.nodes.range_at(0));
  covariance.diagonal().tail<3>().array() += variance(believed.nodes.elevation_at(0));
  return covariance;
}

Eigen::MatrixXd inverse_of(const Eigen::MatrixXd& matrix) {
  const Eigen::MatrixXd inverted = symmetric_solution(matrix, Eigen::MatrixXd::Identity(matrix.rows(), matrix.cols()));
  return 0.5 * (inverted + inverted.transpose());
}

}  // namespace

RigCovariance rig_covariance(const std::vector<RigLidar>& lidars, const RigProblem& problem,
                             const RigInformation& information, const std::vector<RigidTransform>& by_ins,
                             const std::vector<RigidTransform>& by_all) {
  const Eigen::Index size = information.within.rows();
  Eigen::MatrixXd trust = Eigen::MatrixXd::Zero(size, size), beside = trust, limits = trust;
  Eigen::VectorXd by_cross(size);  // how far pairs across drew the mountings
  for (std::size_t l = 0; l < lidars.size(); ++l) {
    const Eigen::Index at = signed_of(6 * l);
    trust.block<6, 6>(at, at) = trust_of(lidars[l], by_all[l]);
    beside.block<6, 6>(at, at) =
        problem.joint.lidars[l].prior_information + problem.joint.lidars[l].measured.information(by_all[l]);
    limits.block<6, 6>(at, at) = inverse_by_lu(seen_by_others(lidars[l]));
    by_cross.segment<6>(at) = difference(by_ins[l], by_all[l]);
  }
  const Eigen::MatrixXd within = trust.transpose() * information.within * trust;
  const Eigen::MatrixXd lost = information.across * inverse_of(information.across + limits);
  const Eigen::MatrixXd across = positive_part(information.across - lost * information.across);
  RigCovariance covariance{inverse_of(within + beside), inverse_of(within + beside + across), {}};
  // The joint solution weighed with the whole of both: (N_w + N_beside) x = N_c (c - x) tells where pairs across have
  // it.
  const Eigen::VectorXd drawn = (information.within + beside) * by_cross;
  covariance.moved = covariance.all * (drawn - lost * drawn - (within + beside) * by_cross);
  const std::vector<Matrix6d> own = common_errors(lidars);
  const Eigen::MatrixXd alone = covariance.within, together = covariance.all;
  add_common(alone, within, own, covariance.within);
  add_common(together, within, own, covariance.all);
  const Eigen::VectorXd north = turned_by_common_north(lidars, by_all);
  covariance.within += north * north.transpose();
  covariance.all += north * north.transpose();
  return covariance;
}

}  // namespace remount::calibration
