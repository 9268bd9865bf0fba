#include "model/drive/attitude_convention.h"

#include <array>

#include "algorithms/core/index.h"
#include "algorithms/geometry/rotation.h"
#include "messages/poses.h"

namespace remount::drive {

namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr std::array<std::string_view, 3> kAttitudeNames{"enu-yaw", "heading", "novatel"};
constexpr std::array<std::string_view, 2> kQuaternionNames{"quaternion-enu", "quaternion-ned"};

/// x right, y forward from x forward, y left.
Quaterniond right_forward_up_from_forward_left_up() { return Quaterniond(AngleAxisd(kPi / 2.0, Vector3d::UnitZ())); }

double positive_angle(double angle_rad) { return angle_rad < 0.0 ? angle_rad + 2.0 * kPi : angle_rad; }

template <class Enumeration, std::size_t N>
std::optional<Enumeration> find_name(const std::array<std::string_view, N>& names, std::string_view text) {
  for (std::size_t i = 0; i < N; ++i)
    if (names[i] == text) return static_cast<Enumeration>(i);
  return std::nullopt;
}

}  // namespace

std::string_view to_string(InsAxes axes) {
  constexpr std::string_view kNames[kInsAxesCount] = {"x forward, y left, z up", "x right, y forward, z up",
                                                      "x backward, y right, z up", "x left, y backward, z up"};
  return kNames[index_of(axes)];
}

Message axes_words(InsAxes axes) {
  constexpr Message (*kWords[kInsAxesCount])() = {say::axes_forward_left_up, say::axes_right_forward_up,
                                                  say::axes_backward_right_up, say::axes_left_backward_up};
  return kWords[index_of(axes)]();
}

std::string_view to_string(AttitudeConvention convention) { return kAttitudeNames[index_of(convention)]; }

std::optional<AttitudeConvention> attitude_convention_from_string(std::string_view text) {
  return find_name<AttitudeConvention>(kAttitudeNames, text);
}

std::string_view to_string(QuaternionConvention convention) { return kQuaternionNames[index_of(convention)]; }

std::optional<QuaternionConvention> quaternion_convention_from_string(std::string_view text) {
  return find_name<QuaternionConvention>(kQuaternionNames, text);
}

InsAxes axes_of(AttitudeConvention convention) {
  return convention == AttitudeConvention::NovAtel ? InsAxes::RightForwardUp : InsAxes::ForwardLeftUp;
}

Quaterniond enu_from_ins(const AttitudeAngles& angles, AttitudeConvention convention) {
  const auto about = [](double angle_rad, const Vector3d& axis) { return AngleAxisd(angle_rad, axis); };
  switch (convention) {
    case AttitudeConvention::EnuYaw:
      return about(angles.yaw_rad, Vector3d::UnitZ()) * about(angles.pitch_rad, Vector3d::UnitY()) *
             about(angles.roll_rad, Vector3d::UnitX());
    case AttitudeConvention::Heading:
      return about(kPi / 2.0 - angles.yaw_rad, Vector3d::UnitZ()) * about(-angles.pitch_rad, Vector3d::UnitY()) *
             about(angles.roll_rad, Vector3d::UnitX());
    default:
      return about(-angles.yaw_rad, Vector3d::UnitZ()) * about(angles.pitch_rad, Vector3d::UnitX()) *
             about(angles.roll_rad, Vector3d::UnitY());
  }
}

AttitudeAngles angles_from(const Quaterniond& enu_from_ins, AttitudeConvention convention) {
  Quaterniond enu_from_flu = enu_from_ins.normalized();
  if (convention == AttitudeConvention::NovAtel) enu_from_flu = enu_from_flu * right_forward_up_from_forward_left_up();
  const YawPitchRoll flu = yaw_pitch_roll_from_rotation(enu_from_flu.toRotationMatrix());
  if (convention == AttitudeConvention::EnuYaw) return {flu.yaw_rad, flu.pitch_rad, flu.roll_rad};
  return {positive_angle(wrap_angle_rad(kPi / 2.0 - flu.yaw_rad)), -flu.pitch_rad, flu.roll_rad};
}

Vector3d axis_sigma_rad(const AttitudeAngles& sigma, AttitudeConvention convention) {
  if (convention == AttitudeConvention::NovAtel) return {sigma.pitch_rad, sigma.roll_rad, sigma.yaw_rad};
  return {sigma.roll_rad, sigma.pitch_rad, sigma.yaw_rad};
}

Quaterniond enu_from_ins(const Quaterniond& logged, QuaternionConvention convention) {
  if (convention == QuaternionConvention::EnuFromIns) return logged.normalized();
  // Half a turn about the diagonal of x and y swaps east with north and up with down.
  const Quaterniond enu_from_ned(0.0, std::sqrt(0.5), std::sqrt(0.5), 0.0);
  const Quaterniond body_from_flu(AngleAxisd(kPi, Vector3d::UnitX()));
  return (enu_from_ned * logged.normalized() * body_from_flu).normalized();
}

}  // namespace remount::drive
