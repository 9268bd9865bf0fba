#include "algorithms/calibration/rig/rig_covariance.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

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

Eigen::MatrixXd inverse_of(const Eigen::MatrixXd& matrix) {
  const Eigen::MatrixXd inverted = symmetric_solution(matrix, Eigen::MatrixXd::Identity(matrix.rows(), matrix.cols()));
  return 0.5 * (inverted + inverted.transpose());
}

// What a move of the INS's white error does to the sides of the equations of the mountings, in the nodes that were
// taken at once with this one: six columns. docs/maths/rig.md (G13)
Eigen::MatrixXd pull_of(const JointProblem& problem, const NoiseModel& noise, const Layout& layout,
                        const Eigen::MatrixXd& mountings_by_keyframes, motion::KeyframeIndex first) {
  const std::size_t count = taken_at_once(problem, first);
  const Eigen::MatrixXd information = inverse_of(covariance_at_once(problem, noise, first, count));
  Eigen::MatrixXd pull = Eigen::MatrixXd::Zero(mountings_by_keyframes.rows(), 6);
  for (std::size_t i = 0; i < count; ++i) {
    const motion::KeyframeIndex node(first + i);
    Matrix6d weight = Matrix6d::Zero();
    for (std::size_t j = 0; j < count; ++j) weight += information.block<6, 6>(signed_of(6 * i), signed_of(6 * j));
    pull += mountings_by_keyframes.middleCols<6>(layout.node_at(node)) * weight;
    if (layout.drift)
      pull -= mountings_by_keyframes.middleCols<6>(layout.drift_at(node)) *
              drift_in_body(problem.nodes[node]).transpose() * weight;
  }
  return pull;
}

Vector6d variance_in_common(const JointProblem& problem, const NoiseModel& noise, const OverlappingSweeps& two) {
  const auto of_ins = [&](motion::KeyframeIndex node) {
    return Matrix6d(node_covariance(problem, noise, node) - noise.node_covariance(problem.nodes[node].scan_covariance) +
                    noise.ins_covariance());
  };
  return common_variance(two.share, of_ins(two.node_a), of_ins(two.node_b));
}

struct MarginalInformation {
  Eigen::MatrixXd information;
  std::map<motion::KeyframeIndex, Eigen::MatrixXd> pulls;  // of nodes in overlaps
};

std::optional<MarginalInformation> marginal_information(const JointProblem& problem,
                                                        const std::vector<OverlappingSweeps>& overlaps,
                                                        const NoiseModel& noise, const State& state) {
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
  Eigen::MatrixXd to_mountings = Eigen::MatrixXd::Identity(size, layout.size());  // of the sides
  if (rest > 0) {
    const Eigen::MatrixXd along = symmetric_solution(Eigen::MatrixXd(step.reduced.bottomRightCorner(rest, rest)),
                                                     step.reduced.bottomLeftCorner(rest, size));
    information -= step.reduced.topRightCorner(size, rest) * along;
    to_mountings.rightCols(rest) = -along.transpose();
  }
  MarginalInformation marginal{positive_part(information), {}};
  if (overlaps.empty()) return marginal;
  const Eigen::MatrixXd by_keyframes =
      -to_mountings * step.counted * step.factors.solve(equations.coupling).transpose();
  for (const OverlappingSweeps& two : overlaps)
    for (const motion::KeyframeIndex node : {two.node_a, two.node_b})
      if (const auto [pull, is_new] = marginal.pulls.try_emplace(node); is_new)
        pull->second = pull_of(problem, noise, layout, by_keyframes, node);
  return marginal;
}

// In units of what counts as observed, in which all below is said.
Matrix6d in_limits(const Matrix6d& covariance, const Vector6d& limits) {
  return limits.cwiseInverse().asDiagonal() * covariance * limits.cwiseInverse().asDiagonal();
}

// What a LiDAR's own calibration doubts of what its pairs say: the covariance, in limits, with which their information
// becomes the part that is trusted. docs/maths/rig.md (G4)
Matrix6d distrust_of(const RigLidar& lidar, const RigidTransform& ins_from_lidar) {
  const Vector6d limits = observation_limits(lidar.input.options);
  const auto scaled = [&](const Matrix6d& information) {
    return Matrix6d(limits.asDiagonal() * information * limits.asDiagonal());
  };
  const Matrix6d beside =
      weak_prior(lidar.input.nominal_ins_from_lidar.has_value()) + lidar.input.measured.information(ins_from_lidar);
  const auto apparent = symmetric_eigen(scaled(lidar.details.joint.information));
  constexpr double kNothing = 1e-6;  // no part of the information to speak of: it is not known at all
  constexpr double kUnknown2 = 1e4;
  const Vector6d known2 = apparent.eigenvalues().cwiseMax(kNothing * kNothing);
  const Matrix6d from_units = apparent.eigenvectors() * known2.cwiseSqrt().cwiseInverse().asDiagonal();
  const auto shares = symmetric_eigen(Matrix6d(
      from_units.transpose() * scaled(symmetric_inverse(lidar.details.pairs_covariance) - beside) * from_units));
  constexpr double kLeastShare = 1e-6;
  const Vector6d excess = shares.eigenvalues().cwiseMax(kLeastShare).cwiseMin(1.0).cwiseInverse() - Vector6d::Ones();
  const Matrix6d axes = from_units * shares.eigenvectors();
  const auto doubted = symmetric_eigen(Matrix6d(axes * excess.asDiagonal() * axes.transpose()));
  return doubted.eigenvectors() * doubted.eigenvalues().cwiseMax(0.0).cwiseMin(kUnknown2).asDiagonal() *
         doubted.eigenvectors().transpose();
}

// How a mounting moves, under `perturb`, with a move of the INS.
Matrix6d moved_with_ins(const RigidTransform& ins_from_lidar) {
  Matrix6d moved = Matrix6d::Identity();
  moved.topRightCorner<3, 3>() = -skew(Eigen::Vector3d(ins_from_lidar.translation()));
  return moved;
}

// What the LiDARs' own calibrations doubt, as roots of covariances of all mountings: what all of them doubt along an
// axis of the INS is taken for a move of the INS, and the rest is each one's own. docs/maths/rig.md (G4)
struct Distrust {
  Eigen::MatrixXd in_common, own;
};
Distrust distrust_of_all(const std::vector<RigLidar>& lidars, const std::vector<RigidTransform>& x) {
  const Vector6d limits = observation_limits(lidars.front().input.options);
  const Eigen::Index size = signed_of(6 * lidars.size());
  Distrust distrust{Eigen::MatrixXd::Zero(size, 6), Eigen::MatrixXd::Zero(size, size)};
  std::vector<Matrix6d> of_lidars;
  Vector6d least = Vector6d::Constant(std::numeric_limits<double>::infinity());
  for (std::size_t l = 0; l < lidars.size(); ++l) {
    of_lidars.push_back(limits.asDiagonal() * distrust_of(lidars[l], x[l]) * limits.asDiagonal());
    const Matrix6d to_ins = inverse_by_lu(moved_with_ins(x[l]));
    least = least.cwiseMin(in_limits(to_ins * of_lidars.back() * to_ins.transpose(), limits).diagonal());
  }
  for (std::size_t l = 0; l < lidars.size(); ++l) {
    const Eigen::Index at = signed_of(6 * l);
    const Matrix6d shared = moved_with_ins(x[l]) * limits.asDiagonal() * least.cwiseMax(0.0).cwiseSqrt().asDiagonal();
    distrust.in_common.middleRows<6>(at) = shared;
    const auto rest = symmetric_eigen(in_limits(of_lidars[l] - shared * shared.transpose(), limits));
    distrust.own.block<6, 6>(at, at) =
        limits.asDiagonal() * rest.eigenvectors() * rest.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal();
  }
  return distrust;
}

// What becomes of information's weights when an error of this root is added to what it tells: they are multiplied by
// this, from the left.
Eigen::MatrixXd weights_with_error(const Eigen::MatrixXd& information, const Eigen::MatrixXd& root) {
  const Eigen::MatrixXd told = information * root;
  const Eigen::MatrixXd sum = Eigen::MatrixXd::Identity(root.cols(), root.cols()) + root.transpose() * told;
  return Eigen::MatrixXd::Identity(root.rows(), root.rows()) -
         told * symmetric_solution(sum, Eigen::MatrixXd(root.transpose()));
}

// Of A e, where e has the covariance C.
Eigen::MatrixXd congruent(const Eigen::MatrixXd& by, const Eigen::MatrixXd& covariance) {
  const Eigen::MatrixXd half = by * covariance;
  return half * by.transpose();
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
// scales, of measured values that contradict, under `perturb`. Nothing of what its pairs and these do not tell.
Matrix6d doubts_of(const RigLidar& lidar) {
  const RigidTransform& x = lidar.alone.mounting.ins_from_lidar();
  const Vector6d by_north = turned_by_north(x, north_sigma_of(lidar.input.sessions));
  const Matrix6d told = parameter_covariance(
      x, lidar.details.pairs_covariance + lidar.details.common_covariance + by_north * by_north.transpose());
  Matrix6d to_parameters = Matrix6d::Identity();
  to_parameters.bottomRightCorner<3, 3>() = yaw_pitch_roll_jacobian(yaw_pitch_roll_from_rotation(x.linear()));
  const Matrix6d doubts = parameter_covariance(x, lidar.details.doubts);
  const Vector6d limits = observation_limits(lidar.input.options);
  Vector6d untold = Vector6d::Zero();
  for (const Parameter parameter : kParameters) {
    const int row = row_of(parameter);
    const double limit2 = limits[row] * limits[row];
    if (lidar.alone.known[parameter].observed)
      untold[row] = std::max(0.0, lidar.alone.covariance(row, row) - told(row, row));
    else if (told(row, row) < limit2)  // withdrawn for doubts: these are larger than what counts as observed
      untold[row] = std::max(limit2, doubts(row, row));
  }
  const Matrix6d from_parameters = inverse_by_lu(to_parameters);
  return from_parameters * untold.asDiagonal() * from_parameters.transpose();
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
  const auto by_within = marginal_information(within, problem.overlaps, problem.noise, state);
  const auto by_all = marginal_information(problem.joint, problem.overlaps, problem.noise, state);
  if (!by_within || !by_all) return {};
  RigInformation information{
      by_within->information, positive_part(by_all->information - by_within->information), {}, {}};
  for (const auto& [node, pull] : by_within->pulls) information.pulls[node] = {pull, by_all->pulls.at(node) - pull};
  for (const OverlappingSweeps& two : problem.overlaps)
    information.in_common.push_back({two.node_a, two.node_b, variance_in_common(problem.joint, problem.noise, two)});
  return information;
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
  // An elevation that is wrong alike all around moves the ground that is seen, along the LiDAR's axis.
  constexpr double kGround_m = 10.0;
  const Eigen::Vector3d axis = lidar.alone.mounting.ins_from_lidar().linear().col(2);
  covariance.topLeftCorner<3, 3>() +=
      kGround_m * kGround_m * variance(believed.nodes.elevation_at(0)) * axis * axis.transpose();
  return covariance;
}

// The covariance of the sides of the equations of the mountings by what overlapping sweeps have in common, beside what
// the equations know of each. @param within, across how the pulls of both kinds of pairs are weighed
Eigen::MatrixXd in_common(const RigInformation& information, const Eigen::MatrixXd& within,
                          const Eigen::MatrixXd& across) {
  std::map<motion::KeyframeIndex, Eigen::MatrixXd> pulls;
  for (const auto& [node, pull] : information.pulls) pulls[node] = within * pull.by_within + across * pull.by_across;
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(within.rows(), within.cols());
  for (const RigInformation::InCommon& two : information.in_common) {
    const Eigen::MatrixXd product = pulls.at(two.node_a) * two.variance.asDiagonal() * pulls.at(two.node_b).transpose();
    sum += product + product.transpose();
  }
  return sum;
}

// What stands beside the pairs, of each LiDAR.
struct BesidePairs {
  Eigen::MatrixXd information, limits;  // priors and measured values; the inverse of what others see wrongly of it
  Eigen::VectorXd by_cross;             // how far pairs across drew the mountings
  std::vector<Matrix6d> common, doubts;
};

BesidePairs beside_pairs(const std::vector<RigLidar>& lidars, const RigProblem& problem,
                         const std::vector<RigidTransform>& by_ins, const std::vector<RigidTransform>& by_all) {
  const Eigen::Index size = signed_of(6 * lidars.size());
  BesidePairs beside{
      Eigen::MatrixXd::Zero(size, size), Eigen::MatrixXd::Zero(size, size), Eigen::VectorXd(size), {}, {}};
  for (std::size_t l = 0; l < lidars.size(); ++l) {
    const Eigen::Index at = signed_of(6 * l);
    beside.information.block<6, 6>(at, at) =
        problem.joint.lidars[l].prior_information + problem.joint.lidars[l].measured.information(by_all[l]);
    beside.limits.block<6, 6>(at, at) = inverse_by_lu(seen_by_others(lidars[l]));
    beside.by_cross.segment<6>(at) = difference(by_ins[l], by_all[l]);
    beside.common.push_back(lidars[l].details.common_covariance);
    beside.doubts.push_back(doubts_of(lidars[l]));
  }
  return beside;
}

// What is alike in many pairs, which the equations take for independent, on top of the covariance that they give.
// @param of_overlaps the covariance of the equations' sides by what overlapping sweeps have in common
// @param of_pairs the information of the LiDARs' own pairs, as it is weighed
Eigen::MatrixXd with_errors_in_common(const Eigen::MatrixXd& by_equations, const Eigen::MatrixXd& of_overlaps,
                                      const Eigen::MatrixXd& of_pairs, const BesidePairs& beside) {
  Eigen::MatrixXd sum = by_equations + congruent(by_equations, of_overlaps);
  add_common(by_equations, of_pairs, beside.common, sum);
  add_common(by_equations, of_pairs + beside.information, beside.doubts, sum);
  return sum;
}

}  // namespace

RigCovariance rig_covariance(const std::vector<RigLidar>& lidars, const RigProblem& problem,
                             const RigInformation& information, const std::vector<RigidTransform>& by_ins,
                             const std::vector<RigidTransform>& by_all) {
  const BesidePairs beside = beside_pairs(lidars, problem, by_ins, by_all);
  const Distrust distrust = distrust_of_all(lidars, by_all);
  const Eigen::MatrixXd weighs_own = weights_with_error(information.within, distrust.own),
                        own = positive_part(weighs_own * information.within);
  const Eigen::MatrixXd lost = information.across * inverse_of(information.across + beside.limits);
  const Eigen::MatrixXd across = positive_part(information.across - lost * information.across);
  // Pairs across at different times tell no more of what the INS does wrong than those within.
  const Eigen::MatrixXd weighs_within = weights_with_error(own, distrust.in_common),
                        weighs_all = weights_with_error(own + across, distrust.in_common);
  RigCovariance covariance{inverse_of(positive_part(weighs_within * own) + beside.information),
                           inverse_of(positive_part(weighs_all * (own + across)) + beside.information),
                           {}};
  // The joint solution weighed with the whole of both: (N_w + N_beside) x = N_c (c - x) tells where pairs across have
  // it.
  const Eigen::VectorXd drawn = (information.within + beside.information) * beside.by_cross;
  covariance.moved = covariance.all * (weighs_all * (drawn - lost * drawn - own * beside.by_cross) -
                                       beside.information * beside.by_cross);
  const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(lost.rows(), lost.cols()),
                        all = Eigen::MatrixXd::Identity(lost.rows(), lost.cols());
  const Eigen::MatrixXd overlaps_within = congruent(weighs_within, in_common(information, weighs_own, none)),
                        overlaps_all = congruent(weighs_all, in_common(information, weighs_own, all - lost));
  covariance.within = with_errors_in_common(covariance.within, overlaps_within, weighs_within * own, beside);
  covariance.all = with_errors_in_common(covariance.all, overlaps_all, weighs_all * own, beside);
  const Eigen::VectorXd north = turned_by_common_north(lidars, by_all);
  covariance.within += north * north.transpose();
  covariance.all += north * north.transpose();
  return covariance;
}

}  // namespace remount::calibration
