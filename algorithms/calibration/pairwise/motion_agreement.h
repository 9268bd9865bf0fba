// Whether the motions of LiDAR and INS go together at all: what no single pair shows as an outlier.
#pragma once

#include "algorithms/calibration/pairwise/joint_problem.h"
#include "algorithms/calibration/pairwise/pairwise.h"

namespace remount::calibration {

/// Of accepted pairs that leave no direction open, under one X.
struct MotionAgreement {
  double travel_m = 0.0;           ///< how far the LiDAR moves by the INS, root mean square
  double apart_m = 0.0;            ///< from that to how it moves by itself, likewise
  double lidar_per_ins = 1.0;      ///< how many times as far the LiDAR moves by itself, in the direction by the INS
  double lidar_per_ins_sigma = 0;  ///< 1-sigma; infinite where there are too few
};
MotionAgreement motion_agreement(const std::vector<motion::Pair>& pairs, const RigidTransform& ins_from_lidar);

/// How many times as long as those of the INS the motions of the LiDAR are, whatever X, where that is alike in most
/// pairs and no mounting (an arm of 5 m at most) explains it: one of the two is not in metres. 1 otherwise.
double lidar_per_ins_way(const std::vector<motion::Pair>& pairs);

/// Makes a result Inconsistent, names that factor and says what to look at. False where there is none.
bool refuse_other_unit(const std::vector<motion::Pair>& pairs, CalibrationResult& result);

/// Where motions differ by a good part of themselves, every pair is as wrong as the others and none is an outlier
/// (poses of another convention, unit or drive): a solved result becomes Inconsistent and claims nothing, and one that
/// is not solved says so where it is the unit. Where one
/// scale would bring them together, the result is widened by what that scale does to X, and advice names it.
void judge_motions(const JointProblem& problem, const std::vector<motion::Pair>& pairs, const PairwiseDetails& details,
                   const SolveOptions& options, const Progress& progress, CalibrationResult& result);

}  // namespace remount::calibration
