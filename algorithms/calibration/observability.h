// What the pairs determine, how well, and what to do about the rest. docs/maths/covariance.md (C10) to (C12), (C21)
#pragma once

#include <algorithm>
#include <vector>

#include "algorithms/calibration/calibration_result.h"
#include "algorithms/calibration/solve_options.h"

namespace remount::calibration {

/// How the vehicle moved, as far as it decides what can be observed.
struct MotionSummary {
  double largest_rotation_rad = 0.0;  ///< of one pair
  double largest_tilt_rad = 0.0;      ///< largest rotation about an axis other than the main one
  bool tilt_assumed = false;          ///< roll and pitch of every INS were taken to be zero, not measured
};
MotionSummary summarise_motion(const std::vector<motion::Pair>& pairs);

/// 1-sigma of a roll and pitch that were taken to be zero, over the sessions: `least_rad` is 0 where one measured them.
struct AssumedTilt {
  double least_rad = 0.0, most_rad = 0.0;
};
template <class Sessions>
AssumedTilt assumed_tilt_of(const Sessions& sessions) {
  AssumedTilt tilt;
  for (const auto& session : sessions) {
    const double sigma_rad = session.assumed_tilt_sigma_rad;
    tilt.least_rad = &session == &sessions.front() ? sigma_rad : std::min(tilt.least_rad, sigma_rad);
    tilt.most_rad = std::max(tilt.most_rad, sigma_rad);
  }
  return tilt;
}

/// What the pairs would seem to say about X if the vehicle had not turned at all: (R_P - I) then is nothing but noise,
/// and its square passes for information. `apparent` is the pairs' information with that part, `spurious` the part
/// itself.
struct SpuriousInformation {
  Matrix6d apparent = Matrix6d::Zero();
  Matrix6d spurious = Matrix6d::Zero();
};

/// Largest sigma of (x, y, z, rotation about x, y, z) that counts as observed, m and rad.
Vector6d observation_limits(const SolveOptions& options);

/// Eigen-directions of the information, each freed of its spurious share, with words; ascending by information. Units
/// are the options' limits: a direction with sigma 1 lies at the limit of what counts as observed.
std::vector<ObservabilityDirection> observed_directions(const Matrix6d& information,
                                                        const SpuriousInformation& spurious,
                                                        const MotionSummary& motion, const SolveOptions& options);

/// Information of X rebuilt from the directions.
Matrix6d trusted_information(const std::vector<ObservabilityDirection>& directions, const SolveOptions& options);

/// Information of the weak prior on X under `perturb`: how far the truth may lie from the nominal in directions that
/// the data do not show (2 m, 0.1 rad). Without a nominal yaw may be anything (1 rad); the ground in the scans still
/// settles roll and pitch.
Matrix6d weak_prior(bool nominal_known);

/// Covariance of X under `perturb` where roll and pitch of the INS are open by `tilt_rad`: a constant error of them
/// turns X about the origin of the INS, lever arm and all.
Matrix6d assumed_tilt_covariance(const RigidTransform& ins_from_lidar, double tilt_rad);

/// How far X is off, under `perturb`, where the north of attitudes is off by `north_rad` against that of positions:
/// it turns about the vertical through the origin of the INS, lever arm and all.
Vector6d turned_by_north(const RigidTransform& ins_from_lidar, double north_rad);

/// The largest of the sessions: where drives are of one place and one driver, no number of them makes it smaller.
template <class Sessions>
double north_sigma_of(const Sessions& sessions) {
  double most_rad = 0.0;
  for (const auto& session : sessions) most_rad = std::max(most_rad, session.north_sigma_rad);
  return most_rad;
}

/// What an open roll and pitch do to X beyond first order, from the covariance that holds to first order: a height that
/// is not known leans over to x and y, and two small turns about x and y make one about z. @param tilt_rad the most
/// that roll and pitch are open by
Matrix6d beyond_first_order(const RigidTransform& ins_from_lidar, const Matrix6d& covariance, double tilt_rad);

/// Whether advice is what judge_parameters adds: what to drive for what is not observed.
bool is_advice_on_motion(const Message& advice);

/// Says of each parameter whether it is observed, and fills `covariance` from that of X under `perturb`: a parameter
/// counts as observed where its sigma is below the options' limit. The directions' sigmas and words follow: what was
/// not observed before is known by what was measured where `known`, filled before, says that anything was. Adds advice
/// for those that are not.
void judge_parameters(const Matrix6d& covariance, const MotionSummary& motion, const SolveOptions& options,
                      CalibrationResult& result);

/// Widens a judged result by an error of X under `perturb` that the pairs do not show. What is no longer observed by
/// it says why: "x (forward): not known, `reason`".
void add_doubt(const Vector6d& doubt, const Message& reason, const SolveOptions& options, CalibrationResult& result);

/// Counts `variance` of the parameters (m^2, rad^2, rows as row_of has them) to the part that has this source.
void add_sigma_part(const Message& source, const Vector6d& variance, CalibrationResult& result);

/// Widens yaw, pitch and roll of a judged result by as much as they may be off with a rotation that the drive leaves
/// open, each for itself. The directions stay: they are turns about axes of the INS, and not of what the angles count
/// from.
void widen_angles(const Eigen::Vector3d& off_rad, const SolveOptions& options, CalibrationResult& result);

/// Whether some parameter was held near a value measured by hand.
bool is_any_measured(const CalibrationResult& result);

/// What a judged result that observes something says of itself: solved, and by what, or but for what.
Message solved_message(const CalibrationResult& result);

/// Whether a judged result does not tell yaw, without which X lies anywhere on an arc.
bool yaw_is_open(const CalibrationResult& result);

/// Why a parameter of a judged result is not observed, as its directions say it: the worst of those that are open and
/// lie along it. Empty where none does.
Message said_of_direction(Parameter parameter, const CalibrationResult& result);

/// Withdraws every parameter and direction of a judged result.
void claim_nothing(const Message& reason, CalibrationResult& result);

/// Covariance of the parameters (row_of) from the covariance of the perturbation [dt; phi] of X.
Matrix6d parameter_covariance(const RigidTransform& ins_from_lidar, const Matrix6d& perturbation_covariance);

}  // namespace remount::calibration
