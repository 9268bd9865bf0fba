// Noise that is told from a handful of residuals is itself uncertain.
#pragma once

#include "algorithms/calibration/joint/joint_solver.h"

namespace remount::calibration {

/// Beyond which Student's t of `freedom` (3 at least) lies as rarely as a normal beyond 3 sigma (0.27 %), to 2.5 %.
double student_of_three_sigma(double freedom);

/// By how much sigma is larger because the noise was estimated from so few motions: 3 sigma are then passed as rarely
/// as where it is known. 1 from forty motions on. What is believed of the noise beforehand counts as further motions
/// do.
/// @param motions fewer count as three
/// @param log_spread 1-sigma of the logarithm of the noise before residuals are looked at, as in NoisePrior
double widening_of_few(int motions, double log_spread);

/// How many motions of the terms in use stand for themselves: keyframes less the groups that pairs link them to. Other
/// pairs repeat what is said already.
int independent_motions(const JointProblem& problem);

}  // namespace remount::calibration
