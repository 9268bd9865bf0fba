#include "model/simulator/drive_formats.h"

#include "algorithms/core/error.h"
#include "messages/simulation.h"
#include "model/formats/sessions/native_session_writer.h"
#include "model/simulator/bag_drive.h"
#include "model/simulator/captured_sensor.h"
#include "model/simulator/lidar_model.h"
#include "model/simulator/novatel_drive.h"
#include "model/simulator/peer_formats.h"
#include "model/simulator/sbet_drive.h"
#include "model/simulator/sbf_drive.h"

namespace remount::simulator {

namespace fs = std::filesystem;

namespace {

/// What readers of KITTI take for granted; they tell from the scans which way the sensor turns.
void check_fits_kitti(const SimulatedDrive& drive) {
  if (drive.session.scan_timing == drive::ScanTiming::Instant)
    throw Error(ErrorCode::Contract, "kitti-raw", say::simulation_kitti_not_distorted());
  if (const SimulationOptions* options = lidar_options_of(drive.session.scans);
      options && !lidar_model(options->lidar.model).spins)
    throw Error(ErrorCode::Contract, "kitti-raw", say::simulation_kitti_not_spinning());
}

/// Of formats whose publishers compensate their scans.
void check_is_compensated(const SimulatedDrive& drive) {
  if (drive.session.scan_timing != drive::ScanTiming::Instant)
    throw Error(ErrorCode::Contract, drive.session.name, say::simulation_not_compensated());
}

void write_native(const SimulatedDrive& drive, const fs::path& folder, int threads, Progress& progress) {
  formats::write_native_session(drive.session, folder, threads, progress);
}
void write_native_las(const SimulatedDrive& drive, const fs::path& folder, int threads, Progress& progress) {
  formats::write_native_session(drive.session, folder, threads, progress, formats::CloudFormat::Las);
}
void write_native_text(const SimulatedDrive& drive, const fs::path& folder, int threads, Progress& progress) {
  formats::write_native_session(drive.session, folder, threads, progress, formats::CloudFormat::Text);
}
void write_kitti(const SimulatedDrive& drive, const fs::path& folder, int threads, Progress& progress) {
  formats::write_kitti_raw_session(drive.session, folder, threads, progress);
}
constexpr char kRosbag1[] = "rosbag1", kRosbag2[] = "rosbag2", kMcap[] = "mcap", kMcapNovatel[] = "mcap-novatel",
               kApolloRecord[] = "apollo-record";
template <const char* id>
void write_bag(const SimulatedDrive& drive, const fs::path& folder, int threads, Progress& progress) {
  write_bag_drive(drive, folder, id, threads, progress);
}
template <const char* id>
void write_bag_of_vehicle(const SimulatedVehicle& vehicle, const fs::path& folder, int threads, Progress& progress) {
  write_bag_vehicle(vehicle, folder, id, threads, progress);
}

template <const CapturedSensor& sensor, const char* id>
void write_packets(const SimulatedDrive& drive, const fs::path& folder, int threads, Progress& progress) {
  write_packet_bag(sensor, drive, folder, id, threads, progress);
}

template <const CapturedSensor& sensor>
void write_sensor(const SimulatedDrive& drive, const fs::path& folder, int threads, Progress& progress) {
  write_capture(sensor, drive, folder, threads, progress);
}

template <formats::CloudFormat scans>
void write_native_vehicle(const SimulatedVehicle& vehicle, const fs::path& folder, int threads, Progress& progress) {
  std::vector<const drive::Session*> lidars;
  for (const SimulatedDrive& drive : vehicle.lidars) lidars.push_back(&drive.session);
  formats::write_native_session(lidars, folder, threads, progress, scans);
}

}  // namespace

const std::vector<DriveFormat>& drive_format_list() {
  constexpr drive::InsAxes kOwnAxes = drive::InsAxes::ForwardLeftUp, kRightForwardUp = drive::InsAxes::RightForwardUp;
  static const std::vector<DriveFormat> formats{
      {"native", "native", write_native, OtherTruth::Sensors, kOwnAxes, nullptr,
       write_native_vehicle<formats::CloudFormat::Pcd>},
      {"native-las", "native", write_native_las, OtherTruth::Sensors, kOwnAxes, nullptr,
       write_native_vehicle<formats::CloudFormat::Las>},
      {"native-text", "native", write_native_text, OtherTruth::Sensors, kOwnAxes, nullptr,
       write_native_vehicle<formats::CloudFormat::Text>},
      {"kitti-raw", "kitti-raw", write_kitti, OtherTruth::None, kOwnAxes, check_fits_kitti},
      {"kitti-odometry", "kitti-odometry", write_kitti_odometry_drive, OtherTruth::None, kOwnAxes,
       check_is_compensated},
      {"nuscenes", "nuscenes", write_nuscenes_drive, OtherTruth::None, kOwnAxes, check_is_compensated},
      {"opencalib", "opencalib", write_opencalib_drive},
      {"novatel-inspvax", "novatel", write_novatel_drive, OtherTruth::None, kRightForwardUp},
      {"novatel-ascii", "novatel", write_novatel_ascii_drive, OtherTruth::None, kRightForwardUp},
      {"novatel-binary", "novatel", write_novatel_binary_drive, OtherTruth::None, kRightForwardUp},
      {"sbet", "ins-log", write_sbet_drive},
      {"sbf", "ins-log", write_sbf_drive},
      {"poses", "poses", write_pose_drive},
      {"apollo-csv", "poses", write_apollo_drive, OtherTruth::None, kRightForwardUp},
      {"nmea", "gnss-log", write_nmea_drive},
      {"gpx", "gnss-log", write_gpx_drive, OtherTruth::AntennaInLidar},
      {"smartloc", "smartloc", write_smartloc_drive, OtherTruth::AntennaInVehicle},
      {"rosbag1", "ros-bag", write_bag<kRosbag1>, OtherTruth::None, kOwnAxes, nullptr, write_bag_of_vehicle<kRosbag1>},
      {"rosbag2", "ros-bag", write_bag<kRosbag2>, OtherTruth::None, kOwnAxes, nullptr, write_bag_of_vehicle<kRosbag2>},
      {"mcap", "ros-bag", write_bag<kMcap>, OtherTruth::None, kOwnAxes, nullptr, write_bag_of_vehicle<kMcap>},
      {"mcap-novatel", "ros-bag", write_bag<kMcapNovatel>, OtherTruth::None, kRightForwardUp, nullptr,
       write_bag_of_vehicle<kMcapNovatel>},
      {"apollo-record", "apollo-record", write_bag<kApolloRecord>, OtherTruth::None, kRightForwardUp, nullptr,
       write_bag_of_vehicle<kApolloRecord>},
      {"rosbag1-velodyne", "ros-bag", write_packets<kPuck, kRosbag1>},
      {"mcap-ouster", "ros-bag", write_packets<kOusterHead, kMcap>},
      {"rosbag2-hesai", "ros-bag", write_packets<kHesaiSpinner, kRosbag2>},
      {"mcap-robosense", "ros-bag", write_packets<kHelios, kMcap>},
      {"velodyne", "lidar-capture", write_sensor<kPuck>},
      {"velodyne-hdl64", "lidar-capture", write_sensor<kHdl64>},
      {"ouster", "lidar-capture", write_sensor<kOusterHead>},
      {"hesai", "lidar-capture", write_sensor<kHesaiSpinner>},
      {"livox", "lidar-capture", write_livox_drive},
      {"lvx", "lidar-capture", write_lvx_drive},
      {"lvx2", "lidar-capture", write_lvx2_drive},
      {"robosense", "lidar-capture", write_sensor<kHelios>},
      {"robosense-m1", "lidar-capture", write_m1_drive}};
  return formats;
}

std::vector<motion::StampedPose> exact_odometry(const SimulatedDrive& drive) {
  std::vector<motion::StampedPose> poses;
  const RigidTransform start_from_enu = (drive.enu_from_ins.front().pose * drive.ins_from_lidar).inverse();
  for (std::size_t scan = 0; scan < drive.enu_from_ins.size(); ++scan)
    poses.push_back(
        {drive.session.scans->stamp_ns(scan), start_from_enu * drive.enu_from_ins[scan].pose * drive.ins_from_lidar});
  return poses;
}

}  // namespace remount::simulator
