#include "model/formats/sessions/kitti_raw_reader.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "algorithms/core/median.h"
#include "algorithms/core/stamps.h"
#include "messages/files.h"
#include "messages/general.h"
#include "messages/ins_logs.h"
#include "messages/sessions.h"
#include "messages/stages.h"
#include "model/drive/attitude_convention.h"
#include "model/drive/bad_items.h"
#include "model/drive/plausible_values.h"
#include "model/drive/stamped_streams.h"
#include "model/formats/clouds/timed_scans.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/listed_files.h"
#include "model/formats/files/numbered_file.h"
#include "model/formats/files/text_file.h"
#include "model/formats/files/time_stamp.h"
#include "model/formats/sessions/line_stamps.h"
#include "model/formats/sessions/several_sessions.h"

namespace remount::formats {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kOxtsFields = 30;
constexpr std::size_t kPositionAccuracy = 23;
constexpr int kSearchDepth = 3;
constexpr std::size_t kMaxFolders = 2000;
constexpr std::size_t kMaxOxtsBytes = 64 * 1024;

bool is_drive(const fs::path& folder) {
  return is_file(folder / "oxts" / "timestamps.txt") && is_folder(folder / "oxts" / "data") &&
         is_folder(folder / "velodyne_points" / "data");
}

std::vector<fs::path> find_drives(const fs::path& path) {
  std::vector<fs::path> drives;
  std::vector<std::pair<fs::path, int>> waiting{{path, 0}};
  for (std::size_t i = 0; i < waiting.size() && i < kMaxFolders; ++i) {
    const auto [folder, depth] = waiting[i];
    if (is_drive(folder)) {
      drives.push_back(folder);
    } else if (depth < kSearchDepth) {
      for (const fs::path& child : directories_in(folder))
        if (may_look_into(child)) waiting.emplace_back(child, depth + 1);  // else no drive of ours: lost+found, say
    }
  }
  return drives;
}

std::vector<std::optional<std::int64_t>> read_stamps(const fs::path& path, std::vector<drive::Finding>& findings) {
  drive::BadItems bad;
  std::vector<std::optional<std::int64_t>> stamps = read_line_stamps(path, parse_date_ns, say::kitti_date(), bad);
  bad.report(findings, "bad-stamps", path.string(), say::left_out_time_stamps);
  return stamps;
}

constexpr std::size_t kDigits = 10;

/// @param largest_angle out: of yaw, pitch and roll, whatever their unit
motion::InsSample read_oxts(const fs::path& path, std::int64_t stamp_ns, double& largest_angle) {
  const std::string text = read_text_file(path, kMaxOxtsBytes);
  std::vector<std::string_view> tokens;
  LineReader lines(text);
  std::string_view line;
  lines.next(line);
  split_blanks(line, tokens);
  if (tokens.size() < kOxtsFields)
    throw Error(ErrorCode::Format, at_line(path, 1), say::kitti_numbers(tokens.size(), kOxtsFields));
  const auto number = [&](std::size_t i) {
    return require_number(
        tokens[i], [&] { return say::kitti_field(i); }, path, 1);
  };
  motion::InsSample sample;
  sample.stamp_ns = stamp_ns;
  sample.latitude_rad = degrees_to_radians(number(0));
  sample.longitude_rad = degrees_to_radians(number(1));
  sample.height_m = number(2);
  if (!drive::plausible_geodetic(sample.latitude_rad, sample.longitude_rad, sample.height_m))
    throw Error(ErrorCode::Format, at_line(path, 1), say::log_place_impossible());
  const drive::AttitudeAngles angles{number(5), number(4), number(3)};
  for (const double angle : {angles.yaw_rad, angles.pitch_rad, angles.roll_rad})
    if (drive::angle_means_not_known(angle))
      throw Error(ErrorCode::Format, at_line(path, 1), say::kitti_angles_not_known());
  largest_angle = std::max({std::abs(angles.yaw_rad), std::abs(angles.pitch_rad), std::abs(angles.roll_rad)});
  sample.enu_from_ins = drive::enu_from_ins(angles, drive::AttitudeConvention::EnuYaw);
  const double accuracy_m = number(kPositionAccuracy);
  if (accuracy_m > 0.0 && !drive::means_not_known(accuracy_m)) sample.sigma.position_enu_m.setConstant(accuracy_m);
  return sample;
}

void read_all_oxts(const fs::path& drive, const std::vector<std::optional<std::int64_t>>& stamps,
                   drive::Session& session, Progress& progress) {
  drive::BadItems bad;
  std::size_t beyond = 0;
  double largest_angle = 0.0;
  for (std::size_t i = 0; i < stamps.size(); ++i) {
    if (i % 1000 == 0) progress.report(say::stage_reading_ins, i, stamps.size());
    if (progress.cancelled()) return;
    const fs::path file = numbered_file(drive / "oxts" / "data", i, kDigits, ".txt");
    try {
      if (!stamps[i]) throw Error(ErrorCode::Format, file.string(), say::kitti_no_stamp());
      double angle = 0.0;
      session.ins.push_back(read_oxts(file, *stamps[i], angle));
      beyond += angle > 2.0 * kPi + 0.01;
      largest_angle = std::max(largest_angle, angle);
      session.files.push_back(file);
    } catch (const Error& error) {
      bad.add(error);
    }
  }
  if (session.ins.empty())
    throw Error(ErrorCode::Format, (drive / "oxts").string(),
                Message::sequence({say::ins_none_usable(),
                                   say::file_first_problem(bad.count() > 0 ? bad.first() : say::kitti_no_stamps())}));
  // A few are glitches of the log.
  if (100 * beyond > session.ins.size())
    throw Error(ErrorCode::Format, (drive / "oxts").string(), say::kitti_degrees(largest_angle));
  bad.report(session.findings, "bad-ins", (drive / "oxts").string(), say::left_out_ins_files);
  drive::keep_near(session.ins, (drive / "oxts").string(), session.findings);
  drive::keep_ascending(session.ins, "ins", (drive / "oxts").string(), session.findings);
}

std::vector<drive::ScanFile> list_scans(const fs::path& drive, const std::vector<std::optional<std::int64_t>>& stamps,
                                        drive::Session& session) {
  const fs::path data = drive / "velodyne_points" / "data";
  std::vector<drive::ScanFile> scans;
  drive::BadItems bad;
  ListedFiles listed;
  for (std::size_t i = 0; i < stamps.size(); ++i) {
    fs::path file = numbered_file(data, i, kDigits, ".bin");
    if (!listed.has(file)) file.replace_extension(".txt");
    if (!listed.has(file))
      bad.add(say::of_file(file.replace_extension(".bin").string(), say::kitti_scan_missing()));
    else if (!stamps[i])
      bad.add(say::of_file(file.string(), say::kitti_no_stamp()));
    else
      scans.push_back({file, *stamps[i]});
  }
  const std::size_t files = listed.count_in(data);
  if (files > stamps.size())
    session.findings.push_back(drive::make_finding(drive::Severity::Warning, "scans-without-stamp", data.string(),
                                                   say::kitti_without_stamp(files - stamps.size())));
  bad.report(session.findings, "missing-scans", data.string(), say::left_out_scans);
  if (scans.empty()) throw Error(ErrorCode::Format, data.string(), say::kitti_no_scan());
  drive::keep_ascending(scans, "scan", data.string(), session.findings);
  return scans;
}

/// Whether scan and INS sample of one number are of one time: as many of both, and their own stamps never further apart
/// than half a scan. Otherwise numbers were lost or given anew, and this is said; empty where they agree.
Message numbers_disagree(const std::vector<std::optional<std::int64_t>>& oxts,
                         const std::vector<std::optional<std::int64_t>>& velodyne) {
  constexpr double kHalfAScan_s = 0.06;
  if (oxts.size() != velodyne.size()) return say::kitti_counts_differ(velodyne.size(), oxts.size());
  std::size_t apart = 0, both = 0;
  for (std::size_t i = 0; i < oxts.size(); ++i) {
    if (!oxts[i] || !velodyne[i]) continue;
    ++both;
    apart += std::abs(seconds(*velodyne[i] - *oxts[i])) > kHalfAScan_s ? 1 : 0;
  }
  return apart == 0 ? Message() : say::kitti_stamps_apart(apart, both);
}

/// The scans of `sync` take the OXTS stamps of their numbers, where these are of one time; how far their own differ is
/// worth knowing.
std::vector<std::optional<std::int64_t>> stamps_by_number(const std::vector<std::optional<std::int64_t>>& oxts,
                                                          const std::vector<std::optional<std::int64_t>>& velodyne,
                                                          drive::Session& session) {
  if (Message why = numbers_disagree(oxts, velodyne); !why.empty()) {
    session.findings.push_back(drive::make_finding(drive::Severity::Warning, "stamps-not-by-number",
                                                   std::string("velodyne_points/timestamps.txt"), std::move(why)));
    return velodyne;
  }
  std::vector<std::optional<std::int64_t>> stamps = velodyne;
  std::vector<double> differences_s;
  for (std::size_t i = 0; i < stamps.size(); ++i) {
    if (!oxts[i]) continue;
    if (velodyne[i]) differences_s.push_back(seconds(*velodyne[i] - *oxts[i]));
    stamps[i] = oxts[i];
  }
  if (differences_s.empty()) return stamps;
  const double median = median_of(differences_s);
  if (std::abs(median) > 1e-3)
    session.findings.push_back(drive::make_finding(drive::Severity::Note, "stamps-by-number",
                                                   std::string("velodyne_points/timestamps.txt"),
                                                   say::kitti_by_number(Duration{median})));
  return stamps;
}

double turn_period_s(const fs::path& drive, const std::vector<drive::ScanFile>& scans,
                     std::vector<drive::Finding>& findings) {
  const fs::path start = drive / "velodyne_points" / "timestamps_start.txt",
                 end = drive / "velodyne_points" / "timestamps_end.txt";
  std::vector<double> periods;
  if (is_file(start) && is_file(end)) {
    const auto starts = read_stamps(start, findings), ends = read_stamps(end, findings);
    for (std::size_t i = 0; i < std::min(starts.size(), ends.size()); ++i)
      if (starts[i] && ends[i] && *ends[i] > *starts[i]) periods.push_back(seconds(*ends[i] - *starts[i]));
  }
  double period = drive::median_period_s(scans);
  if (!periods.empty()) period = median_of(std::move(periods));
  // The sensor turns 5 to 20 times a second; anything else is a gap or a broken file.
  return period > 0.04 && period < 0.25 ? period : 0.1;
}

/// ins_from_lidar of calib_imu_to_velo.txt beside the drive, which holds velo_from_imu.
void read_calibration(const fs::path& drive, drive::Session& session) {
  for (const fs::path& folder : {drive.parent_path(), drive.parent_path().parent_path()}) {
    const fs::path file = folder / "calib_imu_to_velo.txt";
    if (!is_file(file)) continue;
    try {
      const std::string text = read_text_file(file, kMaxManifestBytes);
      std::map<std::string, std::vector<double>> entries;
      std::vector<std::string_view> tokens;
      LineReader lines(text);
      for (std::string_view line; lines.next(line);) {
        split_blanks(line, tokens);
        if (tokens.empty() || (tokens[0] != "R:" && tokens[0] != "T:")) continue;
        auto& numbers = entries[std::string(tokens[0])];
        for (std::size_t i = 1; i < tokens.size(); ++i)
          numbers.push_back(require_number(tokens[i], say::kitti_calibration_entry, file, lines.line_number()));
      }
      const auto &r = entries["R:"], &t = entries["T:"];
      if (r.size() != 9 || t.size() != 3) throw Error(ErrorCode::Format, file.string(), say::kitti_calibration());
      Eigen::Matrix3d rotation;
      rotation << r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8];
      double defect = 0.0;
      rotation = drive::checked_rotation(rotation, file.string(), defect);
      session.nominal_ins_from_lidar = make_rigid(rotation, {t[0], t[1], t[2]}).inverse();
      session.files.push_back(file);
      session.findings.push_back(
          drive::make_finding(drive::Severity::Note, "nominal-found", file.string(), say::kitti_nominal()));
    } catch (const Error& error) {
      session.findings.push_back(
          drive::make_finding(drive::Severity::Warning, "nominal-unreadable", file.string(), drive::message_of(error)));
    }
    return;
  }
}

}  // namespace

int KittiRawReader::probe(const fs::path& path) const {
  if (!is_folder(path)) return 0;
  return find_drives(path).empty() ? 0 : 90;
}

drive::Session KittiRawReader::open(const fs::path& path, Progress& progress) const {
  const std::vector<fs::path> drives = find_drives(path);
  if (drives.empty()) throw Error(ErrorCode::Format, path.string(), say::kitti_no_drive());
  if (drives.size() > 1) throw SeveralSessions(path, say::kitti_several(drives.size(), lines_of(drives)), drives);
  const fs::path drive = drives.front();
  fs::path named = drive.lexically_normal();
  if (named.filename().empty() || named.filename() == ".") named = fs::absolute(drive).lexically_normal();
  if (named.filename().empty()) named = named.parent_path();
  drive::Session session;
  session.name = named.filename().string();
  session.path = path;
  session.format = id();
  session.files = {drive / "oxts" / "timestamps.txt", drive / "velodyne_points" / "timestamps.txt"};
  const auto oxts_stamps = read_stamps(session.files[0], session.findings);
  auto scan_stamps = read_stamps(session.files[1], session.findings);
  const bool extract = session.name.ends_with("_extract");
  if (!extract) scan_stamps = stamps_by_number(oxts_stamps, scan_stamps, session);
  read_all_oxts(drive, oxts_stamps, session, progress);
  if (progress.cancelled()) return session;
  std::vector<drive::ScanFile> scans = list_scans(drive, scan_stamps, session);
  for (const drive::ScanFile& scan : scans) session.files.push_back(scan.path);
  session.scan_timing = drive::ScanTiming::SweepAzimuth;
  session.sweep = {turn_period_s(drive, scans, session.findings), 0.0, false, extract};
  session.sweep.direction_known = false;
  session.scans = std::make_shared<FileScanSource>(std::move(scans));
  read_calibration(drive, session);
  return session;
}

}  // namespace remount::formats
