// Options of the solution of P X = X Q: ranking, noise, what counts as observed.
#pragma once

#include <array>

#include "algorithms/core/options.h"
#include "algorithms/geometry/rotation.h"
#include "messages/options.h"

namespace remount::calibration {

/// Blocks of time of the bootstrap: so many are needed for their scatter; those of a short drive are shorter.
inline constexpr double kBootstrapBlocks = 20.0;

/// Whether X is solved with the offset between the clocks of lidar and INS that the drive shows.
enum class ClockOffsetUse {
  Auto,  ///< where it stands out of its error and is well determined
  Yes,
  No,
};

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
  ClockOffsetUse apply_time_offset = ClockOffsetUse::Auto;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor({"characteristic_length_m", "m", say::option_solve_characteristic_length_m,
             say::option_solve_characteristic_length_m_help, 0.01, 1000.0},
            self.characteristic_length_m);
    visitor({"ins_position_sigma_m", "m", say::option_solve_ins_position_sigma_m,
             say::option_solve_ins_position_sigma_m_help, 1e-6, 10.0},
            self.ins_position_sigma_m);
    visitor({"ins_attitude_sigma_deg", "deg", say::option_solve_ins_attitude_sigma_deg,
             say::option_solve_ins_attitude_sigma_deg_help, 1e-6, 10.0},
            self.ins_attitude_sigma_deg);
    visitor({"ins_attitude_bias_sigma_deg", "deg", say::option_solve_ins_attitude_bias_sigma_deg,
             say::option_solve_ins_attitude_bias_sigma_deg_help, 0.0, 10.0},
            self.ins_attitude_bias_sigma_deg);
    visitor({"ins_position_drift_m", "m/sqrt(s)", say::option_solve_ins_position_drift_m,
             say::option_solve_ins_position_drift_m_help, 0.0, 10.0},
            self.ins_position_drift_m);
    visitor({"ins_attitude_drift_deg", "deg/sqrt(s)", say::option_solve_ins_attitude_drift_deg,
             say::option_solve_ins_attitude_drift_deg_help, 0.0, 10.0},
            self.ins_attitude_drift_deg);
    visitor({"max_translation_sigma_m", "m", say::option_solve_max_translation_sigma_m,
             say::option_solve_max_translation_sigma_m_help, 0.001, 10.0},
            self.max_translation_sigma_m);
    visitor({"max_rotation_sigma_deg", "deg", say::option_solve_max_rotation_sigma_deg,
             say::option_solve_max_rotation_sigma_deg_help, 0.001, 45.0},
            self.max_rotation_sigma_deg);
    visitor({"outlier_threshold", "sigma", say::option_solve_outlier_threshold,
             say::option_solve_outlier_threshold_help, 2.0, 100.0},
            self.outlier_threshold);
    visitor({"max_listed_candidates", "", say::option_solve_max_listed_candidates,
             say::option_solve_max_listed_candidates_help, 1, 100000},
            self.max_listed_candidates);
    visitor({"bootstrap_block_s", "s", say::option_solve_bootstrap_block_s, say::option_solve_bootstrap_block_s_help,
             0.1, 600.0},
            self.bootstrap_block_s);
    visitor({"joint_clouds", "", say::option_solve_joint_clouds, say::option_solve_joint_clouds_help},
            self.joint_clouds);
    visitor.choice(
        {"apply_time_offset", "", say::option_solve_apply_time_offset, say::option_solve_apply_time_offset_help},
        self.apply_time_offset, {"auto", "yes", "no"});
  }
};

}  // namespace remount::calibration
