#include "algorithms/geodesy/local_level.h"

#include <gtest/gtest.h>

#include "algorithms/core/error.h"
#include "algorithms/geodesy/geodesy.h"

namespace remount::geodesy {
namespace {

constexpr double kLatitude = degrees_to_radians(48.78), kLongitude = degrees_to_radians(9.18);

TEST(local_level, the_origin_is_the_origin) {
  const LocalLevel level(kLatitude, kLongitude, 250.0);
  motion::InsSample sample;
  sample.latitude_rad = kLatitude;
  sample.longitude_rad = kLongitude;
  sample.height_m = 252.5;
  sample.enu_from_ins = Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ());
  const RigidTransform pose = level.enu_from_ins(sample);
  EXPECT_LT((pose.translation() - Eigen::Vector3d(0.0, 0.0, 2.5)).norm(), 1e-6);
  EXPECT_LT((pose.linear() - sample.enu_from_ins.toRotationMatrix()).norm(), 1e-12);
}

TEST(local_level, north_turns_with_the_longitude_and_down_curves_away) {
  const LocalLevel level(kLatitude, kLongitude, 0.0);
  motion::InsSample east;
  east.latitude_rad = kLatitude;
  east.longitude_rad = kLongitude + degrees_to_radians(0.1);
  const RigidTransform pose = level.enu_from_ins(east);
  // Meridians converge by the sine of the latitude: north of the start, the east of a place farther east points.
  EXPECT_NEAR(yaw_pitch_roll_from_rotation(pose.linear()).yaw_rad, degrees_to_radians(0.1) * std::sin(kLatitude), 1e-6);
  EXPECT_NEAR(pose.translation().x(), 7350.0, 15.0);
  EXPECT_NEAR(pose.translation().z(), -7350.0 * 7350.0 / 2.0 / 6.39e6, 0.05);
}

TEST(local_level, agrees_with_the_grid_over_a_short_drive) {
  std::vector<motion::InsSample> samples(2);
  samples[0].latitude_rad = samples[1].latitude_rad = kLatitude;
  samples[0].longitude_rad = kLongitude;
  samples[1].longitude_rad = kLongitude + degrees_to_radians(0.003);
  samples[1].latitude_rad += degrees_to_radians(0.002);
  samples[0].height_m = samples[1].height_m = 250.0;
  const LocalLevel level(kLatitude, kLongitude, 250.0);
  const std::vector<motion::StampedPose> grid = local_from_ins(samples);
  const RigidTransform by_grid = grid[0].pose.inverse() * grid[1].pose,
                       by_level = level.enu_from_ins(samples[0]).inverse() * level.enu_from_ins(samples[1]);
  EXPECT_LT((by_grid.translation() - by_level.translation()).norm(), 0.02);
  EXPECT_LT(rotation_angle_between_rad(by_grid, by_level), 1e-4);
}

TEST(local_level, fixes_keep_their_covariance) {
  const LocalLevel level(kLatitude, kLongitude, 250.0);
  motion::GnssFix fix;
  fix.latitude_rad = kLatitude;
  fix.longitude_rad = kLongitude;
  fix.height_m = 249.0;
  fix.covariance_enu_m2 = Eigen::Vector3d(1.0, 2.0, 5.0).asDiagonal();
  EXPECT_LT((level.covariance_enu_m2(fix) - fix.covariance_enu_m2).norm(), 1e-9);
  EXPECT_NEAR(level.position_enu_m(fix).z(), -1.0, 1e-6);
}

TEST(local_level, a_place_off_the_globe_is_refused) {
  EXPECT_THROW(LocalLevel(2.0, 0.0, 0.0), Error);
  EXPECT_THROW(LocalLevel(0.0, std::numeric_limits<double>::infinity(), 0.0), Error);
}

}  // namespace
}  // namespace remount::geodesy
