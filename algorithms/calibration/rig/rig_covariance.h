// How certain the mountings of several LiDARs are together. docs/maths/rig.md (G4) to (G7)
#pragma once

#include <optional>

#include "algorithms/calibration/rig/rig_problem.h"

namespace remount::calibration {

/// Information on all mountings, under `perturb`, six rows a LiDAR; everything else marginalised, without priors and
/// what was measured.
struct RigInformation {
  Eigen::MatrixXd within;  ///< by pairs within LiDARs
  Eigen::MatrixXd across;  ///< what cross pairs add
};
/// Nothing where the equations are singular.
std::optional<RigInformation> rig_information(const RigProblem& problem, const State& state);

/// Covariances of all mountings: by pairs within LiDARs alone, and by all.
struct RigCovariance {
  Eigen::MatrixXd within, all;
};
/// A LiDAR's own pairs count by what its own calibration trusts them with, and errors that are common to all its pairs
/// move the mountings by as much as its pairs count.
RigCovariance rig_covariance(const std::vector<RigLidar>& lidars, const RigProblem& problem,
                             const RigInformation& information, const std::vector<RigidTransform>& ins_from_lidars);

}  // namespace remount::calibration
