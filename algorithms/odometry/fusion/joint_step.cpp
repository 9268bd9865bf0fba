#include "algorithms/odometry/fusion/joint_step.h"

#include <algorithm>
#include <cmath>

#include "algorithms/core/decompositions.h"

namespace remount::odometry {
namespace {

constexpr double kRobust = 3.0;  // sigma
constexpr int kMostTrials = 10;
constexpr double kSettledCost = 1e-8, kSettledShift = 1e-9;  // shares of what is there
constexpr double kFirstDamping = 1e-4, kLeastDamping = 1e-16;
constexpr double kLeastGain = 1e-3;  // share of the decrease that the linear terms promise

// Cauchy's loss of a term, and its derivative: the weight with which the term counts.
double loss(const WeighedTerm& weighed, double squares) {
  constexpr double kScale = kRobust * kRobust;
  return weighed.robust ? kScale * std::log1p(squares / kScale) : squares;
}
double weight(const WeighedTerm& weighed, double squares) {
  return weighed.robust ? 1.0 / (1.0 + squares / (kRobust * kRobust)) : 1.0;
}

int rows_of(const std::vector<WeighedTerm>& terms) {
  int rows = 0;
  for (const WeighedTerm& weighed : terms) rows += weighed.term->rows();
  return rows;
}

double cost_at(const std::vector<WeighedTerm>& terms, const FusionVector& x) {
  double cost = 0.0;
  for (const WeighedTerm& weighed : terms) {
    Eigen::VectorXd residuals(weighed.term->rows());
    weighed.term->evaluate(x, residuals, nullptr);
    cost += loss(weighed, residuals.squaredNorm());
  }
  return cost;
}

// All terms about a place, to first order: their square sum at x + shift is |triangle shift + rest|^2 and what no shift
// changes. Reduced orthogonally, not to normal equations: the unknowns' units differ.
struct LinearTerms {
  FusionInformation triangle;
  FusionVector rest;
};

LinearTerms linear_terms(const std::vector<WeighedTerm>& terms, const FusionVector& x) {
  Eigen::MatrixXd stacked = Eigen::MatrixXd::Zero(std::max(rows_of(terms), kFusionUnknowns), kFusionUnknowns + 1);
  Eigen::Index row = 0;
  for (const WeighedTerm& weighed : terms) {
    const Eigen::Index rows = weighed.term->rows();
    Eigen::VectorXd residuals(rows);
    FusionJacobian jacobian(rows, kFusionUnknowns);
    weighed.term->evaluate(x, residuals, &jacobian);
    const double root_weight = std::sqrt(weight(weighed, residuals.squaredNorm()));
    stacked.block(row, 0, rows, kFusionUnknowns) = root_weight * jacobian;
    stacked.block(row, kFusionUnknowns, rows, 1) = root_weight * residuals;
    row += rows;
  }
  const Eigen::MatrixXd reduced = triangular_factor(stacked).topRows(kFusionUnknowns);
  return {reduced.leftCols(kFusionUnknowns), reduced.col(kFusionUnknowns)};
}

// Minimises |triangle shift + rest|^2 + damping |scale shift|^2, each unknown's scale being what the terms say of it.
FusionVector damped_shift(const LinearTerms& linear, double damping) {
  FusionVector scale = linear.triangle.colwise().norm();
  for (double& each : scale)
    if (!(each > 0.0)) each = 1.0;  // nothing tells of it: it stays
  Eigen::MatrixXd stacked(2 * kFusionUnknowns, kFusionUnknowns);
  stacked << linear.triangle, FusionInformation((std::sqrt(damping) * scale).asDiagonal());
  Eigen::VectorXd wanted = Eigen::VectorXd::Zero(2 * kFusionUnknowns);
  wanted.head(kFusionUnknowns) = -linear.rest;
  return least_squares(stacked, wanted);
}

}  // namespace

// Levenberg (1944) and Marquardt (1963); the damping follows the gain as in Nielsen, "Damping parameter in Marquardt's
// method" (1999).
JointStep solve_joint_step(const std::vector<WeighedTerm>& terms, const FusionVector& start) {
  JointStep step;
  step.x = start;
  double cost = cost_at(terms, start);
  if (rows_of(terms) == 0 || !std::isfinite(cost)) return step;
  LinearTerms here = linear_terms(terms, start);
  if (!here.triangle.allFinite() || !here.rest.allFinite()) return step;
  double damping = kFirstDamping, growth = 2.0;
  for (int trial = 0; trial < kMostTrials; ++trial) {
    const FusionVector shift = damped_shift(here, damping);
    if (!(shift.norm() > kSettledShift * (step.x.norm() + kSettledShift))) break;
    const double promised = here.rest.squaredNorm() - (here.triangle * shift + here.rest).squaredNorm();
    const double gained = cost - cost_at(terms, step.x + shift);
    if (!(gained > kLeastGain * promised)) {  // farther than the linear terms hold, or to where a term has no value
      damping *= growth;
      growth *= 2.0;
      continue;
    }
    LinearTerms there = linear_terms(terms, step.x + shift);
    if (!there.triangle.allFinite() || !there.rest.allFinite()) break;
    step.x += shift;
    here = std::move(there);
    const bool settled = gained <= kSettledCost * cost;
    cost -= gained;
    damping = std::max(kLeastDamping, damping * std::max(1.0 / 3.0, 1.0 - std::pow(2.0 * gained / promised - 1.0, 3)));
    growth = 2.0;
    if (settled) break;
  }
  step.information = here.triangle.transpose() * here.triangle;
  step.usable = true;
  return step;
}

double disagreement(const FusionTerm& term, const FusionVector& x) {
  Eigen::VectorXd residuals(term.rows());
  term.evaluate(x, residuals, nullptr);
  return std::sqrt(residuals.squaredNorm() / std::max(1, term.rows()));
}

}  // namespace remount::odometry
