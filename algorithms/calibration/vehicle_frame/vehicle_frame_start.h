// The steps of the vehicle-frame calibration before everything is solved at once; used by vehicle_frame.cpp.
#pragma once

#include <optional>
#include <vector>

#include "algorithms/calibration/vehicle_frame/vehicle_frame_equations.h"

namespace remount::calibration {

/// What the drives carry, all of them together.
struct VehicleFrameStreams {
  bool reference = false;           ///< some interval has a turn by a reference attitude
  bool wheels_differ = false;       ///< the rear wheels' speeds are told apart, in every drive
  bool one_axis = false;            ///< the IMU has a yaw rate only, in every drive
  bool rates_by_reference = false;  ///< there is no gyro: the rates are those of the reference, in every drive
};
VehicleFrameStreams streams_of(const std::vector<VehicleDrive>& drives, const std::vector<VehicleInterval>& intervals);

struct VehicleFrameStart {
  VehicleFrameState state;
  std::optional<RotationEquationResult> imu_to_reference;
  RotationEquationResult imu_to_sensor;  ///< a: sensor, b: IMU
  PlanarMounting planar;
  /// Axes of the IMU whose scale the drive tells: turns by themselves that exceed all noise by far.
  Eigen::Array<bool, 3, 1> tells_gyro_scale = Eigen::Array<bool, 3, 1>::Constant(false);
  Eigen::Index main_axis_of_imu = 2;  ///< the one about which it turns most
  double turns_per_turn = 1.0;   ///< of the IMU, per those of the sensor; bias apart, 1 where the drive does not tell
  double metres_per_unit = 1.0;  ///< of the sensor's poses by the way of the wheels, whatever the options say
};

/// IMU to vehicle, pitch and roll of the sensor, then x, y, yaw and scale in the plane.
/// docs/maths/vehicle-frame.md (V5) to (V7)
VehicleFrameStart start_of(const std::vector<VehicleInterval>& intervals, const VehicleFrameStreams& streams,
                           const std::optional<RigidTransform>& nominal_vehicle_from_sensor,
                           const VehicleFrameOptions& options);

/// The mounting of the IMU that the options state.
Eigen::Matrix3d stated_imu_mounting(const VehicleFrameOptions& options);

}  // namespace remount::calibration
