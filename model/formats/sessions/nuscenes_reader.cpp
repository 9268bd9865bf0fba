#include "model/formats/sessions/nuscenes_reader.h"

#include <algorithm>

#include "algorithms/core/error.h"
#include "messages/general.h"
#include "messages/sessions.h"
#include "messages/stages.h"
#include "model/drive/bad_items.h"
#include "model/drive/stamped_streams.h"
#include "model/formats/clouds/timed_scans.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/printable_text.h"
#include "model/formats/sessions/nuscenes_tables.h"
#include "model/formats/sessions/several_sessions.h"

namespace remount::formats {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kChannelRole = "lidar";

/// A data set, and the scan that was asked for, if one was.
struct NuscenesPlace {
  fs::path root;
  std::vector<fs::path> tables;
  fs::path scan;  ///< relative to the root; empty: none
};

/// No tables where it is none.
NuscenesPlace nuscenes_at(const fs::path& path) {
  if (is_folder(path)) return {path, nuscenes_tables_in(path), {}};
  const std::string name = lower_case(path.filename().string());
  if (!name.ends_with(".bin") && !name.ends_with(".pcd")) return {};
  const fs::path full = fs::absolute(path).lexically_normal(), kind = full.parent_path().parent_path();
  if (kind.filename() != "samples" && kind.filename() != "sweeps") return {};
  return {kind.parent_path(), nuscenes_tables_in(kind.parent_path()), full.lexically_relative(kind.parent_path())};
}

/// A scene whose scans are there, or of which the scan that was asked for is one.
struct ChosenScene {
  fs::path tables;
  std::vector<std::string> channels;
  NuscenesScene scene;
};

const NuscenesSweep* first_there(const NuscenesScene& scene, const fs::path& root) {
  const auto there = std::find_if(scene.sweeps.begin(), scene.sweeps.end(),
                                  [&](const NuscenesSweep& sweep) { return is_file(root / sweep.file); });
  return there == scene.sweeps.end() ? nullptr : &*there;
}

bool has_scan(const NuscenesScene& scene, const fs::path& scan) {
  return std::any_of(scene.sweeps.begin(), scene.sweeps.end(),
                     [&](const NuscenesSweep& sweep) { return sweep.file == scan; });
}

[[noreturn]] void refuse_several_scenes(const std::vector<std::pair<std::string, fs::path>>& scenes,
                                        const fs::path& root) {
  constexpr std::size_t kMostScenes = 20;
  std::vector<std::string> lines;
  std::vector<fs::path> paths;
  for (const auto& [name, scan] : scenes) {
    if (lines.size() < kMostScenes)
      lines.push_back("  " + printable(name, LineBreaks::Escaped) + ": " +
                      printable(scan.string(), LineBreaks::Escaped));
    paths.push_back(scan);
  }
  if (scenes.size() > kMostScenes) lines.emplace_back("  …");
  throw SeveralSessions(root, say::nuscenes_several(scenes.size(), lines), paths);
}

/// Of several versions of the tables the first that has what is there. Nothing where it is cancelled.
std::optional<ChosenScene> choose_scene(const NuscenesPlace& place, const fs::path& path, Progress& progress) {
  if (place.tables.empty()) throw Error(ErrorCode::Format, path.string(), say::nuscenes_none());
  for (const fs::path& folder : place.tables) {
    NuscenesTables tables = read_nuscenes_tables(folder, progress);
    if (progress.cancelled()) return std::nullopt;
    std::vector<std::pair<std::string, fs::path>> there;
    std::size_t chosen = 0;
    for (std::size_t i = 0; i < tables.scenes.size(); ++i) {
      const NuscenesScene& scene = tables.scenes[i];
      const NuscenesSweep* first = nullptr;
      if (!place.scan.empty() ? !has_scan(scene, place.scan) : !(first = first_there(scene, place.root))) continue;
      chosen = i;
      there.emplace_back(scene.name, place.root / (first != nullptr ? first->file : place.scan));
      if (!place.scan.empty()) break;
    }
    if (there.size() > 1) refuse_several_scenes(there, path);
    if (there.size() == 1) return ChosenScene{folder, std::move(tables.channels), std::move(tables.scenes[chosen])};
  }
  throw Error(ErrorCode::Format, path.string(), say::nuscenes_nothing_there());
}

/// Channels of LiDARs that the scene has sweeps of, with how many.
std::vector<std::pair<std::string, std::size_t>> lidars_of(const ChosenScene& chosen) {
  std::vector<std::pair<std::string, std::size_t>> lidars;
  for (std::size_t channel = 0; channel < chosen.channels.size(); ++channel) {
    const auto count = std::count_if(chosen.scene.sweeps.begin(), chosen.scene.sweeps.end(),
                                     [&](const NuscenesSweep& sweep) { return sweep.channel == channel; });
    if (count > 0) lidars.emplace_back(chosen.channels[channel], static_cast<std::size_t>(count));
  }
  return lidars;
}

drive::SessionTopic channel_topic(const std::pair<std::string, std::size_t>& lidar) {
  return {lidar.first, "LiDAR", lidar.second, 0.0, {std::string(kChannelRole)}, {}};
}

/// The LiDAR that was asked for, or the first; empty where LiDARs are left out.
std::string choose_channel(const std::vector<std::pair<std::string, std::size_t>>& lidars,
                           const drive::TopicChoice& topics, drive::Session& session) {
  for (const auto& [role, name] : topics)
    if (role != kChannelRole && name != drive::kNoTopic)
      throw Error(ErrorCode::Contract, session.path.string(), say::session_no_topics(session.format));
  const auto asked = topics.find(kChannelRole);
  if (asked != topics.end() && asked->second == drive::kNoTopic) return {};
  std::vector<std::string> names;
  for (const auto& lidar : lidars) names.push_back(lidar.first);
  std::string chosen = names.front();
  if (asked != topics.end()) {
    if (std::find(names.begin(), names.end(), asked->second) == names.end())
      throw Error(ErrorCode::Contract, asked->second, say::native_no_such_lidar(names));
    chosen = asked->second;
  } else if (names.size() > 1) {
    session.findings.push_back(drive::make_finding(drive::Severity::Note, "lidar-chosen", chosen,
                                                   say::native_lidar_chosen({names.begin() + 1, names.end()})));
  }
  if (lidars.size() > 1)
    for (const auto& lidar : lidars) {
      session.topics.push_back(channel_topic(lidar));
      if (lidar.first == chosen) session.topics.back().used_as = session.topics.back().can_be;
    }
  return chosen;
}

/// Floats of a known layout, or a file that says itself what is in it.
CloudFormat format_of_sweeps(const std::vector<drive::ScanFile>& scans) {
  return lower_case(scans.front().path.extension().string()) == ".bin" ? CloudFormat::NuscenesBin : CloudFormat::Auto;
}

void take_sweeps(const std::vector<NuscenesSweep>& sweeps, const fs::path& root, drive::Session& session) {
  std::vector<drive::ScanFile> scans;
  drive::BadItems bad;
  for (const NuscenesSweep& sweep : sweeps)
    if (is_file(root / sweep.file))
      scans.push_back({root / sweep.file, sweep.stamp_ns});
    else
      bad.add(say::of_file((root / sweep.file).string(), say::kitti_scan_missing()));
  bad.report(session.findings, "missing-scans", root.string(), say::left_out_scans);
  if (scans.empty()) throw Error(ErrorCode::Format, root.string(), say::nuscenes_nothing_there());
  drive::keep_ascending(scans, "scan", root.string(), session.findings);
  for (const drive::ScanFile& scan : scans) session.files.push_back(scan.path);
  session.scan_timing = drive::ScanTiming::Instant;
  const CloudFormat format = format_of_sweeps(scans);
  session.scans = std::make_shared<FileScanSource>(std::move(scans), format, TimesOfPoints::Unused);
}

}  // namespace

int NuscenesReader::probe(const fs::path& path) const { return nuscenes_at(path).tables.empty() ? 0 : 95; }

drive::Session NuscenesReader::open(const fs::path& path, Progress& progress) const {
  return open_topics(path, {}, progress);
}

drive::Session NuscenesReader::open_topics(const fs::path& path, const drive::TopicChoice& topics,
                                           Progress& progress) const {
  const NuscenesPlace place = nuscenes_at(path);
  std::optional<ChosenScene> found = choose_scene(place, path, progress);
  drive::Session session;
  session.path = path;
  session.format = id();
  if (!found) return session;
  ChosenScene& chosen = *found;
  session.name = chosen.scene.name;
  session.topic_choice = topics;
  for (const char* table : {"sensor", "calibrated_sensor", "scene", "sample", "sample_data", "ego_pose"})
    session.files.push_back(chosen.tables / (std::string(table) + ".json"));
  session.lidar_name = choose_channel(lidars_of(chosen), topics, session);
  std::vector<NuscenesSweep>& sweeps = chosen.scene.sweeps;
  const std::string of_poses =
      session.lidar_name.empty() ? chosen.channels[sweeps.front().channel] : session.lidar_name;
  std::erase_if(sweeps, [&](const NuscenesSweep& sweep) { return chosen.channels[sweep.channel] != of_poses; });
  std::stable_sort(sweeps.begin(), sweeps.end(),
                   [](const NuscenesSweep& a, const NuscenesSweep& b) { return a.stamp_ns < b.stamp_ns; });
  const std::string table = (chosen.tables / "ego_pose.json").string();
  session.world_from_ins = read_ego_poses(chosen.tables, sweeps, session.findings, progress);
  if (progress.cancelled()) return session;
  drive::keep_ascending(session.world_from_ins, "pose", table, session.findings);
  session.findings.push_back(
      drive::make_finding(drive::Severity::Note, "poses-of-localisation", table, say::nuscenes_poses()));
  if (session.lidar_name.empty()) return session;
  progress.report(say::stage_listing_scans, 1, 2);
  take_sweeps(sweeps, place.root, session);
  session.nominal_ins_from_lidar = sweeps.front().ego_from_lidar;
  session.findings.push_back(drive::make_finding(drive::Severity::Note, "nominal-found",
                                                 (chosen.tables / "calibrated_sensor.json").string(),
                                                 say::nuscenes_nominal()));
  return session;
}

std::optional<drive::TopicOffer> NuscenesReader::offer_topics(const fs::path& path, Progress& progress) const {
  const std::optional<ChosenScene> chosen = choose_scene(nuscenes_at(path), path, progress);
  if (!chosen) return std::nullopt;
  const std::vector<std::pair<std::string, std::size_t>> lidars = lidars_of(*chosen);
  if (lidars.size() < 2) return std::nullopt;  // nothing to choose
  drive::TopicOffer offer;
  offer.path = path;
  for (const auto& lidar : lidars) {
    drive::OfferedTopic offered{channel_topic(lidar), {}, {}};
    offered.uses = {{std::string(kChannelRole), say::native_lidar_offered(), offer.topics.empty()}};
    if (offer.topics.empty()) offered.topic.used_as = offered.topic.can_be;
    offer.topics.push_back(std::move(offered));
  }
  offer.open = [path](const drive::TopicChoice& topics, Progress& reading) {
    return NuscenesReader().open_topics(path, topics, reading);
  };
  return offer;
}

std::vector<drive::LidarOffer> NuscenesReader::offer_lidars(const fs::path& path, Progress& progress) const {
  const std::optional<ChosenScene> chosen = choose_scene(nuscenes_at(path), path, progress);
  if (!chosen) return SessionReader::offer_lidars(path, progress);
  const std::vector<std::pair<std::string, std::size_t>> lidars = lidars_of(*chosen);
  std::vector<drive::LidarOffer> offers;
  for (const auto& [name, count] : lidars) {
    offers.push_back({name, {}, count});
    if (lidars.size() > 1) offers.back().choice.emplace(kChannelRole, name);
  }
  return offers;
}

}  // namespace remount::formats
