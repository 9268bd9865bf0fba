// The sensors that a simulated vehicle carries beside its LiDAR and INS, and troubles of the INS. A rate of 0 leaves a
// sensor out.
#pragma once

#include "algorithms/core/options.h"
#include "algorithms/geometry/rigid_transform.h"
#include "messages/simulation_options.h"

namespace remount::simulator {

/// Stretches of the drive in which the INS is worse than usual.
struct InsTroubleOptions {
  double degraded_start_s = 0.0;
  double degraded_s = 0.0;
  double degraded_drift_mps = 0.05;
  double gap_start_s = 0.0;
  double gap_s = 0.0;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor({"ins_degraded_start_s", "s", kNoLabel, say::option_simulate_ins_degraded_start_s, 0.0, 100000.0},
            self.degraded_start_s);
    visitor({"ins_degraded_s", "s", kNoLabel, say::option_simulate_ins_degraded_s, 0.0, 100000.0}, self.degraded_s);
    visitor({"ins_degraded_drift_mps", "m/s", kNoLabel, say::option_simulate_ins_degraded_drift_mps, 0.0, 10.0},
            self.degraded_drift_mps);
    visitor({"ins_gap_start_s", "s", kNoLabel, say::option_simulate_ins_gap_start_s, 0.0, 100000.0}, self.gap_start_s);
    visitor({"ins_gap_s", "s", kNoLabel, say::option_simulate_ins_gap_s, 0.0, 100000.0}, self.gap_s);
  }
};

/// Errors of a good MEMS unit by default.
struct SimulatedImuOptions {
  double rate_hz = 100.0;
  double gyro_noise_dps = 0.02;
  double gyro_bias_dps = 0.02;
  double gyro_bias_walk_dps = 0.0002;
  double accelerometer_noise_mps2 = 0.01;
  double accelerometer_bias_mps2 = 0.02;
  double accelerometer_bias_walk_mps2 = 0.0002;
  RigidTransform ins_from_imu = rigid_from_six({0.0, 0.0, 0.0, 0.02, -0.015, 0.01});

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor({"imu_rate_hz", "Hz", kNoLabel, say::option_simulate_imu_rate_hz, 0.0, 2000.0}, self.rate_hz);
    visitor({"imu_gyro_noise_dps", "deg/s", kNoLabel, say::option_simulate_imu_gyro_noise_dps, 0.0, 10.0},
            self.gyro_noise_dps);
    visitor({"imu_gyro_bias_dps", "deg/s", kNoLabel, say::option_simulate_imu_gyro_bias_dps, 0.0, 10.0},
            self.gyro_bias_dps);
    visitor(
        {"imu_gyro_bias_walk_dps", "deg/s/sqrt(s)", kNoLabel, say::option_simulate_imu_gyro_bias_walk_dps, 0.0, 1.0},
        self.gyro_bias_walk_dps);
    visitor({"imu_accelerometer_noise_mps2", "m/s2", kNoLabel, say::option_simulate_imu_accelerometer_noise_mps2, 0.0,
             10.0},
            self.accelerometer_noise_mps2);
    visitor(
        {"imu_accelerometer_bias_mps2", "m/s2", kNoLabel, say::option_simulate_imu_accelerometer_bias_mps2, 0.0, 10.0},
        self.accelerometer_bias_mps2);
    visitor({"imu_accelerometer_bias_walk_mps2", "m/s2/sqrt(s)", kNoLabel,
             say::option_simulate_imu_accelerometer_bias_walk_mps2, 0.0, 1.0},
            self.accelerometer_bias_walk_mps2);
  }
};

struct SimulatedGnssOptions {
  double rate_hz = 5.0;
  double noise_m = 0.02;
  double vertical_noise_m = 0.04;
  double outlier_share = 0.0;
  double outlier_m = 10.0;
  double outage_start_s = 0.0;
  double outage_s = 0.0;
  Eigen::Vector3d antenna_in_ins_m = {-0.6, 0.15, 0.9};

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor({"gnss_rate_hz", "Hz", kNoLabel, say::option_simulate_gnss_rate_hz, 0.0, 100.0}, self.rate_hz);
    visitor({"gnss_noise_m", "m", kNoLabel, say::option_simulate_gnss_noise_m, 0.0, 100.0}, self.noise_m);
    visitor({"gnss_vertical_noise_m", "m", kNoLabel, say::option_simulate_gnss_vertical_noise_m, 0.0, 100.0},
            self.vertical_noise_m);
    visitor({"gnss_outlier_share", "", kNoLabel, say::option_simulate_gnss_outlier_share, 0.0, 0.9},
            self.outlier_share);
    visitor({"gnss_outlier_m", "m", kNoLabel, say::option_simulate_gnss_outlier_m, 0.0, 10000.0}, self.outlier_m);
    visitor({"gnss_outage_start_s", "s", kNoLabel, say::option_simulate_gnss_outage_start_s, 0.0, 100000.0},
            self.outage_start_s);
    visitor({"gnss_outage_s", "s", kNoLabel, say::option_simulate_gnss_outage_s, 0.0, 100000.0}, self.outage_s);
    visitor({"antenna_x_m", "m", kNoLabel, say::option_simulate_antenna_x_m, -100.0, 100.0}, self.antenna_in_ins_m.x());
    visitor({"antenna_y_m", "m", kNoLabel, say::option_simulate_antenna_y_m, -100.0, 100.0}, self.antenna_in_ins_m.y());
    visitor({"antenna_z_m", "m", kNoLabel, say::option_simulate_antenna_z_m, -100.0, 100.0}, self.antenna_in_ins_m.z());
  }
};

struct SimulatedWheelOptions {
  double rate_hz = 50.0;
  double left_scale = 1.0;
  double right_scale = 1.0;
  double slip = 0.002;
  double noise_mps = 0.01;
  double lasting_slip = 0.0;
  double lasting_slip_s = 10.0;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor({"wheels_rate_hz", "Hz", kNoLabel, say::option_simulate_wheels_rate_hz, 0.0, 1000.0}, self.rate_hz);
    visitor({"wheels_left_scale", "", kNoLabel, say::option_simulate_wheels_left_scale, 0.5, 2.0}, self.left_scale);
    visitor({"wheels_right_scale", "", kNoLabel, say::option_simulate_wheels_right_scale, 0.5, 2.0}, self.right_scale);
    visitor({"wheels_slip", "", kNoLabel, say::option_simulate_wheels_slip, 0.0, 1.0}, self.slip);
    visitor({"wheels_noise_mps", "m/s", kNoLabel, say::option_simulate_wheels_noise_mps, 0.0, 10.0}, self.noise_mps);
    visitor({"wheels_lasting_slip", "", kNoLabel, say::option_simulate_wheels_lasting_slip, 0.0, 0.5},
            self.lasting_slip);
    visitor({"wheels_lasting_slip_s", "s", kNoLabel, say::option_simulate_wheels_lasting_slip_s, 0.01, 100000.0},
            self.lasting_slip_s);
  }
};

struct SimulatedBarometerOptions {
  double rate_hz = 10.0;
  double offset_m = 3.0;
  double drift_m = 0.02;
  double noise_m = 0.1;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor({"barometer_rate_hz", "Hz", kNoLabel, say::option_simulate_barometer_rate_hz, 0.0, 100.0}, self.rate_hz);
    visitor({"barometer_offset_m", "m", kNoLabel, say::option_simulate_barometer_offset_m, -1000.0, 1000.0},
            self.offset_m);
    visitor({"barometer_drift_m", "m/sqrt(s)", kNoLabel, say::option_simulate_barometer_drift_m, 0.0, 10.0},
            self.drift_m);
    visitor({"barometer_noise_m", "m", kNoLabel, say::option_simulate_barometer_noise_m, 0.0, 100.0}, self.noise_m);
  }
};

}  // namespace remount::simulator
