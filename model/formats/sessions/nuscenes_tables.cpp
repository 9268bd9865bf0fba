#include "model/formats/sessions/nuscenes_tables.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <unordered_set>
#include <utility>

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

constexpr std::size_t kRowsBetweenReports = 100'000, kRowsBetweenLooks = 1000;

/// Calls `take(rows)` for each row of a table; what it throws is wrong with that row, and collected. False where it is
/// cancelled. Throws Error where the file is no table.
template <class Take>
bool for_rows(const fs::path& table, Stage stage, Progress& progress, drive::BadItems& bad, Take&& take) {
  TableRows rows(table);
  for (std::size_t row = 0;; ++row) {
    if (row % kRowsBetweenReports == 0) progress.report(stage, row, 0);
    if (row % kRowsBetweenLooks == 0 && progress.cancelled()) return false;
    try {
      if (!rows.next()) return true;
      take(rows);
    } catch (const Error& error) {
      if (error.code() == ErrorCode::Io || rows.is_no_table()) throw;
      bad.add(error);
    }
  }
}

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

/// A name below the data set: an absolute one, or one that leads out of it, is none.
fs::path inner_file(const TableRows& row) {
  const fs::path file = fs::path(row.text("filename")).lexically_normal();
  if (file.empty() || file.is_absolute() || *file.begin() == "..")
    throw Error(ErrorCode::Format, row.place(), say::nuscenes_outside());
  return file;
}

/// Goes through the tables in the order in which they name each other, and keeps what belongs to LiDARs.
class LidarTables {
 public:
  LidarTables(fs::path folder, Progress& progress) : progress_(progress) { read_.folder = std::move(folder); }

  /// Null where it is cancelled.
  std::shared_ptr<const NuscenesTables> read() {
    if (!read_sensors() || !read_calibrations() || !read_scenes() || !read_samples() || !read_sweeps()) return nullptr;
    std::erase_if(read_.scenes, [](const NuscenesScene& scene) { return scene.sweeps.empty(); });
    std::sort(read_.scenes.begin(), read_.scenes.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
    if (read_.scenes.empty()) fail("sample_data", say::nuscenes_no_sweeps());
    return std::make_shared<const NuscenesTables>(std::move(read_));
  }

 private:
  /// With what is wrong with rows before, which may be why.
  [[noreturn]] void fail(const char* table, Message what) const {
    std::vector<Message> sentences{std::move(what)};
    for (const drive::Finding& finding : read_.findings) sentences.push_back(finding.explanation);
    throw Error(ErrorCode::Format, file_of(table).string(), Message::sequence(std::move(sentences)));
  }
  fs::path file_of(const char* table) const { return read_.folder / (std::string(table) + ".json"); }

  template <class Take>
  bool walk(const char* table, Take&& take) {
    drive::BadItems bad;
    const bool whole = for_rows(file_of(table), say::stage_listing_scans, progress_, bad, std::forward<Take>(take));
    bad.report(read_.findings, "bad-rows", file_of(table).string(), say::left_out_rows);
    return whole;
  }

  bool read_sensors() {
    const bool whole = walk("sensor", [&](const TableRows& row) {
      if (row.text("modality") == "lidar") channel_of_sensor_[row.text("token")] = row.text("channel");
    });
    if (!whole) return false;
    if (channel_of_sensor_.empty()) fail("sensor", say::nuscenes_no_lidar());
    std::vector<std::string>& channels = read_.channels;
    for (const auto& [token, channel] : channel_of_sensor_) channels.push_back(channel);
    std::sort(channels.begin(), channels.end());
    channels.erase(std::unique(channels.begin(), channels.end()), channels.end());
    return true;
  }

  bool read_calibrations() {
    return walk("calibrated_sensor", [&](const TableRows& row) {
      const auto sensor = channel_of_sensor_.find(row.text("sensor_token"));
      if (sensor == channel_of_sensor_.end()) return;
      const auto channel = std::find(read_.channels.begin(), read_.channels.end(), sensor->second);
      calibrated_.insert_or_assign(
          row.text("token"), Calibrated{static_cast<std::size_t>(channel - read_.channels.begin()), transform_of(row)});
    });
  }

  bool read_scenes() {
    return walk("scene", [&](const TableRows& row) {
      const std::string token = row.text("token"), name = row.text("name");
      scene_of_token_.emplace(token, read_.scenes.size());
      read_.scenes.push_back({name, {}});
    });
  }

  bool read_samples() {
    return walk("sample", [&](const TableRows& row) {
      const auto scene = scene_of_token_.find(row.text("scene_token"));
      if (scene != scene_of_token_.end()) scene_of_sample_.emplace(row.text("token"), scene->second);
    });
  }

  bool read_sweeps() {
    return walk("sample_data", [&](const TableRows& row) {
      const auto sensor = calibrated_.find(row.text("calibrated_sensor_token"));
      if (sensor == calibrated_.end()) return;
      const auto scene = scene_of_sample_.find(row.text("sample_token"));
      if (scene == scene_of_sample_.end()) return;  // of a scene that these tables do not have
      read_.scenes[scene->second].sweeps.push_back({stamp_of(row), inner_file(row), row.text("ego_pose_token"),
                                                    sensor->second.channel, sensor->second.ego_from_lidar});
    });
  }

  struct Calibrated {
    std::size_t channel;
    RigidTransform ego_from_lidar = RigidTransform::Identity();
  };
  Progress& progress_;
  NuscenesTables read_;
  ByToken<std::string> channel_of_sensor_;
  ByToken<Calibrated> calibrated_;
  ByToken<std::size_t> scene_of_token_, scene_of_sample_;
};

/// "v1.0-mini", "v1.1-trainval".
bool is_name_of_tables(const std::string& name) {
  const std::size_t dash = name.find('-');
  return name.starts_with('v') && dash != std::string::npos && dash > 1 &&
         name.substr(1, dash - 1).find_first_not_of("0123456789.") == std::string::npos;
}

}  // namespace

bool are_nuscenes_tables(const fs::path& folder) {
  return is_name_of_tables(folder.filename().string()) && may_look_into(folder) &&
         is_file(folder / "sample_data.json") && is_file(folder / "ego_pose.json");
}

std::vector<fs::path> nuscenes_tables_in(const fs::path& root) {
  std::vector<fs::path> tables;
  for (const fs::path& folder : directories_in(root))
    if (are_nuscenes_tables(folder)) tables.push_back(folder);
  return tables;
}

std::shared_ptr<const NuscenesTables> read_nuscenes_tables(const fs::path& tables, Progress& progress) {
  return LidarTables(tables, progress).read();
}

std::shared_ptr<const NuscenesPoses> read_ego_poses(const NuscenesTables& tables, Progress& progress) {
  std::unordered_set<std::string_view> wanted;
  for (const NuscenesScene& scene : tables.scenes)
    for (const NuscenesSweep& sweep : scene.sweeps) wanted.insert(sweep.ego_pose);
  NuscenesPoses poses;
  const fs::path table = tables.folder / "ego_pose.json";
  drive::BadItems bad;
  const bool whole = for_rows(table, say::stage_reading_poses, progress, bad, [&](const TableRows& row) {
    const std::string token = row.text("token");
    if (!wanted.contains(token)) return;
    try {
      const motion::StampedPose pose{stamp_of(row), transform_of(row)};
      poses.global_from_ego.insert_or_assign(token, pose);
    } catch (const Error& error) {
      poses.broken.insert_or_assign(token, drive::message_of(error));
    }
  });
  if (!whole) return nullptr;
  bad.report(poses.findings, "bad-rows", table.string(), say::left_out_rows);
  return std::make_shared<const NuscenesPoses>(std::move(poses));
}

std::vector<motion::StampedPose> poses_of_sweeps(const NuscenesPoses& poses, const std::vector<NuscenesSweep>& sweeps,
                                                 const fs::path& table, std::vector<drive::Finding>& findings) {
  std::vector<motion::StampedPose> found;
  std::unordered_set<std::string_view> taken;  // sweeps may share one
  drive::BadItems bad, missing;
  for (const NuscenesSweep& sweep : sweeps) {
    const auto pose = poses.global_from_ego.find(sweep.ego_pose);
    if (pose == poses.global_from_ego.end() && !poses.broken.contains(sweep.ego_pose))
      missing.add(Message::verbatim(sweep.file.string()));
    if (!taken.insert(sweep.ego_pose).second) continue;
    if (pose != poses.global_from_ego.end())
      found.push_back(pose->second);
    else if (const auto broken = poses.broken.find(sweep.ego_pose); broken != poses.broken.end())
      bad.add(broken->second);
  }
  if (found.empty()) {
    std::vector<Message> sentences{bad.after(say::nuscenes_no_poses())};
    for (const drive::Finding& finding : poses.findings) sentences.push_back(finding.explanation);
    throw Error(ErrorCode::Format, table.string(), Message::sequence(std::move(sentences)));
  }
  findings.insert(findings.end(), poses.findings.begin(), poses.findings.end());
  bad.report(findings, "bad-poses", table.string(), say::left_out_rows);
  missing.report(findings, "missing-poses", table.string(), say::nuscenes_missing_poses);
  return found;
}

}  // namespace remount::formats
