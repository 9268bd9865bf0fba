#include "model/formats/sessions/native_session_writer.h"

#include <atomic>
#include <cmath>
#include <set>

#include "algorithms/core/error.h"
#include "algorithms/core/index.h"
#include "algorithms/core/parallel.h"
#include "messages/sessions.h"
#include "messages/stages.h"
#include "model/drive/attitude_convention.h"
#include "model/drive/lidar_offer.h"
#include "model/formats/documents/document.h"
#include "model/formats/files/number_text.h"
#include "model/formats/files/numbered_file.h"
#include "model/formats/files/output_file.h"
#include "model/formats/files/time_stamp.h"
#include "model/formats/ins/ins_table.h"
#include "model/formats/ins/sensor_tables.h"

namespace remount::formats {

namespace fs = std::filesystem;

namespace {

bool has_ins(const drive::Session& session) { return !session.ins.empty() || !session.world_from_ins.empty(); }
bool has_lidar(const drive::Session& session) { return session.scans || !session.odometry_from_lidar.empty(); }
bool has_sensors(const drive::Session& session) {
  return !session.imu.empty() || !session.gnss.empty() || !session.wheels.empty() || !session.barometer.empty();
}

void check_writable(const drive::Session& session) {
  if (has_sensors(session)) return;
  if (!has_ins(session)) throw Error(ErrorCode::Contract, session.name, say::native_no_ins());
  if (!has_lidar(session)) throw Error(ErrorCode::Contract, session.name, say::native_no_lidar());
}

drive::AttitudeConvention convention_of(const drive::Session& session) {
  return session.ins_axes == drive::InsAxes::RightForwardUp ? drive::AttitudeConvention::NovAtel
                                                            : drive::AttitudeConvention::EnuYaw;
}

bool declares_sigma(const std::vector<motion::InsSample>& ins) {
  return std::any_of(ins.begin(), ins.end(), [](const motion::InsSample& sample) {
    return sample.sigma.position_enu_m.array().isFinite().any() || sample.sigma.attitude_rad.array().isFinite().any();
  });
}

std::string ins_csv(const drive::Session& session) {
  const drive::AttitudeConvention convention = convention_of(session);
  const bool sigma = declares_sigma(session.ins);
  std::string text = "time_ns,latitude_deg,longitude_deg,height_m,yaw_deg,pitch_deg,roll_deg,quality";
  if (sigma) text += ",sigma_east_m,sigma_north_m,sigma_up_m,sigma_yaw_deg,sigma_pitch_deg,sigma_roll_deg";
  text += "\n";
  for (const motion::InsSample& sample : session.ins) {
    const drive::AttitudeAngles angles = drive::angles_from(sample.enu_from_ins, convention);
    text += std::to_string(sample.stamp_ns);
    for (const double value : {radians_to_degrees(sample.latitude_rad), radians_to_degrees(sample.longitude_rad),
                               sample.height_m, radians_to_degrees(angles.yaw_rad),
                               radians_to_degrees(angles.pitch_rad), radians_to_degrees(angles.roll_rad)})
      text += "," + exact_text(value);
    text += "," + std::string(to_string(sample.quality));
    if (sigma) {
      const Eigen::Vector3d& axes = sample.sigma.attitude_rad;
      const bool right_forward = convention == drive::AttitudeConvention::NovAtel;
      for (int axis = 0; axis < 3; ++axis) text += "," + exact_text(sample.sigma.position_enu_m[axis]);
      for (const double value : {axes.z(), right_forward ? axes.x() : axes.y(), right_forward ? axes.y() : axes.x()})
        text += "," + exact_text(radians_to_degrees(value));
    }
    text += "\n";
  }
  return text;
}

/// Poses with the numbers of a grid were read as such, and their distances may have been divided by its scale already:
/// from an origin near the drive nobody does so again.
std::vector<motion::StampedPose> near_origin(std::vector<motion::StampedPose> poses) {
  constexpr double kNear_m = 1e4;
  if (poses.empty() || poses.front().pose.translation().head<2>().norm() < kNear_m) return poses;
  const Eigen::Vector3d at_m = poses.front().pose.translation();
  const Eigen::Vector3d origin_m(std::floor(at_m.x()), std::floor(at_m.y()), 0.0);
  for (motion::StampedPose& pose : poses) pose.pose.translation() -= origin_m;
  return poses;
}

std::string name_line(const drive::Session& session) {
  DocumentNode root = DocumentNode::map();
  root.add("name", DocumentNode::string(session.name));
  return to_yaml(root);
}

std::string ins_section(const drive::Session& session) {
  if (!has_ins(session)) return "";
  if (session.ins.empty()) return "ins_poses:\n  file: ins_poses.txt\n  format: tum\n";
  std::string text =
      "ins:\n  file: ins.csv\n  columns:\n    time: {name: time_ns, unit: ns, scale: unix}\n"
      "    latitude: {name: latitude_deg, unit: deg}\n    longitude: {name: longitude_deg, unit: deg}\n"
      "    height: {name: height_m, unit: m}\n    attitude: {convention: " +
      std::string(to_string(convention_of(session))) +
      ", unit: deg, yaw: yaw_deg, pitch: pitch_deg, roll: roll_deg}\n    quality: quality\n";
  if (declares_sigma(session.ins))
    text +=
        "    position_sigma_m: {east: sigma_east_m, north: sigma_north_m, up: sigma_up_m}\n"
        "    attitude_sigma: {yaw: sigma_yaw_deg, pitch: sigma_pitch_deg, roll: sigma_roll_deg}\n";
  return text;
}

/// Where a LiDAR stands in the folder and in the manifest: by itself, or as one of several.
struct LidarPlace {
  std::string below;   ///< "front/", before the names of its files
  std::string indent;  ///< of its keys
};

/// As `type` has it in the manifest.
std::string type_name(CloudFormat scans) {
  return scans == CloudFormat::Las ? "las" : scans == CloudFormat::Text ? "text" : "pcd";
}

std::string scans_section(const drive::Session& session, CloudFormat scans, const LidarPlace& place) {
  if (!has_lidar(session)) return "";
  const std::string& in = place.indent;
  if (!session.scans)
    return in + "lidar_poses:\n" + in + "  file: " + place.below + "lidar_poses.txt\n" + in + "  format: tum\n";
  const std::string text = in + "scans:\n" + in + "  directory: " + place.below + "scans\n" + in +
                           "  type: " + type_name(scans) + "\n" + in + "  stamps: " + place.below +
                           "scan_stamps.csv\n" + in + "  timing: ";
  if (session.scan_timing == drive::ScanTiming::Instant) return text + "instant\n";
  if (session.scan_timing == drive::ScanTiming::PerPoint) return text + "per-point\n";
  if (session.scan_timing == drive::ScanTiming::Unknown) return text + "unknown\n";
  const drive::SweepModel& sweep = session.sweep;
  const auto yes_no = [](bool value) { return value ? "true" : "false"; };
  return text + "sweep\n" + in + "  sweep: {period_s: " + exact_text(sweep.period_s) +
         ", stamp_azimuth_deg: " + exact_text(radians_to_degrees(sweep.stamp_azimuth_rad)) +
         ", clockwise: " + yes_no(sweep.clockwise) + ", certain: " + yes_no(sweep.certain) +
         (sweep.direction_known ? "" : ", direction_certain: false") + "}\n";
}

std::string noise_section(const drive::Session& session) {
  std::string noise;
  const auto add = [&](const char* key, double value) {
    if (std::isfinite(value)) noise += std::string("  ") + key + ": " + exact_text(value) + "\n";
  };
  add("position_sigma_m", session.ins_position_white_sigma_m);
  add("attitude_sigma_deg", radians_to_degrees(session.ins_attitude_white_sigma_rad));
  add("attitude_bias_sigma_deg", radians_to_degrees(session.ins_attitude_bias_sigma_rad));
  add("position_drift_m", session.ins_position_drift);
  add("attitude_drift_deg", radians_to_degrees(session.ins_attitude_drift));
  return noise.empty() ? "" : "ins_noise:\n" + noise;
}

std::string kind_section(const drive::Session& session) {
  if (session.lidar == cloud::LidarKind::Unknown) return "";
  return "lidar: " + std::string(cloud::kDeclaredLidars.at(index_of(session.lidar))) + "\n";
}

std::string nominal_section(const drive::Session& session) {
  if (!session.nominal_ins_from_lidar) return "";
  const SixParameters six = six_from_rigid(*session.nominal_ins_from_lidar);
  return "nominal: {x_m: " + exact_text(six.x_m) + ", y_m: " + exact_text(six.y_m) + ", z_m: " + exact_text(six.z_m) +
         ", yaw_deg: " + exact_text(radians_to_degrees(six.yaw_rad)) +
         ", pitch_deg: " + exact_text(radians_to_degrees(six.pitch_rad)) +
         ", roll_deg: " + exact_text(radians_to_degrees(six.roll_rad)) + "}\n";
}

/// Everything of a LiDAR that is one of several. Names that begin with a dash would be items of a list.
std::string lidar_section(const drive::Session& session, CloudFormat scans) {
  const std::string& name = session.lidar_name;
  const std::string in = "    ", kind = kind_section(session), nominal = nominal_section(session);
  return "  " + (name.starts_with('-') ? "'" + name + "'" : name) + ":\n" +
         scans_section(session, scans, {name + "/", in}) + (kind.empty() ? "" : in + kind) +
         (nominal.empty() ? "" : in + nominal);
}

/// Writes the files of the other sensors and returns what the manifest says of them.
std::string write_sensors(const drive::Session& session, const fs::path& folder) {
  std::string sections;
  const auto write = [&](const std::string& key, const auto& samples, auto&& table) {
    if (samples.empty()) return;
    write_file(folder / (key + ".csv"), table(samples));
    sections += key + ":\n  file: " + key + ".csv\n";
  };
  write("imu", session.imu, imu_table);
  write("gnss", session.gnss, gnss_table);
  write("wheels", session.wheels, wheel_table);
  write("barometer", session.barometer, barometer_table);
  return sections;
}

/// Loads and writes scan after scan; `write(scan, cloud)` stores one. False where cancelled.
template <class Write>
bool write_scans(const drive::ScanSource& scans, int threads, Progress& progress, Write&& write) {
  std::atomic<std::size_t> done{0};
  parallel_for(scans.size(), threads, [&](std::size_t i) {
    if (progress.cancelled()) return;
    write(i, scans.load(i));
    progress.report(say::stage_writing_scans, ++done, scans.size());
  });
  return !progress.cancelled();
}

std::string scan_name(std::size_t scan, const char* extension) {
  return numbered_file({}, scan, 10, extension).string();
}

std::string oxts_line(const motion::InsSample& sample) {
  const drive::AttitudeAngles angles = drive::angles_from(sample.enu_from_ins, drive::AttitudeConvention::EnuYaw);
  std::string text;
  for (const double value : {radians_to_degrees(sample.latitude_rad), radians_to_degrees(sample.longitude_rad),
                             sample.height_m, angles.roll_rad, angles.pitch_rad, angles.yaw_rad})
    text += exact_text(value) + " ";
  for (int unused = 6; unused < 23; ++unused) text += "0 ";
  const double accuracy_m = sample.sigma.position_enu_m.maxCoeff();
  return text + (std::isfinite(accuracy_m) ? exact_text(accuracy_m) : "0") + " 0 4 10 4 4 4\n";
}

bool stamps_agree(const drive::Session& session) {
  if (session.ins.size() != session.scans->size()) return false;
  for (std::size_t i = 0; i < session.ins.size(); ++i)
    if (session.ins[i].stamp_ns != session.scans->stamp_ns(i)) return false;
  return true;
}

}  // namespace

std::string tum_text(const std::vector<motion::StampedPose>& poses) {
  std::string text;
  for (const motion::StampedPose& pose : poses) {
    const Eigen::Quaterniond rotation(pose.pose.linear());
    const Eigen::Vector3d position = pose.pose.translation();
    char stamp[40];
    const std::int64_t magnitude = std::abs(pose.stamp_ns);
    std::snprintf(stamp, sizeof stamp, "%s%lld.%09lld", pose.stamp_ns < 0 ? "-" : "",
                  static_cast<long long>(magnitude / 1'000'000'000), static_cast<long long>(magnitude % 1'000'000'000));
    text += stamp;
    for (const double value :
         {position.x(), position.y(), position.z(), rotation.x(), rotation.y(), rotation.z(), rotation.w()})
      text += " " + exact_text(value);
    text += "\n";
  }
  return text;
}

namespace {

/// Scans with their stamps, or poses. False where cancelled.
bool write_lidar(const drive::Session& session, const fs::path& folder, int threads, Progress& progress,
                 CloudFormat scans) {
  if (!session.scans) {
    if (has_lidar(session)) write_file(folder / "lidar_poses.txt", tum_text(session.odometry_from_lidar));
    return true;
  }
  const bool las = scans == CloudFormat::Las, text = scans == CloudFormat::Text;
  const char* const extension = las ? ".las" : text ? ".csv" : ".pcd";
  const fs::path directory = folder / "scans";
  make_directories(directory);
  std::string stamps = "file,stamp_ns\n";
  for (std::size_t i = 0; i < session.scans->size(); ++i)
    stamps += scan_name(i, extension) + "," + std::to_string(session.scans->stamp_ns(i)) + "\n";
  const auto write = [&](std::size_t i, const cloud::PointCloud& cloud) {
    if (las)
      write_las(directory / scan_name(i, extension), cloud, session.scans->stamp_ns(i));
    else if (text)
      write_text_cloud(directory / scan_name(i, extension), cloud);
    else
      write_pcd(directory / scan_name(i, extension), cloud);
  };
  if (!write_scans(*session.scans, threads, progress, write)) return false;
  write_file(folder / "scan_stamps.csv", stamps);
  return true;
}

void write_ins(const drive::Session& session, const fs::path& folder) {
  if (!session.ins.empty())
    write_file(folder / "ins.csv", ins_csv(session));
  else if (has_ins(session))
    write_file(folder / "ins_poses.txt", tum_text(near_origin(session.world_from_ins)));
}

void check_names(const std::vector<const drive::Session*>& lidars) {
  std::set<std::string> names;
  for (const drive::Session* session : lidars) {
    const std::string& name = session->lidar_name;
    if (!drive::can_name_lidar(name))
      throw Error(ErrorCode::Contract, session->name,
                  say::native_lidar_name(name.substr(0, 80), drive::kLongestLidarName));
    if (!names.insert(name).second) throw Error(ErrorCode::Contract, session->name, say::native_lidar_twice(name));
  }
  if (lidars.empty() || lidars.size() > drive::kMostLidars)
    throw Error(ErrorCode::Contract, "", say::native_lidars_count(drive::kMostLidars));
}

}  // namespace

void write_native_session(const drive::Session& session, const fs::path& folder, int threads, Progress& progress,
                          CloudFormat scans) {
  check_writable(session);
  make_directories(folder);
  if (!write_lidar(session, folder, threads, progress, scans)) return;
  write_ins(session, folder);
  const std::string sensors = write_sensors(session, folder);
  // Last: a folder without its manifest is not taken for a session.
  write_file(folder / "session.yaml", "format: remount-session/1\n" + name_line(session) +
                                          scans_section(session, scans, {}) + ins_section(session) + sensors +
                                          kind_section(session) + noise_section(session) + nominal_section(session));
}

void write_native_session(const std::vector<const drive::Session*>& lidars, const fs::path& folder, int threads,
                          Progress& progress, CloudFormat scans) {
  check_names(lidars);
  std::string sections = "lidars:\n";
  for (const drive::Session* session : lidars) {
    check_writable(*session);
    if (!has_lidar(*session)) throw Error(ErrorCode::Contract, session->lidar_name, say::native_no_lidar());
    sections += lidar_section(*session, scans);
  }
  make_directories(folder);
  for (const drive::Session* session : lidars) {
    make_directories(folder / session->lidar_name);
    if (!write_lidar(*session, folder / session->lidar_name, threads, progress, scans)) return;
  }
  const drive::Session& first = *lidars.front();
  write_ins(first, folder);
  const std::string sensors = write_sensors(first, folder);
  write_file(folder / "session.yaml", "format: remount-session/1\n" + name_line(first) + sections + ins_section(first) +
                                          sensors + noise_section(first));
}

void write_kitti_raw_session(const drive::Session& session, const fs::path& folder, int threads, Progress& progress) {
  check_writable(session);
  if (session.ins.empty() || !session.scans) throw Error(ErrorCode::Contract, session.name, say::kitti_needs());
  const std::string date = [&] {
    std::string day = format_date_ns(session.scans->stamp_ns(0)).substr(0, 10);
    std::replace(day.begin(), day.end(), '-', '_');
    return day;
  }();
  const fs::path drive = folder / date / (date + "_drive_0001_" + (stamps_agree(session) ? "sync" : "extract"));
  const fs::path oxts = drive / "oxts", velodyne = drive / "velodyne_points";
  make_directories(oxts / "data");
  make_directories(velodyne / "data");
  const auto write = [&](std::size_t i, const cloud::PointCloud& cloud) {
    write_kitti_bin(velodyne / "data" / scan_name(i, ".bin"), cloud);
  };
  if (!write_scans(*session.scans, threads, progress, write)) return;
  std::string oxts_stamps, scan_stamps;
  for (std::size_t i = 0; i < session.ins.size(); ++i) {
    write_file(oxts / "data" / scan_name(i, ".txt"), oxts_line(session.ins[i]));
    oxts_stamps += format_date_ns(session.ins[i].stamp_ns) + "\n";
  }
  for (std::size_t i = 0; i < session.scans->size(); ++i)
    scan_stamps += format_date_ns(session.scans->stamp_ns(i)) + "\n";
  write_file(velodyne / "timestamps.txt", scan_stamps);
  write_file(oxts / "timestamps.txt", oxts_stamps);
}

}  // namespace remount::formats
