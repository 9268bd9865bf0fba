// Pairwise calibration: from registered pairs to X with its uncertainty. docs/maths/pairwise.md
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "algorithms/calibration/calibration_result.h"
#include "algorithms/calibration/joint/joint_solver.h"
#include "algorithms/calibration/pairwise/pair_judgement.h"
#include "algorithms/calibration/search_range.h"
#include "algorithms/calibration/solve_options.h"
#include "algorithms/core/progress.h"

namespace remount::calibration {

/// What is known of the INS errors of a session; NaN where the data do not say (then the options' values are used).
struct SessionNoise {
  double position_white_sigma_m = std::numeric_limits<double>::quiet_NaN();
  double attitude_white_sigma_rad = std::numeric_limits<double>::quiet_NaN();
  double attitude_bias_sigma_rad = std::numeric_limits<double>::quiet_NaN();
  double position_drift = std::numeric_limits<double>::quiet_NaN();  ///< m per root of a second
  double attitude_drift = std::numeric_limits<double>::quiet_NaN();  ///< rad per root of a second
  double assumed_tilt_sigma_rad = 0.0;  ///< of roll and pitch that are taken to be zero; 0: they were measured
  double north_sigma_rad = 0.0;         ///< positions and attitudes may count from norths that are apart
  double attitude_rounding_rad = 0.0;   ///< 1-sigma of attitudes that are logged in coarse steps
  double lasting_rounding_rad = 0.0;    ///< of these what stays the same over the drive
  double position_lag_sigma_s = 0.0;    ///< of how much older positions are than attitudes; 0: of one moment
};

/// Of the joint solution at most; a handful where everything is observed.
inline constexpr int kJointIterations = 30;

struct PairwiseInput {
  std::vector<JointNode> nodes;  ///< one for each keyframe, same indices as in the pairs
  std::vector<SessionNoise> sessions;
  std::vector<std::string> session_names;  ///< for messages, beside the number; may be empty
  bool pairs_share_scans = true;           ///< false: every motion stands for itself
  bool narrow_field = false;               ///< the LiDAR looks one way
  /// P and Q were computed elsewhere: their residuals and their order are all that is known of their errors.
  bool motions_only = false;
  std::optional<RigidTransform> nominal_ins_from_lidar;
  /// An earlier estimate where there is no nominal: settles rotations that the motion does not determine.
  std::optional<RigidTransform> initial_ins_from_lidar;
  /// Away from the ground as scans show it, unit length: without a nominal it bounds roll and pitch of sigma's worst
  /// case, for vehicles stand level to some degrees and so do their INS axes. Nothing where no ground was seen.
  std::optional<Eigen::Vector3d> up_in_lidar;
  Measured measured;
  /// The nodes were moved by a clock offset that these very pairs showed: what is left of it is an unknown of each
  /// session, so that its error joins the sigmas.
  bool clock_is_unknown = false;
  /// How far X is off, under `perturb`, by a clock offset that was found and is not applied: it joins the sigmas.
  std::optional<Vector6d> clock_bias;
  cloud::BeamPrior beams;          ///< what is believed of the errors of the LiDAR's beams
  cloud::BeamErrors mended_beams;  ///< of these, what is taken out of the scans already
  /// What the noise turned out to be with earlier registrations of the same pairs; where there are none, pairs are
  /// first judged by what is expected.
  std::optional<NoiseModel> noise_before;
  /// By how much the errors of X are larger than what the pairs' own say: scans were made through former X.
  double sigma_factor = 1.0;
  SearchRange range;
  SolveOptions options;
};

/// Of each pair, as its session has it.
PairTilts assumed_tilts_rad(const PairwiseInput& input, const std::vector<motion::Pair>& pairs);

/// Solves from the pairs' P, Q and registration quality. Sets of each pair: screw test, residuals, weight, and, unless
/// the user decided, state and reason.
CalibrationResult solve_pairwise(const PairwiseInput& input, std::vector<motion::Pair>& pairs,
                                 const Progress& progress);

/// What solve_pairwise found out on the way, for the next stage (joint alignment of the clouds).
struct PairwiseDetails {
  NoiseModel noise;
  JointSolution joint;
  cloud::BeamEstimate beams;
  /// The parts of X's covariance under `perturb` that more pairs would make smaller, and that they would not.
  Matrix6d pairs_covariance = Matrix6d::Zero(), common_covariance = Matrix6d::Zero();
  Matrix6d doubts = Matrix6d::Zero();  ///< what clocks and measured values that contradict add to it, under `perturb`
};
CalibrationResult solve_pairwise(const PairwiseInput& input, std::vector<motion::Pair>& pairs, PairwiseDetails& details,
                                 const Progress& progress);

/// "2 (tuesday)", counted as users do.
Message title_of_session(const PairwiseInput& input, motion::SessionIndex session);

}  // namespace remount::calibration
