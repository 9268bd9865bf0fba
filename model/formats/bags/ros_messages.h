// The messages that a calibration lives on, as values: those of ROS, and what those of others (Apollo's) become.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "algorithms/geometry/rigid_transform.h"
#include "model/formats/bags/message_reader.h"
#include "model/formats/ins/novatel_values.h"

namespace remount::bags {

enum class MessageKind {
  Other,
  PointCloud2,
  LivoxCustom,   ///< livox_ros_driver/CustomMsg and its successors
  LidarPackets,  ///< of the types of packet_messages.cpp
  Imu,
  NavSatFix,
  Odometry,
  PoseStamped,
  PoseWithCovarianceStamped,
  TransformStamped,
  Inspvax,
  Inspva,
  Insstdev,    ///< errors of INSPVA
  Transforms,  ///< tf2_msgs/TFMessage
  // Of makers' own drivers: see ins_messages.h.
  GpsFix,
  SbgNav,
  SbgQuat,
  SbgEuler,
  GnssInsOrientation,
  InsNavGeod,
  Gsof49,
  Gsof50,  ///< errors of Gsof49
  OxtsNcom,
  NmeaSentence,
  // Of Apollo: see apollo_messages.h. Its TransformStampeds are Transforms.
  ApolloCloud,
  ApolloGps,
  ApolloLocalization,
  ApolloBestPose,
  ApolloInsStat,  ///< how good the positions of ApolloGps are
};
/// Of a topic's type, "sensor_msgs/Imu".
MessageKind message_kind(std::string_view type);
/// Odometry, PoseStamped, PoseWithCovarianceStamped or TransformStamped; ApolloGps or ApolloLocalization.
bool is_pose(MessageKind kind);
/// PointCloud2, LivoxCustom or ApolloCloud.
bool is_cloud(MessageKind kind);
/// NovAtel's own solution: INSPVAX or INSPVA.
bool is_inspva(MessageKind kind);
/// The whole solution of an INS, of whatever make.
bool is_solution(MessageKind kind);
/// An orientation that positions of their own go with.
bool is_attitude(MessageKind kind);
/// A position alone.
bool is_fix(MessageKind kind);
/// Whether a type holds a LiDAR's packets as they came over the wire, which the sensor's driver makes points of.
bool is_raw_packets(std::string_view type);

/// sensor_msgs/Imu.
struct ImuMessage {
  MessageHeader header;
  std::optional<Eigen::Quaterniond> orientation;  ///< world_from_imu; nothing where the driver says it has none
  /// Exactly the identity, without a covariance: what the message holds in ROS 2 where nobody has filled it in. An INS
  /// may pass through it, a topic that has nothing else has no orientation.
  bool orientation_is_default = false;
  Eigen::Vector3d orientation_variance_rad2 = Eigen::Vector3d::Zero();  ///< zero: not known
  /// Nothing where the driver says it has none and it is zero.
  std::optional<Eigen::Vector3d> angular_rate_radps;
  std::optional<Eigen::Vector3d> acceleration_mps2;  ///< likewise; with gravity: +9.8 upwards at rest
  bool denied = false;                               ///< one of them is there, though the driver says it has none
};
ImuMessage read_imu(MessageReader& reader);

/// sensor_msgs/NavSatFix.
struct FixMessage {
  MessageHeader header;
  int status = 0;  ///< -1 no fix, 0 fix, 1 with satellite-based, 2 with ground-based augmentation
  /// NovAtel's number of how it was found, which tells more than the status; empty where the message has none.
  std::string position_type{};
  double latitude_rad = 0.0, longitude_rad = 0.0;
  double height_m = 0.0;                             ///< above the ellipsoid
  std::optional<Eigen::Matrix3d> covariance_enu_m2;  ///< nothing: not known
};
FixMessage read_fix(MessageReader& reader);

/// A pose of any of the kinds of is_pose.
struct PoseMessage {
  MessageHeader header;
  std::string child_frame;  ///< empty where the kind has none
  RigidTransform world_from_child = RigidTransform::Identity();
};
PoseMessage read_pose(MessageReader& reader, MessageKind kind);
/// Whether such a message has an orientation: a field that nobody fills in is all zero, or no number.
bool has_orientation(MessageReader& reader, MessageKind kind);

/// tf2_msgs/TFMessage: each takes coordinates of child_frame to the frame of its header.
std::vector<PoseMessage> read_transforms(MessageReader& reader);

/// INSPVAX as three drivers write it, told apart by the type's package: novatel_msgs (the log's own binary layout),
/// novatel_gps_msgs (Inspvax, and Inspvax2 since September 2026), novatel_oem7_msgs. INSPVA of the last two is the same
/// without errors and position type, and with heights above the ellipsoid; so is INSPVAS of novatel_oem6_msgs.
struct InspvaxMessage {
  std::string position_type;  ///< by number or by name, as the driver has it; empty in INSPVA
  bool misnamed = false;      ///< its status is named after the wrong table (is_of_wrong_table)
  motion::InsSample sample;   ///< stamped with GPS time as UTC; INS axes x right, y forward, z up
  std::string frame;          ///< empty in novatel_msgs
};
InspvaxMessage read_inspvax_message(MessageReader& reader, std::string_view type);
/// INSSTDEV of novatel_gps_msgs or novatel_oem7_msgs, stamped as above.
formats::StampedSigma read_insstdev_message(MessageReader& reader, std::string_view type);

}  // namespace remount::bags
