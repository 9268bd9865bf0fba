#include "model/formats/bags/ins_messages.h"

#include <cmath>
#include <utility>

#include "algorithms/core/error.h"
#include "messages/bags.h"
#include "messages/ins_logs.h"
#include "model/drive/plausible_values.h"
#include "model/formats/bags/apollo_messages.h"
#include "model/formats/files/time_stamp.h"
#include "model/formats/ins/sbf_blocks.h"

namespace remount::bags {
namespace {

[[noreturn]] void fail_ins(const MessageReader& reader, Message what) {
  throw Error(ErrorCode::Format, reader.where(), std::move(what));
}

Eigen::Vector3d three_doubles(MessageReader& reader) {
  const auto v = reader.doubles<3>();
  return {v[0], v[1], v[2]};
}

void require_place(const MessageReader& reader, double latitude_rad, double longitude_rad, double height_m) {
  if (!drive::plausible_geodetic(latitude_rad, longitude_rad, height_m)) fail_ins(reader, say::bag_place_impossible());
}

void require_angles(const MessageReader& reader, const drive::AttitudeAngles& angles) {
  if (!(std::abs(angles.yaw_rad) <= 4.0 * kPi && std::abs(angles.pitch_rad) <= kPi &&
        std::abs(angles.roll_rad) <= 4.0 * kPi))
    fail_ins(reader, say::log_angles_impossible());
}

/// NaN for what does not state an error.
double stated(double sigma) { return sigma > 0.0 && !drive::means_not_known(sigma) ? sigma : std::nan(""); }

std::int64_t gps_stamp_ns(const MessageReader& reader, std::int64_t week, std::int64_t milliseconds) {
  const auto stamp = formats::unix_ns_from_gps_week(week, milliseconds * 1'000'000);
  if (!stamp) fail_ins(reader, say::bag_gps_time());
  return *stamp;
}

// ---- sbg_driver

/// The beginning of SbgEkfStatus, which is alike in all versions.
struct SbgStatus {
  bool attitude = false, heading = false, position = false;
};
SbgStatus read_sbg_status(MessageReader& reader) {
  constexpr std::uint8_t kPositionMode = 4, kAttitudeMode = 2;
  const auto mode = reader.number<std::uint8_t>();
  const bool attitude = reader.number<std::uint8_t>() != 0, heading = reader.number<std::uint8_t>() != 0;
  reader.number<std::uint8_t>();  // velocity
  const bool position = reader.number<std::uint8_t>() != 0;
  return {attitude && mode >= kAttitudeMode, heading && mode >= kAttitudeMode, position && mode >= kPositionMode};
}

FixMessage read_sbg_nav(MessageReader& reader) {
  FixMessage message;
  message.header = read_header(reader);
  reader.number<std::uint32_t>();  // since power-on
  reader.doubles<6>();             // velocity and its error
  const Eigen::Vector3d place = three_doubles(reader);
  const double undulation_m = reader.number<float>();
  const Eigen::Vector3d sigma = three_doubles(reader);  // of latitude, longitude, height: see settle_sbg_errors
  message.status = read_sbg_status(reader).position ? 0 : -1;
  message.latitude_rad = degrees_to_radians(place.x()), message.longitude_rad = degrees_to_radians(place.y());
  message.height_m = place.z() + undulation_m;
  if (sigma.allFinite() && sigma.minCoeff() > 0.0 && !drive::means_not_known(sigma.maxCoeff()))
    message.covariance_enu_m2 =
        Eigen::Matrix3d(Eigen::Vector3d(sigma.y(), sigma.x(), sigma.z()).cwiseAbs2().asDiagonal());
  if (message.status >= 0) require_place(reader, message.latitude_rad, message.longitude_rad, message.height_m);
  return message;
}

ImuMessage read_sbg_attitude(MessageReader& reader, MessageKind kind) {
  ImuMessage message;
  message.header = read_header(reader);
  reader.number<std::uint32_t>();  // since power-on
  Eigen::Quaterniond enu_from_ins;
  if (kind == MessageKind::SbgQuat) {
    const auto q = reader.doubles<4>();
    const Eigen::Quaterniond logged(q[3], q[0], q[1], q[2]);
    if (!(std::abs(logged.norm() - 1.0) < 0.1)) fail_ins(reader, say::bag_orientation_not_unit());
    enu_from_ins = drive::enu_from_ins(logged, drive::QuaternionConvention::NedFromBody);
  } else {
    const Eigen::Vector3d angles = three_doubles(reader);  // roll, pitch, yaw
    const drive::AttitudeAngles heading{angles.z(), angles.y(), angles.x()};
    require_angles(reader, heading);
    enu_from_ins = drive::enu_from_ins(heading, drive::AttitudeConvention::Heading);
  }
  const Eigen::Vector3d sigma = three_doubles(reader);  // roll, pitch, yaw
  const SbgStatus status = read_sbg_status(reader);
  if (status.attitude && status.heading) message.orientation = enu_from_ins;
  if (sigma.allFinite() && sigma.minCoeff() > 0.0) message.orientation_variance_rad2 = sigma.cwiseAbs2();
  return message;
}

// ---- gps_common, gps_msgs

FixMessage read_gps_fix(MessageReader& reader) {
  FixMessage message;
  message.header = read_header(reader);
  read_header(reader);  // of the status
  const auto satellites = [&](int lists) {
    reader.number<std::uint16_t>();
    for (int i = 0; i < lists; ++i) reader.skip(reader.sequence(sizeof(std::int32_t)) * sizeof(std::int32_t));
  };
  satellites(1);  // used
  satellites(4);  // visible
  const int status = reader.number<std::int16_t>();
  for (int i = 0; i < 3; ++i) reader.number<std::uint16_t>();  // sources
  message.latitude_rad = degrees_to_radians(reader.number<double>());
  message.longitude_rad = degrees_to_radians(reader.number<double>());
  message.height_m = reader.number<double>();
  reader.doubles<7 + 5 + 10>();  // motion, orientation and time; dilutions; errors of 95 %
  const auto c = reader.doubles<9>();
  const bool known = reader.number<std::uint8_t>() != 0;
  const Eigen::Matrix3d covariance = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(c.data());
  if (known && covariance.allFinite() && covariance.diagonal().minCoeff() > 0.0) message.covariance_enu_m2 = covariance;
  // GPSStatus: 18 differential, 19 and 20 RTK fixed and float, 33 WAAS.
  message.status = status < 0 ? -1 : status == 2 || status == 19 ? 2 : status == 0 ? 0 : 1;
  if (message.status >= 0) require_place(reader, message.latitude_rad, message.longitude_rad, message.height_m);
  return message;
}

// ---- autoware_sensing_msgs

ImuMessage read_autoware_orientation(MessageReader& reader) {
  ImuMessage message;
  message.header = read_header(reader);
  const auto q = reader.doubles<4>();
  const Eigen::Quaterniond orientation(q[3], q[0], q[1], q[2]);
  Eigen::Vector3d sigma_rad;
  for (Eigen::Index axis = 0; axis < 3; ++axis) sigma_rad[axis] = reader.number<float>();
  if (!orientation.coeffs().allFinite() || orientation.norm() == 0.0) return message;
  if (!(std::abs(orientation.norm() - 1.0) < 0.1)) fail_ins(reader, say::bag_orientation_not_unit());
  message.orientation = orientation.normalized();
  if (sigma_rad.allFinite() && sigma_rad.minCoeff() > 0.0) message.orientation_variance_rad2 = sigma_rad.cwiseAbs2();
  message.orientation_is_default =
      orientation.coeffs() == Eigen::Quaterniond::Identity().coeffs() && message.orientation_variance_rad2.isZero(0.0);
  return message;
}

// ---- septentrio_gnss_driver

InspvaxMessage read_ins_nav_geod(MessageReader& reader) {
  constexpr std::uint16_t kPositionErrors = 1, kAttitude = 2, kAttitudeErrors = 4;
  InspvaxMessage message;
  message.frame = read_header(reader).frame;
  reader.number<std::uint8_t>(), reader.number<std::uint8_t>();  // "$@"
  for (int i = 0; i < 3; ++i) reader.number<std::uint16_t>();    // checksum, block, length
  const std::int64_t in_week_ms = reader.number<std::uint32_t>(), week = reader.number<std::uint16_t>();
  const int mode = reader.number<std::uint8_t>() & 0xf, error = reader.number<std::uint8_t>();
  for (int i = 0; i < 2; ++i) reader.number<std::uint16_t>();  // information, age of corrections
  formats::InsNavValues values;
  values.mode = mode, values.error = error;
  values.latitude_rad = reader.number<double>(), values.longitude_rad = reader.number<double>();
  values.height_m = reader.number<double>();
  reader.number<float>();                                      // undulation: heights are above the ellipsoid
  for (int i = 0; i < 2; ++i) reader.number<std::uint16_t>();  // accuracy, latency
  reader.number<std::uint8_t>();                               // datum
  const auto there = reader.number<std::uint16_t>();
  const auto next = [&] { return static_cast<double>(reader.number<float>()); };
  const double north_m = next(), east_m = next(), up_m = next();
  for (int i = 0; i < 3; ++i) next();  // covariances of the position
  const double heading_deg = next(), pitch_deg = next(), roll_deg = next();
  const double heading_sigma_deg = next(), pitch_sigma_deg = next(), roll_sigma_deg = next();
  if ((there & kAttitude) != 0)
    values.heading_deg = heading_deg, values.pitch_deg = pitch_deg, values.roll_deg = roll_deg;
  if ((there & kPositionErrors) != 0) values.position_sigma_enu_m = {east_m, north_m, up_m};
  if ((there & kAttitudeErrors) != 0) {
    values.heading_sigma_deg = heading_sigma_deg, values.pitch_sigma_deg = pitch_sigma_deg;
    values.roll_sigma_deg = roll_sigma_deg;
  }
  message.sample = formats::ins_nav_sample(values, reader.where());
  message.sample.stamp_ns = gps_stamp_ns(reader, week, in_week_ms);
  return message;
}

// ---- applanix_msgs

std::int64_t read_gsof_time_ns(MessageReader& reader) {
  const std::int64_t week = reader.number<std::uint16_t>(), milliseconds = reader.number<std::uint32_t>();
  return gps_stamp_ns(reader, week, milliseconds);
}

motion::InsQuality read_gsof_quality(MessageReader& reader) {
  constexpr int kDegraded = 2, kAligned = 3, kFullNavigation = 4;
  const int alignment = reader.number<std::uint8_t>();
  reader.number<std::uint8_t>();  // of the GNSS
  return alignment == kFullNavigation                      ? motion::InsQuality::Good
         : alignment == kAligned || alignment == kDegraded ? motion::InsQuality::Degraded
                                                           : motion::InsQuality::Invalid;
}

InspvaxMessage read_gsof49(MessageReader& reader) {
  InspvaxMessage message;
  message.frame = read_header(reader).frame;
  motion::InsSample& sample = message.sample;
  sample.stamp_ns = read_gsof_time_ns(reader);
  sample.quality = read_gsof_quality(reader);
  sample.latitude_rad = degrees_to_radians(reader.number<double>());
  sample.longitude_rad = degrees_to_radians(reader.number<double>());
  sample.height_m = reader.number<double>();
  for (int i = 0; i < 3 + 1; ++i) reader.number<float>();    // velocity, speed
  const Eigen::Vector3d angles_deg = three_doubles(reader);  // roll, pitch, heading
  require_place(reader, sample.latitude_rad, sample.longitude_rad, sample.height_m);
  const drive::AttitudeAngles angles{degrees_to_radians(angles_deg.z()), degrees_to_radians(angles_deg.y()),
                                     degrees_to_radians(angles_deg.x())};
  require_angles(reader, angles);
  sample.enu_from_ins = drive::enu_from_ins(angles, drive::AttitudeConvention::Heading);
  return message;
}

// ---- oxts_msgs

/// Each packet has its milliseconds into the minute; the header is good enough for the minute.
std::optional<InspvaxMessage> read_oxts_ncom(MessageReader& reader, formats::NcomErrors& errors) {
  constexpr std::int64_t kMillisecond_ns = 1'000'000, kMinute_ns = 60'000 * kMillisecond_ns;
  const MessageHeader header = read_header(reader);
  std::string bytes(formats::kNcomPacketBytes, '\0');
  for (char& byte : bytes) byte = static_cast<char>(reader.number<std::uint8_t>());
  const auto packet = formats::ncom_packet(bytes, 0);
  if (!packet) fail_ins(reader, say::ncom_no_packet());
  errors.take(*packet);
  if (!formats::has_solution(*packet)) return std::nullopt;
  InspvaxMessage message;
  message.frame = header.frame;
  message.sample = formats::ncom_sample(*packet, errors.sigma(), reader.where());
  const std::int64_t about_ns = formats::gps_ns_from_unix_ns(header.stamp_ns),
                     in_minute_ns = packet->millisecond * kMillisecond_ns;
  const auto minutes = static_cast<std::int64_t>(
      std::llround(static_cast<double>(about_ns - in_minute_ns) / static_cast<double>(kMinute_ns)));
  message.sample.stamp_ns = formats::unix_ns_from_gps_ns(minutes * kMinute_ns + in_minute_ns);
  return message;
}

}  // namespace

FixMessage read_any_fix(MessageReader& reader, MessageKind kind) {
  if (kind == MessageKind::SbgNav) return read_sbg_nav(reader);
  if (kind == MessageKind::ApolloBestPose) return read_apollo_fix(reader);
  return kind == MessageKind::GpsFix ? read_gps_fix(reader) : read_fix(reader);
}

ImuMessage read_attitude(MessageReader& reader, MessageKind kind) {
  if (kind == MessageKind::SbgQuat || kind == MessageKind::SbgEuler) return read_sbg_attitude(reader, kind);
  return kind == MessageKind::GnssInsOrientation ? read_autoware_orientation(reader) : read_imu(reader);
}

bool has_open_axes(MessageKind kind) {
  return kind == MessageKind::SbgQuat || kind == MessageKind::SbgEuler || kind == MessageKind::InsNavGeod;
}

double early_enu_turn_rad(MessageKind kind) {
  if (kind == MessageKind::SbgQuat) return 0.5 * kPi;
  return kind == MessageKind::InsNavGeod ? 0.5 * kPi - degrees_to_radians(0.5 * kPi) : 0.0;
}

bool writes_enu_by_itself(MessageKind kind) { return kind == MessageKind::InsNavGeod; }

std::optional<InspvaxMessage> read_solution(MessageReader& reader, MessageKind kind, formats::NcomErrors& errors) {
  if (kind == MessageKind::OxtsNcom) return read_oxts_ncom(reader, errors);
  return kind == MessageKind::Gsof49 ? read_gsof49(reader) : read_ins_nav_geod(reader);
}

formats::StampedSigma read_gsof50(MessageReader& reader) {
  read_header(reader);
  formats::StampedSigma errors;
  errors.stamp_ns = read_gsof_time_ns(reader);
  read_gsof_quality(reader);
  const auto next = [&] { return stated(static_cast<double>(reader.number<float>())); };
  const double north_m = next(), east_m = next(), down_m = next();
  for (int i = 0; i < 3; ++i) next();  // of the velocity
  const double roll_deg = next(), pitch_deg = next(), heading_deg = next();
  errors.sigma.position_enu_m = {east_m, north_m, down_m};
  errors.sigma.attitude_rad = drive::axis_sigma_rad(
      {degrees_to_radians(heading_deg), degrees_to_radians(pitch_deg), degrees_to_radians(roll_deg)},
      drive::AttitudeConvention::Heading);
  return errors;
}

}  // namespace remount::bags
