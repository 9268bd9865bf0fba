#include "model/simulator/peer_formats.h"

#include <GeographicLib/Geocentric.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "algorithms/core/error.h"
#include "algorithms/core/parallel.h"
#include "algorithms/core/stamps.h"
#include "messages/simulation.h"
#include "model/drive/session_frames.h"
#include "model/formats/clouds/cloud_file.h"
#include "model/formats/files/number_text.h"
#include "model/formats/files/output_file.h"
#include "model/formats/files/time_stamp.h"
#include "model/formats/sessions/native_session_writer.h"
#include "model/simulator/drive_formats.h"
#include "model/simulator/lidar_model.h"
#include "model/simulator/local_earth.h"

namespace remount::simulator {

namespace fs = std::filesystem;

namespace {

/// "2011-09-26 13:02:25.964389445" as OpenCalib writes it, "2011-09-26-13-02-25-964".
std::string name_from_stamp(std::int64_t stamp_ns) {
  if (stamp_ns % 1'000'000 != 0) throw Error(ErrorCode::Contract, "opencalib", say::simulation_opencalib_stamps());
  std::string text = formats::format_date_ns(stamp_ns).substr(0, 23);
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == ' ' || c == ':' || c == '.'; }, '-');
  return text;
}

/// A keyword, the time in seconds, numbers.
std::string smartloc_line(const char* keyword, std::int64_t time_ns, std::initializer_list<double> values) {
  char head[48];
  std::snprintf(head, sizeof head, "%s %lld.%09lld", keyword, static_cast<long long>(time_ns / 1'000'000'000),
                static_cast<long long>(time_ns % 1'000'000'000));
  std::string line = head;
  for (const double value : values) (line += ' ') += formats::exact_text(value);
  return line + '\n';
}

/// Linear between the samples about a stamp; held beyond them.
Eigen::Vector3d rate_at(const std::vector<motion::ImuSample>& imu, std::int64_t stamp_ns) {
  const auto after =
      std::lower_bound(imu.begin(), imu.end(), stamp_ns,
                       [](const motion::ImuSample& sample, std::int64_t stamp) { return sample.stamp_ns < stamp; });
  if (after == imu.end()) return imu.back().angular_rate_radps;
  if (after == imu.begin() || after->stamp_ns == stamp_ns) return after->angular_rate_radps;
  const auto before = after - 1;
  const double share =
      static_cast<double>(stamp_ns - before->stamp_ns) / static_cast<double>(after->stamp_ns - before->stamp_ns);
  return (1.0 - share) * before->angular_rate_radps + share * after->angular_rate_radps;
}

Eigen::Vector3d earth_from(const EarthPlace& place) {
  Eigen::Vector3d point;
  GeographicLib::Geocentric::WGS84().Forward(radians_to_degrees(place.latitude_rad),
                                             radians_to_degrees(place.longitude_rad), place.height_m, point.x(),
                                             point.y(), point.z());
  return point;
}

}  // namespace

void write_opencalib_drive(const SimulatedDrive& drive, const fs::path& folder, int threads, Progress& progress) {
  const drive::Session& session = drive.session;
  std::string lines;
  for (const motion::StampedPose& pose : drive::metric_poses(session)) {
    lines += name_from_stamp(pose.stamp_ns);
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 4; ++column) (lines += ' ') += formats::exact_text(pose.pose(row, column));
    lines += '\n';
  }
  const fs::path scans = folder / "top_lidar";
  std::vector<fs::path> files;
  for (std::size_t i = 0; i < session.scans->size(); ++i)
    files.push_back(scans / (name_from_stamp(session.scans->stamp_ns(i)) + ".pcd"));
  formats::make_directories(scans);
  parallel_for(files.size(), threads, [&](std::size_t i) {
    if (progress.cancelled()) return;
    formats::write_pcd(files[i], session.scans->load(i));
  });
  if (!progress.cancelled()) formats::write_file(folder / "novatel-pose.txt", lines);
}

void write_pose_drive(const SimulatedDrive& drive, const fs::path& folder, int, Progress&) {
  formats::write_file(folder / "ins.txt", formats::tum_text(drive::metric_poses(drive.session)));
  formats::write_file(folder / "lidar.txt", formats::tum_text(exact_odometry(drive)));
}

void write_smartloc_drive(const SimulatedDrive& drive, const fs::path& folder, int, Progress&) {
  const drive::Session& session = drive.session;
  const Scene* scene = scene_of(session.scans);
  if (!scene || session.wheels.empty() || session.imu.empty())
    throw Error(ErrorCode::Contract, "smartloc", say::simulation_smartloc_without_sensors());
  const SimulationOptions& options = scene->options();
  const Eigen::Matrix3d vehicle_from_imu = (drive.sensors.vehicle_from_ins * drive.sensors.ins_from_imu).linear();
  constexpr double kSideways2 = 9e-4;  // (m/s)^2; as the data set has it for a car
  const double slip2 = std::pow(options.wheels.slip, 2) + std::pow(options.wheels.lasting_slip, 2);
  const double rate2 = std::pow(degrees_to_radians(options.imu.gyro_noise_dps), 2);
  const LocalEarth earth(options);
  const std::int64_t first_ns = session.wheels.front().stamp_ns;
  std::string input, truth;
  for (const motion::WheelSample& wheels : session.wheels) {
    const double speed_mps = 0.5 * (wheels.rear_left_mps + wheels.rear_right_mps);
    const Eigen::Vector3d rate = vehicle_from_imu * rate_at(session.imu, wheels.stamp_ns);
    const double speed2 = 0.5 * (slip2 * speed_mps * speed_mps + std::pow(options.wheels.noise_mps, 2));
    input += smartloc_line(
        "odom3", wheels.stamp_ns - first_ns,
        {speed_mps, 0.0, 0.0, rate.x(), rate.y(), rate.z(), speed2, kSideways2, kSideways2, rate2, rate2, rate2});
    const double time_s = seconds(wheels.stamp_ns - kDriveStart_ns);
    const Eigen::Vector3d antenna = earth_from(earth.at(scene->enu_from_ins(time_s) * drive.sensors.antenna_in_ins_m));
    truth += smartloc_line("point3", wheels.stamp_ns - first_ns,
                           {antenna.x(), antenna.y(), antenna.z(), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0});
  }
  formats::write_file(folder / (session.name + "_Input.txt"), input);
  formats::write_file(folder / (session.name + "_GT.txt"), truth);
}

}  // namespace remount::simulator
