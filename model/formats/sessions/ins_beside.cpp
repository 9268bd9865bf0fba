#include "model/formats/sessions/ins_beside.h"

#include "algorithms/core/error.h"
#include "messages/captures.h"
#include "model/formats/ins/ins_log.h"
#include "model/formats/ins/nmea_log.h"
#include "model/formats/poses/gpx_track.h"
#include "model/formats/poses/pose_file.h"
#include "model/formats/poses/rtklib_solution.h"
#include "model/formats/sessions/novatel_reader.h"

namespace remount::formats {

namespace fs = std::filesystem;

namespace {

void refuse_several(const std::vector<fs::path>& logs, const fs::path& where) {
  if (logs.size() > 1)
    throw Error(ErrorCode::Unsupported, where.string(),
                say::capture_several_logs(logs[0].filename().string(), logs[1].filename().string()));
}

void read_poses(const fs::path& file, drive::Session& session) {
  const PoseFormat format = *recognise_pose_file(file);
  session.world_from_ins = read_pose_file(file, format, session.findings);
  session.ins_axes = axes_of(format);
  session.attitudes_to_true_north = counts_from_true_north(format);
}

}  // namespace

bool read_ins_beside(const std::vector<fs::path>& files, const fs::path& where, drive::Session& session) {
  NovatelLogs novatel;
  std::vector<fs::path> whole, nmea, rtklib, gpx, poses;
  for (const fs::path& file : files) {
    if (const auto format = recognise_novatel(file))
      novatel.emplace_back(file, *format);
    else if (ins_log_kind(file))
      whole.push_back(file);
    else if (recognise_nmea(file))
      nmea.push_back(file);
    else if (recognise_rtklib(file))
      rtklib.push_back(file);
    else if (recognise_gpx(file))
      gpx.push_back(file);
    else if (recognise_pose_file(file))
      poses.push_back(file);
  }
  if (!novatel.empty()) {
    read_best_novatel(novatel, session);
    return true;
  }
  const std::vector<fs::path>& logs = !whole.empty()    ? whole
                                      : !nmea.empty()   ? nmea
                                      : !rtklib.empty() ? rtklib
                                      : !gpx.empty()    ? gpx
                                                        : poses;
  if (logs.empty()) return false;
  refuse_several(logs, where);
  if (!whole.empty()) {
    take_ins_log(*ins_log_kind(logs.front()), logs.front(), session);
    return true;
  }
  session.files.push_back(logs.front());
  if (!nmea.empty()) {
    NmeaLog log = read_nmea(logs.front(), session.findings);
    session.gnss = std::move(log.fixes);
    session.ins = std::move(log.ins);
    session.ins_position_lag_sigma_s = log.position_lag_sigma_s;
  } else if (!rtklib.empty()) {
    session.gnss = read_rtklib(logs.front(), session.findings);
  } else if (!gpx.empty()) {
    session.gnss = read_gpx(logs.front(), session.findings);
  } else {
    read_poses(logs.front(), session);
  }
  return true;
}

}  // namespace remount::formats
