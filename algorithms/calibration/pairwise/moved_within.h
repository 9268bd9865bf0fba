// Whether a LiDAR or the INS moved during a session.
#pragma once

#include <vector>

#include "algorithms/calibration/pairwise/pairwise.h"

namespace remount::calibration {

/// A session in which hardly a pair before or behind a time goes with X, where most of the others do, and the former go
/// with another X, several times as well.
struct MovedWithin {
  motion::SessionIndex session;
  double time_s = 0.0;  ///< since the start of the session, where the two parts meet
};

/// The pairs' states are as judged under `ins_from_lidar`; those that the user decided bear no witness. Where
/// `progress` is cancelled, what was found until then. docs/maths/pairwise.md (P19)
std::vector<MovedWithin> find_moved_within(const PairwiseInput& input, const std::vector<motion::Pair>& pairs,
                                           const RigidTransform& ins_from_lidar, const Progress& progress);

/// Says in a final result which sessions have two mountings. Where no other session bears it out, nobody knows which of
/// them is meant, and it claims nothing.
void report_moved_within(const PairwiseInput& input, const std::vector<motion::Pair>& pairs, const Progress& progress,
                         CalibrationResult& result);

}  // namespace remount::calibration
