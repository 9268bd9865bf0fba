#include "model/formats/sessions/native_session_reader.h"

#include <array>
#include <cmath>
#include <map>

#include "algorithms/core/error.h"
#include "messages/sessions.h"
#include "messages/stages.h"
#include "model/drive/stamped_streams.h"
#include "model/formats/documents/parse_document.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/text_file.h"
#include "model/formats/ins/ins_log.h"
#include "model/formats/ins/ins_table.h"
#include "model/formats/ins/nmea_log.h"
#include "model/formats/ins/novatel_log.h"
#include "model/formats/ins/sbf_file.h"
#include "model/formats/ins/sensor_tables.h"
#include "model/formats/poses/gpx_track.h"
#include "model/formats/poses/pose_file.h"
#include "model/formats/poses/pose_pairing.h"
#include "model/formats/poses/rtklib_solution.h"
#include "model/formats/sessions/gnss_log_reader.h"
#include "model/formats/sessions/native_choice.h"
#include "model/formats/sessions/native_columns.h"
#include "model/formats/sessions/native_declared.h"
#include "model/formats/sessions/native_lidars.h"
#include "model/formats/sessions/native_scans.h"
#include "model/formats/sessions/native_two_tables.h"

namespace remount::formats {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kFormat = "remount-session/1";

std::vector<motion::StampedPose> read_poses(const DocumentView& node, const fs::path& folder, SessionSource& source,
                                            drive::Session& session) {
  node.allow_only({"file", "format"});  // or columns, which are of the INS alone
  const DocumentView& format = node.at("format");
  const auto pose_format = pose_format_from_string(format.string());
  if (!pose_format) fail_choice(format, {"tum", "eth-csv", "aloam-csv", "pose-lines", "apollo-csv"});
  session.files.push_back(folder / node.at("file").string());
  const std::string text = source.table(session.files.back());
  if (text.empty() && source.only_new()) return {};
  return parse_poses(text, session.files.back(), *pose_format, session.findings);
}

/// What columns say of the axes and the clock of the INS.
void take_meaning(const InsTableLayout& layout, drive::Session& session) {
  if (!layout.quaternion) session.ins_axes = drive::axes_of(layout.attitude);
  session.ins_stamps_from_gps = layout.time_scale != TimeScale::Unix;
  session.ins_week_open = layout.time_scale == TimeScale::GpsWeek;
}

void read_pose_columns(const DocumentView& node, const fs::path& folder, SessionSource& source,
                       drive::Session& session) {
  node.allow_only({"file", "table", "columns"});
  InsTableLayout layout = read_pose_layout(node.at("columns"));
  layout.text = read_table_text(node);
  take_meaning(layout, session);
  session.files.push_back(folder / node.at("file").string());
  session.world_from_ins =
      parse_pose_table(source.table(session.files.back()), session.files.back(), layout, session.findings);
}

void read_ins(const DocumentView& node, const fs::path& folder, SessionSource& source, drive::Session& session) {
  node.allow_only({"file", "table", "columns", "attitude"});
  if (node.has("attitude")) return read_two_tables(node, folder, source, session);
  const fs::path file = folder / node.at("file").string();
  if (!node.has("columns") && read_ins_log(node.at("file"), file, session)) return;
  InsTableLayout layout = read_layout(node.at("columns"));
  layout.text = read_table_text(node);
  take_meaning(layout, session);
  session.files.push_back(file);
  const std::string text = source.table(session.files.back());
  if (text.empty() && source.only_new()) return;
  session.ins = parse_ins_table(text, session.files.back(), layout, session.findings);
}

/// A recording of a NovAtel with raw measurements, or the table of a native session.
std::vector<motion::ImuSample> read_imu(const fs::path& file, std::vector<drive::Finding>& findings) {
  if (recognise_novatel(file) == NovatelFormat::Log) return read_novatel_imu(file, findings);
  return read_imu_table(file, findings);
}

constexpr std::array<std::string_view, 4> kSensors{"imu", "gnss", "wheels", "barometer"};

void read_sensors(const DocumentView& root, const fs::path& folder, drive::Session& session) {
  const auto read = [&](std::string_view key, auto& samples, auto&& read_table) {
    const auto node = root.find(key);
    if (!node) return;
    node->allow_only({"file"});
    const fs::path file = folder / node->at("file").string();
    const bool again = std::find(session.files.begin(), session.files.end(), file) != session.files.end();
    if (!again) session.files.push_back(file);
    // A log that is the INS as well has told what is wrong with it; columns of a table are each told of.
    std::vector<drive::Finding> told_already;
    const bool is_log = again && (recognise_nmea(file) || recognise_novatel(file) || recognise_sbf(file));
    samples = read_table(file, is_log ? told_already : session.findings);
  };
  read("imu", session.imu, read_imu);
  read("gnss", session.gnss, read_gnss);
  read("wheels", session.wheels, read_wheel_table);
  read("barometer", session.barometer, read_barometer_table);
}

/// Of a session that grows only what trajectory alignment takes: the others are read when it is complete.
void read_new_fixes(const DocumentView& root, const fs::path& folder, SessionSource& source, drive::Session& session) {
  const auto node = root.find("gnss");
  if (!node) return;
  session.files.push_back(folder / node->at("file").string());
  const std::string text = source.table(session.files.back());
  if (!text.empty()) session.gnss = parse_gnss_table(text, session.files.back(), session.findings);
}

/// A file that is not there yet is none.
bool is_in_another_encoding(const fs::path& file) {
  try {
    return is_file(file) && !is_plain_text(file);
  } catch (const Error&) {
    return false;  // the reader says what is wrong with it
  }
}

/// Seconds of a week that nothing names: the week is that of all scans, and runs on over its end from row to row.
bool week_is_open(const DocumentView& root) {
  const auto ins = root.find("ins");
  const auto columns = ins ? ins->find("columns") : std::nullopt;
  const auto time = columns ? columns->find("time") : std::nullopt;
  return time && time->is_map() && time->has("scale") && time->at("scale").string() == "gps-week";
}

/// Sentences of one moment belong together, clocks are aligned over the whole drive, and poses in somebody's world are
/// judged by all of them.
bool can_be_read_in_parts(const DocumentView& root, const fs::path& folder) {
  if (root.has("ins_poses") || root.has("lidars") || (root.has("scans") && root.at("scans").has("capture")))
    return false;
  if (root.has("clocks") && root.at("clocks").string() != "shared") return false;
  // What comes anew has no lines above it, and no place in an order of names.
  if (root.has("ins") && (root.at("ins").has("table") || root.at("ins").has("attitude"))) return false;
  if (week_is_open(root)) return false;
  if (root.has("scans") && root.at("scans").has("stamps") && root.at("scans").at("stamps").is_map()) return false;
  if (root.has("scans") && stamps_are_in_points(root.at("scans"))) return false;
  for (const auto& [stream, file] :
       {std::pair{"ins", "file"}, {"gnss", "file"}, {"lidar_poses", "file"}, {"scans", "stamps"}})
    if (const auto node = root.find(stream); node && node->has(file) && !node->at(file).is_map())
      if (is_in_another_encoding(folder / node->at(file).string())) return false;
  const auto log = [&](std::string_view key) {
    const auto node = root.find(key);
    if (!node || (node->has("columns"))) return false;
    const fs::path file = folder / node->at("file").string();
    return recognise_nmea(file) || recognise_rtklib(file) || recognise_gpx(file) || recognise_novatel(file) ||
           ins_log_kind(file) != nullptr;
  };
  return !log("ins") && !log("gnss");
}

/// A stream that can be given in two ways is given in one; where the drive has other sensors it may be missing.
void require_streams(const DocumentView& root) {
  const bool sensors = std::any_of(kSensors.begin(), kSensors.end(), [&](auto key) { return root.has(key); });
  for (const auto& [first, second] : {std::pair{"scans", "lidar_poses"}, {"ins", "ins_poses"}}) {
    if (first == std::string_view("scans") && root.has("lidars")) continue;  // looked at one by one
    const int given = root.has(first) + root.has(second);
    if (given != 1 && !(given == 0 && sensors)) root.fail(say::native_either(first, second));
  }
}

}  // namespace

int NativeSessionReader::probe(const fs::path& path) const {
  const fs::path manifest = manifest_of(path);
  if (!is_file(manifest)) return 0;
  // A broken session.yaml is ours where nothing else is: open() then says what is wrong with it, and where.
  const int by_name = manifest.filename() == "session.yaml" ? 10 : 0;
  try {
    const std::string head = read_text_head(manifest, 64 * 1024);
    return head.find("remount-session/") != std::string::npos ? 100 : by_name;
  } catch (const Error&) {
    return by_name;
  }
}

fs::path NativeSessionReader::manifest_of(const fs::path& path) {
  return is_folder(path) ? path / "session.yaml" : path;
}

namespace {

/// What the manifest declares, checked as far as it concerns all streams.
DocumentView checked_manifest(const DocumentNode& document, const fs::path& manifest) {
  const DocumentView root(document, manifest.string());
  const std::string expected(kFormat);
  if (!root.is_map()) root.fail(say::native_no_map(expected));
  if (!root.has("format")) root.fail(say::native_format_missing(expected));
  const DocumentView& format = root.at("format");
  if (format.string() != kFormat) format.fail(say::native_other_format(format.string().substr(0, 60), expected));
  root.allow_only({"format", "name", "scans", "lidar_poses", "lidars", "ins", "ins_poses", "ins_noise", "lidar",
                   "nominal", "clocks", "imu", "gnss", "wheels", "barometer"});
  require_streams(root);
  return root;
}

void read_motion(const DocumentView& root, const fs::path& folder, SessionSource& source, drive::Session& session) {
  if (const auto ins = root.find("ins")) {
    read_ins(*ins, folder, source, session);
  } else if (const auto poses = root.find("ins_poses"); poses && poses->has("columns")) {
    read_pose_columns(*poses, folder, source, session);
  } else if (poses) {
    session.world_from_ins = read_poses(*poses, folder, source, session);
    const PoseFormat format = *pose_format_from_string(poses->at("format").string());
    session.ins_axes = axes_of(format);
    session.attitudes_to_true_north = counts_from_true_north(format);
  }
}

void read_lidar(const DocumentView& lidar, const fs::path& folder, SessionSource& source, drive::Session& session,
                Progress& progress) {
  const auto scans = lidar.find("scans");
  if (scans && scans->has("capture"))
    read_captured_scans(*scans, folder, session, progress);
  else if (scans)
    read_scans(*scans, folder, source, session, progress);
  else if (const auto poses = lidar.find("lidar_poses"))
    session.odometry_from_lidar = read_poses(*poses, folder, source, session);
}

/// Of the LiDAR that is read, which is none where LiDARs are left out.
void settle_clocks(const DocumentView& root, const std::vector<DeclaredLidar>& lidars, drive::Session& session) {
  ClockUse clocks = ClockUse::Shared;
  if (const auto node = root.find("clocks"))
    clocks = choice<ClockUse>(*node, {{"shared", ClockUse::Shared}, {"unsynchronised", ClockUse::Unsynchronised}});
  const bool poses = std::any_of(lidars.begin(), lidars.end(),
                                 [](const DeclaredLidar& lidar) { return lidar.node.has("lidar_poses"); });
  if (clocks == ClockUse::Unsynchronised && !poses) root.at("clocks").fail(say::native_clocks());
  if (!session.scans) align_lidar_clock(session, clocks);
}

/// How many there are to be read; nothing where that takes reading them.
std::optional<std::size_t> count_scans(const DeclaredLidar& lidar, const fs::path& folder) {
  const auto scans = lidar.node.find("scans");
  try {
    if (!scans || scans->has("capture") || stamps_are_in_points(*scans)) return std::nullopt;
    SessionSource whole;
    Progress progress;
    std::vector<drive::Finding> findings;
    return listed_scans(*scans, folder, whole, findings, progress).scans.size();
  } catch (const Error&) {
    return std::nullopt;  // the reader says what is wrong with it
  }
}

}  // namespace

drive::Session NativeSessionReader::open(const fs::path& path, Progress& progress) const {
  return open_topics(path, {}, progress);
}

drive::Session NativeSessionReader::open_topics(const fs::path& path, const drive::TopicChoice& topics,
                                                Progress& progress) const {
  const fs::path manifest = manifest_of(path), folder = manifest.parent_path();
  const DocumentNode document = read_document(manifest);
  const DocumentView root = checked_manifest(document, manifest);
  const std::vector<DeclaredLidar> lidars = declared_lidars(root);
  drive::Session session;
  session.name = root.at("name").string();
  session.path = path;
  session.format = id();
  session.files.push_back(manifest);
  const DeclaredLidar* lidar = choose_lidar(lidars, topics, session);
  if (lidars.size() > 1)
    for (const DeclaredLidar& one : lidars) {
      session.topics.push_back(lidar_topic(one, count_scans(one, folder)));
      if (&one == lidar) session.topics.back().used_as = session.topics.back().can_be;
    }
  SessionSource whole;
  progress.report(say::stage_reading_ins, 0, 2);
  read_motion(root, folder, whole, session);
  read_sensors(root, folder, session);
  progress.report(say::stage_listing_scans, 1, 2);
  if (lidar) read_lidar(lidar->node, folder, whole, session, progress);
  read_declared_noise(root, session);
  if (lidar) read_declared_lidar(lidar->node, session);
  settle_clocks(root, lidars, session);
  return session;
}

std::optional<drive::TopicOffer> NativeSessionReader::offer_topics(const fs::path& path, Progress&) const {
  const fs::path manifest = manifest_of(path);
  const DocumentNode document = read_document(manifest);
  const DocumentView root = checked_manifest(document, manifest);
  const std::vector<DeclaredLidar> lidars = declared_lidars(root);
  if (lidars.size() < 2) return std::nullopt;  // nothing to choose
  drive::TopicOffer offer;
  offer.path = path;
  for (const DeclaredLidar& lidar : lidars) {
    drive::OfferedTopic offered{lidar_topic(lidar, count_scans(lidar, manifest.parent_path())), {}, {}};
    // Each is a LiDAR, as the manifest says: the first to begin with, and nobody has to be asked.
    offered.uses = {{offered.topic.can_be.front(), say::native_lidar_offered(), offer.topics.empty()}};
    if (offer.topics.empty()) offered.topic.used_as = offered.topic.can_be;
    offer.topics.push_back(std::move(offered));
  }
  offer.open = [path](const drive::TopicChoice& topics, Progress& reading) {
    return NativeSessionReader().open_topics(path, topics, reading);
  };
  return offer;
}

std::vector<drive::LidarOffer> NativeSessionReader::offer_lidars(const fs::path& path, Progress&) const {
  const fs::path manifest = manifest_of(path);
  const DocumentNode document = read_document(manifest);
  const DocumentView root = checked_manifest(document, manifest);
  std::vector<drive::LidarOffer> offers;
  for (const DeclaredLidar& lidar : declared_lidars(root)) {
    drive::LidarOffer offer{lidar.name, {}, count_scans(lidar, manifest.parent_path())};
    if (!lidar.name.empty()) offer.choice.emplace("lidar", lidar.name);
    offers.push_back(std::move(offer));
  }
  return offers;
}

std::optional<drive::Session> NativeSessionReader::open_part(const fs::path& path, SessionSource& source,
                                                             Progress& progress) const {
  const fs::path manifest = manifest_of(path), folder = manifest.parent_path();
  const DocumentNode document = read_document(manifest);
  const DocumentView root = checked_manifest(document, manifest);
  if (!can_be_read_in_parts(root, folder)) return std::nullopt;
  drive::Session session;
  session.name = root.at("name").string();
  session.path = path;
  session.format = id();
  progress.report(say::stage_reading_what_is_new, 0, 0);
  read_motion(root, folder, source, session);
  read_new_fixes(root, folder, source, session);
  read_lidar(root, folder, source, session, progress);
  read_declared_noise(root, session);
  read_declared_lidar(root, session);
  return session;
}

}  // namespace remount::formats
