// Whether a LiDAR or the INS moved during a session.
#pragma once

#include <vector>

#include "algorithms/calibration/pairwise/pairwise.h"

namespace remount::calibration {

/// A session in which hardly a pair before or behind a time goes with the solution, where most of the others do, and
/// the former agree with each other on another X.
struct MovedWithin {
  motion::SessionIndex session;
  double time_s = 0.0;  ///< since the start of the session, where the two parts meet
};

/// The pairs' states are as judged; those that the user decided bear no witness. Where `progress` is cancelled, what
/// was found until then.
std::vector<MovedWithin> find_moved_within(const PairwiseInput& input, const std::vector<motion::Pair>& pairs,
                                           const std::vector<motion::PairIndex>& usable, const NoiseModel& expected,
                                           const Progress& progress);

}  // namespace remount::calibration
