#include "model/formats/sessions/nuscenes_tables.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <unordered_map>

#include "algorithms/core/error.h"
#include "messages/general.h"
#include "messages/poses.h"
#include "messages/sessions.h"
#include "messages/stages.h"
#include "model/conventions/impossible_motion.h"
#include "model/drive/bad_items.h"
#include "model/formats/documents/table_rows.h"
#include "model/formats/files/input_file.h"

namespace remount::formats {

namespace fs = std::filesystem;

namespace {

template <class T>
using ByToken = std::unordered_map<std::string, T>;

constexpr std::size_t kRowsBetweenReports = 100'000;

bool is_cancelled_at(const Progress& progress, std::size_t row) { return row % 1000 == 0 && progress.cancelled(); }

/// Microseconds since 1970.
std::int64_t stamp_of(const TableRows& row) {
  const std::int64_t stamp_us = row.integer("timestamp");
  constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max() / 1000;
  if (stamp_us > kMost || stamp_us < -kMost) throw Error(ErrorCode::Format, row.place(), say::nuscenes_time());
  return 1000 * stamp_us;
}

/// `translation` in metres, and `rotation` as w, x, y, z.
RigidTransform transform_of(const TableRows& row) {
  const std::vector<double> t = row.numbers("translation", 3), q = row.numbers("rotation", 4);
  const Eigen::Quaterniond rotation(q[0], q[1], q[2], q[3]);
  if (!(std::abs(rotation.norm() - 1.0) < 0.01))
    throw Error(ErrorCode::Format, row.place(), say::pose_quaternion_length(rotation.norm()));
  for (const double value : t)
    if (!(std::abs(value) < conventions::kFarthestPosition_m))
      throw Error(ErrorCode::Format, row.place(), say::nuscenes_beyond());
  return make_rigid(rotation.normalized().toRotationMatrix(), {t[0], t[1], t[2]});
}

/// Where the tables of a data set say what a LiDAR's row belongs to.
struct LidarRows {
  struct Calibrated {
    std::size_t channel;
    RigidTransform ego_from_lidar;
  };
  std::vector<std::string> channels;
  ByToken<Calibrated> calibrated;
  std::vector<std::string> scene_names;
  ByToken<std::size_t> scene_of_sample;
};

void read_lidars(const fs::path& tables, LidarRows& lidars) {
  ByToken<std::string> channel_of_sensor;
  TableRows sensors(tables / "sensor.json");
  while (sensors.next())
    if (sensors.text("modality") == "lidar") channel_of_sensor[sensors.text("token")] = sensors.text("channel");
  if (channel_of_sensor.empty())
    throw Error(ErrorCode::Format, (tables / "sensor.json").string(), say::nuscenes_no_lidar());
  for (const auto& [token, channel] : channel_of_sensor) lidars.channels.push_back(channel);
  std::sort(lidars.channels.begin(), lidars.channels.end());
  lidars.channels.erase(std::unique(lidars.channels.begin(), lidars.channels.end()), lidars.channels.end());
  TableRows rows(tables / "calibrated_sensor.json");
  while (rows.next()) {
    const auto sensor = channel_of_sensor.find(rows.text("sensor_token"));
    if (sensor == channel_of_sensor.end()) continue;
    const auto channel = std::find(lidars.channels.begin(), lidars.channels.end(), sensor->second);
    lidars.calibrated.insert_or_assign(
        rows.text("token"),
        LidarRows::Calibrated{static_cast<std::size_t>(channel - lidars.channels.begin()), transform_of(rows)});
  }
}

void read_samples(const fs::path& tables, LidarRows& lidars) {
  ByToken<std::size_t> scene_of_token;
  TableRows scenes(tables / "scene.json");
  while (scenes.next()) {
    scene_of_token.emplace(scenes.text("token"), lidars.scene_names.size());
    lidars.scene_names.push_back(scenes.text("name"));
  }
  TableRows samples(tables / "sample.json");
  while (samples.next())
    if (const auto scene = scene_of_token.find(samples.text("scene_token")); scene != scene_of_token.end())
      lidars.scene_of_sample.emplace(samples.text("token"), scene->second);
}

/// A name below the data set: an absolute one, or one that leads out of it, is none.
fs::path inner_file(const TableRows& row) {
  const fs::path file = fs::path(row.text("filename")).lexically_normal();
  if (file.empty() || file.is_absolute() || *file.begin() == "..")
    throw Error(ErrorCode::Format, row.place(), say::nuscenes_outside());
  return file;
}

}  // namespace

std::vector<fs::path> nuscenes_tables_in(const fs::path& root) {
  std::vector<fs::path> tables;
  for (const fs::path& folder : directories_in(root))
    if (folder.filename().string().starts_with("v1.0-") && may_look_into(folder) &&
        is_file(folder / "sample_data.json") && is_file(folder / "ego_pose.json"))
      tables.push_back(folder);
  return tables;
}

NuscenesTables read_nuscenes_tables(const fs::path& tables, Progress& progress) {
  LidarRows lidars;
  read_lidars(tables, lidars);
  read_samples(tables, lidars);
  std::vector<NuscenesScene> scenes;
  for (const std::string& name : lidars.scene_names) scenes.push_back({name, {}});
  const fs::path table = tables / "sample_data.json";
  TableRows rows(table);
  for (std::size_t row = 0; rows.next(); ++row) {
    if (is_cancelled_at(progress, row)) return {};
    if (row % kRowsBetweenReports == 0) progress.report(say::stage_listing_scans, row, 0);
    const auto sensor = lidars.calibrated.find(rows.text("calibrated_sensor_token"));
    if (sensor == lidars.calibrated.end()) continue;
    const auto scene = lidars.scene_of_sample.find(rows.text("sample_token"));
    if (scene == lidars.scene_of_sample.end()) continue;  // of a scene that these tables do not have
    scenes[scene->second].sweeps.push_back({stamp_of(rows), inner_file(rows), rows.text("ego_pose_token"),
                                            sensor->second.channel, sensor->second.ego_from_lidar});
  }
  std::erase_if(scenes, [](const NuscenesScene& scene) { return scene.sweeps.empty(); });
  std::sort(scenes.begin(), scenes.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  if (scenes.empty()) throw Error(ErrorCode::Format, table.string(), say::nuscenes_no_sweeps());
  return {std::move(lidars.channels), std::move(scenes)};
}

std::vector<motion::StampedPose> read_ego_poses(const fs::path& tables, const std::vector<NuscenesSweep>& sweeps,
                                                std::vector<drive::Finding>& findings, Progress& progress) {
  ByToken<std::size_t> wanted;
  for (std::size_t i = 0; i < sweeps.size(); ++i) wanted.emplace(sweeps[i].ego_pose, i);  // sweeps may share one
  std::vector<std::optional<motion::StampedPose>> found(sweeps.size());
  const fs::path table = tables / "ego_pose.json";
  drive::BadItems bad;
  TableRows rows(table);
  for (std::size_t row = 0; rows.next(); ++row) {
    if (is_cancelled_at(progress, row)) return {};
    if (row % kRowsBetweenReports == 0) progress.report(say::stage_reading_poses, row, 0);
    const auto sweep = wanted.find(rows.text("token"));
    if (sweep == wanted.end()) continue;
    try {
      found[sweep->second] = motion::StampedPose{stamp_of(rows), transform_of(rows)};
    } catch (const Error& error) {
      bad.add(error);
    }
  }
  std::vector<motion::StampedPose> poses;
  for (const auto& pose : found)
    if (pose) poses.push_back(*pose);
  if (poses.empty()) throw Error(ErrorCode::Format, table.string(), bad.after(say::nuscenes_no_poses()));
  bad.report(findings, "bad-poses", table.string(), say::left_out_lines);
  if (poses.size() + bad.count() < wanted.size())
    findings.push_back(drive::make_finding(drive::Severity::Warning, "missing-poses", table.string(),
                                           say::nuscenes_missing_poses(wanted.size() - poses.size() - bad.count())));
  return poses;
}

}  // namespace remount::formats
