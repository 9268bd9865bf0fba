#include "model/simulator/novatel_drive.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "algorithms/core/stamps.h"
#include "model/drive/session_frames.h"
#include "model/formats/files/number_text.h"
#include "model/formats/files/output_file.h"
#include "model/formats/files/time_stamp.h"
#include "model/formats/ins/novatel_frames.h"
#include "model/formats/sessions/native_session_writer.h"
#include "model/simulator/drive_formats.h"

namespace remount::simulator {

namespace fs = std::filesystem;

namespace {

struct GpsMoment {
  std::int64_t week = 0, in_week_ns = 0;
};
GpsMoment gps_moment(std::int64_t stamp_ns) {
  constexpr std::int64_t kWeek_ns = 604'800'000'000'000;
  const std::int64_t gps_ns = formats::gps_ns_from_unix_ns(stamp_ns);
  return {gps_ns / kWeek_ns, gps_ns % kWeek_ns};
}

/// "2288,166418.000000000"
std::string week_and_seconds(std::int64_t stamp_ns) {
  const GpsMoment moment = gps_moment(stamp_ns);
  char time[48];
  std::snprintf(time, sizeof time, "%lld,%lld.%09lld", static_cast<long long>(moment.week),
                static_cast<long long>(moment.in_week_ns / 1'000'000'000),
                static_cast<long long>(moment.in_week_ns % 1'000'000'000));
  return time;
}

std::string with_checksum(const std::string& body) {
  char crc[16];
  std::snprintf(crc, sizeof crc, "*%08x\r\n", formats::novatel_crc32(body));
  return "#" + body + crc;
}

std::string long_header(const char* name, std::int64_t stamp_ns) {
  return std::string(name) + ",COM1,0,73.5,FINESTEERING," + week_and_seconds(stamp_ns) + ",00000040,4e77,43562;";
}

std::string numbers(std::initializer_list<double> values) {
  std::string text;
  for (const double value : values) (text += ',') += formats::exact_text(value);
  return text;
}

bool is_degraded(const motion::InsSample& sample) { return sample.quality == motion::InsQuality::Degraded; }

std::string inspvaxa(const motion::InsSample& sample, const NovatelMoment& moment) {
  const Eigen::Vector3d &velocity = moment.velocity_enu_mps, &sigma = moment.position_sigma_enu_m;
  const double attitude_deg = moment.attitude_sigma_deg;
  return with_checksum(
      long_header("INSPVAXA", sample.stamp_ns) +
      (is_degraded(sample) ? "INS_HIGH_VARIANCE,INS_PSRSP" : "INS_SOLUTION_GOOD,INS_RTKFIXED") +
      numbers({radians_to_degrees(sample.latitude_rad), radians_to_degrees(sample.longitude_rad), sample.height_m, 0.0,
               velocity.y(), velocity.x(), velocity.z(), moment.roll_deg, moment.pitch_deg, moment.azimuth_deg,
               sigma.y(), sigma.x(), sigma.z(), 0.0, 0.0, 0.0, attitude_deg, attitude_deg, attitude_deg}) +
      ",00000000,0");
}

std::string inspvaa(const motion::InsSample& sample, const NovatelMoment& moment) {
  const Eigen::Vector3d& velocity = moment.velocity_enu_mps;
  return with_checksum(
      long_header("INSPVAA", sample.stamp_ns) + week_and_seconds(sample.stamp_ns) +
      numbers({radians_to_degrees(sample.latitude_rad), radians_to_degrees(sample.longitude_rad), sample.height_m,
               velocity.y(), velocity.x(), velocity.z(), moment.roll_deg, moment.pitch_deg, moment.azimuth_deg}) +
      (is_degraded(sample) ? ",INS_HIGH_VARIANCE" : ",INS_SOLUTION_GOOD"));
}

std::string insstdeva(const motion::InsSample& sample, const NovatelMoment& moment) {
  const Eigen::Vector3d& sigma = moment.position_sigma_enu_m;
  const double attitude_deg = moment.attitude_sigma_deg;
  const std::string values =
      numbers({sigma.y(), sigma.x(), sigma.z(), 0.0, 0.0, 0.0, attitude_deg, attitude_deg, attitude_deg});
  return with_checksum(long_header("INSSTDEVA", sample.stamp_ns) + values.substr(1) + ",00000000,0,0,0,0");
}

/// Little-endian numbers, and what a binary log begins and ends with.
class BinaryLog {
 public:
  template <class T>
  BinaryLog& number(T value) {
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof value);
    bytes_.append(raw, sizeof value);
    return *this;
  }
  BinaryLog& floats(std::initializer_list<double> values) {
    for (const double value : values) number(static_cast<float>(value));
    return *this;
  }
  BinaryLog& doubles(std::initializer_list<double> values) {
    for (const double value : values) number(value);
    return *this;
  }
  static BinaryLog with_short_header(std::uint16_t id, std::uint8_t body_bytes, const GpsMoment& moment) {
    BinaryLog log;
    log.bytes_ = "\xAA\x44\x13";
    log.number(body_bytes).number(id).number(static_cast<std::uint16_t>(moment.week));
    log.number(static_cast<std::int32_t>(moment.in_week_ns / 1'000'000));
    return log;
  }
  static BinaryLog with_long_header(std::uint16_t id, std::uint16_t body_bytes, const GpsMoment& moment) {
    constexpr std::uint8_t kHeaderBytes = 28, kCom1 = 32, kIdle = 147, kFineSteering = 180;
    BinaryLog log;
    log.bytes_ = "\xAA\x44\x12";
    log.number(kHeaderBytes).number(id).number<std::uint8_t>(0).number(kCom1).number(body_bytes);
    log.number<std::uint16_t>(0).number(kIdle).number(kFineSteering).number(static_cast<std::uint16_t>(moment.week));
    log.number(static_cast<std::int32_t>(moment.in_week_ns / 1'000'000)).number<std::uint32_t>(0x40);
    log.number<std::uint16_t>(0x4e77).number<std::uint16_t>(43562);
    return log;
  }
  std::string with_checksum() { return number(formats::novatel_crc32(bytes_)).bytes_; }

 private:
  std::string bytes_;
};

std::string inspvasb(const motion::InsSample& sample, const NovatelMoment& moment) {
  const GpsMoment time = gps_moment(sample.stamp_ns);
  const Eigen::Vector3d& velocity = moment.velocity_enu_mps;
  BinaryLog log = BinaryLog::with_short_header(508, 88, time);
  log.number(static_cast<std::uint32_t>(time.week)).number(static_cast<double>(time.in_week_ns) * 1e-9);
  log.doubles({radians_to_degrees(sample.latitude_rad), radians_to_degrees(sample.longitude_rad), sample.height_m,
               velocity.y(), velocity.x(), velocity.z(), moment.roll_deg, moment.pitch_deg, moment.azimuth_deg});
  return log.number<std::uint32_t>(is_degraded(sample) ? 2 : 3).with_checksum();
}

std::string insstdevb(const motion::InsSample& sample, const NovatelMoment& moment) {
  const Eigen::Vector3d& sigma = moment.position_sigma_enu_m;
  const double attitude_deg = moment.attitude_sigma_deg;
  BinaryLog log = BinaryLog::with_long_header(2051, 52, gps_moment(sample.stamp_ns));
  log.floats({sigma.y(), sigma.x(), sigma.z(), 0.0, 0.0, 0.0, attitude_deg, attitude_deg, attitude_deg});
  for (int i = 0; i < 4; ++i) log.number<std::uint32_t>(0);  // status, age, reserved
  return log.with_checksum();
}

template <class Solution, class Errors>
void write_inspva(const SimulatedDrive& drive, const fs::path& log_file, Solution&& solution, Errors&& errors) {
  const std::vector<motion::InsSample>& ins = drive.session.ins;
  const std::vector<NovatelMoment> moments = novatel_moments(drive.session);
  std::string log;
  for (std::size_t i = 0; i < ins.size(); ++i) {
    log += solution(ins[i], moments[i]);
    if (begins_second(drive.session, i)) log += errors(ins[i], moments[i]);
  }
  formats::write_file(log_file, log);
  formats::write_file(log_file.parent_path() / "lidar_odometry.txt", formats::tum_text(exact_odometry(drive)));
}

}  // namespace

std::vector<NovatelMoment> novatel_moments(const drive::Session& session) {
  const std::vector<motion::StampedPose> enu_from_ins = drive::metric_poses(session);
  const Eigen::Quaterniond flu_from_rfu(drive::forward_left_up_from(drive::InsAxes::RightForwardUp).linear());
  const auto known = [](double value, double otherwise) { return std::isfinite(value) ? value : otherwise; };
  std::vector<NovatelMoment> moments(session.ins.size());
  for (std::size_t i = 0; i < moments.size(); ++i) {
    const std::size_t before = i > 0 ? i - 1 : i, after = std::min(i + 1, enu_from_ins.size() - 1);
    const double step_s = seconds(enu_from_ins[after].stamp_ns - enu_from_ins[before].stamp_ns);
    if (step_s > 0.0)
      moments[i].velocity_enu_mps =
          (enu_from_ins[after].pose.translation() - enu_from_ins[before].pose.translation()) / step_s;
    const drive::AttitudeAngles angles =
        drive::angles_from(session.ins[i].enu_from_ins * flu_from_rfu, drive::AttitudeConvention::NovAtel);
    moments[i].roll_deg = radians_to_degrees(angles.roll_rad);
    moments[i].pitch_deg = radians_to_degrees(angles.pitch_rad);
    moments[i].azimuth_deg = std::fmod(radians_to_degrees(angles.yaw_rad) + 360.0, 360.0);
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      moments[i].position_sigma_enu_m[axis] =
          known(session.ins[i].sigma.position_enu_m[axis], known(session.ins_position_white_sigma_m, 0.0));
    moments[i].attitude_sigma_deg = radians_to_degrees(known(session.ins_attitude_white_sigma_rad, 0.0));
  }
  return moments;
}

bool begins_second(const drive::Session& session, std::size_t sample) {
  constexpr std::int64_t kSecond_ns = 1'000'000'000;
  return sample == 0 || session.ins[sample].stamp_ns / kSecond_ns != session.ins[sample - 1].stamp_ns / kSecond_ns;
}

void write_novatel_drive(const SimulatedDrive& drive, const fs::path& folder, int, Progress&) {
  const std::vector<NovatelMoment> moments = novatel_moments(drive.session);
  std::string log;
  for (std::size_t i = 0; i < moments.size(); ++i) log += inspvaxa(drive.session.ins[i], moments[i]);
  formats::write_file(folder / "inspvax.txt", log);
  formats::write_file(folder / "lidar_odometry.txt", formats::tum_text(exact_odometry(drive)));
}

void write_novatel_ascii_drive(const SimulatedDrive& drive, const fs::path& folder, int, Progress&) {
  write_inspva(drive, folder / "span.txt", inspvaa, insstdeva);
}

void write_novatel_binary_drive(const SimulatedDrive& drive, const fs::path& folder, int, Progress&) {
  write_inspva(drive, folder / "span.gps", inspvasb, insstdevb);
}

}  // namespace remount::simulator
