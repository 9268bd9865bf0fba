// Where a sensor sits on the vehicle, from wheel speeds, an IMU and the sensor's own motion (seeds 001).
//
// The vehicle frame: rear-axle centre on the ground, x forward (the direction in which the rear axle moves), y left, z
// up. Its origin follows from the wheels: the rear axle's centre is the point that moves along x alone.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "algorithms/calibration/calibration_result.h"
#include "algorithms/calibration/method_details.h"
#include "algorithms/calibration/rotation_equation.h"
#include "algorithms/calibration/solve_options.h"
#include "algorithms/core/progress.h"
#include "algorithms/trajectory/wheel_integration.h"

namespace remount {

enum class ScaleMode { Known, Estimated };

struct VehicleFrameOptions {
  ScaleMode scale = ScaleMode::Known;
  bool estimate_wheel_scale = false;
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
             "linked. Off "
             "for drives up or down a single helix."},
            self.level_turns);
  }
};

/// One drive.
struct VehicleDrive {
  WheelImuSignals signals;
  std::vector<StampedPose> world_from_sensor;       ///< any world; translations in metres or in units of their own
  std::vector<StampedPose> reference_from_vehicle;  ///< attitude of the vehicle as an INS knows it; may be empty
};

/// One stretch of a drive as all sensors saw it.
struct VehicleInterval {
  int drive = 0;
  std::int64_t begin_ns = 0, end_ns = 0;
  std::vector<MotionStep> steps;
  RigidTransform sensor_begin_from_sensor_end = RigidTransform::Identity();
  std::optional<Eigen::Matrix3d> reference_begin_from_end;  ///< turn of the vehicle by the reference
};
std::vector<VehicleInterval> vehicle_intervals(const std::vector<VehicleDrive>& drives,
                                               const VehicleFrameOptions& options);

/// What is found beside X, with the steps on the way to it.
struct VehicleFrameResult {
  CalibrationResult calibration;  ///< reference_frame "vehicle": ins_from_lidar is vehicle_from_sensor
  Eigen::Matrix3d vehicle_from_imu = Eigen::Matrix3d::Identity();
  Eigen::Vector3d gyro_bias_radps = Eigen::Vector3d::Zero();
  double scale = 1.0;                                      ///< metres per unit of the sensor's poses
  double wheel_scale = 1.0;                                ///< true way per way of the wheels
  std::optional<RotationEquationResult> imu_to_reference;  ///< step 2, where the drive has a reference attitude
  RotationEquationResult imu_to_sensor;
  PlanarMounting planar;
  std::vector<NamedQuantity> quantities;
  int intervals = 0;
};

/// Rotation equation, planar closed form, then all at once by Gauss-Newton: X, scale, rate bias, mounting of the IMU.
/// What the drive does not determine keeps its nominal value (or zero) and is said so; numerical outcomes are in
/// `calibration.status`. Throws Error(Contract) for options out of range or both scales to be estimated.
VehicleFrameResult solve_vehicle_frame(const std::vector<VehicleDrive>& drives,
                                       const std::optional<RigidTransform>& nominal_vehicle_from_sensor,
                                       const VehicleFrameOptions& options, const SolveOptions& solve,
                                       Progress& progress);

}  // namespace remount
