// Options of trajectory alignment.
#pragma once

#include "algorithms/core/options.h"
#include "messages/method_options.h"

namespace remount::calibration {

struct TrajectoryOptions {
  double state_interval_s = 0.5;
  double odometry_translation_sigma_m = 0.01;
  double odometry_rotation_sigma_deg = 0.05;
  double odometry_drift_percent = 0.5;
  double odometry_drift_deg = 0.01;
  double odometry_scale_percent = 1.0;
  double antenna_reach_m = 5.0;
  double outlier_threshold = 3.5;
  double update_s = 1.0;
  double converged_translation_m = 0.05;
  double converged_rotation_deg = 0.1;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor({"state_interval_s", "s", say::option_trajectory_state_interval_s,
             say::option_trajectory_state_interval_s_help, 0.05, 60.0},
            self.state_interval_s);
    visitor({"odometry_translation_sigma_m", "m", say::option_trajectory_odometry_translation_sigma_m,
             say::option_trajectory_odometry_translation_sigma_m_help, 1e-5, 10.0},
            self.odometry_translation_sigma_m);
    visitor({"odometry_rotation_sigma_deg", "deg", say::option_trajectory_odometry_rotation_sigma_deg,
             say::option_trajectory_odometry_rotation_sigma_deg_help, 1e-5, 10.0},
            self.odometry_rotation_sigma_deg);
    visitor({"odometry_drift_percent", "%", say::option_trajectory_odometry_drift_percent,
             say::option_trajectory_odometry_drift_percent_help, 0.0, 100.0},
            self.odometry_drift_percent);
    visitor({"odometry_drift_deg", "deg/m", say::option_trajectory_odometry_drift_deg,
             say::option_trajectory_odometry_drift_deg_help, 0.0, 10.0},
            self.odometry_drift_deg);
    visitor({"odometry_scale_percent", "%", say::option_trajectory_odometry_scale_percent,
             say::option_trajectory_odometry_scale_percent_help, 0.0, 50.0},
            self.odometry_scale_percent);
    visitor({"antenna_reach_m", "m", say::option_trajectory_antenna_reach_m,
             say::option_trajectory_antenna_reach_m_help, 0.1, 100.0},
            self.antenna_reach_m);
    visitor({"outlier_threshold", "sigma", say::option_trajectory_outlier_threshold,
             say::option_trajectory_outlier_threshold_help, 2.0, 20.0},
            self.outlier_threshold);
    visitor({"update_s", "s", say::option_trajectory_update_s, say::option_trajectory_update_s_help, 0.1, 60.0},
            self.update_s);
    visitor({"converged_translation_m", "m", say::option_trajectory_converged_translation_m,
             say::option_trajectory_converged_translation_m_help, 1e-4, 10.0},
            self.converged_translation_m);
    visitor({"converged_rotation_deg", "deg", say::option_trajectory_converged_rotation_deg,
             say::option_trajectory_converged_rotation_deg_help, 1e-4, 45.0},
            self.converged_rotation_deg);
  }
};

}  // namespace remount::calibration
