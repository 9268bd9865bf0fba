#include "model/formats/sessions/novatel_reader.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "messages/ins_logs.h"
#include "messages/stages.h"
#include "model/drive/attitude_convention.h"
#include "model/drive/bad_items.h"
#include "model/formats/files/input_file.h"
#include "model/formats/ins/ins_log.h"
#include "model/formats/ins/novatel_log.h"
#include "model/formats/poses/pose_file.h"
#include "model/formats/poses/pose_pairing.h"
#include "model/formats/sessions/motion_logs.h"
#include "model/formats/sessions/pose_session_reader.h"

namespace remount::formats {

namespace fs = std::filesystem;

namespace {

struct NovatelContents {
  NovatelLogs logs;
  std::vector<fs::path> imu;  ///< of NovAtel, with raw measurements alone
  std::vector<PoseFileChoice> poses;
  std::vector<fs::path> whole, others;  ///< solutions of other makes; logs of positions
};

NovatelContents examine_novatel(const fs::path& path) {
  NovatelContents contents;
  const std::vector<fs::path> files = is_file(path) ? std::vector<fs::path>{path} : files_in(path);
  for (const fs::path& file : files) {
    if (const auto log = recognise_novatel(file))
      contents.logs.emplace_back(file, *log);
    else if (const auto poses = recognise_pose_file(file))
      contents.poses.emplace_back(file, *poses);
    else if (ins_log_kind(file))
      contents.whole.push_back(file);
    else if (is_motion_log(file))
      contents.others.push_back(file);
  }
  contents.imu = part_raw_imu(contents.logs, !contents.whole.empty() || !contents.others.empty());
  return contents;
}

/// Reads NovAtel's logs, or the solution that was post-processed; the others are named in a finding.
void read_motion(const NovatelContents& contents, drive::Session& session) {
  fs::path taken;
  std::vector<fs::path> others = contents.others;
  if (const fs::path* solution = only_post_processed(contents.whole)) {
    taken = *solution;
    take_ins_log(*ins_log_kind(taken), taken, session);
    for (const auto& [log, format] : contents.logs) others.push_back(log);
  } else {
    taken = read_best_novatel(contents.logs, contents.imu, session);
    others.insert(others.end(), contents.whole.begin(), contents.whole.end());
  }
  tell_passed_over(taken, others, session);
}

/// Of several logs the samples of the best are taken: one that states its own times, then the one with most.
double worth_of(const NovatelLog& log) {
  const bool intact = log.distinct_host_times > 0.5;
  return (log.ins.empty() ? 0.0 : 1e15) + (intact ? 1e12 : 0.0) +
         static_cast<double>(log.ins.empty() ? log.fixes.size() : log.ins.size());
}

/// What one log says of the errors of an INS, for samples of another.
std::vector<StampedSigma> errors_of(const NovatelLog& log) {
  std::vector<StampedSigma> errors = log.errors;
  if (log.states_errors)
    for (const motion::InsSample& sample : log.ins)
      if (sample.quality != motion::InsQuality::Invalid) errors.push_back({sample.stamp_ns, sample.sigma});
  return errors;
}

/// Reads every log; one that holds nothing usable is told of. Throws what is wrong with the first where all are such.
std::vector<NovatelLog> read_logs(const NovatelLogs& files, std::vector<drive::Finding>& findings) {
  std::vector<NovatelLog> logs;
  std::vector<Error> failed;
  for (const auto& [path, format] : files) try {
      logs.push_back(read_novatel_log(path, format));
    } catch (const Error& error) {
      if (error.code() == ErrorCode::Io) throw;
      failed.push_back(error);
    }
  if (logs.empty() && !failed.empty()) throw failed.front();
  for (const Error& error : failed)
    findings.push_back(drive::make_finding(drive::Severity::Warning, "bad-ins", error.where(), error.what_happened()));
  return logs;
}

}  // namespace

std::vector<fs::path> part_raw_imu(NovatelLogs& logs, bool beside) {
  const auto first =
      std::stable_partition(logs.begin(), logs.end(), [](const auto& log) { return !holds_raw_imu_alone(log.first); });
  std::vector<fs::path> imu;
  if (!beside && first == logs.begin()) return imu;  // what is missing is said where it is read
  for (auto log = first; log != logs.end(); ++log) imu.push_back(log->first);
  logs.erase(first, logs.end());
  return imu;
}

namespace {

/// Of the first of the files that has any that can be used.
void take_raw_imu(std::vector<fs::path> files, drive::Session& session) {
  for (const fs::path& file : files) try {
      session.imu = read_novatel_imu(file, session.findings);
      session.files.push_back(file);
      return;
    } catch (const Error& error) {
      session.findings.push_back(
          drive::make_finding(drive::Severity::Note, "bad-imu", error.where(), error.what_happened()));
    }
}

}  // namespace

fs::path read_best_novatel(const NovatelLogs& files, const std::vector<fs::path>& imu, drive::Session& session) {
  session.ins_axes = drive::InsAxes::RightForwardUp;
  session.ins_stamps_from_gps = true;
  std::vector<NovatelLog> logs = read_logs(files, session.findings);
  const auto best = std::ranges::max_element(logs, {}, worth_of);
  std::vector<StampedSigma> errors;
  std::vector<std::string> others;
  for (const NovatelLog& log : logs) {
    if (&log == &*best) continue;
    others.push_back(log.path.filename().string());
    const std::vector<StampedSigma> more = best->states_errors ? std::vector<StampedSigma>() : errors_of(log);
    if (more.empty()) continue;
    best->error_logs.push_back(log.path.filename().string());
    errors.insert(errors.end(), more.begin(), more.end());
    session.findings.insert(session.findings.end(), log.findings.begin(), log.findings.end());
  }
  settle_novatel(*best, errors, session.findings);
  session.files.push_back(best->path);
  session.ins = std::move(best->ins);
  session.gnss = std::move(best->fixes);
  session.imu = std::move(best->imu);
  if (session.imu.empty()) {
    std::vector<fs::path> raw = imu;
    for (const NovatelLog& log : logs)
      if (!log.imu.empty()) raw.push_back(log.path);
    take_raw_imu(std::move(raw), session);
  }
  if (!others.empty())
    session.findings.push_back(drive::make_finding(drive::Severity::Note, "ins-file-chosen", best->path.string(),
                                                   say::inspvax_log_chosen(std::move(others))));
  return best->path;
}

int NovatelReader::probe(const fs::path& path) const {
  if (!is_file(path) && !is_folder(path)) return 0;
  const NovatelContents contents = examine_novatel(path);
  if (contents.logs.empty()) return 0;
  // One that only says what is missing stands back behind every reader that has something to read.
  if (std::ranges::all_of(contents.logs, [](const auto& log) { return holds_raw_imu_alone(log.first); })) return 10;
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
  read_motion(contents, session);
  progress.report(say::stage_reading_poses, 1, 2);
  if (contents.poses.empty()) {
    session.findings.push_back(
        drive::make_finding(drive::Severity::Problem, "one-stream", path.string(), say::inspvax_half_a_session()));
    return session;
  }
  const auto& [file, format] = lidar_poses_of(contents.poses, path);
  session.odometry_from_lidar = read_pose_file(file, format, session.findings);
  session.files.push_back(file);
  if (!session.ins.empty()) align_lidar_clock(session, ClockUse::Unsynchronised);
  return session;
}

}  // namespace remount::formats
