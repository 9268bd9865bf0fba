// The formats in which simulated drives are written: the list, and a function each.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "model/simulator/simulator.h"

namespace remount::simulator {

/// What is true of a drive beside `ins_from_lidar`, as far as its format speaks of such things.
enum class OtherTruth { None, Sensors, AntennaInVehicle, AntennaInLidar };

struct DriveFormat {
  std::string_view id;      ///< as drives are asked for
  std::string_view reader;  ///< id of the session reader that reads it
  /// Writes the files into `folder`, which is there and empty. What the format has no place for is left out. Returns
  /// early where `progress` is cancelled.
  void (*write)(const SimulatedDrive& drive, const std::filesystem::path& folder, int threads, Progress& progress);
  OtherTruth other_truth = OtherTruth::None;
  drive::InsAxes ins_axes = drive::InsAxes::ForwardLeftUp;  ///< of the files, and so of the truth
  /// Throws Error(Contract) for a drive that cannot be written, before anything is; null: `write` refuses.
  void (*check)(const SimulatedDrive& drive) = nullptr;
  /// Writes all LiDARs of a vehicle in the same manner; null: the format has room for one.
  void (*write_vehicle)(const SimulatedVehicle& vehicle, const std::filesystem::path& folder, int threads,
                        Progress& progress) = nullptr;
};

/// In the order in which they are listed; native first.
const std::vector<DriveFormat>& drive_format_list();

/// An NMEA log as an INS with a GNSS receiver writes it (ZDA once; GGA, GST where errors are known and PASHR of every
/// sample), and the LiDAR's poses. Angles to 1e-9 degrees, heights to 0.1 mm.
void write_nmea_drive(const SimulatedDrive& drive, const std::filesystem::path& folder, int threads,
                      Progress& progress);

/// A GPX track of the GNSS antenna's fixes, and the LiDAR's poses. There is no place for errors and for an INS: a drive
/// without fixes is Error(Contract).
void write_gpx_drive(const SimulatedDrive& drive, const std::filesystem::path& folder, int threads, Progress& progress);

/// The INS as Apollo's odometry CSV: UTM positions in the zone of the first sample, attitudes relative to true north of
/// axes right-forward-up; and the LiDAR's poses.
void write_apollo_drive(const SimulatedDrive& drive, const std::filesystem::path& folder, int threads,
                        Progress& progress);

/// Writes the NMEA log of the drive's receiver without anything else, to lie beside the files of a sensor. False where
/// `progress` is cancelled: nothing is written then.
bool write_receiver_log(const SimulatedDrive& drive, const std::filesystem::path& folder, Progress& progress);
/// The position of a sample as a receiver tells it to sensors that hang on it: RMC.
std::string nmea_minimum(const motion::InsSample& sample);

/// What a Livox sends, and the NMEA log as above: a capture of the packets of the second SDK, or a recording of Livox
/// Viewer of version 1.1 or 2. The sensor is the drive's LiDAR where that is a Livox, else a Mid-360 in its place, with
/// the points of its data sheet, and follows the receiver's clock. A drive that is not simulated, or without motion
/// distortion, is Error(Contract).
void write_livox_drive(const SimulatedDrive& drive, const std::filesystem::path& folder, int threads,
                       Progress& progress);
void write_lvx_drive(const SimulatedDrive& drive, const std::filesystem::path& folder, int threads, Progress& progress);
void write_lvx2_drive(const SimulatedDrive& drive, const std::filesystem::path& folder, int threads,
                      Progress& progress);

/// A capture of the packets of an RS-LiDAR-M1, as of write_livox_drive.
void write_m1_drive(const SimulatedDrive& drive, const std::filesystem::path& folder, int threads, Progress& progress);

/// KITTI's odometry layout, `sequences/00` and `poses/00.txt`: the true poses of the INS at the scans' times, in axes
/// of a camera that stands in its place; times count from the first scan. Tr is the nominal, where the drive has one.
/// The layout's scans are compensated.
void write_kitti_odometry_drive(const SimulatedDrive& drive, const std::filesystem::path& folder, int threads,
                                Progress& progress);

/// nuScenes' layout with one scene: the true poses of the INS at the scans' times, and as calibrated_sensor the nominal
/// or, as data sets know it, the true mounting. Stamps are of microseconds; scans are compensated.
void write_nuscenes_drive(const SimulatedDrive& drive, const std::filesystem::path& folder, int threads,
                          Progress& progress);

/// The LiDAR in the frame of its first scan, exact, stamped on its own clock.
std::vector<motion::StampedPose> exact_odometry(const SimulatedDrive& drive);

}  // namespace remount::simulator
