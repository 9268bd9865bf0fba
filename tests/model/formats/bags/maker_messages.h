// Messages of makers' own drivers, for tests and samples.
#pragma once

#include <string>

#include "algorithms/geometry/rotation.h"
#include "model/drive/attitude_convention.h"
#include "model/formats/bags/message_writer.h"
#include "model/formats/files/time_stamp.h"
#include "tests/model/formats/ins/ncom_records.h"

namespace remount::bags {

inline void put(MessageWriter& writer, std::initializer_list<double> values) {
  for (const double value : values) writer.number(value);
}
inline void put_floats(MessageWriter& writer, std::initializer_list<double> values) {
  for (const double value : values) writer.number(static_cast<float>(value));
}

/// SbgEkfStatus of an INS that navigates, unless something is not valid.
inline void put_sbg_status(MessageWriter& writer, bool attitude = true, bool position = true) {
  writer.number<std::uint8_t>(4).number<std::uint8_t>(attitude).number<std::uint8_t>(1).number<std::uint8_t>(1);
  writer.number<std::uint8_t>(position);
  for (int i = 0; i < 14; ++i) writer.number<std::uint8_t>(0);
}

inline std::string sbg_nav(const motion::InsSample& sample, MessageEncoding encoding, bool valid = true) {
  MessageWriter writer(encoding);
  writer.header(sample.stamp_ns, "imu_link").number<std::uint32_t>(7);
  put(writer, {1.0, 2.0, 3.0, 0.1, 0.1, 0.1, radians_to_degrees(sample.latitude_rad),
               radians_to_degrees(sample.longitude_rad), sample.height_m - 47.5});
  writer.number(47.5F);
  put(writer, {0.01, 0.02, 0.03});
  put_sbg_status(writer, true, valid);
  return writer.bytes();
}

/// As the driver writes it, by the Euler angles of either convention.
inline std::string sbg_euler(const motion::InsSample& sample, bool enu, MessageEncoding encoding, bool valid = true) {
  const drive::AttitudeAngles angles = drive::angles_from(
      sample.enu_from_ins, enu ? drive::AttitudeConvention::EnuYaw : drive::AttitudeConvention::Heading);
  MessageWriter writer(encoding);
  writer.header(sample.stamp_ns, "imu_link").number<std::uint32_t>(7);
  put(writer, {angles.roll_rad, angles.pitch_rad, wrap_angle_rad(angles.yaw_rad), 0.001, 0.002, 0.003});
  put_sbg_status(writer, valid);
  return writer.bytes();
}

inline std::string ins_nav_geod(const motion::InsSample& sample, bool enu, MessageEncoding encoding) {
  const drive::AttitudeAngles angles = drive::angles_from(
      sample.enu_from_ins, enu ? drive::AttitudeConvention::EnuYaw : drive::AttitudeConvention::Heading);
  const std::int64_t gps_ms = formats::gps_ns_from_unix_ns(sample.stamp_ns) / 1'000'000;
  MessageWriter writer(encoding);
  writer.header(sample.stamp_ns, "ins").number<std::uint8_t>(36).number<std::uint8_t>(64);
  for (int i = 0; i < 3; ++i) writer.number<std::uint16_t>(0);
  writer.number(static_cast<std::uint32_t>(gps_ms % 604'800'000))
      .number(static_cast<std::uint16_t>(gps_ms / 604'800'000));
  writer.number<std::uint8_t>(4).number<std::uint8_t>(0).number<std::uint16_t>(0).number<std::uint16_t>(0);
  put(writer, {sample.latitude_rad, sample.longitude_rad, sample.height_m});
  writer.number(47.5F).number<std::uint16_t>(1).number<std::uint16_t>(1).number<std::uint8_t>(0);
  writer.number<std::uint16_t>(1 + 2 + 4);
  put_floats(writer, {0.01, 0.02, 0.03, 0.0, 0.0, 0.0, radians_to_degrees(angles.yaw_rad),
                      radians_to_degrees(angles.pitch_rad), radians_to_degrees(angles.roll_rad), 0.3, 0.2, 0.1});
  for (int i = 0; i < 3 + 9; ++i) writer.number(-2e10F);
  return writer.bytes();
}

/// GpsTimeGsof and StatusGsof, behind the header.
inline void put_gsof_begin(MessageWriter& writer, std::int64_t stamp_ns, int alignment) {
  const std::int64_t gps_ms = formats::gps_ns_from_unix_ns(stamp_ns) / 1'000'000;
  writer.header(stamp_ns, "gsof").number(static_cast<std::uint16_t>(gps_ms / 604'800'000));
  writer.number(static_cast<std::uint32_t>(gps_ms % 604'800'000));
  writer.number(static_cast<std::uint8_t>(alignment)).number<std::uint8_t>(4);
}

inline std::string gsof49(const motion::InsSample& sample, int alignment, MessageEncoding encoding) {
  const drive::AttitudeAngles angles = drive::angles_from(sample.enu_from_ins, drive::AttitudeConvention::Heading);
  MessageWriter writer(encoding);
  put_gsof_begin(writer, sample.stamp_ns, alignment);
  put(writer, {radians_to_degrees(sample.latitude_rad), radians_to_degrees(sample.longitude_rad), sample.height_m});
  put_floats(writer, {1.0, 2.0, 3.0, 4.0});
  put(writer, {radians_to_degrees(angles.roll_rad), radians_to_degrees(angles.pitch_rad),
               radians_to_degrees(angles.yaw_rad), 0.0});
  put_floats(writer, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0});
  return writer.bytes();
}

inline std::string gsof50(std::int64_t stamp_ns, MessageEncoding encoding) {
  MessageWriter writer(encoding);
  put_gsof_begin(writer, stamp_ns, 4);
  put_floats(writer, {0.01, 0.02, 0.03, 0.1, 0.1, 0.1, 0.1, 0.2, 0.3});
  return writer.bytes();
}

inline std::string oxts_ncom(const formats::NcomRecord& record, std::int64_t stamp_ns, MessageEncoding encoding) {
  MessageWriter writer(encoding);
  writer.header(stamp_ns, "oxts");
  for (const char byte : record.bytes()) writer.number(static_cast<std::uint8_t>(byte));
  return writer.bytes();
}

}  // namespace remount::bags
