#include "model/formats/sessions/ins_log_reader.h"

#include "algorithms/core/error.h"
#include "messages/ins_logs.h"
#include "messages/stages.h"
#include "model/drive/bad_items.h"
#include "model/formats/files/input_file.h"
#include "model/formats/ins/ins_log.h"
#include "model/formats/poses/pose_pairing.h"
#include "model/formats/sessions/motion_logs.h"
#include "model/formats/sessions/pose_session_reader.h"

namespace remount::formats {

namespace fs = std::filesystem;

namespace {

struct InsLogContents {
  std::vector<std::pair<fs::path, const InsLogKind*>> logs;
  std::vector<PoseFileChoice> poses;
  std::vector<fs::path> others;  ///< logs of other kinds
};

InsLogContents examine_ins_logs(const fs::path& path) {
  InsLogContents contents;
  const std::vector<fs::path> files = is_file(path) ? std::vector<fs::path>{path} : files_in(path);
  for (const fs::path& file : files) {
    if (const InsLogKind* kind = ins_log_kind(file))
      contents.logs.emplace_back(file, kind);
    else if (const auto poses = recognise_pose_file(file))
      contents.poses.emplace_back(file, *poses);
    else if (is_motion_log(file))
      contents.others.push_back(file);
  }
  return contents;
}

}  // namespace

int InsLogReader::probe(const fs::path& path) const {
  constexpr int kAlone = 65, kWithPoses = 80;
  if (!is_file(path) && !is_folder(path)) return 0;
  const InsLogContents contents = examine_ins_logs(path);
  if (contents.logs.empty()) return 0;
  return contents.poses.empty() ? kAlone : kWithPoses;
}

drive::Session InsLogReader::open(const fs::path& path, Progress& progress) const {
  progress.report(say::stage_reading_ins, 0, 2);
  const InsLogContents contents = examine_ins_logs(path);
  if (contents.logs.empty()) throw Error(ErrorCode::Format, path.string(), say::ins_log_none());
  const auto& [log, kind] = contents.logs.front();
  if (contents.logs.size() > 1)
    throw Error(ErrorCode::Unsupported, path.string(),
                say::ins_log_several(log.filename().string(), contents.logs[1].first.filename().string()));
  drive::Session session;
  session.name = (path.has_filename() ? path : path.parent_path()).filename().string();
  session.path = path;
  session.format = id();
  take_ins_log(*kind, log, session);
  tell_passed_over(log, contents.others, session);
  progress.report(say::stage_reading_poses, 1, 2);
  if (contents.poses.empty()) {
    session.findings.push_back(
        drive::make_finding(drive::Severity::Problem, "one-stream", path.string(), say::ins_log_half_a_session()));
    return session;
  }
  const auto& [file, format] = lidar_poses_of(contents.poses, path);
  session.odometry_from_lidar = read_pose_file(file, format, session.findings);
  session.files.push_back(file);
  align_lidar_clock(session, ClockUse::Shared);
  return session;
}

}  // namespace remount::formats
