// Drives with known truth: a ray-cast world, a LiDAR and the other sensors of one vehicle.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "algorithms/core/progress.h"
#include "algorithms/geometry/rigid_transform.h"
#include "model/drive/session.h"
#include "model/simulator/lidar_mount.h"
#include "model/simulator/lidar_truth.h"
#include "model/simulator/sensor_models.h"
#include "model/simulator/simulation_options.h"

namespace remount::simulator {

/// Where the sensors are, and their errors. Vehicle frame: middle of the rear axle on the ground, x forward, y left,
/// z up; of an excavator its upper body's frame, see slew_yard.h.
struct SensorTruth {
  RigidTransform vehicle_from_ins = RigidTransform::Identity();
  RigidTransform ins_from_imu = RigidTransform::Identity();
  Eigen::Vector3d antenna_in_ins_m = Eigen::Vector3d::Zero();
  double track_m = 0.0;  ///< between the rear wheels
  ImuErrors imu_at_start, imu_at_end;
  std::vector<std::int64_t> gnss_outlier_stamps_ns;  ///< fixes that are grossly wrong
  LidarTruth lidar;
};

/// A simulated drive. The session's scans are ray-cast when they are loaded, so a long drive needs no memory.
struct SimulatedDrive {
  drive::Session session;                                      ///< as a reader would deliver it; declares its INS noise
  RigidTransform ins_from_lidar = RigidTransform::Identity();  ///< the truth
  SensorTruth sensors;
  std::vector<motion::StampedPose> enu_from_ins;  ///< true poses at the scans' stamps, on the INS clock
};

/// Throws Error(Contract) where an option is out of range.
SimulatedDrive simulate_drive(const SimulationOptions& options);

/// What each LiDAR of a vehicle recorded on one drive: a session each, with the same world, INS and other sensors.
struct SimulatedVehicle {
  std::vector<SimulatedDrive> lidars;  ///< in the order of their mounts; names are in session.lidar_name
};

/// Several LiDARs on one vehicle. Those of the options that describe a LiDAR are of none of them. Throws
/// Error(Contract) where an option is out of range, and for names that are none.
SimulatedVehicle simulate_vehicle(const SimulationOptions& options, const std::vector<LidarMount>& mounts);

/// The formats that drives are written in: ids of session readers, "rosbag1" and "mcap"; native first.
const std::vector<std::string>& drive_formats();

/// Writes the drive as a session folder in one of those formats (see peer_formats.h and bag_drive.h for what they leave
/// out). Also writes truth.yaml, of which `ins_from_lidar` is in the axes that the format's INS has. Deterministic for
/// any number of threads. The folder is made; an existing one that is not empty is an Error. KITTI's LiDAR turns
/// counter-clockwise while the vehicle moves, and its files have no place to say otherwise: a drive with another sense,
/// of a LiDAR that does not spin, or without motion distortion, is Error(Contract) for "kitti-raw".
void write_drive(const SimulatedDrive& drive, const std::filesystem::path& folder, const std::string& format,
                 int threads, Progress& progress);

/// The formats that vehicles with several LiDARs are written in.
const std::vector<std::string>& vehicle_formats();

/// As write_drive, with all LiDARs in one recording: a native session declares them under `lidars`, a bag has a topic
/// for each, "/lidar_NAME/points". truth.yaml has the truth of each under `lidars`. Other formats have room for one
/// LiDAR: Error(Contract).
void write_vehicle(const SimulatedVehicle& vehicle, const std::filesystem::path& folder, const std::string& format,
                   int threads, Progress& progress);

}  // namespace remount::simulator
