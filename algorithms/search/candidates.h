// Candidate X from one pair, from two, and from all. docs/maths/search.md (S5) to (S9)
#pragma once

#include <optional>
#include <vector>

#include "algorithms/calibration/calibration_result.h"
#include "algorithms/calibration/search_range.h"
#include "algorithms/calibration/solve_options.h"
#include "algorithms/core/progress.h"
#include "algorithms/search/scoring.h"

namespace remount::search {

/// The X nearest to the nominal that satisfies one pair. One pair leaves a two-parameter family (rotation about the
/// screw axis, translation along it); a rotation smaller than `min_rotation_rad` has no usable axis, then the direction
/// of travel takes its place and the translation stays nominal.
RigidTransform single_pair_candidate(const MotionPair& pair, const RigidTransform& nominal, double min_rotation_rad);

/// X from two pairs whose screw axes differ by more than `min_axis_angle_rad`; nothing otherwise.
std::optional<RigidTransform> two_pair_candidate(const MotionPair& first, const MotionPair& second,
                                                 const RigidTransform& nominal, double min_rotation_rad,
                                                 double min_axis_angle_rad);

/// Park and Martin 1994: rotation from the logarithms of all rotations, then translation. Nothing where all axes are
/// parallel.
std::optional<RigidTransform> park_martin(const std::vector<MotionPair>& pairs, const RigidTransform& nominal);

/// Daniilidis 1999: dual quaternions. Nothing where the null space has not the two dimensions that it must have.
std::optional<RigidTransform> dual_quaternion(const std::vector<MotionPair>& pairs);

/// The global minimum of the quadratic form: rotation and translation together, from a net of starts over all
/// rotations. Solving jointly is what keeps planar driving well-posed. Translation that is not determined stays at
/// `near_m`.
RigidTransform joint_quadratic(const QuadraticForm& form, const Eigen::Vector3d& near_m);

/// All candidates of the accepted pairs, ranked: in range before out of range, then by the Frobenius sum. Among them
/// the optimum of the sum of squares within the range, with its certified gap.
std::vector<calibration::Candidate> find_candidates(const std::vector<MotionPair>& pairs,
                                                    const std::vector<motion::PairIndex>& pair_names,
                                                    const RigidTransform& nominal,
                                                    const calibration::SearchRange& range,
                                                    const calibration::SolveOptions& options,
                                                    const Progress& progress = {});

/// Judges range and error of each candidate and sorts: in range before out of range, then by the Frobenius sum.
void rank_candidates(std::vector<calibration::Candidate>& candidates, const std::vector<MotionPair>& pairs,
                     const calibration::SearchRange& range, const calibration::SolveOptions& options);

}  // namespace remount::search
