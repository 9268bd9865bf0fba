// The joint problem of several LiDARs, put together from those of each.
#pragma once

#include "algorithms/calibration/joint/joint_equations.h"
#include "algorithms/calibration/rig/rig.h"

namespace remount::calibration {

/// How much of the variance of the INS's white error two keyframes of LiDARs have in common; their sweeps seldom begin
/// and end together. docs/maths/rig.md (G13)
double common_share(const motion::Sweep& a, const motion::Sweep& b, double b_after_a_s);

/// The variance of the INS's white errors that two keyframes have in common: of what each has the smaller, by its axes,
/// under `perturb` in body axes as a node's error (F5). docs/maths/rig.md (G13)
/// @param share as common_share gives it
Vector6d common_variance(double share, const Matrix6d& ins_at_a, const Matrix6d& ins_at_b);

/// Whether they have all of it in common: stamps at once, and as good as one sweep.
bool is_at_once(const RigLidar& a, const motion::Sweep& of_a, const RigLidar& b, const motion::Sweep& of_b,
                double b_after_a_s);

/// Of a keyframe of that session.
motion::Sweep sweep_of(const RigLidar& lidar, motion::SessionIndex session);

/// Nodes of two LiDARs whose sweeps overlap; each stands for those that were taken at once with it.
struct OverlappingSweeps {
  motion::KeyframeIndex node_a, node_b;
  double share = 0.0;  ///< common_share
};

struct RigProblem {
  JointProblem joint;
  NoiseModel noise;                                          ///< of the INS; registrations carry their own
  std::vector<std::vector<motion::KeyframeIndex>> nodes_of;  ///< of each LiDAR's keyframes, where they are in `joint`
  std::vector<OverlappingSweeps> overlaps;                   ///< of nodes that were not taken at once
  std::size_t pairs_within = 0;                              ///< the first terms are of pairs within LiDARs
  std::vector<std::size_t> cross_of_term;                    ///< of those behind, which cross pair
};

/// The pairs within each LiDAR that count, at the mountings given, and no cross pairs yet; of these only which errors
/// of beams they show.
RigProblem make_rig_problem(const std::vector<RigLidar>& lidars, const std::vector<CrossPair>& cross_pairs,
                            const std::vector<RigidTransform>& ins_from_lidars);

/// Registration noise between two LiDARs: of each component that of the worse.
NoiseModel noise_across(const NoiseModel& a, const NoiseModel& b);

/// Puts the cross pairs with a weight behind the pairs within, in place of those that were there.
/// @param scale2 of each cross pair: how much larger its variance is than the noise says
void put_cross_terms(const std::vector<RigLidar>& lidars, const std::vector<CrossPair>& cross_pairs,
                     const std::vector<double>& scale2, RigProblem& problem);

}  // namespace remount::calibration
