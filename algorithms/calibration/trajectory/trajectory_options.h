// Options of trajectory alignment.
#pragma once

#include "algorithms/core/options.h"

namespace remount {

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
    visitor(
        {"state_interval_s", "s", "Time between two poses of the trajectory that is aligned with the INS.", 0.05, 60.0},
        self.state_interval_s);
    visitor(
        {"odometry_translation_sigma_m", "m", "Error of one step of LiDAR poses that do not state theirs.", 1e-5, 10.0},
        self.odometry_translation_sigma_m);
    visitor({"odometry_rotation_sigma_deg", "deg", "Error of one step of LiDAR poses that do not state theirs.", 1e-5,
             10.0},
            self.odometry_rotation_sigma_deg);
    visitor({"odometry_drift_percent", "%", "Error of the LiDAR's motion that grows with the distance of a step.", 0.0,
             100.0},
            self.odometry_drift_percent);
    visitor({"odometry_drift_deg", "deg/m", "Error of the LiDAR's heading that grows with the distance of a step.", 0.0,
             10.0},
            self.odometry_drift_deg);
    visitor({"odometry_scale_percent", "%", "By how much all distances of the LiDAR's motion may be wrong alike.", 0.0,
             50.0},
            self.odometry_scale_percent);
    visitor({"antenna_reach_m", "m", "How far the GNSS antenna may be from the LiDAR where nothing else is known.", 0.1,
             100.0},
            self.antenna_reach_m);
    visitor({"outlier_threshold", "sigma", "Measurements farther off than this lose their weight.", 2.0, 20.0},
            self.outlier_threshold);
    visitor({"update_s", "s", "Time between two answers while data arrive.", 0.1, 60.0}, self.update_s);
    visitor({"converged_translation_m", "m", "Sigma below which a translation counts as converged.", 1e-4, 10.0},
            self.converged_translation_m);
    visitor({"converged_rotation_deg", "deg", "Sigma below which an angle counts as converged.", 1e-4, 45.0},
            self.converged_rotation_deg);
  }
};

}  // namespace remount
