// The joint solution of all pairs: X, the corrections of every INS pose, and what is shared by a drive.
// docs/maths/pairwise.md (P11) to (P16)
//
// A generalized least-squares problem. Unknowns: X (6) of each LiDAR, for each keyframe the error of its INS pose and
// scan (6), for each session a constant attitude error (3) and, on request, the clock offset (1) and how much older its
// positions are than its attitudes (1), and for the LiDAR the errors of its beams (docs/maths/beams.md). Every pair
// couples X and its two keyframes, so that the error of one fix that enters many pairs is counted once. The keyframes'
// block is sparse and eliminated; what is left is the small system of X and the sessions.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "algorithms/calibration/joint/beam_unknowns.h"
#include "algorithms/calibration/measured.h"
#include "algorithms/calibration/noise_model.h"
#include "algorithms/core/progress.h"
#include "algorithms/geometry/rigid_transform.h"
#include "algorithms/motion/pair.h"

namespace remount::calibration {

/// A keyframe's INS pose.
struct JointNode {
  motion::SessionIndex session;  ///< what was recorded with one INS: LiDARs of a vehicle share its errors
  double time_s = 0.0;           ///< since the start of its session; ascending within a session
  RigidTransform local_from_ins = RigidTransform::Identity();
  Vector6d body_velocity = Vector6d::Zero();  ///< m/s, rad/s in INS axes; for the clock offset
  /// What the scan taken here brings to each of its registrations, as an error of this pose [nu; omega]: before the
  /// noise model's scale, half of a typical registration's covariance. Zero where pairs share no scans.
  Matrix6d scan_covariance = Matrix6d::Zero();
  /// Of a pose between two samples of the INS, as an error of this pose [nu; omega]: how far the way between them may
  /// have been another one. Zero at a sample.
  Matrix6d between_samples_covariance = Matrix6d::Zero();
  motion::LidarIndex lidar = {};  ///< whose scan was taken here
  /// Of another LiDAR than the node before, and taken at the same time: the INS errs alike in both.
  bool at_once_with_before = false;
};

/// A registered pair with its own weight: two scans of one LiDAR, or, as P X_a = X_b Q, of two.
struct JointTerm {
  motion::KeyframeIndex node_a, node_b;
  RigidTransform lidar_b_from_lidar_a = RigidTransform::Identity();
  Matrix6d information = Matrix6d::Zero();  ///< of the registration, before the noise model's scale and floor
  double weight = 1.0;                      ///< 0 leaves it out
  /// How lidar_b_from_lidar_a moves, under `perturb`, with each of the unknowns of the beams; a column each.
  Eigen::Matrix<double, 6, Eigen::Dynamic> beam_response = Eigen::Matrix<double, 6, Eigen::Dynamic>(6, 0);
  /// The same of the LiDAR of node_b, where that is another: the former are then of the LiDAR of node_a alone.
  Eigen::Matrix<double, 6, Eigen::Dynamic> beam_response_b = Eigen::Matrix<double, 6, Eigen::Dynamic>(6, 0);
  /// `information` is of the registration as a whole: the noise model has no say in it any more.
  bool whole = false;
};

/// What is solved for of a LiDAR.
struct JointLidar {
  BeamUnknowns beams;  ///< what its terms share of the errors of its beams; none: it has none
  /// Weak prior on X: keeps what the data do not determine at `prior_ins_from_lidar`.
  RigidTransform prior_ins_from_lidar = RigidTransform::Identity();
  Matrix6d prior_information = Matrix6d::Identity();  ///< under `perturb`, axes of the INS
  Measured measured;
  bool narrow_field = false;  ///< it looks one way
  bool clock_known = false;   ///< its offset stays as it is where those of other LiDARs are unknowns
};

struct JointProblem {
  std::vector<JointLidar> lidars = std::vector<JointLidar>(1);
  std::vector<JointNode> nodes;  ///< by session and time
  std::vector<JointTerm> terms;
  std::vector<double> session_attitude_bias_sigma_rad;  ///< 0: none
  /// Of roll and pitch that are assumed instead of measured, beside the bias: as much of it stays the same over the
  /// drive as changes from keyframe to keyframe. 0, or no entry: they were measured.
  std::vector<double> session_tilt_sigma_rad;
  bool estimate_time_offset = false;
  double time_offset_prior_sigma_s = 1.0;
  /// Of how much older the positions of a session are than its attitudes: what is believed of it before. 0, or no
  /// entry: they are of one moment.
  std::vector<double> session_position_lag_sigma_s;

  /// For one LiDAR.
  JointLidar& lidar() { return lidars.front(); }
  const JointLidar& lidar() const { return lidars.front(); }
};

/// Of a problem with one LiDAR.
struct JointSolution {
  bool converged = false;
  RigidTransform ins_from_lidar = RigidTransform::Identity();
  Vector6d last_step = Vector6d::Zero();  ///< of X, under `perturb`
  /// Covariance of X under `perturb`, everything else marginalised, the weak prior and what was measured included.
  Matrix6d covariance = Matrix6d::Identity();
  /// Information of X from the pairs alone (without prior and measurements), everything else marginalised.
  Matrix6d information = Matrix6d::Zero();
  std::vector<Vector6d> node_errors;                         ///< estimated error of each INS pose, body axes
  std::vector<Eigen::Vector3d> attitude_bias_rad;            ///< per session, INS axes
  std::vector<double> time_offset_s, time_offset_sigma_s;    ///< per session; empty where not estimated
  std::vector<double> position_lag_s, position_lag_sigma_s;  ///< likewise
  std::vector<Vector6d> moved_by_position_lag;  ///< how far X moves (under `perturb`) with a lag, for each second
  Eigen::VectorXd beams;                        ///< the unknowns of the beams
  Eigen::MatrixXd beams_covariance;             ///< of these, everything else marginalised
  /// Twice the negative restricted log-likelihood, up to a constant: compares noise models.
  double minus_two_log_likelihood = 0.0;
};

/// Gauss-Newton from `start`. Cancelled calls return converged = false.
JointSolution solve_joint(const JointProblem& problem, const NoiseModel& noise, const RigidTransform& start,
                          int max_iterations, const Progress& progress);

/// Restricted maximum likelihood of the noise model (variance components): starts from and is drawn towards `expected`,
/// with `log_spread` the 1-sigma of the logarithm of each component in the order of NoiseModel's members; 0 holds it. A
/// component that is zero stays zero.
/// @param start where the search begins, with small steps (an estimate from nearly the same pairs); nothing: at
/// `expected`
NoiseModel estimate_noise(const JointProblem& problem, const NoiseModel& expected,
                          const std::array<double, 7>& log_spread, const RigidTransform& ins_from_lidar,
                          const std::optional<NoiseModel>& start, const Progress& progress);

}  // namespace remount::calibration
