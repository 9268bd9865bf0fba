#include "model/formats/sessions/opencalib_reader.h"

#include <algorithm>

#include "messages/sessions.h"
#include "messages/stages.h"
#include "model/drive/bad_items.h"
#include "model/drive/stamped_streams.h"
#include "model/formats/clouds/timed_scans.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/time_stamp.h"
#include "model/formats/poses/pose_file.h"
#include "model/formats/poses/pose_pairing.h"
#include "model/formats/sessions/pose_session_reader.h"

namespace remount::formats {

namespace fs = std::filesystem;

namespace {

struct OpencalibContents {
  std::vector<fs::path> ins_poses;    ///< best first
  std::vector<fs::path> lidar_poses;  ///< best first
  std::vector<drive::ScanFile> scans;
  fs::path scan_folder;
};

bool is_lidar_pose_name(const fs::path& file) {
  const std::string name = lower_case(file.stem().string());
  return name.find("lidar") != std::string::npos && name.find("-pose") != std::string::npos &&
         !name_has_word(file, {"novatel", "ins", "gnss", "imu"});
}

/// Smaller is better.
int ins_rank(const fs::path& file) {
  if (name_has_word(file, {"novatel"})) return 0;
  if (name_has_word(file, {"ins", "gnss", "imu"})) return 1;
  return name_has_word(file, {"enu"}) ? 2 : 3;
}

std::vector<drive::ScanFile> stamped_scans(const fs::path& folder) {
  std::vector<drive::ScanFile> scans;
  for (const fs::path& file : files_in(folder))
    if (lower_case(file.extension().string()) == ".pcd")
      if (const auto stamp = parse_date_ns(file.stem().string())) scans.push_back({file, *stamp});
  return scans;
}

void find_scans(const fs::path& folder, OpencalibContents& contents) {
  std::vector<fs::path> candidates = directories_in(folder);
  candidates.insert(candidates.begin(), folder);
  for (const fs::path& candidate : candidates) {
    std::vector<drive::ScanFile> scans = stamped_scans(candidate);
    if (scans.size() <= contents.scans.size()) continue;
    contents.scans = std::move(scans);
    contents.scan_folder = candidate;
  }
}

OpencalibContents examine_opencalib(const fs::path& folder) {
  OpencalibContents contents;
  std::vector<fs::path> poses;
  for (const fs::path& file : files_in(folder))
    if (lower_case(file.extension().string()) != ".pcd" && recognise_pose_file(file) == PoseFormat::PoseLines)
      poses.push_back(file);
  for (const fs::path& file : poses)
    (poses.size() > 1 && is_lidar_pose_name(file) ? contents.lidar_poses : contents.ins_poses).push_back(file);
  std::stable_sort(contents.ins_poses.begin(), contents.ins_poses.end(),
                   [](const fs::path& a, const fs::path& b) { return ins_rank(a) < ins_rank(b); });
  if (!contents.ins_poses.empty()) find_scans(folder, contents);
  return contents;
}

void report_choice(const std::vector<fs::path>& files, const char* code,
                   Message (*chosen)(std::vector<std::string> others), std::vector<drive::Finding>& findings) {
  if (files.size() < 2) return;
  std::vector<std::string> others;
  for (std::size_t i = 1; i < files.size(); ++i) others.push_back(files[i].filename().string());
  findings.push_back(drive::make_finding(drive::Severity::Note, code, files[0].string(), chosen(std::move(others))));
}

void use_scans(OpencalibContents& contents, drive::Session& session) {
  drive::keep_ascending(contents.scans, "scan", contents.scan_folder.string(), session.findings);
  for (const drive::ScanFile& scan : contents.scans) session.files.push_back(scan.path);
  const auto scans = std::make_shared<FileScanSource>(std::move(contents.scans), CloudFormat::Pcd);
  session.scans = scans;
  use_point_times(*scans, session);
}

}  // namespace

int OpenCalibReader::probe(const fs::path& path) const {
  if (!is_folder(path)) return 0;
  const OpencalibContents contents = examine_opencalib(path);
  if (contents.ins_poses.empty()) return 0;
  return contents.scans.empty() && contents.lidar_poses.empty() ? 30 : 80;
}

drive::Session OpenCalibReader::open(const fs::path& path, Progress& progress) const {
  progress.report(say::stage_reading_poses, 0, 2);
  OpencalibContents contents = examine_opencalib(path);
  if (contents.ins_poses.empty()) throw Error(ErrorCode::Format, path.string(), say::opencalib_no_ins());
  drive::Session session;
  session.name = (path.has_filename() ? path : path.parent_path()).filename().string();
  session.path = path;
  session.format = id();
  session.ins_axes.reset();
  report_choice(contents.ins_poses, "ins-file-chosen", say::opencalib_ins_chosen, session.findings);
  session.world_from_ins = read_pose_file(contents.ins_poses[0], PoseFormat::PoseLines, session.findings);
  session.files.push_back(contents.ins_poses[0]);
  progress.report(say::stage_reading_poses, 1, 2);
  const bool enough_scans = contents.scans.size() >= session.world_from_ins.size();
  if (!contents.scans.empty() && (enough_scans || contents.lidar_poses.empty())) {
    if (!contents.lidar_poses.empty())
      session.findings.push_back(drive::make_finding(drive::Severity::Note, "scans-preferred",
                                                     contents.scan_folder.string(), say::opencalib_scans_preferred()));
    use_scans(contents, session);
    return session;
  }
  if (contents.lidar_poses.empty()) throw Error(ErrorCode::Format, path.string(), say::opencalib_no_lidar());
  report_choice(contents.lidar_poses, "lidar-file-chosen", say::opencalib_lidar_chosen, session.findings);
  session.odometry_from_lidar = read_pose_file(contents.lidar_poses[0], PoseFormat::PoseLines, session.findings);
  session.files.push_back(contents.lidar_poses[0]);
  if (!contents.scans.empty())
    session.findings.push_back(
        drive::make_finding(drive::Severity::Note, "lidar-poses-preferred", contents.lidar_poses[0].string(),
                            say::opencalib_poses_preferred(session.odometry_from_lidar.size(), contents.scans.size())));
  align_lidar_clock(session, ClockUse::Shared);
  return session;
}

}  // namespace remount::formats
