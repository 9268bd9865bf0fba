// A simulated drive through a tunnel and the odometries that are asked about it.
#pragma once

#include "model/methods/fusion_odometry/fusion_run.h"
#include "model/simulator/simulator.h"

namespace remount::testing {

/// A tunnel without features, driven at 15 m/s on average; the speed swings by a fifth, as traffic makes it.
inline simulator::SimulationOptions tunnel_options(double length_m) {
  simulator::SimulationOptions options;
  options.scenario = simulator::ScenarioKind::Tunnel;
  options.speed_mps = 15.0;
  options.speed_swing = 0.2;
  options.duration_s = length_m / options.speed_mps;
  options.beams = 32;
  options.azimuth_steps = 720;
  options.standstill_s = 3.0;
  options.moving_objects = 0;
  options.ins_rate_hz = 10.0;
  return options;
}

/// What the drive's sensors are, as its truth tells.
inline settings::Settings settings_of(const simulator::SimulatedDrive& drive) {
  settings::Settings settings;
  const auto six = [](const RigidTransform& transform) { return six_from_rigid(transform); };
  const SixParameters ins = six(drive.sensors.vehicle_from_ins), imu = six(drive.sensors.ins_from_imu);
  odometry::FusionOptions& fusion = settings.fusion;
  fusion.ins_x_m = ins.x_m, fusion.ins_y_m = ins.y_m, fusion.ins_z_m = ins.z_m;
  fusion.ins_yaw_deg = radians_to_degrees(ins.yaw_rad);
  fusion.ins_pitch_deg = radians_to_degrees(ins.pitch_rad);
  fusion.ins_roll_deg = radians_to_degrees(ins.roll_rad);
  fusion.imu_x_m = imu.x_m, fusion.imu_y_m = imu.y_m, fusion.imu_z_m = imu.z_m;
  fusion.imu_yaw_deg = radians_to_degrees(imu.yaw_rad);
  fusion.imu_pitch_deg = radians_to_degrees(imu.pitch_rad);
  fusion.imu_roll_deg = radians_to_degrees(imu.roll_rad);
  fusion.track_width_m = drive.sensors.track_m;
  return settings;
}

/// Distance between the end that was found and the true one, m: the odometry frame is level and has origin and heading
/// of the first scan's vehicle.
inline double end_error_m(const simulator::SimulatedDrive& drive, const methods::FusionRun& run) {
  const auto enu_from_vehicle = [&](const motion::StampedPose& enu_from_ins) {
    return RigidTransform(enu_from_ins.pose * drive.sensors.vehicle_from_ins.inverse());
  };
  const RigidTransform first = enu_from_vehicle(drive.enu_from_ins.front());
  const double yaw_rad = yaw_pitch_roll_from_rotation(first.linear()).yaw_rad;
  const RigidTransform enu_from_odometry =
      make_rigid(rotation_from_yaw_pitch_roll({yaw_rad, 0.0, 0.0}), first.translation());
  const Eigen::Vector3d truth = enu_from_odometry.inverse() * enu_from_vehicle(drive.enu_from_ins.back()).translation();
  return (run.odometry.scans.back().odometry_from_vehicle.translation() - truth).norm();
}

/// The same with the LiDAR's other odometry: the scans alone.
inline settings::Settings scans_alone(settings::Settings settings) {
  settings.fusion.ackermann = settings.fusion.accelerometer = settings.fusion.barometer = false;
  return settings;
}

}  // namespace remount::testing
