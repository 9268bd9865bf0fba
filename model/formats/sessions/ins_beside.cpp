#include "model/formats/sessions/ins_beside.h"

#include <algorithm>
#include <array>

#include "algorithms/core/error.h"
#include "messages/captures.h"
#include "model/formats/ins/ins_log.h"
#include "model/formats/ins/nmea_log.h"
#include "model/formats/poses/gpx_track.h"
#include "model/formats/poses/pose_file.h"
#include "model/formats/poses/rtklib_solution.h"
#include "model/formats/sessions/motion_logs.h"
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

/// Logs among files by their kind, in the order in which they are taken.
struct LogsBeside {
  NovatelLogs novatel;
  std::vector<fs::path> raw_imu;  ///< of NovAtel, alone
  std::vector<fs::path> whole, nmea, rtklib, gpx, poses;

  explicit LogsBeside(const std::vector<fs::path>& files) {
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
    raw_imu = part_raw_imu(novatel, !best().empty());
  }

  /// The kind that is taken where none of NovAtel's is; empty where there is none.
  const std::vector<fs::path>& best() const {
    const std::array kinds{&whole, &nmea, &rtklib, &gpx, &poses};
    const auto first = std::ranges::find_if(kinds, [](const auto* kind) { return !kind->empty(); });
    return first == kinds.end() ? poses : **first;
  }

  /// All that are not of the kind that is taken.
  std::vector<fs::path> others(bool novatel_taken) const {
    std::vector<fs::path> others;
    if (!novatel_taken)
      for (const auto& [path, format] : novatel) others.push_back(path);
    for (const auto* kind : {&whole, &nmea, &rtklib, &gpx, &poses})
      if (novatel_taken || kind != &best()) others.insert(others.end(), kind->begin(), kind->end());
    return others;
  }
};

/// The log of the kind that is taken.
void read_beside(const LogsBeside& logs, const fs::path& log, drive::Session& session) {
  if (!logs.whole.empty()) {
    take_ins_log(*ins_log_kind(log), log, session);
    return;
  }
  session.files.push_back(log);
  if (!logs.nmea.empty()) {
    NmeaLog nmea = read_nmea(log, session.findings);
    session.gnss = std::move(nmea.fixes);
    session.ins = std::move(nmea.ins);
    session.ins_position_lag_sigma_s = nmea.position_lag_sigma_s;
  } else if (!logs.rtklib.empty()) {
    session.gnss = read_rtklib(log, session.findings);
  } else if (!logs.gpx.empty()) {
    session.gnss = read_gpx(log, session.findings);
  } else {
    read_poses(log, session);
  }
}

}  // namespace

bool read_ins_beside(const std::vector<fs::path>& files, const fs::path& where, drive::Session& session) {
  const LogsBeside logs(files);
  const bool novatel = !logs.novatel.empty() && !only_post_processed(logs.whole);
  fs::path taken;
  if (novatel) {
    taken = read_best_novatel(logs.novatel, logs.raw_imu, session);
  } else {
    if (logs.best().empty()) return false;
    refuse_several(logs.best(), where);
    taken = logs.best().front();
    read_beside(logs, taken, session);
  }
  tell_passed_over(taken, logs.others(novatel), session);
  return true;
}

}  // namespace remount::formats
