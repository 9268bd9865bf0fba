// What the sigmas of X are made of, kept while its covariance is composed. docs/maths/covariance.md
#pragma once

#include <vector>

#include "algorithms/calibration/pairwise/pairwise.h"

namespace remount::calibration {

/// Each step of the composition makes the variances of the parameters larger; by how much, is the part of its source.
/// Parts so add up to the last covariance, whatever the steps are.
class SigmaBudget {
 public:
  explicit SigmaBudget(const RigidTransform& ins_from_lidar) : ins_from_lidar_(ins_from_lidar) {}
  /// The covariance under `perturb` has become this, by `source`.
  void reach(const Matrix6d& covariance, const Message& source);
  /// Begins with `covariance`, of which some is of these sources, whatever each of them brings alone, and what is left
  /// over of another.
  struct Source {
    Message name;
    Matrix6d covariance;
  };
  void begin(const Matrix6d& covariance, const std::vector<Source>& sources, const Message& rest);
  /// Writes the parts into a result that has none.
  void write(CalibrationResult& result) const;

 private:
  struct Part {
    Message source;
    Vector6d variance;  // of the parameters, m^2 and rad^2
  };
  Vector6d variances_of(const Matrix6d& covariance) const;
  RigidTransform ins_from_lidar_;
  std::vector<Part> parts_;
  Vector6d reached_ = Vector6d::Zero();
};

/// Begins a budget with the covariance of the joint solution, parted into what its sources contribute: of the best
/// linear estimate the derivative by the logarithm of the variance of a source is the covariance that this source
/// alone brings. What is left over is of errors that last over a drive, and of the weak prior. (C34)
void begin_with_sources(const JointProblem& problem, const PairwiseDetails& details, const Matrix6d& covariance,
                        const Progress& progress, SigmaBudget& budget);

}  // namespace remount::calibration
