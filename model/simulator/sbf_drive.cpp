#include "model/simulator/sbf_drive.h"

#include <cstring>
#include <string>

#include "algorithms/geometry/rotation.h"
#include "model/drive/attitude_convention.h"
#include "model/formats/files/output_file.h"
#include "model/formats/files/time_stamp.h"
#include "model/formats/ins/sbf_blocks.h"
#include "model/formats/sessions/native_session_writer.h"
#include "model/simulator/drive_formats.h"
#include "model/simulator/novatel_drive.h"

namespace remount::simulator {
namespace {

template <class T>
void append_number(std::string& bytes, T value) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  bytes.append(raw, sizeof value);
}

void append_floats(std::string& bytes, std::initializer_list<double> values) {
  for (const double value : values) append_number(bytes, static_cast<float>(value));
}

std::string ins_nav_geod_block(const motion::InsSample& sample, const NovatelMoment& moment) {
  constexpr std::uint16_t kId = 4226;
  constexpr std::int64_t kWeek_ms = 604'800'000;
  constexpr std::uint8_t kRtkFixed = 4, kImuAlone = 0;
  const std::int64_t gps_ms = (formats::gps_ns_from_unix_ns(sample.stamp_ns) + 500'000) / 1'000'000;
  const drive::AttitudeAngles angles = drive::angles_from(sample.enu_from_ins, drive::AttitudeConvention::Heading);
  const bool states_errors = moment.attitude_sigma_deg > 0.0;
  std::string body;
  append_number(body, static_cast<std::uint32_t>(gps_ms % kWeek_ms));
  append_number(body, static_cast<std::uint16_t>(gps_ms / kWeek_ms));
  append_number(body, sample.quality == motion::InsQuality::Degraded ? kImuAlone : kRtkFixed);
  append_number<std::uint8_t>(body, 0);   // no error
  append_number<std::uint16_t>(body, 0);  // loosely coupled, of the main antenna
  append_number<std::uint16_t>(body, 100);
  append_number(body, sample.latitude_rad);
  append_number(body, sample.longitude_rad);
  append_number(body, sample.height_m);
  append_floats(body, {0.0});  // undulation
  append_number<std::uint16_t>(body, 65'535);
  append_number<std::uint16_t>(body, 65'535);
  append_number<std::uint16_t>(body, 0);  // WGS84
  append_number<std::uint16_t>(body, states_errors ? 0b1111 : 0b1010);
  const Eigen::Vector3d &sigma_m = moment.position_sigma_enu_m, &velocity = moment.velocity_enu_mps;
  const double sigma_deg = moment.attitude_sigma_deg;
  if (states_errors) append_floats(body, {sigma_m.y(), sigma_m.x(), sigma_m.z()});
  append_floats(body, {radians_to_degrees(angles.yaw_rad), radians_to_degrees(angles.pitch_rad),
                       radians_to_degrees(angles.roll_rad)});
  if (states_errors) append_floats(body, {sigma_deg, sigma_deg, sigma_deg});
  append_floats(body, {velocity.x(), velocity.y(), velocity.z()});
  std::string numbered;
  append_number(numbered, kId);
  append_number(numbered, static_cast<std::uint16_t>(8 + body.size()));
  numbered += body;
  std::string block = "$@";
  append_number(block, formats::sbf_crc16(numbered));
  return block + numbered;
}

}  // namespace

void write_sbf_drive(const SimulatedDrive& drive, const std::filesystem::path& folder, int, Progress&) {
  const std::vector<NovatelMoment> moments = novatel_moments(drive.session);
  std::string log;
  for (std::size_t i = 0; i < moments.size(); ++i) log += ins_nav_geod_block(drive.session.ins[i], moments[i]);
  formats::write_file(folder / "ins.sbf", log);
  formats::write_file(folder / "lidar_odometry.txt", formats::tum_text(exact_odometry(drive)));
}

}  // namespace remount::simulator
