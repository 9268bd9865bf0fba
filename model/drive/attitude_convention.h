// Attitude as logs write it, to enu_from_ins. Each convention is spelled out once, here.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <string_view>

#include "algorithms/messages/message.h"

namespace remount::drive {

/// Axes of the INS frame, as the log itself defines them. X = ins_from_lidar is expressed in these.
enum class InsAxes {
  ForwardLeftUp,   ///< x forward, y left, z up: OXTS as KITTI uses it, and every log without axes of its own
  RightForwardUp,  ///< x right, y forward, z up: NovAtel SPAN's body frame
  // Boxes that are built in as there was room; only the direction of travel tells.
  BackwardRightUp,
  LeftBackwardUp,
};
inline constexpr std::size_t kInsAxesCount = 4;
/// "x forward, y left, z up": as files name them.
std::string_view to_string(InsAxes axes);
/// The same as words of a sentence.
Message axes_words(InsAxes axes);

enum class AttitudeConvention {
  /// Yaw from east counter-clockwise; pitch positive nose *down*; roll positive right side down. INS axes
  /// forward-left-up.
  /// R = Rz(yaw) Ry(pitch) Rx(roll). OXTS as KITTI writes it.
  EnuYaw,
  /// Heading from true north clockwise; pitch positive nose *up*; roll positive right side down. INS axes
  /// forward-left-up.
  /// R = Rz(90 deg - heading) Ry(-pitch) Rx(roll).
  Heading,
  /// The angles of `Heading`, for NovAtel's body axes right-forward-up. R = Rz(-azimuth) Rx(pitch) Ry(roll).
  NovAtel,
};
std::string_view to_string(AttitudeConvention convention);  ///< "enu-yaw", "heading", "novatel"
std::optional<AttitudeConvention> attitude_convention_from_string(std::string_view text);
InsAxes axes_of(AttitudeConvention convention);

/// Angles as a log names them; which way they count is the convention's.
struct AttitudeAngles {
  double yaw_rad = 0.0;  ///< or heading, azimuth
  double pitch_rad = 0.0;
  double roll_rad = 0.0;
};

/// enu_from_ins, INS axes as axes_of(convention).
Eigen::Quaterniond enu_from_ins(const AttitudeAngles& angles, AttitudeConvention convention);
/// The inverse; pitch in [-90, 90] degrees, yaw in (-180, 180] (EnuYaw) or [0, 360) degrees.
AttitudeAngles angles_from(const Eigen::Quaterniond& enu_from_ins, AttitudeConvention convention);

/// 1-sigma of the three angles, ordered about the INS axes x, y, z, to first order and for a nearly level vehicle.
Eigen::Vector3d axis_sigma_rad(const AttitudeAngles& sigma, AttitudeConvention convention);

enum class QuaternionConvention {
  EnuFromIns,   ///< takes forward-left-up to east-north-up: ROS
  NedFromBody,  ///< takes forward-right-down to north-east-down: aerospace logs
};
std::string_view to_string(QuaternionConvention convention);  ///< "quaternion-enu", "quaternion-ned"
std::optional<QuaternionConvention> quaternion_convention_from_string(std::string_view text);

/// enu_from_ins with INS axes forward-left-up; normalised.
Eigen::Quaterniond enu_from_ins(const Eigen::Quaterniond& logged, QuaternionConvention convention);

}  // namespace remount::drive
