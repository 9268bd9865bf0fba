// Where a sensor sits on the vehicle, from wheel speeds, an IMU and the sensor's own motion.
// docs/maths/vehicle-frame.md
//
// The vehicle frame: rear-axle centre on the ground, x forward (the direction in which the rear axle moves), y left, z
// up. Its origin follows from the wheels: the rear axle's centre is the point that moves along x alone.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "algorithms/calibration/calibration_result.h"
#include "algorithms/calibration/joint/rotation_equation.h"
#include "algorithms/calibration/method_details.h"
#include "algorithms/calibration/solve_options.h"
#include "algorithms/calibration/vehicle_frame/vehicle_frame_options.h"
#include "algorithms/core/progress.h"
#include "algorithms/motion/wheel_integration.h"

namespace remount::calibration {

/// One drive.
struct VehicleDrive {
  motion::WheelImuSignals sensed;
  std::vector<motion::StampedPose> world_from_sensor;  ///< any world; translations in metres or in units of their own
  std::vector<motion::StampedPose>
      reference_from_vehicle;       ///< attitude of the vehicle as an INS knows it; may be empty
  bool rates_by_reference = false;  ///< the rates are those of this attitude, not of a gyro
};

/// One stretch of a drive as all sensors saw it.
struct VehicleInterval {
  std::int64_t begin_ns = 0, end_ns = 0;
  std::vector<motion::MotionStep> steps;
  RigidTransform sensor_begin_from_sensor_end = RigidTransform::Identity();
  std::optional<Eigen::Matrix3d> reference_begin_from_end;  ///< turn of the vehicle by the reference
};
std::vector<VehicleInterval> vehicle_intervals(const std::vector<VehicleDrive>& drives,
                                               const VehicleFrameOptions& options);

/// Id of the quantity that tells the sides of the rear axle apart.
inline constexpr const char* kRightOverLeft = "right wheel scale over left";
/// Ids of the quantities that scale the rates of an IMU: of all axes alike, or of one, 'x' to 'z'.
inline constexpr const char* kGyroScale = "gyro scale";
inline std::string gyro_scale_of_axis(char axis) { return std::string(kGyroScale) + ' ' + axis; }

/// What is found beside X, with the steps on the way to it.
struct VehicleFrameResult {
  CalibrationResult calibration;  ///< its mounting is vehicle_from_sensor
  Eigen::Matrix3d vehicle_from_imu = Eigen::Matrix3d::Identity();
  Eigen::Vector3d gyro_bias_radps = Eigen::Vector3d::Zero();
  Eigen::Vector3d gyro_scale = Eigen::Vector3d::Ones();    ///< true rates per measured ones, axes of the IMU
  double right_over_left = 1.0;                            ///< true way per way of the right wheel over the left's
  double scale = 1.0;                                      ///< metres per unit of the sensor's poses
  double wheel_scale = 1.0;                                ///< true way per way of the wheels
  std::optional<RotationEquationResult> imu_to_reference;  ///< where the drive has a reference attitude
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

/// Status and message of a solved calibration by what of it is observed.
void state_vehicle_frame(int intervals, CalibrationResult& calibration);

}  // namespace remount::calibration
