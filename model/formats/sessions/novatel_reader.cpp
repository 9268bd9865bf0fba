#include "model/formats/sessions/novatel_reader.h"

#include <utility>

#include "messages/ins_logs.h"
#include "messages/stages.h"
#include "model/drive/attitude_convention.h"
#include "model/drive/bad_items.h"
#include "model/formats/files/input_file.h"
#include "model/formats/ins/inspvax_log.h"
#include "model/formats/poses/pose_file.h"
#include "model/formats/poses/pose_pairing.h"
#include "model/formats/sessions/pose_session_reader.h"

namespace remount::formats {

namespace fs = std::filesystem;

namespace {

struct NovatelContents {
  std::vector<std::pair<fs::path, InspvaxFormat>> logs;
  std::vector<std::pair<fs::path, PoseFormat>> poses;
};

NovatelContents examine_novatel(const fs::path& path) {
  NovatelContents contents;
  const std::vector<fs::path> files = is_file(path) ? std::vector<fs::path>{path} : files_in(path);
  for (const fs::path& file : files) {
    if (const auto log = recognise_inspvax(file))
      contents.logs.emplace_back(file, *log);
    else if (const auto poses = recognise_pose_file(file))
      contents.poses.emplace_back(file, *poses);
  }
  return contents;
}

/// Reads every log and keeps the best; the others are named in a finding.
void read_best_log(const NovatelContents& contents, drive::Session& session) {
  std::vector<std::string> others;
  double best_score = -1.0;
  std::vector<drive::Finding> best_findings;
  fs::path best_path;
  for (const auto& [path, format] : contents.logs) {
    std::vector<drive::Finding> findings;
    InspvaxLog log = read_inspvax(path, format, findings);
    const bool intact = format == InspvaxFormat::AsciiLog || log.distinct_host_times > 0.5;
    const double score = (intact ? 1e12 : 0.0) + static_cast<double>(log.ins.size());
    const bool better = score > best_score;
    const fs::path& other = better ? best_path : path;
    if (!other.empty()) others.push_back(other.filename().string());
    if (!better) continue;
    best_score = score;
    best_path = path;
    best_findings = std::move(findings);
    session.ins = std::move(log.ins);
  }
  session.files.push_back(best_path);
  session.findings.insert(session.findings.end(), best_findings.begin(), best_findings.end());
  if (!others.empty())
    session.findings.push_back(drive::make_finding(drive::Severity::Note, "ins-file-chosen", best_path.string(),
                                                   say::inspvax_log_chosen(std::move(others))));
}

const std::pair<fs::path, PoseFormat>& lidar_poses(const NovatelContents& contents, const fs::path& folder) {
  if (contents.poses.size() == 1) return contents.poses[0];
  const std::pair<fs::path, PoseFormat>* found = nullptr;
  for (const auto& candidate : contents.poses) {
    if (!name_has_word(candidate.first, {"lidar", "odom", "laser", "mapped", "loam"})) continue;
    if (found)
      throw Error(ErrorCode::Unsupported, folder.string(),
                  say::inspvax_several_poses(found->first.filename().string(), candidate.first.filename().string()));
    found = &candidate;
  }
  if (found) return *found;
  throw Error(ErrorCode::Unsupported, folder.string(), say::inspvax_no_named_poses());
}

}  // namespace

int NovatelReader::probe(const fs::path& path) const {
  if (!is_file(path) && !is_folder(path)) return 0;
  const NovatelContents contents = examine_novatel(path);
  if (contents.logs.empty()) return 0;
  return contents.poses.empty() ? 70 : 85;
}

drive::Session NovatelReader::open(const fs::path& path, Progress& progress) const {
  progress.report(say::stage_reading_ins, 0, 2);
  const NovatelContents contents = examine_novatel(path);
  if (contents.logs.empty()) throw Error(ErrorCode::Format, path.string(), say::inspvax_no_log());
  drive::Session session;
  session.name = (path.has_filename() ? path : path.parent_path()).filename().string();
  session.path = path;
  session.format = id();
  session.ins_axes = drive::InsAxes::RightForwardUp;
  session.ins_stamps_from_gps = true;
  read_best_log(contents, session);
  progress.report(say::stage_reading_poses, 1, 2);
  if (contents.poses.empty()) {
    session.findings.push_back(
        drive::make_finding(drive::Severity::Problem, "one-stream", path.string(), say::inspvax_half_a_session()));
    return session;
  }
  const auto& [file, format] = lidar_poses(contents, path);
  session.odometry_from_lidar = read_pose_file(file, format, session.findings);
  session.files.push_back(file);
  align_lidar_clock(session, ClockUse::Unsynchronised);
  return session;
}

}  // namespace remount::formats
