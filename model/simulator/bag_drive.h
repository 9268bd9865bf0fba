// Simulated drives as bags of ROS.
#pragma once

#include "model/simulator/simulator.h"

namespace remount::simulator {

/// Writes drive.bag ("rosbag1"), drive.db3 ("rosbag2") or drive.mcap ("mcap" and "mcap-novatel", in CDR) into `folder`,
/// which is there and empty: scans as /lidar/points, the INS as /ins/imu (orientation) with /ins/fix, or as
/// novatel_oem7_driver publishes INSPVA, and INSSTDEV once a second; the IMU as /imu/data and the GNSS receiver as
/// /gnss/fix; wheels and barometer are left out. Deterministic for any number of threads. Distorted scans
/// without the time of each point are Error(Contract). Returns early, without the file, where `progress` is cancelled.
void write_bag_drive(const SimulatedDrive& drive, const std::filesystem::path& folder, const std::string& format,
                     int threads, Progress& progress);

/// As write_bag_drive, with the scans of each LiDAR as /lidar_NAME/points in the frame NAME.
void write_bag_vehicle(const SimulatedVehicle& vehicle, const std::filesystem::path& folder, const std::string& format,
                       int threads, Progress& progress);

}  // namespace remount::simulator
