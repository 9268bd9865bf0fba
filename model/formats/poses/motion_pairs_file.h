// Motion pairs computed elsewhere, as CSV: the input of the `solve` verb.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "algorithms/motion/pair.h"

namespace remount::formats {

/// Pairs of a file. Keyframes are numbered by (set, index); `sets` are the sessions.
struct MotionPairs {
  std::vector<std::string> sets;  ///< names, in the order of the file; one empty name where there is no such column
  std::vector<motion::Keyframe> keyframes;  ///< session = index of the set, scan = i or j of the file; no stamps
  std::vector<motion::Pair> pairs;  ///< Proposed, with P and Q; registration counts as done, without information
};

/// The motion of a matrix [R t] as other programs print or hand it over, m; R is made orthonormal. Throws Error(Format)
/// at `where` that names it, "P", where it is no rigid transform (beyond 1e-3) or no possible motion.
RigidTransform motion_of_matrix(const Eigen::Matrix<double, 3, 4>& matrix, const std::string& name,
                                const std::string& where);

/// Columns by name: P00..P23 and Q00..Q23 (rows of 3x4 matrices) with P = ins_i_from_ins_j, Q = lidar_i_from_lidar_j,
/// and, where present, `set` (or `seq`), i and j. Lines that begin with '#' are comments. Rotations printed with few
/// digits are made orthonormal. Throws Error(Format) with file and line for a column that is missing, a number that is
/// none, or a matrix that is no rigid transform (beyond 1e-3); Error(Io) where the file cannot be read.
MotionPairs read_motion_pairs(const std::filesystem::path& path);

}  // namespace remount::formats
