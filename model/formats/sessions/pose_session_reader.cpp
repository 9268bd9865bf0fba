#include "model/formats/sessions/pose_session_reader.h"

#include <algorithm>
#include <iterator>
#include <optional>

#include "algorithms/core/error.h"
#include "messages/ins_logs.h"
#include "messages/poses.h"
#include "messages/stages.h"
#include "model/drive/bad_items.h"
#include "model/formats/files/input_file.h"
#include "model/formats/poses/pose_file.h"
#include "model/formats/poses/pose_pairing.h"

namespace remount::formats {

namespace fs = std::filesystem;

namespace {

struct PoseFile {
  fs::path path;
  PoseFormat format;
};

bool is_ins(const fs::path& file) { return name_has_word(file, {"ins", "imu", "gnss", "hand", "vicon", "body"}); }

/// What EuRoC and TUM-VI call the folders of their truth, the best first: that of EuRoC was estimated in axes of the
/// IMU from what Vicon saw of its markers.
constexpr std::string_view kFoldersOfTruth[] = {"state_groundtruth", "mocap", "vicon"};

/// The truth of EuRoC and TUM-VI: `state_groundtruth_estimate0/data.csv`, `mocap0/data.csv`. It is of the body.
bool is_truth_of_body(const fs::path& file) {
  const std::string folder = lower_case(fs::absolute(file).parent_path().filename().string());
  return lower_case(file.filename().string()) == "data.csv" &&
         std::any_of(std::begin(kFoldersOfTruth), std::end(kFoldersOfTruth),
                     [&](std::string_view name) { return folder.starts_with(name); });
}

bool is_of_body(const fs::path& file) { return is_ins(file) || is_truth_of_body(file); }
bool is_lidar(const fs::path& file) { return name_has_word(file, {"lidar", "camera", "cam", "odom", "laser"}); }

/// The best of those below the folder, or below its `mav0`.
std::optional<PoseFile> truth_below(const fs::path& folder) {
  for (const std::string_view name : kFoldersOfTruth)
    for (const fs::path& parent : {folder, folder / "mav0"}) {
      if (!may_look_into(parent)) continue;
      for (const fs::path& below : directories_in(parent)) {
        const fs::path file = below / "data.csv";
        if (!lower_case(below.filename().string()).starts_with(name) || !may_look_into(below) || !is_file(file))
          continue;
        if (const auto format = recognise_pose_file(file)) return PoseFile{file, *format};
      }
    }
  return std::nullopt;
}

/// Right in the folder; where none of them is of the body, with the truth of a data set below.
std::vector<PoseFile> pose_files_in(const fs::path& folder) {
  std::vector<PoseFile> found;
  for (const fs::path& file : files_in(folder))
    if (const auto format = recognise_pose_file(file)) found.push_back({file, *format});
  const bool body = std::any_of(found.begin(), found.end(), [](const PoseFile& one) { return is_of_body(one.path); });
  const std::optional<PoseFile> truth = body ? std::nullopt : truth_below(folder);
  if (truth) found.push_back(*truth);
  return found;
}

/// A single file of which it is known that it is of the body can be looked at by its folder.
bool is_truth_alone(const std::vector<PoseFile>& files) {
  return files.size() == 1 && is_truth_of_body(files.front().path);
}

/// A line each, for messages.
std::vector<std::string> names_of_files(const std::vector<PoseFile>& files) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < std::min<std::size_t>(files.size(), 20); ++i)
    names.push_back("  " + files[i].path.filename().string());
  return names;
}

const PoseFile& only_one(const std::vector<PoseFile>& files, bool (*wanted)(const fs::path&), const fs::path& folder,
                         Message words) {
  const PoseFile* found = nullptr;
  for (const PoseFile& file : files) {
    if (!wanted(file.path)) continue;
    if (found)
      throw Error(ErrorCode::Unsupported, folder.string(),
                  say::pose_several_files(std::move(words), names_of_files(files)));
    found = &file;
  }
  if (found) return *found;
  throw Error(ErrorCode::Unsupported, folder.string(),
              say::pose_no_file_of_name(std::move(words), names_of_files(files)));
}

void read_one_stream(const PoseFile& file, drive::Session& session) {
  auto& poses = is_of_body(file.path) ? session.world_from_ins : session.odometry_from_lidar;
  poses = read_pose_file(file.path, file.format, session.findings);
  session.files.push_back(file.path);
  session.findings.push_back(
      drive::make_finding(drive::Severity::Problem, "one-stream", file.path.string(), say::pose_one_file()));
}

}  // namespace

bool name_has_word(const fs::path& file, std::initializer_list<std::string_view> words) {
  const std::string name = lower_case(file.stem().string());
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'); };
  for (std::size_t at = 0; at < name.size();) {
    std::size_t end = at;
    while (end < name.size() && letter(name[end])) ++end;
    if (std::find(words.begin(), words.end(), std::string_view(name).substr(at, end - at)) != words.end()) return true;
    at = end + 1;
  }
  return false;
}

const PoseFileChoice& lidar_poses_of(const std::vector<PoseFileChoice>& poses, const fs::path& folder) {
  if (poses.size() == 1) return poses[0];
  const PoseFileChoice* found = nullptr;
  for (const auto& candidate : poses) {
    if (!name_has_word(candidate.first, {"lidar", "odom", "laser", "mapped", "loam"})) continue;
    if (found)
      throw Error(ErrorCode::Unsupported, folder.string(),
                  say::inspvax_several_poses(found->first.filename().string(), candidate.first.filename().string()));
    found = &candidate;
  }
  if (found) return *found;
  throw Error(ErrorCode::Unsupported, folder.string(), say::inspvax_no_named_poses());
}

int PoseSessionReader::probe(const fs::path& path) const {
  if (is_file(path)) return recognise_pose_file(path) ? 60 : 0;
  if (!is_folder(path)) return 0;
  const std::vector<PoseFile> files = pose_files_in(path);
  if (files.size() < 2) return is_truth_alone(files) ? 40 : 0;
  return files.size() == 2 && is_of_body(files[0].path) != is_of_body(files[1].path) ? 60 : 20;
}

drive::Session PoseSessionReader::open(const fs::path& path, Progress& progress) const {
  drive::Session session;
  session.name = (path.has_filename() ? path : path.parent_path()).filename().string();
  session.path = path;
  session.format = id();
  session.ins_axes.reset();
  if (is_file(path)) {
    const auto format = recognise_pose_file(path);
    if (!format) throw Error(ErrorCode::Format, path.string(), say::pose_no_file());
    read_one_stream({path, *format}, session);
    return session;
  }
  const std::vector<PoseFile> files = pose_files_in(path);
  if (is_truth_alone(files)) {
    read_one_stream(files.front(), session);
    return session;
  }
  const PoseFile& ins = only_one(files, is_of_body, path, say::pose_names_of_ins());
  const PoseFile& lidar = only_one(files, is_lidar, path, say::pose_names_of_lidar());
  progress.report(say::stage_reading_poses, 0, 2);
  session.world_from_ins = read_pose_file(ins.path, ins.format, session.findings);
  session.ins_axes = axes_of(ins.format);
  session.attitudes_to_true_north = counts_from_true_north(ins.format);
  progress.report(say::stage_reading_poses, 1, 2);
  session.odometry_from_lidar = read_pose_file(lidar.path, lidar.format, session.findings);
  session.files = {ins.path, lidar.path};
  align_lidar_clock(session, ClockUse::Shared);
  return session;
}

}  // namespace remount::formats
