// Drives made of numbers for trajectory alignment: a winding road with known truth and errors of a known size.
#pragma once

#include <cmath>
#include <random>

#include "algorithms/calibration/trajectory/trajectory_problem.h"

namespace remount::testing {

struct TrajectoryDriveOptions {
  double duration_s = 120.0;
  double interval_s = 0.5;
  double speed_mps = 6.0;
  double turn_rad = 1.2;    ///< amplitude of the heading
  double slope_rad = 0.06;  ///< amplitude of pitch and roll
  double position_sigma_m = 0.02;
  double attitude_sigma_rad = degrees_to_radians(0.05);
  double step_sigma_m = 0.01;
  double step_sigma_rad = 5e-4;
  double scale = 0.0;      ///< of the odometry: the truth is 1 + scale times shorter
  double clock_s = 0.0;    ///< t_ins = t_lidar + clock
  double outliers = 0.0;   ///< share of grossly wrong positions
  double lasting_s = 0.0;  ///< for how long errors of positions last; 0: each is independent
  bool noise = true;
  bool ins = true, antenna = false;
  RigidTransform ins_from_lidar = rigid_from_six({0.9, -0.25, 0.75, 0.03, -0.02, 0.015});
  Eigen::Vector3d antenna_in_lidar{-0.6, 0.3, 0.45};
  unsigned seed = 1;
};

/// enu_from_lidar at a time.
inline RigidTransform true_pose(const TrajectoryDriveOptions& options, double time_s) {
  const int steps = 16 * (1 + static_cast<int>(std::abs(time_s)));
  const auto heading = [&](double t) { return 0.5 + options.turn_rad * std::sin(0.21 * t); };
  Eigen::Vector3d position(0.0, 0.0, 0.0);
  const double dt = time_s / steps;
  for (int k = 0; k < steps; ++k) {
    const double h = heading((k + 0.5) * dt);
    position += options.speed_mps * dt * Eigen::Vector3d(std::cos(h), std::sin(h), 0.0);
  }
  position.z() = 20.0 * options.slope_rad * std::sin(0.11 * time_s);
  const YawPitchRoll angles{heading(time_s), options.slope_rad * std::sin(0.33 * time_s),
                            options.slope_rad * std::cos(0.27 * time_s)};
  return make_rigid(rotation_from_yaw_pitch_roll(angles), position);
}

inline calibration::TrajectorySession trajectory_session(const TrajectoryDriveOptions& options) {
  std::mt19937 engine(options.seed);
  const auto normal = [&engine] { return std::normal_distribution<double>()(engine); };
  const auto normal3 = [&](double sigma) {
    const double x = normal(), y = normal(), z = normal();
    return Eigen::Vector3d(sigma * Eigen::Vector3d(x, y, z));
  };
  const double on = options.noise ? 1.0 : 0.0;
  // Gauss-Markov of the first order.
  const double kept = options.lasting_s > 0.0 ? std::exp(-options.interval_s / options.lasting_s) : 0.0;
  Eigen::Vector3d lasting = kept > 0.0 ? normal3(1.0) : Eigen::Vector3d(Eigen::Vector3d::Zero());
  const auto position_error = [&](double sigma) {
    const Eigen::Vector3d fresh = normal3(1.0);
    lasting = kept > 0.0 ? Eigen::Vector3d(kept * lasting + std::sqrt(1.0 - kept * kept) * fresh) : fresh;
    return Eigen::Vector3d(sigma * lasting);
  };
  calibration::TrajectorySession session;
  RigidTransform odometry = RigidTransform::Identity();
  const auto count = static_cast<int>(options.duration_s / options.interval_s);
  for (int i = 0; i < count; ++i) {
    const double t = i * options.interval_s, d = 1e-3;
    const RigidTransform here = true_pose(options, t);
    calibration::TrajectoryEpoch epoch;
    epoch.time_s = t;
    if (i > 0) {
      const RigidTransform step = true_pose(options, t - options.interval_s).inverse() * here;
      const RigidTransform noisy =
          make_rigid(step.linear() * so3_exp(normal3(on * options.step_sigma_rad)),
                     (1.0 + options.scale) * step.translation() + step.linear() * normal3(on * options.step_sigma_m));
      odometry = odometry * noisy;
    }
    epoch.odometry_from_lidar = odometry;
    const RigidTransform moved = here.inverse() * true_pose(options, t + d);
    epoch.lidar_velocity << moved.translation() / d, so3_log(moved.linear()) / d;
    epoch.step_translation_m2 = options.step_sigma_m * options.step_sigma_m * Eigen::Matrix3d::Identity();
    epoch.step_rotation_rad2 = options.step_sigma_rad * options.step_sigma_rad * Eigen::Matrix3d::Identity();
    // Observed in the INS clock's t: where the LiDAR was `clock_s` before.
    const RigidTransform seen = true_pose(options, t - options.clock_s);
    const bool wrong = std::uniform_real_distribution<double>()(engine) < options.outliers;
    const Eigen::Vector3d gross =
        wrong ? Eigen::Vector3d(8.0 + 5.0 * normal(), -12.0, 6.0 * normal()) : Eigen::Vector3d(Eigen::Vector3d::Zero());
    if (options.ins) {
      const RigidTransform enu_from_ins = seen * options.ins_from_lidar.inverse();
      const RigidTransform after = true_pose(options, t - options.clock_s + d) * options.ins_from_lidar.inverse();
      calibration::InsObservation ins;
      ins.position_sigma_m = options.position_sigma_m;
      ins.attitude_sigma_rad = options.attitude_sigma_rad;
      ins.enu_from_ins = make_rigid(enu_from_ins.linear() * so3_exp(normal3(on * options.attitude_sigma_rad)),
                                    enu_from_ins.translation() + position_error(on * options.position_sigma_m) + gross);
      const RigidTransform rate = enu_from_ins.inverse() * after;
      ins.body_velocity << rate.translation() / d, so3_log(rate.linear()) / d;
      epoch.ins = ins;
    }
    if (options.antenna) {
      calibration::AntennaObservation fix;
      fix.covariance_enu_m2 =
          options.position_sigma_m * options.position_sigma_m * Eigen::Vector3d(1.0, 1.0, 4.0).asDiagonal();
      Eigen::Vector3d error = position_error(on * options.position_sigma_m);
      error.z() *= 2.0;
      fix.position_enu_m = seen * options.antenna_in_lidar + error + gross;
      epoch.antenna = fix;
    }
    session.epochs.push_back(epoch);
  }
  return session;
}

}  // namespace remount::testing
