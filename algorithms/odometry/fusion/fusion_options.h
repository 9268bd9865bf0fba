// What can be set of the multi-sensor odometry: its terms, their weights, and where the sensors sit.
#pragma once

#include "algorithms/core/options.h"
#include "algorithms/geometry/rigid_transform.h"
#include "messages/method_options.h"

namespace remount::odometry {

/// Each sigma is the root of the inverse of its term's information. Angles in degrees, since people type them.
struct FusionOptions {
  bool lines = true;
  bool planes = true;
  bool ackermann = true;
  bool accelerometer = true;
  bool barometer = true;

  double line_sigma_m = 0.1;
  double plane_sigma_m = 0.03;
  int independent_features = 300;
  double wheel_sigma = 0.01;
  double wheel_sigma_mps = 0.02;
  double sideslip_sigma_mps = 0.03;
  double gyro_sigma_dps = 0.05;
  double gyro_bias_sigma_dps = 0.05;
  double gyro_bias_walk_dps = 0.0005;
  double wheel_scale_sigma = 0.005;
  double accelerometer_sigma_deg = 0.5;
  double accelerometer_discount_deg = 1.0;
  double accelerometer_bias_deg = 0.15;
  double barometer_sigma_m = 0.5;
  double barometer_drift_m = 0.5;

  bool deskew = true;
  int map_frames = 15;
  double map_step_m = 0.2;
  double map_step_deg = 1.0;
  double line_voxel_m = 0.2;
  double plane_voxel_m = 0.4;
  int most_lines = 400;
  int most_planes = 1600;
  double match_distance_m = 1.0;
  double min_range_m = 1.5;
  double max_range_m = 90.0;
  double range_noise_m = 0.02;

  double track_width_m = 1.6;
  // The rear axle's centre on the ground is the vehicle's origin; its axes are forward, left, up.
  double ins_x_m = 0.0, ins_y_m = 0.0, ins_z_m = 0.0, ins_yaw_deg = 0.0, ins_pitch_deg = 0.0, ins_roll_deg = 0.0;
  double imu_x_m = 0.0, imu_y_m = 0.0, imu_z_m = 0.0, imu_yaw_deg = 0.0, imu_pitch_deg = 0.0, imu_roll_deg = 0.0;

  RigidTransform vehicle_from_ins() const {
    return rigid_from_six({ins_x_m, ins_y_m, ins_z_m, degrees_to_radians(ins_yaw_deg),
                           degrees_to_radians(ins_pitch_deg), degrees_to_radians(ins_roll_deg)});
  }
  RigidTransform ins_from_imu() const {
    return rigid_from_six({imu_x_m, imu_y_m, imu_z_m, degrees_to_radians(imu_yaw_deg),
                           degrees_to_radians(imu_pitch_deg), degrees_to_radians(imu_roll_deg)});
  }

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visit_terms(self, visitor);
    visit_features(self, visitor);
    visit_mounting(self, visitor);
  }

 private:
  template <class Self, class Visitor>
  static void visit_terms(Self& self, Visitor& visitor) {
    visitor({"lines", "", say::option_fusion_lines, say::option_fusion_lines_help}, self.lines);
    visitor({"planes", "", say::option_fusion_planes, say::option_fusion_planes_help}, self.planes);
    visitor({"ackermann", "", say::option_fusion_ackermann, say::option_fusion_ackermann_help}, self.ackermann);
    visitor({"accelerometer", "", say::option_fusion_accelerometer, say::option_fusion_accelerometer_help},
            self.accelerometer);
    visitor({"barometer", "", say::option_fusion_barometer, say::option_fusion_barometer_help}, self.barometer);
    visitor({"line_sigma_m", "m", say::option_fusion_line_sigma_m, say::option_fusion_line_sigma_m_help, 0.001, 10.0},
            self.line_sigma_m);
    visitor(
        {"plane_sigma_m", "m", say::option_fusion_plane_sigma_m, say::option_fusion_plane_sigma_m_help, 0.001, 10.0},
        self.plane_sigma_m);
    visitor({"independent_features", "", say::option_fusion_independent_features,
             say::option_fusion_independent_features_help, 10, 100000},
            self.independent_features);
    visitor({"wheel_sigma", "", say::option_fusion_wheel_sigma, say::option_fusion_wheel_sigma_help, 0.0001, 1.0},
            self.wheel_sigma);
    visitor({"wheel_sigma_mps", "m/s", say::option_fusion_wheel_sigma_mps, say::option_fusion_wheel_sigma_mps_help,
             0.0001, 10.0},
            self.wheel_sigma_mps);
    visitor({"sideslip_sigma_mps", "m/s", say::option_fusion_sideslip_sigma_mps,
             say::option_fusion_sideslip_sigma_mps_help, 0.0001, 10.0},
            self.sideslip_sigma_mps);
    visitor({"gyro_sigma_dps", "deg/s", say::option_fusion_gyro_sigma_dps, say::option_fusion_gyro_sigma_dps_help,
             0.0001, 10.0},
            self.gyro_sigma_dps);
    visitor({"gyro_bias_sigma_dps", "deg/s", say::option_fusion_gyro_bias_sigma_dps,
             say::option_fusion_gyro_bias_sigma_dps_help, 0.0, 10.0},
            self.gyro_bias_sigma_dps);
    visitor({"gyro_bias_walk_dps", "deg/s/sqrt(s)", say::option_fusion_gyro_bias_walk_dps,
             say::option_fusion_gyro_bias_walk_dps_help, 0.0, 1.0},
            self.gyro_bias_walk_dps);
    visitor({"wheel_scale_sigma", "", say::option_fusion_wheel_scale_sigma, say::option_fusion_wheel_scale_sigma_help,
             0.0, 0.2},
            self.wheel_scale_sigma);
    visitor({"accelerometer_sigma_deg", "deg", say::option_fusion_accelerometer_sigma_deg,
             say::option_fusion_accelerometer_sigma_deg_help, 0.01, 45.0},
            self.accelerometer_sigma_deg);
    visitor({"accelerometer_discount_deg", "deg", say::option_fusion_accelerometer_discount_deg,
             say::option_fusion_accelerometer_discount_deg_help, 0.0, 45.0},
            self.accelerometer_discount_deg);
    visitor({"accelerometer_bias_deg", "deg", say::option_fusion_accelerometer_bias_deg,
             say::option_fusion_accelerometer_bias_deg_help, 0.0, 45.0},
            self.accelerometer_bias_deg);
    visitor({"barometer_sigma_m", "m", say::option_fusion_barometer_sigma_m, say::option_fusion_barometer_sigma_m_help,
             0.01, 100.0},
            self.barometer_sigma_m);
    visitor({"barometer_drift_m", "m", say::option_fusion_barometer_drift_m, say::option_fusion_barometer_drift_m_help,
             0.0, 100.0},
            self.barometer_drift_m);
  }

  template <class Self, class Visitor>
  static void visit_features(Self& self, Visitor& visitor) {
    visitor({"deskew", "", say::option_fusion_deskew, say::option_fusion_deskew_help}, self.deskew);
    visitor({"map_frames", "", say::option_fusion_map_frames, say::option_fusion_map_frames_help, 1, 200},
            self.map_frames);
    visitor({"map_step_m", "m", say::option_fusion_map_step_m, say::option_fusion_map_step_m_help, 0.0, 10.0},
            self.map_step_m);
    visitor({"map_step_deg", "deg", say::option_fusion_map_step_deg, say::option_fusion_map_step_deg_help, 0.0, 90.0},
            self.map_step_deg);
    visitor({"line_voxel_m", "m", say::option_fusion_line_voxel_m, say::option_fusion_line_voxel_m_help, 0.02, 5.0},
            self.line_voxel_m);
    visitor({"plane_voxel_m", "m", say::option_fusion_plane_voxel_m, say::option_fusion_plane_voxel_m_help, 0.02, 5.0},
            self.plane_voxel_m);
    visitor({"most_lines", "", say::option_fusion_most_lines, say::option_fusion_most_lines_help, 10, 100000},
            self.most_lines);
    visitor({"most_planes", "", say::option_fusion_most_planes, say::option_fusion_most_planes_help, 10, 100000},
            self.most_planes);
    visitor({"match_distance_m", "m", say::option_fusion_match_distance_m, say::option_fusion_match_distance_m_help,
             0.1, 10.0},
            self.match_distance_m);
    visitor({"min_range_m", "m", say::option_fusion_min_range_m, say::option_fusion_min_range_m_help, 0.0, 50.0},
            self.min_range_m);
    visitor({"max_range_m", "m", say::option_fusion_max_range_m, say::option_fusion_max_range_m_help, 5.0, 1000.0},
            self.max_range_m);
    visitor({"range_noise_m", "m", say::option_fusion_range_noise_m, say::option_fusion_range_noise_m_help, 0.0, 1.0},
            self.range_noise_m);
  }

  template <class Self, class Visitor>
  static void visit_mounting(Self& self, Visitor& visitor) {
    visitor({"track_width_m", "m", say::option_fusion_track_width_m, say::option_fusion_track_width_m_help, 0.2, 20.0},
            self.track_width_m);
    visitor({"ins_x_m", "m", say::option_fusion_ins_x_m, say::option_fusion_ins_x_m_help, -50.0, 50.0}, self.ins_x_m);
    visitor({"ins_y_m", "m", say::option_fusion_ins_y_m, say::option_fusion_ins_y_m_help, -50.0, 50.0}, self.ins_y_m);
    visitor({"ins_z_m", "m", say::option_fusion_ins_z_m, say::option_fusion_ins_z_m_help, -50.0, 50.0}, self.ins_z_m);
    visitor({"ins_yaw_deg", "deg", say::option_fusion_ins_yaw_deg, say::option_fusion_ins_yaw_deg_help, -180.0, 180.0},
            self.ins_yaw_deg);
    visitor(
        {"ins_pitch_deg", "deg", say::option_fusion_ins_pitch_deg, say::option_fusion_ins_pitch_deg_help, -90.0, 90.0},
        self.ins_pitch_deg);
    visitor(
        {"ins_roll_deg", "deg", say::option_fusion_ins_roll_deg, say::option_fusion_ins_roll_deg_help, -180.0, 180.0},
        self.ins_roll_deg);
    visitor({"imu_x_m", "m", say::option_fusion_imu_x_m, say::option_fusion_imu_x_m_help, -50.0, 50.0}, self.imu_x_m);
    visitor({"imu_y_m", "m", say::option_fusion_imu_y_m, say::option_fusion_imu_y_m_help, -50.0, 50.0}, self.imu_y_m);
    visitor({"imu_z_m", "m", say::option_fusion_imu_z_m, say::option_fusion_imu_z_m_help, -50.0, 50.0}, self.imu_z_m);
    visitor({"imu_yaw_deg", "deg", say::option_fusion_imu_yaw_deg, say::option_fusion_imu_yaw_deg_help, -180.0, 180.0},
            self.imu_yaw_deg);
    visitor(
        {"imu_pitch_deg", "deg", say::option_fusion_imu_pitch_deg, say::option_fusion_imu_pitch_deg_help, -90.0, 90.0},
        self.imu_pitch_deg);
    visitor(
        {"imu_roll_deg", "deg", say::option_fusion_imu_roll_deg, say::option_fusion_imu_roll_deg_help, -180.0, 180.0},
        self.imu_roll_deg);
  }
};

}  // namespace remount::odometry
