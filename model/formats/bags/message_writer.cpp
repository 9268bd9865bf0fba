#include "model/formats/bags/message_writer.h"

#include <cmath>

#include "algorithms/core/error.h"
#include "algorithms/geometry/rotation.h"
#include "model/formats/bags/packet_messages.h"
#include "model/formats/files/time_stamp.h"

namespace remount::bags {
namespace {

constexpr std::uint8_t kUint16 = 4, kFloat32 = 7;  // of sensor_msgs/PointField

void vector(MessageWriter& writer, const Eigen::Vector3d& v) {
  for (int axis = 0; axis < 3; ++axis) writer.number<double>(v[axis]);
}

void covariance(MessageWriter& writer, const Eigen::Matrix3d& m) {
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) writer.number<double>(m(row, column));
}

/// Of what is not measured.
Eigen::Matrix3d not_measured() { return Eigen::Vector3d(-1.0, 0.0, 0.0).asDiagonal(); }

struct Column {
  const char* name;
  std::uint8_t type;
  std::uint32_t bytes;
};

std::string points_of(const cloud::PointCloud& cloud) {
  std::string data;
  const auto put = [&](auto value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    data.append(raw, sizeof value);
  };
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) put(cloud.points[i][axis]);
    if (!cloud.intensity.empty()) put(cloud.intensity[i]);
    if (!cloud.ring.empty()) put(cloud.ring[i]);
    if (!cloud.time_from_stamp_s.empty()) put(cloud.time_from_stamp_s[i]);
  }
  return data;
}

MessageDefinition cloud_definition(MessageEncoding encoding) {
  return {"sensor_msgs/PointCloud2", "1158d486dd51d683ce2f1be655c3c181",
          "std_msgs/Header header\nuint32 height\nuint32 width\nPointField[] fields\nbool is_bigendian\n"
          "uint32 point_step\nuint32 row_step\nuint8[] data\nbool is_dense\n" +
              header_definition_part(encoding) +
              definition_part(
                  "sensor_msgs/PointField",
                  "uint8 INT8=1\nuint8 UINT8=2\nuint8 INT16=3\nuint8 UINT16=4\nuint8 INT32=5\nuint8 UINT32=6\n"
                  "uint8 FLOAT32=7\nuint8 FLOAT64=8\nstring name\nuint32 offset\nuint8 datatype\nuint32 count\n")};
}

MessageDefinition imu_definition(MessageEncoding encoding) {
  return {"sensor_msgs/Imu", "6a62c6daae103f4ff57a132d6f95cec2",
          "std_msgs/Header header\ngeometry_msgs/Quaternion orientation\nfloat64[9] orientation_covariance\n"
          "geometry_msgs/Vector3 angular_velocity\nfloat64[9] angular_velocity_covariance\n"
          "geometry_msgs/Vector3 linear_acceleration\nfloat64[9] linear_acceleration_covariance\n" +
              header_definition_part(encoding) +
              definition_part("geometry_msgs/Quaternion", "float64 x\nfloat64 y\nfloat64 z\nfloat64 w\n") +
              definition_part("geometry_msgs/Vector3", "float64 x\nfloat64 y\nfloat64 z\n")};
}

MessageDefinition fix_definition(MessageEncoding encoding) {
  return {
      "sensor_msgs/NavSatFix", "2d3a8cd499b9b4a0249fb98fd05cfa48",
      "uint8 COVARIANCE_TYPE_UNKNOWN=0\nuint8 COVARIANCE_TYPE_APPROXIMATED=1\n"
      "uint8 COVARIANCE_TYPE_DIAGONAL_KNOWN=2\nuint8 COVARIANCE_TYPE_KNOWN=3\nstd_msgs/Header header\n"
      "sensor_msgs/NavSatStatus status\nfloat64 latitude\nfloat64 longitude\nfloat64 altitude\n"
      "float64[9] position_covariance\nuint8 position_covariance_type\n" +
          header_definition_part(encoding) +
          definition_part("sensor_msgs/NavSatStatus",
                          "int8 STATUS_NO_FIX=-1\nint8 STATUS_FIX=0\nint8 STATUS_SBAS_FIX=1\nint8 STATUS_GBAS_FIX=2\n"
                          "uint16 SERVICE_GPS=1\nuint16 SERVICE_GLONASS=2\nuint16 SERVICE_COMPASS=4\n"
                          "uint16 SERVICE_GALILEO=8\nint8 status\nuint16 service\n")};
}

constexpr const char* kOem7HeaderFields =
    "string message_name\nuint16 message_id\nuint8 message_type\nuint32 sequence_number\nuint8 time_status\n"
    "uint16 gps_week_number\nuint32 gps_week_milliseconds\n";

/// The checksums of ROS 1 are not known here: "*" fits any.
MessageDefinition inspva_definition(MessageEncoding encoding) {
  return {"novatel_oem7_msgs/INSPVA", "*",
          "std_msgs/Header header\nOem7Header nov_header\nfloat64 latitude\nfloat64 longitude\nfloat64 height\n"
          "float64 north_velocity\nfloat64 east_velocity\nfloat64 up_velocity\nfloat64 roll\nfloat64 pitch\n"
          "float64 azimuth\nInertialSolutionStatus status\n" +
              header_definition_part(encoding) + definition_part("novatel_oem7_msgs/Oem7Header", kOem7HeaderFields) +
              definition_part("novatel_oem7_msgs/InertialSolutionStatus", "uint32 status\n")};
}

MessageDefinition insstdev_definition(MessageEncoding encoding) {
  return {"novatel_oem7_msgs/INSSTDEV", "*",
          "std_msgs/Header header\nOem7Header nov_header\nfloat32 latitude_stdev\nfloat32 longitude_stdev\n"
          "float32 height_stdev\nfloat32 north_velocity_stdev\nfloat32 east_velocity_stdev\n"
          "float32 up_velocity_stdev\nfloat32 roll_stdev\nfloat32 pitch_stdev\nfloat32 azimuth_stdev\n"
          "INSExtendedSolutionStatus ext_sol_status\nuint16 time_since_last_update\nuint16 reserved1\n"
          "uint32 reserved2\nuint32 reserved3\n" +
              header_definition_part(encoding) + definition_part("novatel_oem7_msgs/Oem7Header", kOem7HeaderFields) +
              definition_part("novatel_oem7_msgs/INSExtendedSolutionStatus", "uint32 status\n")};
}

void oem7_header(MessageWriter& writer, std::string_view name, std::uint16_t id, std::int64_t stamp_ns,
                 std::string_view frame) {
  constexpr std::int64_t kWeek_ns = 604'800'000'000'000;
  constexpr std::uint8_t kFineSteering = 180;
  const std::int64_t gps_ns = formats::gps_ns_from_unix_ns(stamp_ns);
  writer.header(stamp_ns, frame).string(name).number(id).number<std::uint8_t>(0).number<std::uint32_t>(0);
  writer.number(kFineSteering).number(static_cast<std::uint16_t>(gps_ns / kWeek_ns));
  writer.number(static_cast<std::uint32_t>(gps_ns % kWeek_ns / 1'000'000));
}

MessageDefinition text_definition(MessageEncoding) {
  return {"std_msgs/String", "992ce8a1687cec8c8bd883ec73ca41d1", "string data\n"};
}

MessageDefinition bytes_definition(MessageEncoding) {
  return {"std_msgs/UInt8MultiArray", "82373f1612381bb6ee473b5cd6f5d89c",
          "std_msgs/MultiArrayLayout layout\nuint8[] data\n" +
              definition_part("std_msgs/MultiArrayLayout", "std_msgs/MultiArrayDimension[] dim\nuint32 data_offset\n") +
              definition_part("std_msgs/MultiArrayDimension", "string label\nuint32 size\nuint32 stride\n")};
}

}  // namespace

MessageWriter::MessageWriter(MessageEncoding encoding) : encoding_(encoding) {
  if (encoding == MessageEncoding::Cdr) bytes_.assign({0, 1, 0, 0});  // plain, little-endian
  start_ = bytes_.size();
}

void MessageWriter::align(std::size_t bytes) {
  if (encoding_ != MessageEncoding::Cdr) return;
  while ((bytes_.size() - start_) % bytes != 0) bytes_.push_back('\0');
}

MessageWriter& MessageWriter::string(std::string_view text) {
  const bool zero = encoding_ == MessageEncoding::Cdr;
  number(static_cast<std::uint32_t>(text.size() + (zero ? 1 : 0)));
  bytes_.append(text);
  if (zero) bytes_.push_back('\0');
  return *this;
}

MessageWriter& MessageWriter::byte_sequence(std::string_view bytes) {
  number(static_cast<std::uint32_t>(bytes.size()));
  bytes_.append(bytes);
  return *this;
}

MessageWriter& MessageWriter::time(std::int64_t stamp_ns) {
  number(static_cast<std::uint32_t>(stamp_ns / 1'000'000'000));
  return number(static_cast<std::uint32_t>(stamp_ns % 1'000'000'000));
}

MessageWriter& MessageWriter::header(std::int64_t stamp_ns, std::string_view frame) {
  if (encoding_ == MessageEncoding::Ros1) number<std::uint32_t>(0);
  return time(stamp_ns).string(frame);
}

std::string definition_part(std::string_view type, std::string_view fields) {
  return std::string(80, '=') + "\nMSG: " + std::string(type) + "\n" + std::string(fields);
}

std::string header_definition_part(MessageEncoding encoding) {
  return encoding == MessageEncoding::Ros1
             ? definition_part("std_msgs/Header", "uint32 seq\ntime stamp\nstring frame_id\n")
             : definition_part("std_msgs/Header", "builtin_interfaces/Time stamp\nstring frame_id\n") +
                   definition_part("builtin_interfaces/Time", "int32 sec\nuint32 nanosec\n");
}

MessageDefinition message_definition(std::string_view type, MessageEncoding encoding) {
  MessageDefinition found;
  for (const auto definition : {cloud_definition, imu_definition, fix_definition, inspva_definition,
                                insstdev_definition, text_definition, bytes_definition})
    if (MessageDefinition candidate = definition(encoding); candidate.type == type) found = std::move(candidate);
  if (holds_lidar_packets(type)) found = packet_definition(type, encoding);
  if (found.type.empty())
    throw Error(ErrorCode::Contract, std::string(type), Message::verbatim("has no definition here"));
  if (encoding == MessageEncoding::Cdr) found.type.insert(found.type.find('/'), "/msg");
  return found;
}

std::string cloud_message(const cloud::PointCloud& cloud, std::int64_t stamp_ns, std::string_view frame,
                          MessageEncoding encoding) {
  std::vector<Column> columns{{"x", kFloat32, 4}, {"y", kFloat32, 4}, {"z", kFloat32, 4}};
  if (!cloud.intensity.empty()) columns.push_back({"intensity", kFloat32, 4});
  if (!cloud.ring.empty()) columns.push_back({"ring", kUint16, 2});
  if (!cloud.time_from_stamp_s.empty()) columns.push_back({"time", kFloat32, 4});
  MessageWriter writer(encoding);
  writer.header(stamp_ns, frame).number<std::uint32_t>(1).number(static_cast<std::uint32_t>(cloud.size()));
  writer.number(static_cast<std::uint32_t>(columns.size()));
  std::uint32_t offset = 0;
  for (const Column& column : columns) {
    writer.string(column.name).number(offset).number(column.type).number<std::uint32_t>(1);
    offset += column.bytes;
  }
  writer.number<std::uint8_t>(0).number(offset).number(static_cast<std::uint32_t>(offset * cloud.size()));
  return writer.byte_sequence(points_of(cloud)).number<std::uint8_t>(1).bytes();
}

std::string text_message(std::string_view text, MessageEncoding encoding) {
  return MessageWriter(encoding).string(text).bytes();
}

std::string bytes_message(std::string_view bytes, MessageEncoding encoding) {
  return MessageWriter(encoding).number<std::uint32_t>(0).number<std::uint32_t>(0).byte_sequence(bytes).bytes();
}

std::string attitude_message(const motion::InsSample& sample, double attitude_sigma_rad, std::string_view frame,
                             MessageEncoding encoding) {
  MessageWriter writer(encoding);
  writer.header(sample.stamp_ns, frame);
  const Eigen::Quaterniond& q = sample.enu_from_ins;
  writer.number(q.x()).number(q.y()).number(q.z()).number(q.w());
  const double variance = std::isfinite(attitude_sigma_rad) ? attitude_sigma_rad * attitude_sigma_rad : 0.0;
  covariance(writer, Eigen::Matrix3d::Identity() * variance);
  for (int i = 0; i < 2; ++i) {
    vector(writer, Eigen::Vector3d::Zero());
    covariance(writer, not_measured());
  }
  return writer.bytes();
}

std::string imu_message(const motion::ImuSample& sample, std::string_view frame, MessageEncoding encoding) {
  MessageWriter writer(encoding);
  writer.header(sample.stamp_ns, frame).number(0.0).number(0.0).number(0.0).number(1.0);
  covariance(writer, not_measured());
  vector(writer, sample.angular_rate_radps);
  covariance(writer, Eigen::Matrix3d::Zero());
  vector(writer, sample.specific_force_mps2);
  covariance(writer, Eigen::Matrix3d::Zero());
  return writer.bytes();
}

std::string fix_message(const motion::GnssFix& fix, int status, std::string_view frame, MessageEncoding encoding) {
  MessageWriter writer(encoding);
  writer.header(fix.stamp_ns, frame).number(static_cast<std::int8_t>(status)).number<std::uint16_t>(1);
  writer.number(fix.latitude_rad * 180.0 / kPi).number(fix.longitude_rad * 180.0 / kPi).number(fix.height_m);
  const bool known = fix.covariance_enu_m2.allFinite();
  covariance(writer, known ? fix.covariance_enu_m2 : Eigen::Matrix3d(Eigen::Matrix3d::Zero()));
  constexpr std::uint8_t kUnknown = 0, kKnown = 3;
  return writer.number(known ? kKnown : kUnknown).bytes();
}

std::string inspva_message(const InspvaContent& content, std::string_view frame, MessageEncoding encoding) {
  MessageWriter writer(encoding);
  oem7_header(writer, "INSPVA", 507, content.stamp_ns, frame);
  const Eigen::Vector3d& velocity = content.velocity_enu_mps;
  for (const double value :
       {radians_to_degrees(content.latitude_rad), radians_to_degrees(content.longitude_rad), content.height_m,
        velocity.y(), velocity.x(), velocity.z(), content.roll_deg, content.pitch_deg, content.azimuth_deg})
    writer.number(value);
  return writer.number(content.ins_status).bytes();
}

std::string insstdev_message(std::int64_t stamp_ns, const Eigen::Vector3d& position_sigma_enu_m,
                             double attitude_sigma_deg, std::string_view frame, MessageEncoding encoding) {
  MessageWriter writer(encoding);
  oem7_header(writer, "INSSTDEV", 2051, stamp_ns, frame);
  const Eigen::Vector3d& sigma = position_sigma_enu_m;
  for (const double value :
       {sigma.y(), sigma.x(), sigma.z(), 0.0, 0.0, 0.0, attitude_sigma_deg, attitude_sigma_deg, attitude_sigma_deg})
    writer.number(static_cast<float>(value));
  writer.number<std::uint32_t>(0).number<std::uint16_t>(0).number<std::uint16_t>(0);
  return writer.number<std::uint32_t>(0).number<std::uint32_t>(0).bytes();
}

}  // namespace remount::bags
