#include "algorithms/geodesy/geodesy.h"

#include <gtest/gtest.h>

#include <GeographicLib/Geodesic.hpp>
#include <GeographicLib/LocalCartesian.hpp>
#include <cmath>

#include "algorithms/core/error.h"

namespace remount::geodesy {
namespace {

struct Place {
  const char* name;
  double latitude_deg, longitude_deg, azimuth_deg, height_m;
};

const std::vector<Place> kPlaces{
    {"middle of a zone", 48.0, 9.001, 30.0, 300.0},
    {"edge of a zone at 55 N", 55.0, 11.99, 350.0, 40.0},
    {"across the boundary at 12 E", 55.0, 11.99, 88.0, 40.0},
    {"across the boundary westwards", 55.0, 12.01, 271.0, 40.0},
    {"Cape Town", -33.9, 18.43, 135.0, 20.0},
    {"across the equator southwards", 0.006, 36.8, 185.0, 1600.0},
    {"across the equator northwards", -0.006, 36.8, 20.0, 1600.0},
    {"high road", 46.5, 6.05, 60.0, 2000.0},
    {"across 180 E", -17.0, 179.995, 80.0, 10.0},
    {"into the polar grid", 83.995, 15.0, 3.0, 0.0},
    {"polar grid", 86.0, 50.0, 100.0, 0.0},
};

constexpr double kStep_m = 20.0;
constexpr int kSteps = 100;

// A straight drive (a geodesic), the vehicle looking along it: azimuth clockwise from north at each sample.
std::vector<motion::InsSample> straight_drive(const Place& place) {
  const GeographicLib::Geodesic& earth = GeographicLib::Geodesic::WGS84();
  std::vector<motion::InsSample> samples;
  for (int i = 0; i <= kSteps; ++i) {
    double latitude_deg = 0.0, longitude_deg = 0.0, azimuth_deg = 0.0;
    earth.Direct(place.latitude_deg, place.longitude_deg, place.azimuth_deg, i * kStep_m, latitude_deg, longitude_deg,
                 azimuth_deg);
    motion::InsSample sample;
    sample.stamp_ns = i * 1'000'000'000LL;
    sample.latitude_rad = degrees_to_radians(latitude_deg);
    sample.longitude_rad = degrees_to_radians(longitude_deg);
    sample.height_m = place.height_m;
    sample.enu_from_ins =
        Eigen::Quaterniond(rotation_from_yaw_pitch_roll({kPi / 2.0 - degrees_to_radians(azimuth_deg), 0.0, 0.0}));
    samples.push_back(sample);
  }
  return samples;
}

TEST(geodesy, steps_of_a_straight_drive_have_their_true_length) {
  for (const Place& place : kPlaces) {
    const std::vector<motion::InsSample> samples = straight_drive(place);
    const std::vector<motion::StampedPose> local = local_from_ins(samples);
    ASSERT_EQ(local.size(), samples.size());
    double worst = 0.0;
    for (std::size_t i = 1; i < samples.size(); ++i) {
      // Independent truth: Cartesian coordinates about the sample before, at its height.
      const GeographicLib::LocalCartesian around(radians_to_degrees(samples[i - 1].latitude_rad),
                                                 radians_to_degrees(samples[i - 1].longitude_rad), place.height_m);
      Eigen::Vector3d truth;
      around.Forward(radians_to_degrees(samples[i].latitude_rad), radians_to_degrees(samples[i].longitude_rad),
                     place.height_m, truth.x(), truth.y(), truth.z());
      const double length_m = (local[i].pose.translation() - local[i - 1].pose.translation()).norm();
      worst = std::max(worst, std::abs(length_m / truth.norm() - 1.0));
    }
    // A mean radius stands for the ellipsoid's in the height correction: 0.5 % of height over radius.
    EXPECT_LT(worst, 1e-7 + 0.006 * place.height_m / 6.371e6) << place.name << ": relative " << worst;
  }
}

TEST(geodesy, attitude_relative_to_the_direction_of_travel_is_the_same_everywhere) {
  for (const Place& place : kPlaces) {
    const std::vector<motion::StampedPose> local = local_from_ins(straight_drive(place));
    double worst_rad = 0.0;
    for (std::size_t i = 1; i + 1 < local.size(); ++i) {
      const Eigen::Vector3d travel = local[i + 1].pose.translation() - local[i - 1].pose.translation();
      const Eigen::Vector3d in_body = local[i].pose.linear().transpose() * travel;
      worst_rad = std::max(worst_rad, std::hypot(in_body.y(), in_body.z()) / in_body.x());
    }
    EXPECT_LT(worst_rad, 1e-6) << place.name << ": " << radians_to_degrees(worst_rad) << " deg";
  }
}

TEST(geodesy, the_corrections_that_this_needs_are_large_at_a_zones_edge) {
  const double latitude_rad = degrees_to_radians(55.0), longitude_rad = degrees_to_radians(11.99);
  const GridFix fix = UtmGrid(latitude_rad, longitude_rad).project(latitude_rad, longitude_rad);
  EXPECT_NEAR(radians_to_degrees(fix.convergence_rad), 2.99 * std::sin(latitude_rad), 0.01);
  EXPECT_GT(std::abs(fix.point_scale - 1.0), 2e-5);
}

TEST(geodesy, a_drive_stays_in_the_zone_of_its_first_fix_without_a_jump) {
  const UtmGrid grid(degrees_to_radians(55.0), degrees_to_radians(11.9999));
  EXPECT_EQ(grid.zone(), 32);
  const GridFix west = grid.project(degrees_to_radians(55.0), degrees_to_radians(11.9999));
  const GridFix east = grid.project(degrees_to_radians(55.0), degrees_to_radians(12.0001));
  EXPECT_NEAR(std::hypot(east.easting_m - west.easting_m, east.northing_m - west.northing_m), 12.79, 0.05);
  const UtmGrid equator(degrees_to_radians(-0.0001), degrees_to_radians(36.8));
  const GridFix south = equator.project(degrees_to_radians(-0.0001), degrees_to_radians(36.8));
  const GridFix north = equator.project(degrees_to_radians(0.0001), degrees_to_radians(36.8));
  EXPECT_NEAR(north.northing_m - south.northing_m, 22.11, 0.05);
}

TEST(geodesy, the_first_sample_is_the_origin_and_height_is_up) {
  std::vector<motion::InsSample> samples = straight_drive(kPlaces[0]);
  for (std::size_t i = 0; i < samples.size(); ++i) samples[i].height_m += 0.5 * static_cast<double>(i);
  const std::vector<motion::StampedPose> local = local_from_ins(samples);
  EXPECT_EQ(local.front().pose.translation().norm(), 0.0);
  EXPECT_NEAR(local.back().pose.translation().z(), 0.5 * kSteps, 1e-9);
  EXPECT_EQ(local.back().stamp_ns, samples.back().stamp_ns);
  EXPECT_TRUE(local_from_ins({}).empty());
}

TEST(geodesy, positions_not_on_the_globe_are_errors) {
  std::vector<motion::InsSample> samples = straight_drive(kPlaces[0]);
  samples[5].latitude_rad = 2.0;
  EXPECT_THROW(local_from_ins(samples), Error);
  EXPECT_THROW(UtmGrid(2.0, 0.0), Error);
}

}  // namespace
}  // namespace remount::geodesy
