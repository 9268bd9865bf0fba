// NMEA 0183 as an INS with a GNSS receiver writes it.
#include <cmath>
#include <cstdio>

#include "model/formats/files/number_text.h"
#include "model/formats/files/output_file.h"
#include "model/formats/files/time_stamp.h"
#include "model/formats/ins/nmea_sentence.h"
#include "model/formats/sessions/native_session_writer.h"
#include "model/simulator/drive_formats.h"

namespace remount::simulator {

namespace fs = std::filesystem;

namespace {

/// `body` without '$' and checksum.
std::string sentence(const std::string& body) {
  char end[8];
  std::snprintf(end, sizeof end, "*%02X\r\n", formats::nmea_checksum(body));
  return "$" + body + end;
}

/// "130225.964389445"
std::string time_of_day(std::int64_t stamp_ns) {
  const std::string text = formats::format_date_ns(stamp_ns);  // 2011-09-26 13:02:25.964389445
  return text.substr(11, 2) + text.substr(14, 2) + text.substr(17);
}

std::string number(double value, int decimals) {
  return std::isfinite(value) ? formats::rounded_text(value, decimals) : "";
}

/// Degrees and minutes with the letter of the side; minutes never round up to 60.
std::string angle(double value_rad, int degree_digits, const char* positive, const char* negative) {
  constexpr double kUnits = 6e10;  // of 1e-9 minutes in a degree
  const auto units = static_cast<long long>(std::llround(std::abs(radians_to_degrees(value_rad)) * kUnits));
  const auto whole = static_cast<long long>(kUnits);
  char text[48];
  std::snprintf(text, sizeof text, "%0*lld%02lld.%09lld,", degree_digits, units / whole, units % whole / 1'000'000'000,
                units % 1'000'000'000);
  return text + std::string(value_rad < 0.0 ? negative : positive);
}

double known_or(double value, double otherwise) { return std::isfinite(value) ? value : otherwise; }

std::string position(const motion::InsSample& sample, const std::string& time) {
  // 4: whole ambiguities, 5: not yet. The geoid lies on the ellipsoid here.
  const char* quality = sample.quality == motion::InsQuality::Degraded ? "5" : "4";
  return sentence("GPGGA," + time + "," + angle(sample.latitude_rad, 2, "N", "S") + "," +
                  angle(sample.longitude_rad, 3, "E", "W") + "," + quality + ",12,0.8," + number(sample.height_m, 4) +
                  ",M,0.0,M,,");
}

std::string errors(const drive::Session& session, const motion::InsSample& sample, const std::string& time) {
  Eigen::Vector3d sigma_m = sample.sigma.position_enu_m;
  for (int axis = 0; axis < 3; ++axis) sigma_m[axis] = known_or(sigma_m[axis], session.ins_position_white_sigma_m);
  if (!sigma_m.allFinite() || sigma_m.minCoeff() <= 0.0) return "";
  return sentence("GPGST," + time + "," + number(sigma_m.norm(), 4) + ",,,," + number(sigma_m.y(), 6) + "," +
                  number(sigma_m.x(), 6) + "," + number(sigma_m.z(), 6));
}

std::string attitude(const drive::Session& session, const motion::InsSample& sample, const std::string& time) {
  const drive::AttitudeAngles angles = drive::angles_from(sample.enu_from_ins, drive::AttitudeConvention::Heading);
  Eigen::Vector3d sigma_rad = sample.sigma.attitude_rad;  // about x, y, z: of roll, pitch, heading
  for (int axis = 0; axis < 3; ++axis)
    sigma_rad[axis] = known_or(sigma_rad[axis], session.ins_attitude_white_sigma_rad);
  std::string body = "PASHR," + time + "," + number(radians_to_degrees(angles.yaw_rad), 9) + ",T," +
                     number(radians_to_degrees(angles.roll_rad), 9) + "," +
                     number(radians_to_degrees(angles.pitch_rad), 9) + ",0.00";
  for (int axis = 0; axis < 3; ++axis) (body += ',') += number(radians_to_degrees(sigma_rad[axis]), 6);
  return sentence(body + ",2");
}

/// Incomplete where `progress` is cancelled.
std::string nmea_log(const drive::Session& session, Progress& progress) {
  std::string log;
  for (const motion::InsSample& sample : session.ins) {
    if (progress.cancelled()) return log;
    const std::string time = time_of_day(sample.stamp_ns);
    if (log.empty()) {
      const std::string date = formats::format_date_ns(sample.stamp_ns);
      log += sentence("GPZDA," + time + "," + date.substr(8, 2) + "," + date.substr(5, 2) + "," + date.substr(0, 4) +
                      ",00,00");
    }
    log += position(sample, time) + errors(session, sample, time) + attitude(session, sample, time);
  }
  return log;
}

}  // namespace

std::string nmea_minimum(const motion::InsSample& sample) {
  const std::string date = formats::format_date_ns(sample.stamp_ns);
  return sentence("GPRMC," + time_of_day(sample.stamp_ns).substr(0, 9) + ",A," +
                  angle(sample.latitude_rad, 2, "N", "S") + "," + angle(sample.longitude_rad, 3, "E", "W") +
                  ",0.0,0.0," + date.substr(8, 2) + date.substr(5, 2) + date.substr(2, 2) + ",,,A");
}

bool write_receiver_log(const SimulatedDrive& drive, const fs::path& folder, Progress& progress) {
  const std::string log = nmea_log(drive.session, progress);
  if (progress.cancelled()) return false;
  formats::write_file(folder / "receiver.nmea", log);
  return true;
}

void write_nmea_drive(const SimulatedDrive& drive, const fs::path& folder, int, Progress& progress) {
  if (write_receiver_log(drive, folder, progress))
    formats::write_file(folder / "lidar_odometry.txt", formats::tum_text(exact_odometry(drive)));
}

}  // namespace remount::simulator
