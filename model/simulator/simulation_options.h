// What is simulated: the road, the sensors, their errors.
#pragma once

#include "algorithms/core/options.h"
#include "algorithms/geometry/rigid_transform.h"
#include "messages/simulation_options.h"
#include "model/simulator/lidar_error_options.h"
#include "model/simulator/lidar_options.h"
#include "model/simulator/scenario_options.h"
#include "model/simulator/sensor_options.h"

namespace remount::simulator {

enum class ScenarioKind { Street, Flat, Straight, FigureEight, ParkingRamp, Hill, Highway, Tunnel, SlewYard };

struct SimulationOptions {
  ScenarioKind scenario = ScenarioKind::Street;
  double duration_s = 12.0;
  double speed_mps = 6.0;
  double scan_rate_hz = 10.0;
  int beams = 64;
  int azimuth_steps = 1000;
  double range_noise_m = 0.015;
  double max_range_m = 80.0;
  double dropout = 0.02;
  bool motion_distortion = true;
  bool per_point_time = true;
  bool clockwise = true;
  int moving_objects = 3;
  double ins_rate_hz = 100.0;
  double ins_position_noise_m = 0.005;
  double ins_attitude_noise_deg = 0.02;
  double ins_attitude_bias_deg = 0.0;
  double ins_position_drift_m = 0.0;
  double ins_attitude_drift_deg = 0.0;
  double lidar_clock_offset_s = 0.0;
  double standstill_s = 0.0;
  double speed_swing = 0.0;
  double latitude_deg = 48.78;
  double longitude_deg = 9.18;
  double height_m = 250.0;
  double heading_deg = 30.0;
  int seed = 1;
  SimulatedLidarOptions lidar;
  SimulatedLidarErrors lidar_errors;
  SlewYardOptions slew_yard;
  InsTroubleOptions ins_trouble;
  SimulatedImuOptions imu;
  SimulatedGnssOptions gnss;
  SimulatedWheelOptions wheels;
  SimulatedBarometerOptions barometer;
  RigidTransform ins_from_lidar = rigid_from_six({0.9, -0.25, 0.75, 0.03, -0.02, 0.015});
  /// The LiDAR's first scan begins so long after the start of the drive: LiDARs of one vehicle (lidar_mount.h) need not
  /// begin their scans together.
  double scan_phase_s = 0.0;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor.choice(
        {"scenario", "", kNoLabel, say::option_simulate_scenario}, self.scenario,
        {"street", "flat", "straight", "figure-eight", "parking-ramp", "hill", "highway", "tunnel", "slew-yard"});
    visitor({"duration_s", "s", kNoLabel, say::option_simulate_duration_s, 0.5, 100000.0}, self.duration_s);
    visitor({"speed_mps", "m/s", kNoLabel, say::option_simulate_speed_mps, 0.1, 60.0}, self.speed_mps);
    visitor({"scan_rate_hz", "Hz", kNoLabel, say::option_simulate_scan_rate_hz, 0.1, 100.0}, self.scan_rate_hz);
    visitor({"beams", "", kNoLabel, say::option_simulate_beams, 1, 256}, self.beams);
    visitor({"azimuth_steps", "", kNoLabel, say::option_simulate_azimuth_steps, 16, 10000}, self.azimuth_steps);
    visitor({"range_noise_m", "m", kNoLabel, say::option_simulate_range_noise_m, 0.0, 1.0}, self.range_noise_m);
    visitor({"max_range_m", "m", kNoLabel, say::option_simulate_max_range_m, 1.0, 500.0}, self.max_range_m);
    visitor({"dropout", "", kNoLabel, say::option_simulate_dropout, 0.0, 0.99}, self.dropout);
    visitor({"motion_distortion", "", kNoLabel, say::option_simulate_motion_distortion}, self.motion_distortion);
    visitor({"per_point_time", "", kNoLabel, say::option_simulate_per_point_time}, self.per_point_time);
    visitor({"clockwise", "", kNoLabel, say::option_simulate_clockwise}, self.clockwise);
    visitor({"moving_objects", "", kNoLabel, say::option_simulate_moving_objects, 0, 100}, self.moving_objects);
    visitor({"ins_rate_hz", "Hz", kNoLabel, say::option_simulate_ins_rate_hz, 1.0, 1000.0}, self.ins_rate_hz);
    visitor({"ins_position_noise_m", "m", kNoLabel, say::option_simulate_ins_position_noise_m, 0.0, 10.0},
            self.ins_position_noise_m);
    visitor({"ins_attitude_noise_deg", "deg", kNoLabel, say::option_simulate_ins_attitude_noise_deg, 0.0, 10.0},
            self.ins_attitude_noise_deg);
    visitor({"ins_attitude_bias_deg", "deg", kNoLabel, say::option_simulate_ins_attitude_bias_deg, 0.0, 10.0},
            self.ins_attitude_bias_deg);
    visitor({"ins_position_drift_m", "m/sqrt(s)", kNoLabel, say::option_simulate_ins_position_drift_m, 0.0, 10.0},
            self.ins_position_drift_m);
    visitor({"ins_attitude_drift_deg", "deg/sqrt(s)", kNoLabel, say::option_simulate_ins_attitude_drift_deg, 0.0, 10.0},
            self.ins_attitude_drift_deg);
    visitor({"lidar_clock_offset_s", "s", kNoLabel, say::option_simulate_lidar_clock_offset_s, -10.0, 10.0},
            self.lidar_clock_offset_s);
    visitor({"standstill_s", "s", kNoLabel, say::option_simulate_standstill_s, 0.0, 1000.0}, self.standstill_s);
    visitor({"speed_swing", "", kNoLabel, say::option_simulate_speed_swing, 0.0, 0.9}, self.speed_swing);
    visitor({"latitude_deg", "deg", kNoLabel, say::option_simulate_latitude_deg, -79.0, 83.0}, self.latitude_deg);
    visitor({"longitude_deg", "deg", kNoLabel, say::option_simulate_longitude_deg, -180.0, 180.0}, self.longitude_deg);
    visitor({"height_m", "m", kNoLabel, say::option_simulate_height_m, -500.0, 9000.0}, self.height_m);
    visitor({"heading_deg", "deg", kNoLabel, say::option_simulate_heading_deg, -360.0, 360.0}, self.heading_deg);
    visitor({"seed", "", kNoLabel, say::option_simulate_seed, 0, 2147483647}, self.seed);
    SimulatedLidarOptions::visit(self.lidar, visitor);
    SimulatedLidarErrors::visit(self.lidar_errors, visitor);
    SlewYardOptions::visit(self.slew_yard, visitor);
    InsTroubleOptions::visit(self.ins_trouble, visitor);
    SimulatedImuOptions::visit(self.imu, visitor);
    SimulatedGnssOptions::visit(self.gnss, visitor);
    SimulatedWheelOptions::visit(self.wheels, visitor);
    SimulatedBarometerOptions::visit(self.barometer, visitor);
  }
};

}  // namespace remount::simulator
