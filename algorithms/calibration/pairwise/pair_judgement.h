// Which pairs take part: the screw test, residuals, weights, and states with their reasons.
#pragma once

#include <string>
#include <vector>

#include "algorithms/calibration/noise_model.h"
#include "algorithms/motion/pair.h"
#include "algorithms/search/scoring.h"

namespace remount::calibration {

/// Indices of the pairs that have a registration and that the user did not reject.
std::vector<motion::PairIndex> usable_pairs(const std::vector<motion::Pair>& pairs);

/// Rejects, with the reason, accepted pairs that no solution can use, whoever accepted them, and proposed ones whose
/// registration failed: as many pairs are used as are counted as accepted, and nobody else would judge the others.
void refuse_unusable(std::vector<motion::Pair>& pairs);

/// 1-sigma of roll and pitch of both INS poses of each pair where these were assumed; 0, or none at all: measured.
using PairTilts = std::vector<double>;

/// P and Q of the accepted pairs, in order.
std::vector<search::MotionPair> accepted_motions(const std::vector<motion::Pair>& pairs);

/// A pair with its errors, which stay the same under every X.
struct NoisyPair {
  RigidTransform ins_b_from_ins_a, lidar_b_from_lidar_a;
  Matrix6d registration_information, registration_covariance;
  /// Of the INS poses along each axis, all alike: the position of a and b together, the attitude of each; what drifts
  /// from a to b counts with b.
  double ins_position_variance_m2 = 0.0, attitude_variance_a_rad2 = 0.0, attitude_variance_b_rad2 = 0.0;
  double assumed_tilt_variance_rad2 = 0.0;  ///< of roll and pitch of either pose, beside that
};
std::vector<NoisyPair> noisy_pairs(const std::vector<motion::Pair>& pairs, const std::vector<motion::PairIndex>& usable,
                                   const NoiseModel& noise, const PairTilts& tilts_rad = {});

/// Squared Mahalanobis distances of the pairs' residuals under X, with the errors of both INS poses and of the
/// registration.
std::vector<double> distances2(const std::vector<NoisyPair>& pairs, const RigidTransform& ins_from_lidar);

/// Normal score of a chi-square distance of six degrees of freedom (Fisher). docs/maths/pairwise.md (P9)
double sigma_equivalent(double distance2);

/// How much larger residuals are than the noise model says, from squared Mahalanobis distances; at least 1. Judging
/// pairs by the model alone would spiral: fewer pairs, less noise, fewer pairs.
double residual_scale2(std::vector<double> d2);

/// Fills `screw` of the usable pairs. @param threshold in sigma
void test_screws(std::vector<motion::Pair>& pairs, const std::vector<motion::PairIndex>& usable,
                 const NoiseModel& noise, double threshold, const PairTilts& tilts_rad = {});

/// Fills residuals, weights and, unless the user decided, states and reasons of the usable pairs under X.
/// @param threshold in sigma
/// @return how many states changed
int judge_pairs(std::vector<motion::Pair>& pairs, const std::vector<motion::PairIndex>& usable,
                const RigidTransform& ins_from_lidar, const NoiseModel& noise, double threshold,
                const PairTilts& tilts_rad = {});

/// The residuals of all aligned pairs, decided by whomever, under the X that users are told.
void set_residuals(std::vector<motion::Pair>& pairs, const RigidTransform& ins_from_lidar);

/// The same, and those in the reasons of the usable pairs that the program rejected. What is not observed has another
/// value in `judged_by`, by which pairs were judged and their sigmas are counted, than in what is told.
void tell_residuals(std::vector<motion::Pair>& pairs, const std::vector<motion::PairIndex>& usable,
                    const RigidTransform& judged_by, const RigidTransform& ins_from_lidar, const NoiseModel& noise,
                    double threshold, const PairTilts& tilts_rad = {});

}  // namespace remount::calibration
