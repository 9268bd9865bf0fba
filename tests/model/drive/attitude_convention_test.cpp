#include "model/drive/attitude_convention.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "algorithms/geometry/rotation.h"

namespace remount::drive {
namespace {

using Eigen::Vector3d;

AttitudeAngles degrees(double yaw, double pitch, double roll) {
  return {degrees_to_radians(yaw), degrees_to_radians(pitch), degrees_to_radians(roll)};
}

/// The way the nose and the right-hand side of the vehicle point, in east, north, up.
struct Directions {
  Vector3d nose, right;
};
Directions directions(const AttitudeAngles& angles, AttitudeConvention convention) {
  const Eigen::Quaterniond enu_from = enu_from_ins(angles, convention);
  if (axes_of(convention) == InsAxes::RightForwardUp)
    return {enu_from * Vector3d::UnitY(), enu_from * Vector3d::UnitX()};
  return {enu_from * Vector3d::UnitX(), enu_from * -Vector3d::UnitY()};
}

void expect_near(const Vector3d& value, const Vector3d& expected) {
  EXPECT_LT((value - expected).norm(), 1e-12) << value.transpose() << " expected " << expected.transpose();
}

const double kSin10 = std::sin(degrees_to_radians(10.0)), kCos10 = std::cos(degrees_to_radians(10.0));

TEST(attitude_convention, heading_east_is_ninety_degrees_from_north_and_zero_from_east) {
  for (const auto convention : {AttitudeConvention::Heading, AttitudeConvention::NovAtel}) {
    expect_near(directions(degrees(90, 0, 0), convention).nose, {1, 0, 0});
    expect_near(directions(degrees(0, 0, 0), convention).nose, {0, 1, 0});
    expect_near(directions(degrees(0, 0, 0), convention).right, {1, 0, 0});
  }
  expect_near(directions(degrees(0, 0, 0), AttitudeConvention::EnuYaw).nose, {1, 0, 0});
  expect_near(directions(degrees(90, 0, 0), AttitudeConvention::EnuYaw).nose, {0, 1, 0});
  expect_near(directions(degrees(90, 0, 0), AttitudeConvention::EnuYaw).right, {1, 0, 0});
}

TEST(attitude_convention, pitch_lifts_the_nose_where_the_convention_says_so) {
  expect_near(directions(degrees(90, 10, 0), AttitudeConvention::Heading).nose, {kCos10, 0, kSin10});
  expect_near(directions(degrees(90, 10, 0), AttitudeConvention::NovAtel).nose, {kCos10, 0, kSin10});
  expect_near(directions(degrees(0, 10, 0), AttitudeConvention::EnuYaw).nose, {kCos10, 0, -kSin10});
}

TEST(attitude_convention, roll_lowers_the_right_hand_side) {
  expect_near(directions(degrees(0, 0, 10), AttitudeConvention::Heading).right, {kCos10, 0, -kSin10});
  expect_near(directions(degrees(0, 0, 10), AttitudeConvention::NovAtel).right, {kCos10, 0, -kSin10});
  expect_near(directions(degrees(90, 0, 10), AttitudeConvention::EnuYaw).right, {kCos10, 0, -kSin10});
}

TEST(attitude_convention, novatel_is_heading_in_other_axes) {
  const AttitudeAngles angles = degrees(123, -21, 34);
  const Directions novatel = directions(angles, AttitudeConvention::NovAtel),
                   heading = directions(angles, AttitudeConvention::Heading);
  expect_near(novatel.nose, heading.nose);
  expect_near(novatel.right, heading.right);
}

TEST(attitude_convention, angles_come_back) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> full(-3.1, 3.1), half(-1.5, 1.5);
  for (int i = 0; i < 200; ++i)
    for (const auto convention :
         {AttitudeConvention::EnuYaw, AttitudeConvention::Heading, AttitudeConvention::NovAtel}) {
      const AttitudeAngles angles{full(random), half(random), full(random)};
      const AttitudeAngles back = angles_from(enu_from_ins(angles, convention), convention);
      EXPECT_NEAR(wrap_angle_rad(back.yaw_rad - angles.yaw_rad), 0.0, 1e-12);
      EXPECT_NEAR(back.pitch_rad, angles.pitch_rad, 1e-12);
      EXPECT_NEAR(wrap_angle_rad(back.roll_rad - angles.roll_rad), 0.0, 1e-12);
    }
}

TEST(attitude_convention, sigma_follows_the_axes) {
  EXPECT_EQ(axis_sigma_rad({3, 2, 1}, AttitudeConvention::EnuYaw), Vector3d(1, 2, 3));
  EXPECT_EQ(axis_sigma_rad({3, 2, 1}, AttitudeConvention::NovAtel), Vector3d(2, 1, 3));
}

TEST(attitude_convention, quaternions_of_both_worlds) {
  // Heading east, nose up 10 degrees, right side down 5 degrees in the aerospace sense: Rz(90) Ry(10) Rx(5) in NED.
  const Eigen::Quaterniond ned(
      rotation_from_yaw_pitch_roll({degrees_to_radians(90), degrees_to_radians(10), degrees_to_radians(5)}));
  const Eigen::Quaterniond enu = enu_from_ins(ned, QuaternionConvention::NedFromBody);
  EXPECT_LT(enu.angularDistance(enu_from_ins(degrees(90, 10, 5), AttitudeConvention::Heading)), 1e-12);
  EXPECT_LT(enu_from_ins(enu, QuaternionConvention::EnuFromIns).angularDistance(enu), 1e-12);
}

TEST(attitude_convention, names_come_back) {
  for (const auto convention : {AttitudeConvention::EnuYaw, AttitudeConvention::Heading, AttitudeConvention::NovAtel})
    EXPECT_EQ(attitude_convention_from_string(to_string(convention)), convention);
  for (const auto convention : {QuaternionConvention::EnuFromIns, QuaternionConvention::NedFromBody})
    EXPECT_EQ(quaternion_convention_from_string(to_string(convention)), convention);
  EXPECT_FALSE(attitude_convention_from_string("compass"));
}

}  // namespace
}  // namespace remount::drive
