// Options of the vehicle-frame method.
#pragma once

#include "algorithms/core/options.h"

namespace remount {

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
    visitor.choice({"scale", "",
                    "Scale of the sensor's poses: known where they are in metres (LiDAR), estimated where it is free "
                    "(one camera)."},
                   self.scale, {"known", "estimated"});
    visitor({"estimate_wheel_scale", "",
             "Estimate the scale of the wheel speeds (tyre radius) too; needs sensor poses in metres."},
            self.estimate_wheel_scale);
    visitor({"interval_m", "m", "Way between two poses of the sensor that are compared with the wheels.", 0.2, 200.0},
            self.interval_m);
    visitor({"interval_turn_deg", "deg", "Turn after which two poses are compared even on a shorter way.", 0.5, 90.0},
            self.interval_turn_deg);
    visitor({"imu_yaw_deg", "deg", "Yaw of the IMU in the vehicle as far as it is known.", -180.0, 180.0},
            self.imu_yaw_deg);
    visitor({"imu_pitch_deg", "deg", "Pitch of the IMU in the vehicle as far as it is known.", -90.0, 90.0},
            self.imu_pitch_deg);
    visitor({"imu_roll_deg", "deg", "Roll of the IMU in the vehicle as far as it is known.", -180.0, 180.0},
            self.imu_roll_deg);
    visitor(
        {"imu_mounting_sigma_deg", "deg", "How well these angles of the IMU are known; 180: not at all.", 0.001, 180.0},
        self.imu_mounting_sigma_deg);
    visitor({"ins_alignment_sigma_deg", "deg",
             "How well the axes of an INS, where the drive has one, are those of the vehicle.", 0.001, 180.0},
            self.ins_alignment_sigma_deg);
    visitor({"gyro_bias_sigma_dps", "deg/s", "How large the constant error of the IMU's rates may be.", 0.0, 100.0},
            self.gyro_bias_sigma_dps);
    visitor({"level_turns", "",
             "Where no INS says it: on the whole the vehicle turns about its own z, leaning and turning are not "
             "linked."},
            self.level_turns);
  }
};

}  // namespace remount
