#include "model/formats/sessions/native_declared.h"

#include <cmath>
#include <optional>

#include "algorithms/geometry/rotation.h"
#include "messages/sessions.h"
#include "model/conventions/week_rollover.h"
#include "model/formats/files/number_text.h"
#include "model/formats/ins/ins_log.h"
#include "model/formats/ins/nmea_log.h"
#include "model/formats/ins/novatel_log.h"
#include "model/formats/packets/capture_index.h"
#include "model/formats/packets/capture_records.h"
#include "model/formats/packets/capture_scans.h"

namespace remount::formats {
namespace {

void read_noise(const DocumentView& node, drive::Session& session) {
  node.allow_only(
      {"position_sigma_m", "attitude_sigma_deg", "attitude_bias_sigma_deg", "position_drift_m", "attitude_drift_deg"});
  const auto read = [&](const char* key, double unit, double& sigma) {
    const auto value = node.find(key);
    if (!value) return;
    sigma = value->number() * unit;
    if (sigma < 0.0) value->fail(say::native_negative_sigma());
  };
  read("position_sigma_m", 1.0, session.ins_position_white_sigma_m);
  read("attitude_sigma_deg", kPi / 180.0, session.ins_attitude_white_sigma_rad);
  read("attitude_bias_sigma_deg", kPi / 180.0, session.ins_attitude_bias_sigma_rad);
  read("position_drift_m", 1.0, session.ins_position_drift);
  read("attitude_drift_deg", kPi / 180.0, session.ins_attitude_drift);
}

RigidTransform read_nominal(const DocumentView& node) {
  node.allow_only({"x_m", "y_m", "z_m", "yaw_deg", "pitch_deg", "roll_deg"});
  const auto angle = [&](const char* key) {
    const double degrees = node.at(key).number();
    constexpr Angle kLeast{-2.0 * kPi}, kMost{2.0 * kPi};
    const Angle turn{degrees_to_radians(degrees)};
    if (std::abs(degrees) > 360.0) node.at(key).fail(say::native_angle(turn, kLeast, kMost));
    return turn.rad;
  };
  return rigid_from_six({node.at("x_m").number(), node.at("y_m").number(), node.at("z_m").number(), angle("yaw_deg"),
                         angle("pitch_deg"), angle("roll_deg")});
}

/// With what is wrong with the stamps of a session that is refused for something else: both are seen in one go.
Message with_what_is_off(Message refusal, drive::Session session) {
  conventions::mend_week_rollover(session);
  for (const drive::Finding& finding : session.findings)
    if (finding.code == conventions::kWeekRollover)
      return say::native_untimed_and_off(std::move(refusal), finding.where.words());
  return refusal;
}

}  // namespace

void read_declared_noise(const DocumentView& root, drive::Session& session) {
  if (const auto noise = root.find("ins_noise")) read_noise(*noise, session);
}

void read_declared_lidar(const DocumentView& node, drive::Session& session) {
  if (const auto lidar = node.find("lidar"))
    session.lidar =
        static_cast<cloud::LidarKind>(lidar->choice({cloud::kDeclaredLidars.begin(), cloud::kDeclaredLidars.end()}));
  if (const auto nominal = node.find("nominal")) session.nominal_ins_from_lidar = read_nominal(*nominal);
}

void read_captured_scans(const DocumentView& node, const std::filesystem::path& folder, drive::Session& session,
                         Progress& progress) {
  node.allow_only({"capture", "sensor"});
  const std::filesystem::path capture = folder / node.at("capture").string();
  if (!is_capture(capture)) node.at("capture").fail(say::native_no_capture(capture.string()));
  session.files.push_back(capture);
  PacketIndex index = index_capture(capture, progress);
  if (progress.cancelled()) return;
  const auto sensor = node.find("sensor");
  take_scans(index, choose_sensor(index, sensor ? sensor->string() : std::string(), capture.string()), session);
}

bool read_ins_log(const DocumentView& node, const std::filesystem::path& file, drive::Session& session) {
  if (const InsLogKind* kind = ins_log_kind(file)) {
    take_ins_log(*kind, file, session);
    return true;
  }
  const bool nmea = recognise_nmea(file);
  if (!nmea && recognise_novatel(file) != NovatelFormat::Log) return false;
  session.files.push_back(file);
  if (nmea) {
    NmeaLog log = read_nmea(file, session.findings);
    session.ins = std::move(log.ins);
    session.ins_position_lag_sigma_s = log.position_lag_sigma_s;
  } else {
    session.ins = read_novatel(file, NovatelFormat::Log, session.findings).ins;
    session.ins_axes = drive::InsAxes::RightForwardUp;
    session.ins_stamps_from_gps = true;
  }
  if (!session.ins.empty()) return true;
  for (const drive::Finding& finding : session.findings)
    if (finding.code == "attitude-sparse" && finding.where == file.string()) node.fail(finding.explanation);
  node.fail(say::native_no_attitude());
}

FoundPointTimes require_point_times(const DocumentView& timing, const TimedScanSource& scans,
                                    const drive::Session& session) {
  const FoundPointTimes found = find_point_times(scans);
  if (found.usable || found.misfit || found.scan.empty()) return found;
  timing.fail(with_what_is_off(say::native_untimed(found.problem, found.scan, expected_time_columns()), session));
}

}  // namespace remount::formats
