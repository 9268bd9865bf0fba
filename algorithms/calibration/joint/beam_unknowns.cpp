#include "algorithms/calibration/joint/beam_unknowns.h"

#include <cmath>

#include "algorithms/core/symmetric_eigen.h"

namespace remount::calibration {

Eigen::MatrixXd response_of(const motion::Pair& pair, Eigen::Index errors) {
  const motion::BeamResponse& response = pair.registration.beam_response;
  Eigen::MatrixXd whole = Eigen::MatrixXd::Zero(6, errors);
  if (response.cols() <= errors) whole.leftCols(response.cols()) = response.cast<double>();
  return whole;
}

BeamUnknowns choose_beam_unknowns(const cloud::BeamPrior& believed, const cloud::BeamErrors& mended,
                                  const std::vector<motion::Pair>& pairs, const std::vector<motion::PairIndex>& usable,
                                  const Eigen::MatrixXd& beside) {
  BeamUnknowns unknowns;
  if (believed.empty()) return unknowns;
  const Eigen::Index errors = believed.nodes.errors();
  unknowns.mean = believed.mean - mended.at(believed.nodes);
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(errors, errors);
  for (const motion::PairIndex i : usable) {
    const motion::Pair& pair = pairs[i];
    if (!(pair.weight > 0.0) || pair.registration.beam_response.cols() == 0) continue;
    const Eigen::MatrixXd response = response_of(pair, errors);
    information.noalias() += pair.weight * response.transpose() * (pair.registration.information * response);
  }
  if (beside.rows() == errors) information += beside;
  // Registered by a version, or under settings, that did not ask: their errors cannot be told any more.
  if (information.isZero(0.0)) return {};
  const auto prior = symmetric_eigen(believed.own);
  const Eigen::MatrixXd root = prior.eigenvectors() * prior.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal();
  const auto shown = symmetric_eigen(Eigen::MatrixXd(root.transpose() * information * root));
  // Less than this moves all registrations together by a small part of their own errors.
  constexpr double kLeast = 0.05;
  const Eigen::Index kept = (shown.eigenvalues().array() > kLeast).count();
  unknowns.of_single = kept;
  unknowns.basis.resize(errors, believed.common.cols() + kept);
  unknowns.basis << believed.common, root * shown.eigenvectors().rightCols(kept);
  return unknowns;
}

namespace {

cloud::BeamMean mean_of(Eigen::Index first, Eigen::Index count, const Eigen::VectorXd& errors,
                        const Eigen::VectorXd& untold_sigmas, const Eigen::MatrixXd& after) {
  constexpr double kTold = 0.5;  // of the sigma before any drive
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(errors.size());
  for (Eigen::Index i = first; i < first + count; ++i)
    if (after(i, i) > 0.0 && std::sqrt(after(i, i)) < kTold * untold_sigmas[i]) weights[i] = 1.0 / after(i, i);
  if (weights.isZero(0.0)) return {};
  weights /= weights.sum();
  return {weights.dot(errors), std::sqrt(weights.dot(after * weights)), true};
}

}  // namespace

cloud::BeamEstimate estimate_beams(const cloud::BeamPrior& believed, const cloud::BeamErrors& mended,
                                   const BeamUnknowns& unknowns, const Eigen::VectorXd& solution,
                                   const Eigen::MatrixXd& covariance) {
  if (solution.size() == 0 || solution.size() != unknowns.basis.cols()) return {};
  const Eigen::MatrixXd before = believed.common * believed.common.transpose() + believed.own;
  const Eigen::MatrixXd told = covariance - Eigen::MatrixXd::Identity(solution.size(), solution.size());
  const Eigen::MatrixXd after = before + unknowns.basis * told * unknowns.basis.transpose();
  const cloud::BeamNodes& nodes = believed.nodes;
  cloud::BeamEstimate estimate;
  estimate.nodes = nodes;
  estimate.errors = mended.at(nodes) + unknowns.mean + unknowns.basis * solution;
  estimate.sigmas = after.diagonal().cwiseMax(0.0).cwiseSqrt();
  const auto mean = [&](Eigen::Index first) {
    return mean_of(first, nodes.count(), estimate.errors, believed.untold_sigmas, after);
  };
  estimate.elevation = mean(nodes.elevation_at(0));
  estimate.range = mean(nodes.range_at(0));
  return estimate;
}

}  // namespace remount::calibration
