// Options of the solution of P X = X Q: search range, ranking, noise, what counts as observed.
#pragma once

#include <array>

#include "algorithms/core/options.h"
#include "algorithms/geometry/rotation.h"

namespace remount {

/// Search range of the six parameters of X = ins_from_lidar, in the navigation (INS) frame. Angles are compared as they
/// are stated, yaw and roll within +-180 deg and pitch within +-90 deg: from -180 to 180 deg is every angle.
struct SearchRange {
  double x_min_m = -5.0, x_max_m = 5.0;
  double y_min_m = -5.0, y_max_m = 5.0;
  double z_min_m = -5.0, z_max_m = 5.0;
  double yaw_min_rad = -kPi, yaw_max_rad = kPi;
  double pitch_min_rad = -kPi, pitch_max_rad = kPi;
  double roll_min_rad = -kPi, roll_max_rad = kPi;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor({"x_min_m", "m", "Search range of x, forward in the INS frame.", -1000.0, 1000.0}, self.x_min_m);
    visitor({"x_max_m", "m", "Search range of x, forward in the INS frame.", -1000.0, 1000.0}, self.x_max_m);
    visitor({"y_min_m", "m", "Search range of y, left in the INS frame.", -1000.0, 1000.0}, self.y_min_m);
    visitor({"y_max_m", "m", "Search range of y, left in the INS frame.", -1000.0, 1000.0}, self.y_max_m);
    visitor({"z_min_m", "m", "Search range of z, up in the INS frame.", -1000.0, 1000.0}, self.z_min_m);
    visitor({"z_max_m", "m", "Search range of z, up in the INS frame.", -1000.0, 1000.0}, self.z_max_m);
    visitor({"yaw_min_rad", "rad", "Search range of yaw; half a turn to each side is every angle.", -kPi, kPi},
            self.yaw_min_rad);
    visitor({"yaw_max_rad", "rad", "Search range of yaw; half a turn to each side is every angle.", -kPi, kPi},
            self.yaw_max_rad);
    visitor({"pitch_min_rad", "rad", "Search range of pitch, which is stated within a quarter turn.", -kPi, kPi},
            self.pitch_min_rad);
    visitor({"pitch_max_rad", "rad", "Search range of pitch, which is stated within a quarter turn.", -kPi, kPi},
            self.pitch_max_rad);
    visitor({"roll_min_rad", "rad", "Search range of roll; half a turn to each side is every angle.", -kPi, kPi},
            self.roll_min_rad);
    visitor({"roll_max_rad", "rad", "Search range of roll; half a turn to each side is every angle.", -kPi, kPi},
            self.roll_max_rad);
  }
};

/// Blocks of time of the bootstrap: so many are needed for their scatter; those of a short drive are shorter.
inline constexpr double kBootstrapBlocks = 20.0;

struct SolveOptions {
  double characteristic_length_m = 1.0;
  double ins_position_sigma_m = 0.01;
  double ins_attitude_sigma_deg = 0.03;
  double ins_attitude_bias_sigma_deg = 0.05;
  double ins_position_drift_m = 0.02;
  double ins_attitude_drift_deg = 0.01;
  double max_translation_sigma_m = 0.30;
  double max_rotation_sigma_deg = 1.0;
  double outlier_threshold = 4.0;
  int max_listed_candidates = 200;
  double bootstrap_block_s = 5.0;
  bool joint_clouds = true;
  bool apply_time_offset = false;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor({"characteristic_length_m", "m",
             "Scales the translation block in the ranking error; 1 m is the plain Frobenius norm.", 0.01, 1000.0},
            self.characteristic_length_m);
    visitor({"ins_position_sigma_m", "m", "INS position noise from sample to sample, where the log does not state it.",
             1e-6, 10.0},
            self.ins_position_sigma_m);
    visitor({"ins_attitude_sigma_deg", "deg",
             "INS attitude noise from sample to sample, where the log does not state it.", 1e-6, 10.0},
            self.ins_attitude_sigma_deg);
    visitor({"ins_attitude_bias_sigma_deg", "deg",
             "INS attitude error that stays the same over a drive, where the log does not "
             "state it.",
             0.0, 10.0},
            self.ins_attitude_bias_sigma_deg);
    visitor({"ins_position_drift_m", "m/sqrt(s)",
             "INS position error that builds up in one second, growing with the root of time, where the "
             "log does not state its errors.",
             0.0, 10.0},
            self.ins_position_drift_m);
    visitor({"ins_attitude_drift_deg", "deg/sqrt(s)",
             "INS attitude error that builds up in one second, growing with the root of time, where "
             "the log does not state its errors.",
             0.0, 10.0},
            self.ins_attitude_drift_deg);
    visitor({"max_translation_sigma_m", "m", "A translation with a larger sigma counts as not observed.", 0.001, 10.0},
            self.max_translation_sigma_m);
    visitor({"max_rotation_sigma_deg", "deg", "A rotation with a larger sigma counts as not observed.", 0.001, 45.0},
            self.max_rotation_sigma_deg);
    visitor({"outlier_threshold", "sigma", "Pairs whose residual exceeds this many sigma are rejected.", 2.0, 100.0},
            self.outlier_threshold);
    visitor({"max_listed_candidates", "", "Candidates kept in the result, best first.", 1, 100000},
            self.max_listed_candidates);
    visitor({"bootstrap_block_s", "s", "Longest block of time whose errors count as one for the bootstrap sigma.", 0.1,
             600.0},
            self.bootstrap_block_s);
    visitor({"joint_clouds", "", "Align the clouds of all accepted pairs together as the last step."},
            self.joint_clouds);
    visitor({"apply_time_offset", "", "Apply the estimated clock offset between lidar and INS."},
            self.apply_time_offset);
  }
};

}  // namespace remount
