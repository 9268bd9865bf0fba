#include "model/simulator/sbet_drive.h"

#include <cmath>
#include <cstring>
#include <string>

#include "algorithms/core/stamps.h"
#include "algorithms/geometry/rotation.h"
#include "model/drive/attitude_convention.h"
#include "model/formats/files/output_file.h"
#include "model/formats/files/time_stamp.h"
#include "model/formats/sessions/native_session_writer.h"
#include "model/simulator/drive_formats.h"
#include "model/simulator/novatel_drive.h"

namespace remount::simulator {
namespace {

void append_doubles(std::string& bytes, std::initializer_list<double> values) {
  for (const double value : values) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    bytes.append(raw, sizeof value);
  }
}

double seconds_of_week(std::int64_t stamp_ns) {
  constexpr std::int64_t kWeek_ns = std::int64_t{604'800} * 1'000'000'000;
  return static_cast<double>(formats::gps_ns_from_unix_ns(stamp_ns) % kWeek_ns) * 1e-9;
}

}  // namespace

void write_sbet_drive(const SimulatedDrive& drive, const std::filesystem::path& folder, int, Progress&) {
  constexpr double kWander_rad = 0.35, kWanderRate_radps = 1e-3;
  const std::vector<motion::InsSample>& ins = drive.session.ins;
  const std::vector<NovatelMoment> moments = novatel_moments(drive.session);
  std::string sbet, smrmsg;
  for (std::size_t i = 0; i < ins.size(); ++i) {
    const double time_s = seconds_of_week(ins[i].stamp_ns),
                 wander_rad = kWander_rad + kWanderRate_radps * seconds(ins[i].stamp_ns - ins.front().stamp_ns);
    const drive::AttitudeAngles angles = drive::angles_from(ins[i].enu_from_ins, drive::AttitudeConvention::Heading);
    // Velocities are along the axes of the platform, which stand the wander angle west of north.
    const Eigen::Vector3d& enu = moments[i].velocity_enu_mps;
    append_doubles(sbet, {time_s, ins[i].latitude_rad, ins[i].longitude_rad, ins[i].height_m,
                          enu.y() * std::cos(wander_rad) - enu.x() * std::sin(wander_rad),
                          -enu.x() * std::cos(wander_rad) - enu.y() * std::sin(wander_rad), -enu.z(), angles.roll_rad,
                          angles.pitch_rad, angles.yaw_rad + wander_rad, wander_rad, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0});
    const Eigen::Vector3d& sigma_m = moments[i].position_sigma_enu_m;
    const double attitude_arcmin = 60.0 * moments[i].attitude_sigma_deg;
    if (begins_second(drive.session, i) && attitude_arcmin > 0.0)
      append_doubles(smrmsg, {time_s, sigma_m.y(), sigma_m.x(), sigma_m.z(), 0.01, 0.01, 0.01, attitude_arcmin,
                              attitude_arcmin, attitude_arcmin});
  }
  formats::write_file(folder / "sbet_drive.out", sbet);
  if (!smrmsg.empty()) formats::write_file(folder / "smrmsg_drive.out", smrmsg);
  formats::write_file(folder / "lidar_odometry.txt", formats::tum_text(exact_odometry(drive)));
}

}  // namespace remount::simulator
