#include "tests/fuzz/readers.h"

#include <algorithm>
#include <fstream>

#include "algorithms/messages/render.h"
#include "model/fleet/fleet.h"
#include "model/formats/clouds/cloud_file.h"
#include "model/formats/files/input_file.h"
#include "model/formats/packets/kept_index.h"
#include "model/formats/poses/motion_pairs_file.h"
#include "model/formats/session_readers.h"
#include "model/guesses/description.h"
#include "model/guesses/manifest.h"
#include "model/overview/session_report.h"
#include "model/project/project.h"
#include "model/results/beam_file.h"
#include "model/results/exporters/exporter.h"
#include "model/results/velodyne_mending.h"
#include "model/settings/settings_file.h"

namespace remount::formats {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kBetween = "\n>>> ", kMark = kBetween.substr(1);
constexpr std::size_t kMostFiles = 100;

template <class T>
std::string raw(const std::vector<T>& items) {
  return {reinterpret_cast<const char*>(items.data()), items.size() * sizeof(T)};
}

std::string matrix_text(const RigidTransform& transform) {
  const Eigen::Matrix4d matrix = transform.matrix();
  return {reinterpret_cast<const char*>(matrix.data()), 16 * sizeof(double)};
}

/// Everything that is done with a session before it is calibrated.
std::string read_session(const fs::path& path) {
  Progress progress;
  const drive::Session session = open_session(path, progress);
  std::string text = overview::describe(session, overview::report_session(session, progress));
  const std::vector<drive::LidarOffer> lidars = offer_lidars(path, progress);
  for (const drive::LidarOffer& lidar : lidars)
    text += lidar.name + " " + std::to_string(lidar.scans.value_or(0)) + (lidar.rare ? " rare\n" : "\n");
  if (lidars.back().name != session.lidar_name)
    text += std::to_string(open_session(path, lidars.back().choice, progress).files.size());
  return text;
}

/// As if no format of it were known.
std::string read_described(const fs::path& path) {
  Progress progress;
  const guesses::Description found = guesses::describe_data({path}, progress, guesses::KnownFormats::PassedOver);
  if (!found.ins && found.lidars.empty()) throw Error(ErrorCode::Format, path.string(), found.missing.front());
  DocumentNode manifest = guesses::manifest_of(found, path, Language::English);
  manifest.items[1] = DocumentNode::string("drive");  // not the name of the folder
  return to_yaml(manifest);
}

std::string read_cloud(const fs::path& path) {
  const cloud::PointCloud cloud = load_cloud(path, 1'600'000'000'000'000'000);
  return raw(cloud.points) + raw(cloud.time_from_stamp_s) + raw(cloud.intensity) + raw(cloud.ring) +
         std::to_string(cloud.dropped_points);
}

std::string read_project(const fs::path& path) {
  const project::Project project = project::load_project(path);
  std::string text = settings::settings_text(project.settings);
  for (const fs::path& session : project.sessions) text += session.string() + "\n";
  if (project.nominal_ins_from_lidar) text += matrix_text(*project.nominal_ins_from_lidar);
  if (project.output) text += matrix_text(project.output->result.mounting.reference_from_sensor);
  for (const pipeline::PairVerdict& verdict : project.verdicts) text += english(verdict.reason);
  for (const Message& change : project.changes_since_calibration()) text += english(change);
  return text;
}

std::string read_result(const fs::path& path) { return to_yaml(results::result_document(results::load_result(path))); }

std::string read_vehicle(const fs::path& path) {
  return to_yaml(results::vehicle_document(results::load_vehicle(path)));
}

/// As of several LiDARs first: what is one mounting is one of those.
std::string read_mounting(const fs::path& path) {
  std::vector<Message> doubts;
  std::string text;
  const std::vector<results::NamedMounting> mountings = results::read_any_mountings(path, &doubts);
  for (const results::NamedMounting& one : mountings)
    text += one.name + "\n" + matrix_text(one.mounting.ins_from_lidar);
  if (mountings.size() == 1) text += matrix_text(results::read_any_mounting(path, &doubts).ins_from_lidar);
  for (const Message& doubt : doubts) text += english(doubt);
  return text;
}

std::string read_beams(const fs::path& path) { return to_yaml(results::beams_document(results::load_beams(path))); }

/// As it is corrected by nothing, which rounds the numbers of it.
std::string read_velodyne(const fs::path& path) {
  return results::with_beams_mended(read_velodyne_calibration(read_regular_file(path), path.filename()), {});
}

/// Behind its head, whose checksum would keep every change out.
std::string read_index_body(const fs::path& path) {
  const KeptIndex index = unpack_index(read_regular_file(path), path.string());
  return pack_index(index.capture, index.counts, index.passed, index.sensors);
}

std::string read_settings(const fs::path& path) { return settings::settings_text(settings::load_settings(path)); }

std::string read_pairs(const fs::path& path) {
  const MotionPairs pairs = read_motion_pairs(path);
  std::string text;
  for (const std::string& set : pairs.sets) text += set + "\n";
  for (const motion::Pair& pair : pairs.pairs)
    text += matrix_text(pair.ins_b_from_ins_a) + matrix_text(pair.lidar_b_from_lidar_a);
  return text;
}

std::string read_fleet(const fs::path& path) {
  const fleet::Fleet fleet = fleet::load_fleet(path);
  std::string text;
  for (const fleet::FleetVehicle& vehicle : fleet.vehicles)
    text += fleet::nominal_text(vehicle) + settings::settings_text(vehicle.settings);
  for (const fleet::FleetJob& job : fleet.jobs) text += fleet::title_of(fleet, job) + " " + job.lidars + "\n";
  return text;
}

/// A name that leads to a place below the folder and can be one on every file system.
bool is_safe(std::string_view name) {
  if (name.empty() || name.size() > 120 || name.front() == '/' || name.find("..") != std::string_view::npos)
    return false;
  return std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '/' || c == '.' ||
           c == '_' || c == '-';
  });
}

void write_bytes(const fs::path& path, std::string_view bytes) {
  std::error_code taken;  // "a" and "a/b" cannot both be files: the first is
  fs::create_directories(path.parent_path(), taken);
  std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

}  // namespace

const std::vector<Reader>& readers() {
  static const std::vector<Reader> table{
      {"native", "", read_session},
      {"described", "", read_described},
      {"kitti-raw", "", read_session},
      {"kitti-odometry", "", read_session},
      {"nuscenes", "", read_session},
      {"opencalib", "", read_session},
      {"novatel", "", read_session},
      {"gnss-log", "", read_session},
      {"ins-log", "", read_session},
      {"poses", "", read_session},
      {"smartloc", "", read_session},
      {"rosbag1", "drive.bag", read_session},
      {"mcap", "drive.mcap", read_session},
      {"rosbag2-database", "drive.db3", read_session},
      {"rosbag2-packed", "drive.db3.zstd", read_session},
      {"rosbag2-folder", "", read_session},
      {"record", "drive.record", read_session},
      {"record-parts", "", read_session},
      {"lidar-capture", "drive.pcap", read_session},
      {"lvx", "drive.lvx", read_session},
      {"kept-index", "capture.index", read_index_body},
      {"ouster", "", read_session},
      {"hesai", "", read_session},
      {"hdl64", "", read_session},
      {"pcd", "scan.pcd", read_cloud},
      {"ply", "scan.ply", read_cloud},
      {"las", "scan.las", read_cloud},
      {"kitti-bin", "scan.bin", read_cloud},
      {"scan-text", "scan.txt", read_cloud},
      {"project", "job.remount", read_project},
      {"settings", "settings.yaml", read_settings},
      {"result-yaml", "result.yaml", read_result},
      {"result-json", "result.json", read_result},
      {"vehicle", "vehicle.yaml", read_vehicle},
      {"mounting", "mounting", read_mounting},
      {"motion-pairs", "pairs.csv", read_pairs},
      {"fleet", "fleet.yaml", read_fleet},
      {"beams", "beams.yaml", read_beams},
      {"velodyne", "db.xml", read_velodyne},
  };
  return table;
}

const Reader& reader_of(std::string_view name) {
  std::string known;
  for (const Reader& reader : readers()) {
    if (reader.name == name) return reader;
    known.append(" ").append(reader.name);
  }
  throw Error(ErrorCode::Contract, "",
              Message::verbatim("there is no reader '" + std::string(name) + "'; there are:" + known));
}

std::string pack_files(const std::vector<PackedFile>& files) {
  std::string pack;
  for (const PackedFile& file : files) {
    pack.append(pack.empty() ? kMark : kBetween).append(file.name).append("\n").append(file.bytes);
  }
  return pack;
}

std::vector<PackedFile> unpack_files(std::string_view pack) {
  std::vector<PackedFile> files;
  if (!pack.starts_with(kMark)) return files;
  pack.remove_prefix(kMark.size());
  while (!pack.empty() && files.size() < kMostFiles) {
    const std::size_t end = std::min(pack.find(kBetween), pack.size());
    const std::string_view piece = pack.substr(0, end);
    const std::size_t name_end = std::min(piece.find('\n'), piece.size());
    if (is_safe(piece.substr(0, name_end)))
      files.push_back({std::string(piece.substr(0, name_end)), std::string(piece.substr(std::min(name_end + 1, end)))});
    pack.remove_prefix(std::min(end + kBetween.size(), pack.size()));
  }
  return files;
}

fs::path write_input(const Reader& reader, std::string_view bytes, const fs::path& folder) {
  for (const fs::directory_entry& old : fs::directory_iterator(folder)) fs::remove_all(old.path());
  if (!reader.file_name.empty()) {
    write_bytes(folder / reader.file_name, bytes);
    return folder / reader.file_name;
  }
  for (const PackedFile& file : unpack_files(bytes)) write_bytes(folder / file.name, file.bytes);
  return folder;
}

bool names_input(const Error& error, const Reader& reader, const fs::path& folder) {
  const std::string message = error.what();
  if (message.find(folder.string()) != std::string::npos) return true;
  return !reader.file_name.empty() && message.find(reader.file_name) != std::string::npos;
}

}  // namespace remount::formats
