// What can be set of the multi-sensor odometry: its terms, their weights, and where the sensors sit.
#pragma once

#include "algorithms/core/options.h"
#include "algorithms/geometry/rigid_transform.h"

namespace remount {

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
    visitor({"lines", "", "Use line features of the scans."}, self.lines);
    visitor({"planes", "", "Use plane features of the scans."}, self.planes);
    visitor({"ackermann", "", "Use dead reckoning from the rear wheels and the gyroscope."}, self.ackermann);
    visitor({"accelerometer", "", "Use roll and pitch from the accelerometer."}, self.accelerometer);
    visitor({"barometer", "", "Use the height of the barometer, relative to the start."}, self.barometer);
    visitor({"line_sigma_m", "m", "1-sigma of a line feature's distance from its line.", 0.001, 10.0},
            self.line_sigma_m);
    visitor({"plane_sigma_m", "m", "1-sigma of a plane feature's distance from its plane.", 0.001, 10.0},
            self.plane_sigma_m);
    visitor({"independent_features", "",
             "Features of a scan count for at most as many independent ones: neighbours share the errors of the map.",
             10, 100000},
            self.independent_features);
    visitor({"wheel_sigma", "", "1-sigma of a step by the wheels, as a share of the distance.", 0.0001, 1.0},
            self.wheel_sigma);
    visitor({"wheel_sigma_mps", "m/s", "1-sigma of the wheels' speed that does not grow with it.", 0.0001, 10.0},
            self.wheel_sigma_mps);
    visitor({"sideslip_sigma_mps", "m/s", "1-sigma of the rear axle's motion to the side and up.", 0.0001, 10.0},
            self.sideslip_sigma_mps);
    visitor({"gyro_sigma_dps", "deg/s", "1-sigma of a step's mean angular rate, each axis.", 0.0001, 10.0},
            self.gyro_sigma_dps);
    visitor({"gyro_bias_sigma_dps", "deg/s", "1-sigma of the gyroscope's bias at the start, each axis.", 0.0, 10.0},
            self.gyro_bias_sigma_dps);
    visitor({"gyro_bias_walk_dps", "deg/s/sqrt(s)", "How fast that bias walks, each axis.", 0.0, 1.0},
            self.gyro_bias_walk_dps);
    visitor({"wheel_scale_sigma", "", "1-sigma of the scale of the wheels' speed.", 0.0, 0.2}, self.wheel_scale_sigma);
    visitor({"accelerometer_sigma_deg", "deg", "1-sigma of roll and pitch from the accelerometer.", 0.01, 45.0},
            self.accelerometer_sigma_deg);
    visitor(
        {"accelerometer_discount_deg", "deg",
         "Added to that for each m/s2 by which the vehicle accelerates, what is known of that taken off.", 0.0, 45.0},
        self.accelerometer_discount_deg);
    visitor(
        {"accelerometer_bias_deg", "deg", "1-sigma of the part of their error that stays over the drive.", 0.0, 45.0},
        self.accelerometer_bias_deg);
    visitor({"barometer_sigma_m", "m", "1-sigma of the height of the barometer.", 0.01, 100.0}, self.barometer_sigma_m);
    visitor({"barometer_drift_m", "m", "1-sigma of the part of its error that stays: weather, and the start's.", 0.0,
             100.0},
            self.barometer_drift_m);
  }

  template <class Self, class Visitor>
  static void visit_features(Self& self, Visitor& visitor) {
    visitor({"deskew", "", "Compensate the motion within a scan by the predicted motion."}, self.deskew);
    visitor({"map_frames", "", "Scans in the local map.", 1, 200}, self.map_frames);
    visitor({"map_step_m", "m", "A scan enters the map that moved this far since the last one, or turned.", 0.0, 10.0},
            self.map_step_m);
    visitor(
        {"map_step_deg", "deg", "A scan enters the map that turned this much since the last one, or moved.", 0.0, 90.0},
        self.map_step_deg);
    visitor({"line_voxel_m", "m", "Line features are thinned to one in a cube of this size.", 0.02, 5.0},
            self.line_voxel_m);
    visitor({"plane_voxel_m", "m", "Plane features are thinned to one in a cube of this size.", 0.02, 5.0},
            self.plane_voxel_m);
    visitor({"most_lines", "", "Line features of a scan that are matched, at most.", 10, 100000}, self.most_lines);
    visitor({"most_planes", "", "Plane features of a scan that are matched, at most.", 10, 100000}, self.most_planes);
    visitor({"match_distance_m", "m", "Neighbours in the map are looked for within this distance.", 0.1, 10.0},
            self.match_distance_m);
    visitor({"min_range_m", "m", "Nearer points are left out.", 0.0, 50.0}, self.min_range_m);
    visitor({"max_range_m", "m", "Farther points are left out.", 5.0, 1000.0}, self.max_range_m);
    visitor({"range_noise_m", "m", "1-sigma of the range that the LiDAR measures.", 0.0, 1.0}, self.range_noise_m);
  }

  template <class Self, class Visitor>
  static void visit_mounting(Self& self, Visitor& visitor) {
    visitor({"track_width_m", "m", "Between the rear wheels; gives the turn where there is no gyroscope.", 0.2, 20.0},
            self.track_width_m);
    visitor({"ins_x_m", "m", "INS ahead of the rear axle.", -50.0, 50.0}, self.ins_x_m);
    visitor({"ins_y_m", "m", "INS to the left of the rear axle's centre.", -50.0, 50.0}, self.ins_y_m);
    visitor({"ins_z_m", "m", "INS above the ground under the rear axle.", -50.0, 50.0}, self.ins_z_m);
    visitor({"ins_yaw_deg", "deg", "Yaw of the INS in the vehicle.", -180.0, 180.0}, self.ins_yaw_deg);
    visitor({"ins_pitch_deg", "deg", "Pitch of the INS in the vehicle.", -90.0, 90.0}, self.ins_pitch_deg);
    visitor({"ins_roll_deg", "deg", "Roll of the INS in the vehicle.", -180.0, 180.0}, self.ins_roll_deg);
    visitor({"imu_x_m", "m", "IMU ahead of the INS, in its axes.", -50.0, 50.0}, self.imu_x_m);
    visitor({"imu_y_m", "m", "IMU to the left of the INS, in its axes.", -50.0, 50.0}, self.imu_y_m);
    visitor({"imu_z_m", "m", "IMU above the INS, in its axes.", -50.0, 50.0}, self.imu_z_m);
    visitor({"imu_yaw_deg", "deg", "Yaw of the IMU in the INS frame.", -180.0, 180.0}, self.imu_yaw_deg);
    visitor({"imu_pitch_deg", "deg", "Pitch of the IMU in the INS frame.", -90.0, 90.0}, self.imu_pitch_deg);
    visitor({"imu_roll_deg", "deg", "Roll of the IMU in the INS frame.", -180.0, 180.0}, self.imu_roll_deg);
  }
};

}  // namespace remount
