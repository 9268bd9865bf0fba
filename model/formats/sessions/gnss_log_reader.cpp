#include "model/formats/sessions/gnss_log_reader.h"

#include "algorithms/core/error.h"
#include "messages/ins_logs.h"
#include "messages/stages.h"
#include "model/drive/bad_items.h"
#include "model/formats/files/input_file.h"
#include "model/formats/ins/nmea_log.h"
#include "model/formats/ins/novatel_log.h"
#include "model/formats/ins/sbf_file.h"
#include "model/formats/ins/sensor_tables.h"
#include "model/formats/poses/gpx_track.h"
#include "model/formats/poses/pose_file.h"
#include "model/formats/poses/pose_pairing.h"
#include "model/formats/poses/rtklib_solution.h"
#include "model/formats/sessions/motion_logs.h"

namespace remount::formats {

namespace fs = std::filesystem;

namespace {

struct GnssContents {
  std::vector<fs::path> nmea, rtklib, gpx;
  std::vector<std::pair<fs::path, PoseFormat>> poses;
};

GnssContents examine_gnss(const fs::path& path) {
  GnssContents contents;
  const std::vector<fs::path> files = is_file(path) ? std::vector<fs::path>{path} : files_in(path);
  for (const fs::path& file : files) {
    if (recognise_nmea(file))
      contents.nmea.push_back(file);
    else if (recognise_rtklib(file))
      contents.rtklib.push_back(file);
    else if (recognise_gpx(file))
      contents.gpx.push_back(file);
    else if (const auto poses = recognise_pose_file(file))
      contents.poses.emplace_back(file, *poses);
  }
  return contents;
}

/// The only one of a kind. Throws Error(Unsupported) that names two where there are several.
template <class Item, class Name>
const Item& only(const std::vector<Item>& items, const fs::path& folder,
                 Message (*several)(std::string one, std::string other), Name&& name) {
  if (items.size() > 1) throw Error(ErrorCode::Unsupported, folder.string(), several(name(items[0]), name(items[1])));
  return items.front();
}

}  // namespace

int GnssLogReader::probe(const fs::path& path) const {
  if (!is_file(path) && !is_folder(path)) return 0;
  const GnssContents contents = examine_gnss(path);
  if (contents.nmea.empty() && contents.rtklib.empty() && contents.gpx.empty()) return 0;
  return contents.poses.empty() ? 50 : 75;
}

drive::Session GnssLogReader::open(const fs::path& path, Progress& progress) const {
  const GnssContents contents = examine_gnss(path);
  drive::Session session;
  session.name = (path.has_filename() ? path : path.parent_path()).filename().string();
  session.path = path;
  session.format = id();
  progress.report(say::stage_reading_gnss, 0, 2);
  const auto file_name = [](const fs::path& file) { return file.filename().string(); };
  if (!contents.nmea.empty()) {
    session.files.push_back(only(contents.nmea, path, say::gnss_several_nmea, file_name));
    NmeaLog log = read_nmea(session.files.back(), session.findings);
    session.gnss = std::move(log.fixes);
    session.ins = std::move(log.ins);
    session.ins_position_lag_sigma_s = log.position_lag_sigma_s;
  } else if (!contents.rtklib.empty()) {
    session.files.push_back(only(contents.rtklib, path, say::gnss_several_rtklib, file_name));
    session.gnss = read_rtklib(session.files.back(), session.findings);
  } else if (!contents.gpx.empty()) {
    session.files.push_back(only(contents.gpx, path, say::gnss_several_gpx, file_name));
    session.gnss = read_gpx(session.files.back(), session.findings);
  } else {
    throw Error(ErrorCode::Format, path.string(), say::gnss_no_log());
  }
  std::vector<fs::path> others;
  for (const auto* logs : {&contents.nmea, &contents.rtklib, &contents.gpx})
    if (!logs->empty() && logs->front() != session.files.front())
      others.insert(others.end(), logs->begin(), logs->end());
  tell_passed_over(session.files.front(), others, session);
  progress.report(say::stage_reading_poses, 1, 2);
  if (contents.poses.empty()) {
    session.findings.push_back(
        drive::make_finding(drive::Severity::Problem, "one-stream", path.string(), say::gnss_half_a_session()));
    return session;
  }
  const auto& [file, format] =
      only(contents.poses, path, say::gnss_several_poses, [&](const auto& poses) { return file_name(poses.first); });
  session.odometry_from_lidar = read_pose_file(file, format, session.findings);
  session.files.push_back(file);
  if (!session.ins.empty()) align_lidar_clock(session, ClockUse::Shared);
  return session;
}

std::vector<motion::GnssFix> read_gnss(const fs::path& path, std::vector<drive::Finding>& findings) {
  if (recognise_nmea(path)) return read_nmea(path, findings).fixes;
  if (recognise_rtklib(path)) return read_rtklib(path, findings);
  if (recognise_gpx(path)) return read_gpx(path, findings);
  if (recognise_novatel(path) == NovatelFormat::Log) return read_novatel_fixes(path, findings);
  if (recognise_sbf(path)) return read_sbf_fixes(path, findings);
  return read_gnss_table(path, findings);
}

}  // namespace remount::formats
