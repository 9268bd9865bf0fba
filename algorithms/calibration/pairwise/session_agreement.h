// Whether several sessions say the same about X.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "algorithms/calibration/pairwise/pairwise.h"

namespace remount::calibration {

/// What one session says about X on its own.
struct SessionAnswer {
  Matrix6d information = Matrix6d::Zero();  ///< of X under `perturb`, its registrations' limits counted
  Vector6d from_common = Vector6d::Zero();  ///< its own X as seen from the common one
};

/// The answer of each session, linearised at the common X of `details`. Empty with a single session.
std::vector<SessionAnswer> session_answers(const JointProblem& problem, const PairwiseDetails& details,
                                           const Progress& progress);

/// How far the answers of sessions scatter about their common one.
struct SessionScatter {
  /// As a multiple of what their errors explain (the Birge ratio: root of chi-square over its degrees of freedom, over
  /// the directions that each session determines well); about 1 where the noise model holds. NaN without `freedom`.
  double ratio = std::numeric_limits<double>::quiet_NaN();
  int freedom = 0;  ///< 0 where no two sessions determine the same direction
};

/// @param without a session that is left out
SessionScatter session_scatter(const std::vector<SessionAnswer>& answers, const SolveOptions& options,
                               std::optional<motion::SessionIndex> without = {});

/// By how much every sigma is larger for that scatter, never below 1: a few sessions may agree by chance, and may
/// differ by chance as well. What is believed of the noise counts like so many degrees of freedom at a ratio of 1.
/// @param log_spread 1-sigma of the logarithm of the noise before it is compared, as in NoisePrior
double widening(const SessionScatter& scatter, double log_spread);

/// A session that all others contradict.
struct OutlierSession {
  motion::SessionIndex session;
  double disagreement = 0.0;           ///< with it
  Vector6d common = Vector6d::Zero();  ///< what the others agree on, as seen from the common X
};

/// The session without which the others, at least two, agree, where they badly do not with it. Nothing where none or
/// more than one would have to go: then nobody knows who is right.
std::optional<OutlierSession> outlier_session(const std::vector<SessionAnswer>& answers, const SolveOptions& options);

/// A session of which hardly any pair was accepted.
struct RejectedSession {
  motion::SessionIndex session;
  bool coherent = false;  ///< its pairs agree with each other on another X: the lidar was mounted differently
};

struct SessionVerdicts {
  std::vector<RejectedSession> rejected;
  int kept = 0;  ///< those with enough accepted pairs to speak for the solution
};

/// Sessions that the solution rejected whole, or nearly so, while it kept others. The pairs' states are as judged.
SessionVerdicts judge_sessions(const PairwiseInput& input, const std::vector<motion::Pair>& pairs,
                               const std::vector<motion::PairIndex>& usable, const NoiseModel& expected,
                               const Progress& progress);

}  // namespace remount::calibration
