// Several LiDARs of one vehicle, solved together: P X_a = X_b Q. docs/maths/rig.md
//
// Each LiDAR was calibrated alone before. What joins them is that all were recorded with one INS, whose errors are
// unknowns once, and pairs across LiDARs: what one saw, another sees, at the same time or after the vehicle has moved.
#pragma once

#include <string>
#include <vector>

#include "algorithms/calibration/pairwise/pairwise.h"
#include "algorithms/calibration/rig/relative_mounting.h"
#include "algorithms/motion/sweep.h"

namespace remount::calibration {

/// A LiDAR with its own calibration.
struct RigLidar {
  std::string name;
  PairwiseInput input;              ///< of that calibration
  std::vector<motion::Pair> pairs;  ///< as it left them
  CalibrationResult alone;          ///< usable
  PairwiseDetails details;
  /// Where each of its sessions stands among the recordings of the vehicle.
  std::vector<motion::SessionIndex> recordings;
  std::vector<std::int64_t> keyframe_stamps_ns;  ///< of each of `input.nodes`, on the clock of the INS
  double at_once_s = 0.0;  ///< scans of two LiDARs that lie no further apart have the same INS error
  /// Of its keyframes, a session each: their INS error is the mean of this time. Sessions that are left out were
  /// measured at their stamps.
  std::vector<motion::Sweep> sweeps;
};

/// Two scans of two LiDARs of one recording, `lidar_a` before `lidar_b` in the list of LiDARs.
struct CrossPair {
  motion::LidarIndex lidar_a, lidar_b;
  /// Keyframes a and b are of lidar a and lidar b. The response to errors of beams: columns of a's, then of b's.
  motion::Pair pair;
};

/// Whether what LiDARs see of each other's surroundings goes with what the INS says of them.
struct RigAgreement {
  motion::LidarIndex lidar_a, lidar_b;
  Vector6d difference = Vector6d::Zero();  ///< by cross pairs less by the INS: of X_a^-1 X_b, under `perturb`
  Vector6d sigma = Vector6d::Zero();       ///< of each, 1-sigma; infinite: the INS or the pairs do not say
  double most_sigmas = 0.0;                ///< the largest of difference over sigma
};

struct RigSolution {
  bool solved = false;
  std::vector<RigidTransform> ins_from_lidars;  ///< in the order of the LiDARs
  /// Of all mountings, under `perturb`, six rows a LiDAR: what is believed of each beforehand is in it where the drive
  /// says less.
  Eigen::MatrixXd covariance;
  std::vector<CalibrationResult> results;   ///< of each LiDAR: as it was alone, with what all of them say
  std::vector<RelativeMounting> relatives;  ///< of every two that are joined, by pairs or by the INS
  std::vector<RigAgreement> agreements;     ///< of every two with cross pairs
  /// Of each cross pair, the motion of the LiDAR that the solution predicts, errors of the INS taken out.
  std::vector<RigidTransform> cross_motions;
  std::vector<std::vector<motion::LidarIndex>> groups;  ///< of LiDARs that cross pairs join, directly or by others
};

/// Sets of each cross pair its residual, weight, state and reason. Not solved where cancelled, or where nothing
/// converges. Of one LiDAR, or without cross pairs, the INS alone joins the results.
RigSolution solve_rig(const std::vector<RigLidar>& lidars, std::vector<CrossPair>& cross_pairs,
                      const Progress& progress);

}  // namespace remount::calibration
