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
#include "model/formats/files/listed_files.h"
#include "model/formats/files/printable_text.h"
#include "model/formats/sessions/nuscenes_kept.h"
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

/// No tables where it is none. A folder of tables stands for its data set, with these tables alone.
NuscenesPlace nuscenes_at(const fs::path& path) {
  if (is_folder(path)) {
    fs::path full = fs::absolute(path).lexically_normal();
    if (full.filename().empty()) full = full.parent_path();
    if (are_nuscenes_tables(full)) return {full.parent_path(), {full}, {}};
    return {path, nuscenes_tables_in(path), {}};
  }
  const std::string name = lower_case(path.filename().string());
  if (!name.ends_with(".bin") && !name.ends_with(".pcd")) return {};
  const fs::path full = fs::absolute(path).lexically_normal(), kind = full.parent_path().parent_path();
  if (kind.filename() != "samples" && kind.filename() != "sweeps") return {};
  return {kind.parent_path(), nuscenes_tables_in(kind.parent_path()), full.lexically_relative(kind.parent_path())};
}

/// A scene of one version of the tables, of which scans are there.
struct SceneThere {
  std::shared_ptr<const NuscenesTables> tables;
  const NuscenesScene* scene = nullptr;
  std::size_t scans = 0;  ///< that are there
  fs::path first;         ///< the earliest of them
};

/// The scene that is opened.
struct ChosenScene {
  SceneThere there;
  std::vector<std::string> other_versions;  ///< of the tables, that have it too
  drive::BadItems broken_versions;
};

bool has_scan(const NuscenesScene& scene, const fs::path& scan) {
  return std::any_of(scene.sweeps.begin(), scene.sweeps.end(),
                     [&](const NuscenesSweep& sweep) { return sweep.file == scan; });
}

/// Those of which scans are there, or of which the one that was asked for is one.
void add_scenes_there(const std::shared_ptr<const NuscenesTables>& tables, const NuscenesPlace& place,
                      ListedFiles& listed, std::vector<SceneThere>& out) {
  for (const NuscenesScene& scene : tables->scenes) {
    if (!place.scan.empty() && !has_scan(scene, place.scan)) continue;
    SceneThere there{tables, &scene, 0, {}};
    std::int64_t first_ns = 0;
    for (const NuscenesSweep& sweep : scene.sweeps) {
      if (!listed.has(place.root / sweep.file)) continue;
      if (there.scans++ > 0 && sweep.stamp_ns >= first_ns) continue;
      first_ns = sweep.stamp_ns;
      there.first = sweep.file;
    }
    if (there.scans > 0) out.push_back(std::move(there));
  }
}

[[noreturn]] void refuse_several_scenes(const std::vector<SceneThere>& scenes, const fs::path& root,
                                        const fs::path& path) {
  constexpr std::size_t kMostScenes = 20;
  std::vector<std::string> lines;
  std::vector<fs::path> paths;
  for (const SceneThere& there : scenes) {
    const fs::path scan = root / there.first;
    if (lines.size() < kMostScenes)
      lines.push_back("  " + printable(there.scene->name, LineBreaks::Escaped) + ": " +
                      printable(scan.string(), LineBreaks::Escaped));
    paths.push_back(scan);
  }
  if (scenes.size() > kMostScenes) lines.emplace_back("  …");
  throw SeveralSessions(path, say::nuscenes_several(scenes.size(), lines), paths);
}

/// The same scene in several versions of the tables counts once: with those that have most of what is there, of these
/// the one with the fewest sweeps beside, of these the first. @return by their names, with the versions left aside
std::vector<ChosenScene> one_of_each(std::vector<SceneThere> all) {
  std::stable_sort(all.begin(), all.end(), [](const SceneThere& a, const SceneThere& b) {
    if (a.scene->name != b.scene->name) return a.scene->name < b.scene->name;
    if (a.first != b.first) return a.first < b.first;
    if (a.scans != b.scans) return a.scans > b.scans;
    return a.scene->sweeps.size() < b.scene->sweeps.size();
  });
  std::vector<ChosenScene> chosen;
  for (SceneThere& there : all) {
    if (!chosen.empty() && chosen.back().there.scene->name == there.scene->name &&
        chosen.back().there.first == there.first)
      chosen.back().other_versions.push_back(there.tables->folder.filename().string());
    else
      chosen.push_back({std::move(there), {}, {}});
  }
  return chosen;
}

/// Nothing where it is cancelled.
std::optional<ChosenScene> choose_scene(const NuscenesPlace& place, const fs::path& path, ListedFiles& listed,
                                        Progress& progress) {
  if (place.tables.empty()) throw Error(ErrorCode::Format, path.string(), say::nuscenes_none());
  std::vector<SceneThere> all;
  drive::BadItems broken;
  std::optional<Error> first_error;
  for (const fs::path& folder : place.tables) {
    try {
      const std::shared_ptr<const NuscenesTables> tables = kept_nuscenes().tables(folder, progress);
      if (!tables) return std::nullopt;
      add_scenes_there(tables, place, listed, all);
    } catch (const Error& error) {
      broken.add(error);
      if (!first_error) first_error = error;
    }
  }
  std::vector<ChosenScene> chosen = one_of_each(std::move(all));
  if (chosen.size() > 1) {
    std::vector<SceneThere> scenes;
    for (ChosenScene& one : chosen) scenes.push_back(std::move(one.there));
    refuse_several_scenes(scenes, place.root, path);
  }
  if (chosen.empty() && first_error) throw *first_error;
  if (chosen.empty()) throw Error(ErrorCode::Format, path.string(), say::nuscenes_nothing_there());
  chosen.front().broken_versions = broken;
  return std::move(chosen.front());
}

/// Channels of LiDARs that the scene has sweeps of, with how many.
std::vector<std::pair<std::string, std::size_t>> lidars_of(const ChosenScene& chosen) {
  std::vector<std::pair<std::string, std::size_t>> lidars;
  const std::vector<NuscenesSweep>& sweeps = chosen.there.scene->sweeps;
  const std::vector<std::string>& channels = chosen.there.tables->channels;
  for (std::size_t channel = 0; channel < channels.size(); ++channel) {
    const auto count = std::count_if(sweeps.begin(), sweeps.end(),
                                     [&](const NuscenesSweep& sweep) { return sweep.channel == channel; });
    if (count > 0) lidars.emplace_back(channels[channel], static_cast<std::size_t>(count));
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

/// Names that the publisher of nuScenes gives: the vehicle, when, the channel and the stamp
/// ("n015-2018-07-24-11-22-45+0800__LIDAR_TOP__1532402927647951.pcd.bin"). Tools that write the layout have others.
bool is_published_sweep(const drive::ScanFile& scan) {
  const std::string name = scan.path.filename().string();
  return (name.starts_with("n008-2018-") || name.starts_with("n015-2018-")) &&
         name.find("__LIDAR_TOP__") != std::string::npos && name.ends_with(".pcd.bin");
}

void take_sweeps(const std::vector<NuscenesSweep>& sweeps, const fs::path& root, ListedFiles& listed,
                 drive::Session& session) {
  std::vector<drive::ScanFile> scans;
  drive::BadItems bad;
  for (const NuscenesSweep& sweep : sweeps)
    if (listed.has(root / sweep.file))
      scans.push_back({root / sweep.file, sweep.stamp_ns});
    else
      bad.add(say::of_file((root / sweep.file).string(), say::kitti_scan_missing()));
  bad.report(session.findings, "missing-scans", root.string(), say::left_out_scans);
  if (scans.empty()) throw Error(ErrorCode::Format, root.string(), say::nuscenes_nothing_there());
  drive::keep_ascending(scans, "scan", root.string(), session.findings);
  for (const drive::ScanFile& scan : scans) session.files.push_back(scan.path);
  const bool published = std::all_of(scans.begin(), scans.end(), is_published_sweep);
  const CloudFormat format = format_of_sweeps(scans);
  const auto source = std::make_shared<FileScanSource>(std::move(scans), format,
                                                       published ? TimesOfPoints::Unused : TimesOfPoints::Kept);
  session.scans = source;
  session.scan_timing = drive::ScanTiming::Instant;
  if (!published) use_point_times(*source, session);
}

/// X stands in the data already, and was used to make the poses, as far as is known.
void tell_of_poses(const fs::path& table, drive::Session& session) {
  const bool published = !session.files.empty() && is_published_sweep({session.files.back(), 0});
  session.findings.push_back(drive::make_finding(published ? drive::Severity::Warning : drive::Severity::Note,
                                                 "poses-by-mounting", table.string(),
                                                 published ? say::nuscenes_poses() : say::nuscenes_poses_of_others()));
}

void tell_of_tables(const ChosenScene& chosen, const NuscenesPlace& place, drive::Session& session) {
  const NuscenesTables& tables = *chosen.there.tables;
  for (const char* table : kNuscenesTables) session.files.push_back(tables.folder / (std::string(table) + ".json"));
  session.findings.insert(session.findings.end(), tables.findings.begin(), tables.findings.end());
  if (!chosen.other_versions.empty())
    session.findings.push_back(
        drive::make_finding(drive::Severity::Note, "tables-chosen", place.root.string(),
                            say::nuscenes_tables_chosen(tables.folder.filename().string(), chosen.other_versions)));
  chosen.broken_versions.report(session.findings, "bad-tables", place.root.string(), say::nuscenes_tables_broken);
}

}  // namespace

int NuscenesReader::probe(const fs::path& path) const { return nuscenes_at(path).tables.empty() ? 0 : 95; }

drive::Session NuscenesReader::open(const fs::path& path, Progress& progress) const {
  return open_topics(path, {}, progress);
}

drive::Session NuscenesReader::open_topics(const fs::path& path, const drive::TopicChoice& topics,
                                           Progress& progress) const {
  const NuscenesPlace place = nuscenes_at(path);
  ListedFiles listed;
  const std::optional<ChosenScene> chosen = choose_scene(place, path, listed, progress);
  drive::Session session;
  session.path = path;
  session.format = id();
  if (!chosen) return session;
  const NuscenesTables& tables = *chosen->there.tables;
  session.name = chosen->there.scene->name;
  session.topic_choice = topics;
  tell_of_tables(*chosen, place, session);
  session.lidar_name = choose_channel(lidars_of(*chosen), topics, session);
  std::vector<NuscenesSweep> sweeps = chosen->there.scene->sweeps;
  const std::string of_poses =
      session.lidar_name.empty() ? tables.channels[sweeps.front().channel] : session.lidar_name;
  std::erase_if(sweeps, [&](const NuscenesSweep& sweep) { return tables.channels[sweep.channel] != of_poses; });
  std::stable_sort(sweeps.begin(), sweeps.end(),
                   [](const NuscenesSweep& a, const NuscenesSweep& b) { return a.stamp_ns < b.stamp_ns; });
  const fs::path table = tables.folder / "ego_pose.json";
  const std::shared_ptr<const NuscenesPoses> poses = kept_nuscenes().ego_poses(chosen->there.tables, progress);
  if (!poses) return session;
  session.world_from_ins = poses_of_sweeps(*poses, sweeps, table, session.findings);
  drive::keep_ascending(session.world_from_ins, "pose", table.string(), session.findings);
  if (!session.lidar_name.empty()) {
    progress.report(say::stage_listing_scans, 1, 2);
    take_sweeps(sweeps, place.root, listed, session);
    session.nominal_ins_from_lidar = sweeps.front().ego_from_lidar;
    session.findings.push_back(drive::make_finding(drive::Severity::Note, "nominal-found",
                                                   (tables.folder / "calibrated_sensor.json").string(),
                                                   say::nuscenes_nominal()));
  }
  tell_of_poses(table, session);
  return session;
}

std::optional<drive::TopicOffer> NuscenesReader::offer_topics(const fs::path& path, Progress& progress) const {
  ListedFiles listed;
  const std::optional<ChosenScene> chosen = choose_scene(nuscenes_at(path), path, listed, progress);
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
  ListedFiles listed;
  const std::optional<ChosenScene> chosen = choose_scene(nuscenes_at(path), path, listed, progress);
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
