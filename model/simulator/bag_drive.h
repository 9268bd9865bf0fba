// Simulated drives as bags of ROS, and as records of Apollo's Cyber.
#pragma once

#include "model/simulator/captured_sensor.h"
#include "model/simulator/simulator.h"

namespace remount::simulator {

/// Writes drive.bag ("rosbag1"), drive.db3 ("rosbag2") or drive.mcap ("mcap" and "mcap-novatel", in CDR) into `folder`,
/// which is there and empty: scans as /lidar/points, the INS as /ins/imu (orientation) with /ins/fix, or as
/// novatel_oem7_driver publishes INSPVA, and INSSTDEV once a second; the IMU as /imu/data and the GNSS receiver as
/// /gnss/fix; wheels and barometer are left out. Deterministic for any number of threads. Distorted scans
/// without the time of each point are Error(Contract). Returns early, without the file, where `progress` is cancelled.
/// As "apollo-record" it is drive.record.00000: scans as /apollo/sensor/lidar/PointCloud2, the INS as Gps and InsStat,
/// the receiver as GnssBestPose, the nominal in /tf_static; the IMU is left out. A drive without INS is
/// Error(Contract).
void write_bag_drive(const SimulatedDrive& drive, const std::filesystem::path& folder, const std::string& format,
                     int threads, Progress& progress);

/// As write_bag_drive into "rosbag1", "rosbag2" or "mcap", with the packets of a sensor that stands in the LiDAR's
/// place as its driver publishes them: a VelodyneScan a turn (/velodyne_packets), a PacketMsg a packet
/// (/ouster/lidar_packets, with /ouster/metadata), a UdpFrame a turn (/lidar_packets, with /lidar_corrections), an
/// RslidarPacket for each that the sensor sends (/rslidar_packets). Throws as scene_without_lidar does.
void write_packet_bag(const CapturedSensor& sensor, const SimulatedDrive& drive, const std::filesystem::path& folder,
                      const std::string& format, int threads, Progress& progress);

/// As write_bag_drive, with the scans of each LiDAR as /lidar_NAME/points, or /apollo/sensor/NAME/PointCloud2, in the
/// frame NAME.
void write_bag_vehicle(const SimulatedVehicle& vehicle, const std::filesystem::path& folder, const std::string& format,
                       int threads, Progress& progress);

}  // namespace remount::simulator
