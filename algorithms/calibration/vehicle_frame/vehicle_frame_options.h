// Options of the vehicle-frame method.
#pragma once

#include "algorithms/core/options.h"
#include "messages/method_options.h"

namespace remount::calibration {

enum class ScaleMode { Known, Estimated };

struct VehicleFrameOptions {
  ScaleMode scale = ScaleMode::Known;
  bool estimate_wheel_scale = false;  ///< within 10%; else within 1.5% where the sensor is metric
  double interval_m = 5.0;
  double interval_turn_deg = 8.0;
  double imu_yaw_deg = 0.0, imu_pitch_deg = 0.0, imu_roll_deg = 0.0;
  double imu_mounting_sigma_deg = 5.0;
  double ins_alignment_sigma_deg = 0.1;
  double gyro_bias_sigma_dps = 1.0;
  bool level_turns = true;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor.choice({"scale", "", say::option_vehicle_frame_scale, say::option_vehicle_frame_scale_help}, self.scale,
                   {"known", "estimated"});
    visitor({"estimate_wheel_scale", "", say::option_vehicle_frame_estimate_wheel_scale,
             say::option_vehicle_frame_estimate_wheel_scale_help},
            self.estimate_wheel_scale);
    visitor({"interval_m", "m", say::option_vehicle_frame_interval_m, say::option_vehicle_frame_interval_m_help, 0.2,
             200.0},
            self.interval_m);
    visitor({"interval_turn_deg", "deg", say::option_vehicle_frame_interval_turn_deg,
             say::option_vehicle_frame_interval_turn_deg_help, 0.5, 90.0},
            self.interval_turn_deg);
    visitor({"imu_yaw_deg", "deg", say::option_vehicle_frame_imu_yaw_deg, say::option_vehicle_frame_imu_yaw_deg_help,
             -180.0, 180.0},
            self.imu_yaw_deg);
    visitor({"imu_pitch_deg", "deg", say::option_vehicle_frame_imu_pitch_deg,
             say::option_vehicle_frame_imu_pitch_deg_help, -90.0, 90.0},
            self.imu_pitch_deg);
    visitor({"imu_roll_deg", "deg", say::option_vehicle_frame_imu_roll_deg, say::option_vehicle_frame_imu_roll_deg_help,
             -180.0, 180.0},
            self.imu_roll_deg);
    visitor({"imu_mounting_sigma_deg", "deg", say::option_vehicle_frame_imu_mounting_sigma_deg,
             say::option_vehicle_frame_imu_mounting_sigma_deg_help, 0.001, 180.0},
            self.imu_mounting_sigma_deg);
    visitor({"ins_alignment_sigma_deg", "deg", say::option_vehicle_frame_ins_alignment_sigma_deg,
             say::option_vehicle_frame_ins_alignment_sigma_deg_help, 0.001, 180.0},
            self.ins_alignment_sigma_deg);
    visitor({"gyro_bias_sigma_dps", "deg/s", say::option_vehicle_frame_gyro_bias_sigma_dps,
             say::option_vehicle_frame_gyro_bias_sigma_dps_help, 0.0, 100.0},
            self.gyro_bias_sigma_dps);
    visitor({"level_turns", "", say::option_vehicle_frame_level_turns, say::option_vehicle_frame_level_turns_help},
            self.level_turns);
  }
};

}  // namespace remount::calibration
