// Sigma of X, from the joint solution, from blocks of time, and from what neither can see. docs/maths/covariance.md
#pragma once

#include "algorithms/calibration/joint/pair_equation.h"
#include "algorithms/calibration/pairwise/pairwise.h"
#include "algorithms/calibration/pairwise/session_agreement.h"

namespace remount::calibration {

/// Covariance (under `perturb`) of what one drive does to X that no residual of it shows: its surroundings, sampled
/// by beams and voxels, displace and tilt every one of its scans alike.
/// @param narrow_field the LiDAR looks one way
Matrix6d registration_limits(bool narrow_field);

/// Information of a pair's residual with the errors of both INS poses, the drift between them and the registration's
/// error marginalised: (M + L^-1)^-1 without the inverse of L, which may be singular.
/// @param tilt_rad 1-sigma of roll and pitch of both poses where these were assumed
Matrix6d residual_information(const motion::Pair& pair, const PairEquation& equation, const NoiseModel& noise,
                              double tilt_rad = 0.0);

/// Whether what is left to move of a solution lies along directions of X that the pairs do not show. There noise passes
/// for information and pulls without end (the height on a flat road: the further off, the better small tilts explain
/// the noise of the way), and nothing is claimed of them.
bool settles_where_observed(const PairwiseInput& input, const std::vector<motion::Pair>& pairs,
                            const PairwiseDetails& details);

/// Fills `directions`, `observed`, `covariance`, `bootstrap_sigma`, `session_disagreement` and `advice` of the result
/// from the joint solution; of the details, the parts of the covariance that more pairs lessen and that they do not.
/// @param answers what each session says on its own; empty with a single one
/// @return the covariance of X under `perturb` that is believed of pairs, prior and measurements
Matrix6d describe_uncertainty(const PairwiseInput& input, const std::vector<motion::Pair>& pairs,
                              const JointProblem& problem, const std::vector<SessionAnswer>& answers,
                              PairwiseDetails& details, const Progress& progress, CalibrationResult& result);

/// Widens a described result by what the pairs do not show: measurements that contradict them, and clocks that differ.
/// The values of X stay: they are in doubt, not unknown. @param believed of describe_uncertainty @param details takes
/// the doubts
void add_doubts(const PairwiseInput& input, const Matrix6d& believed, PairwiseDetails& details,
                CalibrationResult& result);

}  // namespace remount::calibration
