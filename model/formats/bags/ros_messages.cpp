#include "model/formats/bags/ros_messages.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "algorithms/core/error.h"
#include "messages/bags.h"
#include "model/conventions/impossible_motion.h"
#include "model/drive/plausible_values.h"
#include "model/formats/bags/apollo_messages.h"
#include "model/formats/bags/packet_messages.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/time_stamp.h"

namespace remount::bags {
namespace {

[[noreturn]] void fail_message(const MessageReader& reader, Message what) {
  throw Error(ErrorCode::Format, reader.where(), std::move(what));
}

Eigen::Vector3d read_vector(MessageReader& reader) {
  const auto v = reader.doubles<3>();
  return {v[0], v[1], v[2]};
}

/// As written; x, y, z, w.
Eigen::Quaterniond read_quaternion(MessageReader& reader) {
  const auto q = reader.doubles<4>();
  return {q[3], q[0], q[1], q[2]};
}

Eigen::Quaterniond checked(const Eigen::Quaterniond& q, const MessageReader& reader) {
  const double norm = q.norm();
  // Drivers that write floats are off by 1e-7; nothing that means a rotation is off by a tenth.
  if (!(std::abs(norm - 1.0) < 0.1)) fail_message(reader, say::bag_orientation_not_unit());
  return q.normalized();
}

Eigen::Matrix3d read_covariance(MessageReader& reader) {
  const auto c = reader.doubles<9>();
  Eigen::Matrix3d covariance;
  covariance << c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7], c[8];
  return covariance;
}

/// A vector with its covariance. Minus one says "not measured"; a driver that says so of a vector that is filled in
/// (novatel_oem7_driver does) means that it does not know the covariance.
/// @param denied becomes true where that is the case
std::optional<Eigen::Vector3d> read_measured(MessageReader& reader, bool& denied) {
  const Eigen::Vector3d value = read_vector(reader);
  const bool declared = read_covariance(reader)(0, 0) != -1.0;
  const bool known = !drive::means_not_known(value.cwiseAbs().maxCoeff()) && value.allFinite();
  const bool there = known && (declared || !value.isZero(0.0));
  denied = denied || (there && !declared);
  return there ? std::optional(value) : std::nullopt;
}

RigidTransform read_rigid(MessageReader& reader) {
  const Eigen::Vector3d translation = read_vector(reader);
  const Eigen::Quaterniond rotation = checked(read_quaternion(reader), reader);
  if (!translation.allFinite()) fail_message(reader, say::bag_position_not_finite());
  if (!conventions::is_possible_position(translation)) fail_message(reader, say::bag_position_too_far());
  return make_rigid(rotation.toRotationMatrix(), translation);
}

std::string frame_name(std::string_view name) {
  while (name.starts_with('/')) name.remove_prefix(1);
  return std::string(name);
}

void read_errors(MessageReader& reader, formats::NovatelValues& values) {
  values.latitude_std_m = reader.number<float>();
  values.longitude_std_m = reader.number<float>();
  values.height_std_m = reader.number<float>();
  for (int i = 0; i < 3; ++i) reader.number<float>();  // of the velocity
  values.roll_std_deg = reader.number<float>();
  values.pitch_std_deg = reader.number<float>();
  values.azimuth_std_deg = reader.number<float>();
}

/// Latitude to azimuth, then nine sigmas: alike in all three drivers.
formats::NovatelValues read_values(MessageReader& reader) {
  formats::NovatelValues values;
  values.latitude_deg = reader.number<double>();
  values.longitude_deg = reader.number<double>();
  values.height_m = reader.number<double>();
  values.undulation_m = reader.number<float>();
  reader.doubles<3>();  // velocity
  values.roll_deg = reader.number<double>();
  values.pitch_deg = reader.number<double>();
  values.azimuth_deg = reader.number<double>();
  read_errors(reader, values);
  return values;
}

/// Of INSPVA: latitude to azimuth.
formats::NovatelValues read_values_without_errors(MessageReader& reader) {
  formats::NovatelValues values;
  values.latitude_deg = reader.number<double>();
  values.longitude_deg = reader.number<double>();
  values.height_m = reader.number<double>();
  reader.doubles<3>();  // velocity
  values.roll_deg = reader.number<double>();
  values.pitch_deg = reader.number<double>();
  values.azimuth_deg = reader.number<double>();
  return values;
}

/// Whatever stands between the ROS header and the status.
struct GpsTime {
  std::int64_t week = 0, time_of_week_ns = 0;
};

std::int64_t stamp_of(const GpsTime& time, const MessageReader& reader) {
  const auto stamp_ns = formats::unix_ns_from_gps_week(time.week, time.time_of_week_ns);
  if (!stamp_ns) fail_message(reader, say::bag_gps_time());
  return *stamp_ns;
}

/// novatel_msgs/CommonHeader: the header of the receiver's binary logs.
GpsTime read_span_header(MessageReader& reader) {
  GpsTime time;
  reader.number<std::uint16_t>();                             // message
  for (int i = 0; i < 2; ++i) reader.number<std::uint8_t>();  // type, port
  for (int i = 0; i < 2; ++i) reader.number<std::uint16_t>();
  for (int i = 0; i < 2; ++i) reader.number<std::uint8_t>();  // idle time, time status
  time.week = reader.number<std::uint16_t>();
  time.time_of_week_ns = std::int64_t{reader.number<std::uint32_t>()} * 1'000'000;
  reader.number<std::uint32_t>();  // receiver status
  for (int i = 0; i < 2; ++i) reader.number<std::uint16_t>();
  return time;
}

GpsTime read_week_and_seconds(MessageReader& reader) {
  GpsTime time;
  time.week = reader.number<std::uint32_t>();
  const double seconds = reader.number<double>();
  if (!(seconds >= 0.0 && seconds <= 604'800.0)) fail_message(reader, say::bag_gps_seconds());
  time.time_of_week_ns = std::llround(seconds * 1e9);
  return time;
}

/// novatel_gps_msgs/NovatelMessageHeader.
GpsTime read_gps_driver_header(MessageReader& reader) {
  reader.string();                 // message
  reader.string();                 // port
  reader.number<std::uint32_t>();  // sequence
  reader.number<float>();          // idle time
  reader.string();                 // time status
  const GpsTime time = read_week_and_seconds(reader);
  constexpr int kReceiverFlags = 23;
  reader.number<std::uint32_t>();  // receiver status, in bits and once more flag by flag
  for (int i = 0; i < kReceiverFlags; ++i) reader.number<std::uint8_t>();
  reader.number<std::uint32_t>();  // software version
  return time;
}

/// novatel_oem7_msgs/Oem7Header.
GpsTime read_oem7_header(MessageReader& reader) {
  GpsTime time;
  reader.string();                 // message
  reader.number<std::uint16_t>();  // its number
  reader.number<std::uint8_t>();   // type
  reader.number<std::uint32_t>();  // sequence
  reader.number<std::uint8_t>();   // time status
  time.week = reader.number<std::uint16_t>();
  time.time_of_week_ns = std::int64_t{reader.number<std::uint32_t>()} * 1'000'000;
  return time;
}

constexpr std::pair<std::string_view, MessageKind> kKinds[] = {
    {"sensor_msgs/PointCloud2", MessageKind::PointCloud2},
    {"livox_ros_driver/CustomMsg", MessageKind::LivoxCustom},
    {"livox_ros_driver2/CustomMsg", MessageKind::LivoxCustom},
    {"livox_interfaces/CustomMsg", MessageKind::LivoxCustom},
    {"sensor_msgs/Imu", MessageKind::Imu},
    {"sensor_msgs/NavSatFix", MessageKind::NavSatFix},
    {"nav_msgs/Odometry", MessageKind::Odometry},
    {"geometry_msgs/PoseStamped", MessageKind::PoseStamped},
    {"geometry_msgs/PoseWithCovarianceStamped", MessageKind::PoseWithCovarianceStamped},
    {"geometry_msgs/TransformStamped", MessageKind::TransformStamped},
    {"novatel_msgs/INSPVAX", MessageKind::Inspvax},
    {"novatel_gps_msgs/Inspvax", MessageKind::Inspvax},
    {"novatel_gps_msgs/Inspvax2", MessageKind::Inspvax},
    {"novatel_oem7_msgs/INSPVAX", MessageKind::Inspvax},
    {"novatel_gps_msgs/Inspva", MessageKind::Inspva},
    {"novatel_oem7_msgs/INSPVA", MessageKind::Inspva},
    {"novatel_oem6_msgs/INSPVAS", MessageKind::Inspva},
    {"novatel_gps_msgs/Insstdev", MessageKind::Insstdev},
    {"novatel_gps_msgs/Insstdev2", MessageKind::Insstdev},
    {"novatel_oem7_msgs/INSSTDEV", MessageKind::Insstdev},
    {"gps_common/GPSFix", MessageKind::GpsFix},
    {"gps_msgs/GPSFix", MessageKind::GpsFix},
    {"sbg_driver/SbgEkfNav", MessageKind::SbgNav},
    {"sbg_driver/SbgEkfQuat", MessageKind::SbgQuat},
    {"sbg_driver/SbgEkfEuler", MessageKind::SbgEuler},
    {"autoware_sensing_msgs/GnssInsOrientationStamped", MessageKind::GnssInsOrientation},
    {"septentrio_gnss_driver/INSNavGeod", MessageKind::InsNavGeod},
    {"applanix_msgs/NavigationSolutionGsof49", MessageKind::Gsof49},
    {"applanix_msgs/NavigationPerformanceGsof50", MessageKind::Gsof50},
    {"oxts_msgs/Ncom", MessageKind::OxtsNcom},
    {"nmea_msgs/Sentence", MessageKind::NmeaSentence},
    {"tf2_msgs/TFMessage", MessageKind::Transforms},
    {"tf/tfMessage", MessageKind::Transforms},
    {"apollo.drivers.PointCloud", MessageKind::ApolloCloud},
    {"apollo.localization.Gps", MessageKind::ApolloGps},
    {"apollo.localization.LocalizationEstimate", MessageKind::ApolloLocalization},
    {"apollo.drivers.gnss.GnssBestPose", MessageKind::ApolloBestPose},
    {"apollo.drivers.gnss.InsStat", MessageKind::ApolloInsStat},
    {"apollo.transform.TransformStampeds", MessageKind::Transforms},
};

}  // namespace

MessageKind message_kind(std::string_view type) {
  for (const auto& [name, kind] : kKinds)
    if (name == type) return kind;
  return holds_lidar_packets(type) ? MessageKind::LidarPackets : MessageKind::Other;
}

bool is_pose(MessageKind kind) {
  return kind == MessageKind::Odometry || kind == MessageKind::PoseStamped ||
         kind == MessageKind::PoseWithCovarianceStamped || kind == MessageKind::TransformStamped ||
         is_apollo_pose(kind);
}

bool is_cloud(MessageKind kind) {
  return kind == MessageKind::PointCloud2 || kind == MessageKind::LivoxCustom || kind == MessageKind::ApolloCloud;
}

bool is_inspva(MessageKind kind) { return kind == MessageKind::Inspvax || kind == MessageKind::Inspva; }

bool is_solution(MessageKind kind) {
  return is_inspva(kind) || kind == MessageKind::InsNavGeod || kind == MessageKind::Gsof49 ||
         kind == MessageKind::OxtsNcom;
}

bool is_attitude(MessageKind kind) {
  return kind == MessageKind::Imu || kind == MessageKind::SbgQuat || kind == MessageKind::SbgEuler ||
         kind == MessageKind::GnssInsOrientation;
}

bool is_fix(MessageKind kind) {
  return kind == MessageKind::NavSatFix || kind == MessageKind::GpsFix || kind == MessageKind::SbgNav;
}

bool is_raw_packets(std::string_view type) {
  const std::size_t slash = std::min(type.find('/'), type.size());
  const std::string package = formats::lower_case(type.substr(0, slash));
  const std::string name = formats::lower_case(type.substr(std::min(slash + 1, type.size())));
  // VelodynePacket, PacketMsg, NebulaPackets, RslidarPacket, UdpFrame; VelodyneScan, PandarScan, rslidarScan.
  return name.find("packet") != std::string::npos || name == "udpframe" ||
         (name.ends_with("scan") && package != "sensor_msgs");
}

ImuMessage read_imu(MessageReader& reader) {
  ImuMessage message;
  message.header = read_header(reader);
  const Eigen::Quaterniond orientation = read_quaternion(reader);
  const Eigen::Matrix3d orientation_covariance = read_covariance(reader);
  // Minus one says "not measured"; some drivers leave all zero instead, or what is no number.
  if (orientation_covariance(0, 0) != -1.0 && orientation.norm() > 0.0 && orientation.coeffs().allFinite()) {
    message.orientation = checked(orientation, reader);
    const Eigen::Vector3d variance = orientation_covariance.diagonal();
    if (variance.allFinite() && variance.minCoeff() > 0.0) message.orientation_variance_rad2 = variance;
    message.orientation_is_default = orientation.coeffs() == Eigen::Quaterniond::Identity().coeffs() &&
                                     orientation_covariance == Eigen::Matrix3d::Zero();
  }
  message.angular_rate_radps = read_measured(reader, message.denied);
  message.acceleration_mps2 = read_measured(reader, message.denied);
  return message;
}

FixMessage read_fix(MessageReader& reader) {
  FixMessage message;
  message.header = read_header(reader);
  message.status = reader.number<std::int8_t>();
  reader.number<std::uint16_t>();  // which satellites
  message.latitude_rad = degrees_to_radians(reader.number<double>());
  message.longitude_rad = degrees_to_radians(reader.number<double>());
  message.height_m = reader.number<double>();
  const Eigen::Matrix3d covariance = read_covariance(reader);
  const bool known = reader.number<std::uint8_t>() != 0;
  const double largest_sigma_m = std::sqrt(std::max(0.0, covariance.diagonal().maxCoeff()));
  if (known && covariance.allFinite() && covariance.diagonal().minCoeff() > 0.0 &&
      !drive::means_not_known(largest_sigma_m))
    message.covariance_enu_m2 = covariance;
  // Without a fix receivers write NaN: such a message is whole, and its reader looks at the status.
  if (message.status >= 0 && !drive::plausible_geodetic(message.latitude_rad, message.longitude_rad, message.height_m))
    fail_message(reader, say::bag_place_impossible());
  return message;
}

PoseMessage read_pose(MessageReader& reader, MessageKind kind) {
  if (is_apollo_pose(kind)) return read_apollo_pose(reader, kind);
  PoseMessage message;
  message.header = read_header(reader);
  if (kind == MessageKind::Odometry || kind == MessageKind::TransformStamped)
    message.child_frame = frame_name(reader.string());
  message.world_from_child = read_rigid(reader);
  return message;
}

bool has_orientation(MessageReader& reader, MessageKind kind) {
  if (is_apollo_pose(kind)) return apollo_pose_has_orientation(reader, kind);
  read_header(reader);
  if (kind == MessageKind::Odometry || kind == MessageKind::TransformStamped) reader.string();
  read_vector(reader);
  const Eigen::Quaterniond orientation = read_quaternion(reader);
  return orientation.coeffs().allFinite() && orientation.norm() > 0.0;
}

std::vector<PoseMessage> read_transforms(MessageReader& reader) {
  if (reader.encoding() == MessageEncoding::Protobuf) return read_apollo_transforms(reader);
  constexpr std::size_t kLeastBytes = 64;
  std::vector<PoseMessage> transforms;
  for (std::size_t left = reader.sequence(kLeastBytes); left > 0; --left)
    transforms.push_back(read_pose(reader, MessageKind::TransformStamped));
  return transforms;
}

InspvaxMessage read_inspvax_message(MessageReader& reader, std::string_view type) {
  InspvaxMessage message;
  GpsTime time;
  std::string status;
  formats::NovatelValues values;
  const bool errors = message_kind(type) == MessageKind::Inspvax;
  const auto numbered = [&] { return std::to_string(reader.number<std::uint32_t>()); };
  const bool named = type.starts_with("novatel_gps_msgs/"), oem6 = type.starts_with("novatel_oem6_msgs/");
  if (type.starts_with("novatel_msgs/")) {
    time = read_span_header(reader);
  } else {
    message.frame = read_header(reader).frame;
    if (!oem6) time = named ? read_gps_driver_header(reader) : read_oem7_header(reader);
  }
  const auto word = [&] { return named ? std::string(reader.string()) : numbered(); };
  if (errors) {
    status = word();
    message.position_type = word();
    values = read_values(reader);
  } else {
    if (named || oem6) time = read_week_and_seconds(reader);  // of the log's body
    values = read_values_without_errors(reader);
    status = word();
  }
  values.quality = formats::novatel_quality(status);
  message.misnamed = formats::is_of_wrong_table(status);
  const std::int64_t stamp_ns = stamp_of(time, reader);
  message.sample = formats::ins_sample(values, reader.where());
  message.sample.stamp_ns = stamp_ns;
  return message;
}

formats::StampedSigma read_insstdev_message(MessageReader& reader, std::string_view type) {
  read_header(reader);
  const GpsTime time =
      type.starts_with("novatel_gps_msgs/") ? read_gps_driver_header(reader) : read_oem7_header(reader);
  formats::NovatelValues values;
  read_errors(reader, values);
  return {stamp_of(time, reader), formats::ins_sigma(values)};
}

}  // namespace remount::bags
