#include "algorithms/odometry/joint_step.h"

#include <ceres/ceres.h>

#include <cmath>

namespace remount {
namespace {

constexpr double kRobust = 3.0;  // sigma

class TermCost : public ceres::CostFunction {
 public:
  explicit TermCost(const FusionTerm& term) : term_(term) {
    set_num_residuals(term.rows());
    mutable_parameter_block_sizes()->push_back(kFusionUnknowns);
  }

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    const FusionVector x = Eigen::Map<const FusionVector>(parameters[0]);
    Eigen::Map<Eigen::VectorXd> values(residuals, term_.rows());
    if (!jacobians || !jacobians[0]) {
      term_.evaluate(x, values, nullptr);
      return values.allFinite();
    }
    FusionJacobian slope(term_.rows(), kFusionUnknowns);
    term_.evaluate(x, values, &slope);
    Eigen::Map<FusionJacobian>(jacobians[0], term_.rows(), kFusionUnknowns) = slope;
    return values.allFinite() && slope.allFinite();
  }

 private:
  const FusionTerm& term_;
};

FusionInformation information_at(const std::vector<WeighedTerm>& terms, const FusionVector& x) {
  FusionInformation information = FusionInformation::Zero();
  for (const WeighedTerm& weighed : terms) {
    if (weighed.term->rows() == 0) continue;
    Eigen::VectorXd residuals(weighed.term->rows());
    FusionJacobian jacobian(weighed.term->rows(), kFusionUnknowns);
    weighed.term->evaluate(x, residuals, &jacobian);
    // The first derivative of Cauchy's loss: the weight with which the term counts.
    const double weight = weighed.robust ? 1.0 / (1.0 + residuals.squaredNorm() / (kRobust * kRobust)) : 1.0;
    information.selfadjointView<Eigen::Lower>().rankUpdate(jacobian.transpose(), weight);
  }
  return information.selfadjointView<Eigen::Lower>();
}

}  // namespace

JointStep solve_joint_step(const std::vector<WeighedTerm>& terms, const FusionVector& start) {
  JointStep step;
  step.x = start;
  ceres::Problem problem;
  for (const WeighedTerm& weighed : terms)
    if (weighed.term->rows() > 0)
      problem.AddResidualBlock(new TermCost(*weighed.term), weighed.robust ? new ceres::CauchyLoss(kRobust) : nullptr,
                               step.x.data());
  if (problem.NumResidualBlocks() == 0) return step;
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;  // few unknowns, whose units differ: no normal equations
  options.max_num_iterations = 10;
  options.function_tolerance = 1e-8;
  options.parameter_tolerance = 1e-9;
  options.num_threads = 1;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  step.usable = summary.IsSolutionUsable() && step.x.allFinite();
  if (!step.usable) {
    step.x = start;
    return step;
  }
  step.information = information_at(terms, step.x);
  return step;
}

double disagreement(const FusionTerm& term, const FusionVector& x) {
  Eigen::VectorXd residuals(term.rows());
  term.evaluate(x, residuals, nullptr);
  return std::sqrt(residuals.squaredNorm() / std::max(1, term.rows()));
}

}  // namespace remount
