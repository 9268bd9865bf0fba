// Messages of ROS from values: what MessageReader and ros_messages.h read.
#pragma once

#include <cstring>
#include <string>
#include <string_view>

#include "algorithms/cloud/point_cloud.h"
#include "model/drive/session.h"
#include "model/formats/bags/message_reader.h"

namespace remount::bags {

/// Writes the fields of a message in the order of its definition; little-endian.
class MessageWriter {
 public:
  /// @param encoding Ros1 or Cdr
  explicit MessageWriter(MessageEncoding encoding);

  template <class T>
  MessageWriter& number(T value) {
    align(sizeof(T));
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    bytes_.append(raw, sizeof(T));
    return *this;
  }
  MessageWriter& string(std::string_view text);
  /// A sequence of 8-bit numbers.
  MessageWriter& byte_sequence(std::string_view bytes);
  MessageWriter& time(std::int64_t stamp_ns);
  /// std_msgs/Header.
  MessageWriter& header(std::int64_t stamp_ns, std::string_view frame);

  const std::string& bytes() const { return bytes_; }

 private:
  void align(std::size_t bytes);

  MessageEncoding encoding_;
  std::size_t start_;  // of what is aligned
  std::string bytes_;
};

/// What a topic's description in a bag needs.
struct MessageDefinition {
  std::string type;  ///< "sensor_msgs/Imu"; in ROS 2 "sensor_msgs/msg/Imu"
  std::string md5;   ///< of ROS 1
  std::string text;  ///< with the definitions of what it contains
};
/// The part of a definition that is of a message within it; and those of std_msgs/Header and what is in it.
std::string definition_part(std::string_view type, std::string_view fields);
std::string header_definition_part(MessageEncoding encoding);
/// Of sensor_msgs/PointCloud2, Imu or NavSatFix, std_msgs/String or UInt8MultiArray, novatel_oem7_msgs/INSPVA or
/// INSSTDEV, or a type that holds_lidar_packets. Throws Error(Contract) for other types.
MessageDefinition message_definition(std::string_view type, MessageEncoding encoding);

/// sensor_msgs/PointCloud2 with x, y, z and those of intensity, ring (16 bits) and time (float, seconds from the stamp)
/// that are there: the layout of Velodyne's driver.
std::string cloud_message(const cloud::PointCloud& cloud, std::int64_t stamp_ns, std::string_view frame,
                          MessageEncoding encoding);
/// std_msgs/String, and std_msgs/UInt8MultiArray without dimensions.
std::string text_message(std::string_view text, MessageEncoding encoding);
std::string bytes_message(std::string_view bytes, MessageEncoding encoding);
/// sensor_msgs/Imu with an orientation and nothing else. @param attitude_sigma_rad NaN: not known
std::string attitude_message(const motion::InsSample& sample, double attitude_sigma_rad, std::string_view frame,
                             MessageEncoding encoding);
/// sensor_msgs/Imu without orientation.
std::string imu_message(const motion::ImuSample& sample, std::string_view frame, MessageEncoding encoding);
/// sensor_msgs/NavSatFix. @param status as there: 0 fix, 2 with ground-based augmentation
std::string fix_message(const motion::GnssFix& fix, int status, std::string_view frame, MessageEncoding encoding);

/// What INSPVA says, in NovAtel's axes.
struct InspvaContent {
  std::int64_t stamp_ns = 0;  ///< UTC; written as GPS time, in milliseconds
  double latitude_rad = 0.0, longitude_rad = 0.0;
  double height_m = 0.0;  ///< above the ellipsoid
  Eigen::Vector3d velocity_enu_mps = Eigen::Vector3d::Zero();
  double roll_deg = 0.0, pitch_deg = 0.0, azimuth_deg = 0.0;
  std::uint32_t ins_status = 3;  ///< of the inertial solution: 3 is good, 2 of high variance
};
/// novatel_oem7_msgs/INSPVA.
std::string inspva_message(const InspvaContent& content, std::string_view frame, MessageEncoding encoding);
/// novatel_oem7_msgs/INSSTDEV with one error for all angles.
std::string insstdev_message(std::int64_t stamp_ns, const Eigen::Vector3d& position_sigma_enu_m,
                             double attitude_sigma_deg, std::string_view frame, MessageEncoding encoding);

}  // namespace remount::bags
