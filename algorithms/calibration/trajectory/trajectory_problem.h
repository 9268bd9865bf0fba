// Trajectory alignment: what is given and what is sought.
#pragma once

#include <optional>
#include <vector>

#include "algorithms/calibration/measured.h"
#include "algorithms/calibration/trajectory/trajectory_options.h"
#include "algorithms/calibration/trajectory/trajectory_past.h"
#include "algorithms/geometry/rigid_transform.h"

namespace remount::calibration {

/// A pose of the INS. Attitude errors are about the axes of the INS.
struct InsObservation {
  RigidTransform enu_from_ins = RigidTransform::Identity();
  Vector6d body_velocity = Vector6d::Zero();  ///< INS axes, [m/s; rad/s]: what an offset of the clocks does
  double position_sigma_m = 0.01;             ///< each axis, independent from sample to sample
  double attitude_sigma_rad = 5e-4;           ///< likewise
  /// Of roll and pitch that nobody measured; 0: they were measured. Such an error lasts: of many poses of a drive each
  /// has one as many times larger as its root is, so that all of them say what one would.
  double assumed_tilt_sigma_rad = 0.0;
  double unmeasured_height_sigma_m = 0.0;  ///< of a height that nobody measured, likewise
};

/// A position of the GNSS antenna.
struct AntennaObservation {
  Eigen::Vector3d position_enu_m = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance_enu_m2 = Eigen::Matrix3d::Identity();
};

/// One pose of the LiDAR, and what was observed at its time.
struct TrajectoryEpoch {
  double time_s = 0.0;  ///< since the start of its session; ascending
  RigidTransform odometry_from_lidar = RigidTransform::Identity();
  Vector6d lidar_velocity = Vector6d::Zero();  ///< LiDAR axes, [m/s; rad/s]
  /// Covariance of the motion since the epoch before, in the axes of the LiDAR at this epoch.
  Eigen::Matrix3d step_translation_m2 = 1e-4 * Eigen::Matrix3d::Identity();
  Eigen::Matrix3d step_rotation_rad2 = 1e-6 * Eigen::Matrix3d::Identity();
  std::optional<InsObservation> ins;
  std::optional<AntennaObservation> antenna;
};

/// One drive: an odometry frame and a local level frame (ENU) of its own.
struct TrajectorySession {
  std::vector<TrajectoryEpoch> epochs;
  TrajectoryPast past;  ///< epochs before these; of a stream only
  /// Covariance of what this drive does to X under `perturb` that no residual shows: constant attitude errors of the
  /// INS, surroundings that shift every scan alike.
  Matrix6d unseen = Matrix6d::Zero();
  /// Of INS attitudes whose log states no errors: turns this small follow braking and steering and show no lever arm.
  double doubtful_attitude_rad = 0.0;
  double assumed_tilt_sigma_rad = 0.0;  ///< of roll and pitch of the INS that nobody measured; 0: they were measured
  double unmeasured_height_sigma_m = 0.0;
  double north_sigma_rad = 0.0;  ///< positions and attitudes may count from norths that are apart
  /// The INS states its errors: they are not believed to be smaller, however smooth its poses.
  bool ins_noise_stated = false;
  bool odometry_over_scans = false;  ///< poses of the LiDAR are by the odometry over its scans, and not somebody's
};

struct TrajectoryProblem {
  std::vector<TrajectorySession> sessions;
  std::optional<RigidTransform> nominal_ins_from_lidar;
  bool estimate_clock = false;  ///< t_ins = t_lidar + offset, one for each session
  /// Of how much older positions of an INS may be than its attitudes, one for each session; 0: they are of one moment.
  double position_lag_sigma_s = 0.0;
  bool estimate_odometry_drift = false;  ///< the odometry leaves its way aside, by a share of it
  Measured measured;                     ///< what is known of X beside the drives
  /// Away from the ground in the scans, unit length: settles roll where the motion does not and no nominal is known.
  std::optional<Eigen::Vector3d> up_in_lidar;
};

/// Everything that is sought. `clock_s` also holds for GNSS fixes.
struct TrajectoryState {
  RigidTransform ins_from_lidar = RigidTransform::Identity();
  Eigen::Vector3d antenna_in_lidar = Eigen::Vector3d::Zero();
  std::vector<std::vector<RigidTransform>> enu_from_lidar;  ///< of each session's epochs
  std::vector<double> scale;    ///< of each session: the odometry's distances are 1 + scale times too long
  std::vector<double> clock_s;  ///< of each session
  /// Of each session by how much its INS positions are older than attitudes, and by which share of the way its odometry
  /// drifts, LiDAR axes; empty where neither is sought.
  std::vector<double> position_lag_s;
  std::vector<Eigen::Vector3d> odometry_drift;

  /// What belongs to one session, in the order of BorderPoint::own.
  OwnVector own(std::size_t session) const {
    OwnVector out = OwnVector::Zero();
    out[kScaleAt - kSharedSize] = scale[session];
    out[kClockAt - kSharedSize] = clock_s[session];
    if (!position_lag_s.empty()) out[kLagAt - kSharedSize] = position_lag_s[session];
    if (!odometry_drift.empty()) out.segment<3>(kDriftAt - kSharedSize) = odometry_drift[session];
    return out;
  }
  void add_own(std::size_t session, const OwnVector& step) {
    position_lag_s.resize(scale.size(), 0.0);
    odometry_drift.resize(scale.size(), Eigen::Vector3d::Zero());
    scale[session] += step[kScaleAt - kSharedSize];
    clock_s[session] += step[kClockAt - kSharedSize];
    position_lag_s[session] += step[kLagAt - kSharedSize];
    odometry_drift[session] += step.segment<3>(kDriftAt - kSharedSize);
  }
};

inline BorderPoint border_point(const TrajectoryState& state, std::size_t session) {
  return {state.ins_from_lidar, state.antenna_in_lidar, state.own(session)};
}

inline bool has_ins(const TrajectoryProblem& problem) {
  for (const TrajectorySession& session : problem.sessions) {
    if (session.past.has_ins) return true;
    for (const TrajectoryEpoch& epoch : session.epochs)
      if (epoch.ins) return true;
  }
  return false;
}
inline bool has_antenna(const TrajectoryProblem& problem) {
  for (const TrajectorySession& session : problem.sessions) {
    if (session.past.has_antenna) return true;
    for (const TrajectoryEpoch& epoch : session.epochs)
      if (epoch.antenna) return true;
  }
  return false;
}

}  // namespace remount::calibration
