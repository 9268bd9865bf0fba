// How certain the mountings of several LiDARs are together. docs/maths/rig.md (G4) to (G7), (G10) to (G12)
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "algorithms/calibration/rig/rig_problem.h"

namespace remount::calibration {

/// Information on all mountings, under `perturb`, six rows a LiDAR; everything else marginalised, without priors and
/// what was measured.
struct RigInformation {
  Eigen::MatrixXd within;  ///< by pairs within LiDARs
  Eigen::MatrixXd across;  ///< what cross pairs add

  /// What a move of the white error of a keyframe's INS pose, as in (F5), does to the sides of these equations: six
  /// columns.
  struct Pull {
    Eigen::MatrixXd by_within, by_across;
  };
  std::map<motion::KeyframeIndex, Pull> pulls;  ///< of those whose sweeps overlap others'
  /// Of two of these, the variance of the white error that both have, as in (F5): m² and rad².
  struct InCommon {
    motion::KeyframeIndex node_a, node_b;
    Vector6d variance;
  };
  std::vector<InCommon> in_common;
};
/// Nothing where the equations are singular.
std::optional<RigInformation> rig_information(const RigProblem& problem, const State& state);

/// Covariances of all mountings: by pairs within LiDARs alone, and by all.
struct RigCovariance {
  Eigen::MatrixXd within, all;
  Eigen::VectorXd moved;  ///< how the mountings of the joint solution move, under `perturb`, with these weights
};
/// What LiDARs' own calibrations doubt of their pairs is an error of the INS as far as all of them doubt it, else of
/// each; errors that are common to all pairs of one move the mountings by as much as its pairs count. What is wrong
/// alike in all that others see of it counts against the pairs across. docs/maths/rig.md (G5), (G12)
/// @param by_ins of the pairs within LiDARs alone @param by_all of the joint solution
RigCovariance rig_covariance(const std::vector<RigLidar>& lidars, const RigProblem& problem,
                             const RigInformation& information, const std::vector<RigidTransform>& by_ins,
                             const std::vector<RigidTransform>& by_all);

}  // namespace remount::calibration
