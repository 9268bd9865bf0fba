#include "model/formats/sessions/kitti_odometry_reader.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "algorithms/core/stamps.h"
#include "messages/poses.h"
#include "messages/sessions.h"
#include "messages/stages.h"
#include "model/conventions/impossible_motion.h"
#include "model/drive/bad_items.h"
#include "model/drive/plausible_values.h"
#include "model/drive/stamped_streams.h"
#include "model/formats/clouds/timed_scans.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/listed_files.h"
#include "model/formats/files/numbered_file.h"
#include "model/formats/files/text_file.h"
#include "model/formats/sessions/line_stamps.h"
#include "model/formats/sessions/several_sessions.h"

namespace remount::formats {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMatrixNumbers = 12;
constexpr std::size_t kMostSequences = 1000;

/// Stamps by their numbers; a line that cannot be read has none.
using SequenceTimes = std::vector<std::optional<std::int64_t>>;

bool is_sequence(const fs::path& folder) { return is_file(folder / "times.txt") && is_folder(folder / "velodyne"); }

/// The folder itself, or those below it or below its `sequences`.
std::vector<fs::path> find_sequences(const fs::path& path) {
  if (is_sequence(path)) return {path};
  std::vector<fs::path> sequences;
  for (const fs::path& parent : {path, path / "sequences", path / "dataset" / "sequences"}) {
    for (const fs::path& child : directories_in(parent))
      if (sequences.size() < kMostSequences && may_look_into(child) && is_sequence(child)) sequences.push_back(child);
    if (!sequences.empty()) break;
  }
  return sequences;
}

fs::path normal_path(const fs::path& folder) {
  fs::path plain = fs::absolute(folder).lexically_normal();
  return plain.filename().empty() ? plain.parent_path() : plain;
}

SequenceTimes read_sequence_times(const fs::path& path, std::vector<drive::Finding>& findings) {
  drive::BadItems bad;
  SequenceTimes times = read_line_stamps(path, parse_seconds_ns, say::kitti_odometry_time(), bad);
  if (times.empty()) throw Error(ErrorCode::Format, path.string(), bad.after(say::kitti_odometry_no_times()));
  bad.report(findings, "bad-stamps", path.string(), say::left_out_time_stamps);
  return times;
}

/// Twelve numbers from token `first` on, row by row. @param defect out: how far the rotation is off, where that is more
RigidTransform read_matrix_row(const std::vector<std::string_view>& tokens, std::size_t first, const fs::path& path,
                               std::size_t line, double& defect) {
  if (tokens.size() != first + kMatrixNumbers)
    throw Error(ErrorCode::Format, at_line(path, line),
                say::kitti_odometry_numbers(tokens.size() - std::min(first, tokens.size()), kMatrixNumbers));
  Eigen::Matrix<double, 3, 4> matrix;
  for (std::size_t i = 0; i < kMatrixNumbers; ++i) {
    const double value = require_number(
        tokens[first + i], [&] { return say::pose_field(i + 1); }, path, line);
    if (std::abs(value) > conventions::kFarthestPosition_m)
      throw Error(ErrorCode::Format, at_line(path, line), say::pose_field_beyond(i + 1));
    matrix(static_cast<int>(i / 4), static_cast<int>(i % 4)) = value;
  }
  double own_defect = 0.0;
  const Eigen::Matrix3d rotation = drive::checked_rotation(matrix.leftCols<3>(), at_line(path, line), own_defect);
  defect = std::max(defect, own_defect);
  return make_rigid(rotation, matrix.col(3));
}

RigidTransform flu_from_camera() { return make_rigid(forward_left_up_from_camera(), Eigen::Vector3d::Zero()); }

struct SequencePoses {
  fs::path file;
  bool of_scans = false;  ///< poses.txt of SemanticKITTI: SuMa made them of the scans
};

std::optional<SequencePoses> find_camera_poses(const fs::path& sequence) {
  const fs::path named = sequence.filename().string() + ".txt";
  for (const fs::path& file :
       {sequence.parent_path().parent_path() / "poses" / named, sequence.parent_path() / "poses" / named})
    if (is_file(file)) return SequencePoses{file, false};
  if (is_file(sequence / "poses.txt")) return SequencePoses{sequence / "poses.txt", true};
  return std::nullopt;
}

/// Line i is of time i, as it stands; one that is empty is no pose.
void read_camera_poses(const fs::path& path, const SequenceTimes& times, drive::Session& session) {
  constexpr double kNotableDefect = 1e-3;
  const std::string text = read_text_file(path);
  std::vector<std::string_view> tokens;
  drive::BadItems bad;
  double defect = 0.0;
  std::size_t number = 0, without_time = 0;
  LineReader lines(text);
  const RigidTransform flu_from_cam = flu_from_camera(), cam_from_flu = flu_from_cam.inverse();
  for (std::string_view line; lines.next(line); ++number) {
    split_blanks(line, tokens);
    if (tokens.empty()) continue;
    if (number >= times.size() || !times[number]) {
      ++without_time;
      continue;
    }
    try {
      const RigidTransform first_cam_from_cam = read_matrix_row(tokens, 0, path, lines.line_number(), defect);
      session.world_from_ins.push_back({*times[number], flu_from_cam * first_cam_from_cam * cam_from_flu});
    } catch (const Error& error) {
      bad.add(error);
    }
  }
  if (session.world_from_ins.empty())
    throw Error(ErrorCode::Format, path.string(), bad.after(say::kitti_odometry_no_poses()));
  session.files.push_back(path);
  bad.report(session.findings, "bad-poses", path.string(), say::left_out_lines);
  if (defect > kNotableDefect)
    session.findings.push_back(drive::make_finding(drive::Severity::Warning, "rotation-not-orthonormal", path.string(),
                                                   say::pose_not_orthonormal(defect)));
  if (without_time > 0)
    session.findings.push_back(drive::make_finding(drive::Severity::Warning, "poses-without-time", path.string(),
                                                   say::kitti_odometry_without_time(without_time)));
  drive::keep_ascending(session.world_from_ins, "pose", path.string(), session.findings);
}

constexpr std::size_t kScanDigits = 6;

void list_scans_by_number(const fs::path& sequence, const SequenceTimes& times, drive::Session& session) {
  const fs::path data = sequence / "velodyne";
  std::vector<drive::ScanFile> scans;
  drive::BadItems bad;
  ListedFiles listed;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const fs::path file = numbered_file(data, i, kScanDigits, ".bin");
    if (!listed.has(file))
      bad.add(say::of_file(file.string(), say::kitti_scan_missing()));
    else if (times[i])
      scans.push_back({file, *times[i]});
  }
  bad.report(session.findings, "missing-scans", data.string(), say::left_out_scans);
  if (const std::size_t without = listed.count_in(data) - scans.size(); without > 0)
    session.findings.push_back(drive::make_finding(drive::Severity::Warning, "scans-without-stamp", data.string(),
                                                   say::kitti_without_stamp(without)));
  if (scans.empty()) throw Error(ErrorCode::Format, data.string(), bad.after(say::kitti_no_scan()));
  drive::keep_ascending(scans, "scan", data.string(), session.findings);
  for (const drive::ScanFile& scan : scans) session.files.push_back(scan.path);
  session.scans = std::make_shared<FileScanSource>(std::move(scans), CloudFormat::KittiBin, TimesOfPoints::Unused);
}

/// Whether it is `Tr` of a sequence that the benchmark published: sequences 00 to 02, 03, and 04 to 12, each set of one
/// day of recording. No two calibrations agree in so many digits, so the scans are the benchmark's own.
bool is_published_calibration(const RigidTransform& camera_from_lidar) {
  constexpr double kNear = 1e-6;  // published with more digits, and made orthonormal while it is read
  // Rows 1 and 2 of the first column, and the place of the LiDAR, of each.
  constexpr double kPublished[][5] = {
      {4.276802385584e-04, -7.210626507497e-03, -1.198459927713e-02, -5.403984729748e-02, -2.921968648686e-01},
      {2.347736981471e-04, 1.044940741659e-02, -2.796816941295e-03, -7.510879138296e-02, -2.721327964059e-01},
      {-1.857739385241e-03, -6.481465826011e-03, -4.784029760483e-03, -7.337429464231e-02, -3.339968064433e-01}};
  const Eigen::Matrix4d m = camera_from_lidar.matrix();
  const double own[] = {m(0, 0), m(1, 0), m(0, 3), m(1, 3), m(2, 3)};
  return std::any_of(std::begin(kPublished), std::end(kPublished), [&](const auto& published) {
    return std::equal(std::begin(own), std::end(own), std::begin(published),
                      [](double a, double b) { return std::abs(a - b) < kNear; });
  });
}

/// The benchmark's own scans are compensated; others that are laid out alike may be or not, and have no times.
void settle_scan_timing(const std::optional<RigidTransform>& camera_from_lidar, drive::Session& session) {
  session.scan_timing = drive::ScanTiming::Instant;
  if (camera_from_lidar && is_published_calibration(*camera_from_lidar)) return;
  session.scan_timing = drive::ScanTiming::Unknown;
  session.findings.push_back(drive::make_finding(drive::Severity::Warning, "no-point-times", session.scans->name(0),
                                                 say::kitti_odometry_no_times_of_points()));
}

/// "Tr:" of calib.txt; nothing where the file has none, as that of the images alone. Throws Error(Format).
std::optional<RigidTransform> camera_from_lidar_in(const fs::path& file) {
  const std::string text = read_text_file(file, kMaxManifestBytes);
  std::vector<std::string_view> tokens;
  LineReader lines(text);
  for (std::string_view line; lines.next(line);) {
    split_blanks(line, tokens);
    if (tokens.empty() || (tokens[0] != "Tr:" && tokens[0] != "Tr")) continue;
    double defect = 0.0;
    return read_matrix_row(tokens, 1, file, lines.line_number(), defect);
  }
  return std::nullopt;
}

/// @return Tr, where there is one
std::optional<RigidTransform> read_lidar_calibration(const fs::path& sequence, drive::Session& session) {
  const fs::path file = sequence / "calib.txt";
  std::optional<RigidTransform> camera_from_lidar;
  const auto tell = [&](drive::Severity severity, const char* code, Message words) {
    session.findings.push_back(drive::make_finding(severity, code, file.string(), std::move(words)));
  };
  if (!is_file(file)) {
    tell(drive::Severity::Warning, "no-nominal", say::kitti_odometry_no_calibration());
    return std::nullopt;
  }
  try {
    camera_from_lidar = camera_from_lidar_in(file);
    session.files.push_back(file);
    if (camera_from_lidar) session.nominal_ins_from_lidar = flu_from_camera() * *camera_from_lidar;
    if (camera_from_lidar)
      tell(drive::Severity::Note, "nominal-found", say::kitti_odometry_nominal());
    else
      tell(drive::Severity::Warning, "no-nominal", say::kitti_odometry_no_tr());
  } catch (const Error& error) {
    tell(drive::Severity::Warning, "nominal-unreadable", drive::message_of(error));
  }
  return camera_from_lidar;
}

}  // namespace

Eigen::Matrix3d forward_left_up_from_camera() {
  Eigen::Matrix3d flu_from_camera;
  flu_from_camera << 0, 0, 1,  //
      -1, 0, 0,                //
      0, -1, 0;
  return flu_from_camera;
}

int KittiOdometryReader::probe(const fs::path& path) const {
  if (!is_folder(path)) return 0;
  return find_sequences(path).empty() ? 0 : 90;
}

drive::Session KittiOdometryReader::open(const fs::path& path, Progress& progress) const {
  const std::vector<fs::path> sequences = find_sequences(path);
  if (sequences.empty()) throw Error(ErrorCode::Format, path.string(), say::kitti_odometry_no_sequence());
  if (sequences.size() > 1)
    throw SeveralSessions(path, say::kitti_odometry_several(sequences.size(), lines_of(sequences)), sequences);
  const fs::path sequence = normal_path(sequences.front());
  drive::Session session;
  session.name = sequence.filename().string();
  session.path = path;
  session.format = id();
  progress.report(say::stage_reading_poses, 0, 2);
  const fs::path times_file = sequences.front() / "times.txt";
  session.files = {times_file};
  const SequenceTimes times = read_sequence_times(times_file, session.findings);
  const std::optional<SequencePoses> poses = find_camera_poses(sequence);
  if (poses) {
    read_camera_poses(poses->file, times, session);
    session.findings.push_back(drive::make_finding(
        poses->of_scans ? drive::Severity::Warning : drive::Severity::Note, "poses-by-mounting", poses->file.string(),
        poses->of_scans ? say::kitti_odometry_poses_of_scans() : say::kitti_odometry_poses_of_camera()));
  } else {
    session.findings.push_back(drive::make_finding(drive::Severity::Problem, "one-stream", sequence.string(),
                                                   say::kitti_odometry_half_a_session(session.name + ".txt")));
  }
  progress.report(say::stage_listing_scans, 1, 2);
  list_scans_by_number(sequences.front(), times, session);
  settle_scan_timing(read_lidar_calibration(sequences.front(), session), session);
  return session;
}

}  // namespace remount::formats
