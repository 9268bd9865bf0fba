// One joint non-linear least squares over the terms of a step.
#pragma once

#include <memory>
#include <vector>

#include "algorithms/odometry/fusion/fusion_terms.h"

namespace remount::odometry {

using FusionInformation = Eigen::Matrix<double, kFusionUnknowns, kFusionUnknowns>;

/// Terms of a step; `robust` ones count less where they disagree with the others by more than three sigma (wheels that
/// slip).
struct WeighedTerm {
  std::unique_ptr<FusionTerm> term;
  bool robust = false;
};

struct JointStep {
  FusionVector x = FusionVector::Zero();
  FusionInformation information = FusionInformation::Zero();  ///< at x; robust terms as they count there
  bool usable = false;
};

/// Minimises the terms' square sum from `start` (Levenberg-Marquardt).
JointStep solve_joint_step(const std::vector<WeighedTerm>& terms, const FusionVector& start);

/// How far a three-row term disagrees at x: the root of its mean square residual, in sigma.
double disagreement(const FusionTerm& term, const FusionVector& x);

}  // namespace remount::odometry
