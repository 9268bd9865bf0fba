#include "model/io/pose_session_reader.h"

#include <algorithm>

#include "algorithms/core/error.h"
#include "model/io/input_file.h"
#include "model/io/pose_file.h"
#include "model/io/pose_pairing.h"
#include "model/io/stream_tools.h"

namespace remount {

namespace fs = std::filesystem;

namespace {

struct PoseFile {
  fs::path path;
  PoseFormat format;
};

bool is_ins(const fs::path& file) { return name_has_word(file, {"ins", "imu", "gnss", "hand", "vicon", "body"}); }
bool is_lidar(const fs::path& file) { return name_has_word(file, {"lidar", "camera", "cam", "odom", "laser"}); }

std::vector<PoseFile> pose_files_in(const fs::path& folder) {
  std::vector<PoseFile> found;
  for (const fs::path& file : files_in(folder))
    if (const auto format = recognise_pose_file(file)) found.push_back({file, *format});
  return found;
}

std::string names_of_files(const std::vector<PoseFile>& files) {
  std::string text;
  for (std::size_t i = 0; i < std::min<std::size_t>(files.size(), 20); ++i)
    text += "\n  " + files[i].path.filename().string();
  return text;
}

const PoseFile& only_one(const std::vector<PoseFile>& files, bool (*wanted)(const fs::path&), const fs::path& folder,
                         const char* words) {
  const PoseFile* found = nullptr;
  for (const PoseFile& file : files) {
    if (!wanted(file.path)) continue;
    if (found)
      throw Error(ErrorCode::Unsupported, folder.string(),
                  "holds several pose files named after " + std::string(words) +
                      "; put each pair into a folder of its own:" + names_of_files(files));
    found = &file;
  }
  if (found) return *found;
  throw Error(ErrorCode::Unsupported, folder.string(),
              "holds no pose file named after " + std::string(words) + ", found:" + names_of_files(files));
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

int PoseSessionReader::probe(const fs::path& path) const {
  if (is_file(path)) return recognise_pose_file(path) ? 60 : 0;
  if (!is_folder(path)) return 0;
  const std::vector<PoseFile> files = pose_files_in(path);
  if (files.size() < 2) return 0;
  return files.size() == 2 && is_ins(files[0].path) != is_ins(files[1].path) ? 60 : 20;
}

Session PoseSessionReader::open(const fs::path& path, Progress& progress) const {
  Session session;
  session.name = (path.has_filename() ? path : path.parent_path()).filename().string();
  session.path = path;
  session.format = id();
  session.ins_axes.reset();
  if (is_file(path)) {
    const auto format = recognise_pose_file(path);
    if (!format) throw Error(ErrorCode::Format, path.string(), "is no pose file");
    auto& poses = is_ins(path) ? session.world_from_ins : session.odometry_from_lidar;
    poses = read_pose_file(path, *format, session.findings);
    session.files.push_back(path);
    session.findings.push_back(
        make_finding(Severity::Problem, "one-stream", path.string(),
                     "One pose file is half a session: put it into a folder with the poses of the other sensor."));
    return session;
  }
  const std::vector<PoseFile> files = pose_files_in(path);
  const PoseFile& ins = only_one(files, is_ins, path, "ins, imu, gnss, hand, vicon or body");
  const PoseFile& lidar = only_one(files, is_lidar, path, "lidar, camera, cam, odom or laser");
  progress.report("reading poses", 0, 2);
  session.world_from_ins = read_pose_file(ins.path, ins.format, session.findings);
  session.ins_axes = axes_of(ins.format);
  session.attitudes_to_true_north = counts_from_true_north(ins.format);
  progress.report("reading poses", 1, 2);
  session.odometry_from_lidar = read_pose_file(lidar.path, lidar.format, session.findings);
  session.files = {ins.path, lidar.path};
  align_lidar_clock(session, ClockUse::Shared);
  return session;
}

}  // namespace remount
