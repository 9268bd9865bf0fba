// How far every single measurement of the joint solution moves what is solved for. docs/maths/covariance.md (C17)
#pragma once

#include <optional>
#include <vector>

#include "algorithms/calibration/joint/joint_equations.h"

namespace remount::calibration {

/// How far one measurement moves unknowns at the solution: a registration's own error, or what a keyframe's INS pose,
/// scan and drift since the keyframe before bring together.
struct MeasurementPull {
  Eigen::VectorXd step;
  motion::KeyframeIndex node;  ///< the keyframe; of a registration its first
};

/// What every measurement of a joint solution pulls: minus its gradient times the inverse of the information, all
/// other unknowns moving along. To first order the change of the unknown when the measurement counts twice; at the
/// solution all of them sum to what the weak priors hold back.
class MeasurementPulls {
 public:
  /// Of a problem that outlives this, at its solution.
  MeasurementPulls(const JointProblem& problem, const NoiseModel& noise, const JointSolution& solution,
                   const Progress& progress);

  /// Of X (6, under `perturb`). Empty where nothing converges from the solution.
  std::vector<MeasurementPull> of_mounting() const;

  /// Likewise of what was estimated of a session's times: clock offset, and how much older its positions are (s). What
  /// other sessions pull of them through X is left out.
  std::vector<MeasurementPull> of_times(motion::SessionIndex session) const;

 private:
  std::vector<MeasurementPull> of_unknowns(const std::vector<Eigen::Index>& shared,
                                           std::optional<motion::SessionIndex> only) const;

  const JointProblem& problem_;
  NoiseModel noise_;
  Layout layout_;
  State state_;
  std::vector<LinearTerm> terms_;
  NormalEquations equations_;
  Eliminated step_;
};

}  // namespace remount::calibration
