// The joint problem of the pairs that take part.
#pragma once

#include "algorithms/calibration/pairwise/pairwise.h"

namespace remount::calibration {

/// @param usable indices of pairs; those with a weight take part
/// @param prior_ins_from_lidar centre of the weak prior
/// @param ins_from_lidar an estimate, for what scans bring to several pairs
/// @param beam_information_beside as in choose_beam_unknowns
JointProblem make_joint_problem(const PairwiseInput& input, const std::vector<motion::Pair>& pairs,
                                const std::vector<motion::PairIndex>& usable,
                                const RigidTransform& prior_ins_from_lidar, const RigidTransform& ins_from_lidar,
                                const Eigen::MatrixXd& beam_information_beside = {});

}  // namespace remount::calibration
