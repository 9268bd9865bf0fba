#include "algorithms/calibration/joint/beam_unknowns.h"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace remount::calibration {

BeamUnknowns choose_beam_unknowns(const cloud::BeamPrior& believed, const cloud::BeamErrors& mended,
                                  const std::vector<motion::Pair>& pairs,
                                  const std::vector<motion::PairIndex>& usable) {
  BeamUnknowns unknowns;
  if (believed.empty()) return unknowns;
  unknowns.mean = -mended;
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(cloud::kBeamErrors, cloud::kBeamErrors);
  for (const motion::PairIndex i : usable) {
    const motion::Pair& pair = pairs[i];
    if (!(pair.weight > 0.0) || pair.registration.beam_response.cols() == 0) continue;
    const Eigen::MatrixXd response = pair.registration.beam_response.cast<double>();
    information.noalias() += pair.weight * response.transpose() * (pair.registration.information * response);
  }
  // Registered by a version, or under settings, that did not ask: their errors cannot be told any more.
  if (information.isZero(0.0)) return {};
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> prior(believed.own);
  const Eigen::MatrixXd root = prior.eigenvectors() * prior.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> shown(root.transpose() * information * root);
  // Less than this moves all registrations together by a small part of their own errors.
  constexpr double kLeast = 0.05;
  const Eigen::Index kept = (shown.eigenvalues().array() > kLeast).count();
  unknowns.of_single = kept;
  unknowns.basis.resize(cloud::kBeamErrors, believed.common.cols() + kept);
  unknowns.basis << believed.common, root * shown.eigenvectors().rightCols(kept);
  return unknowns;
}

namespace {

cloud::BeamMean mean_of(Eigen::Index first, const cloud::BeamErrors& errors, const Eigen::MatrixXd& before,
                        const Eigen::MatrixXd& after) {
  constexpr double kTold = 0.5;  // of the sigma before
  cloud::BeamErrors weights = cloud::BeamErrors::Zero();
  for (Eigen::Index i = first; i < first + cloud::kBeamNodes; ++i)
    if (after(i, i) < kTold * kTold * before(i, i)) weights[i] = 1.0 / after(i, i);
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
  cloud::BeamEstimate estimate;
  estimate.errors = mended + unknowns.mean + unknowns.basis * solution;
  estimate.sigmas = after.diagonal().cwiseMax(0.0).cwiseSqrt();
  estimate.elevation = mean_of(cloud::elevation_at(0), estimate.errors, before, after);
  estimate.range = mean_of(cloud::range_at(0), estimate.errors, before, after);
  return estimate;
}

}  // namespace remount::calibration
