#include "algorithms/cloud/directions.h"

#include <gtest/gtest.h>

#include <cmath>

#include "algorithms/geometry/rotation.h"

namespace remount::cloud {
namespace {

// Points at some distance, every half degree of a band around the sensor.
std::vector<Eigen::Vector3f> band(double from_deg, double to_deg, double low_deg, double high_deg) {
  std::vector<Eigen::Vector3f> points;
  for (double elevation_deg = low_deg; elevation_deg <= high_deg; elevation_deg += 0.5)
    for (double azimuth_deg = from_deg; azimuth_deg < to_deg; azimuth_deg += 0.5) {
      const double elevation = degrees_to_radians(elevation_deg), azimuth = degrees_to_radians(azimuth_deg);
      points.push_back((12.0 * Eigen::Vector3d(std::cos(elevation) * std::cos(azimuth),
                                               std::cos(elevation) * std::sin(azimuth), std::sin(elevation)))
                           .cast<float>());
    }
  return points;
}

Directions directions_of(const std::vector<Eigen::Vector3f>& points) {
  Directions directions;
  directions.add(points);
  return directions;
}

TEST(directions, count_about_a_cell_for_each_square_degree) {
  const Directions level = directions_of(band(-59.9, 60.0, -9.8, 9.9));
  EXPECT_NEAR(static_cast<double>(level.count()), 120.0 * 20.0, 100.0);
  const Directions high = directions_of(band(-179.9, 180.0, 60.2, 69.9));
  EXPECT_NEAR(static_cast<double>(high.count()), 360.0 * 10.0 * std::cos(degrees_to_radians(65.0)), 100.0);
}

TEST(directions, a_part_shows_its_share_of_the_whole) {
  const Directions whole = directions_of(band(-60.0, 60.0, -10.0, 9.9)),
                   part = directions_of(band(0.0, 60.0, -10.0, 9.9));
  EXPECT_DOUBLE_EQ(whole.share_of(whole), 1.0);
  EXPECT_NEAR(part.share_of(whole), 0.5, 0.02);
  EXPECT_DOUBLE_EQ(whole.share_of(part), 1.0);
  EXPECT_DOUBLE_EQ(whole.share_of({}), 0.0);
  Directions sum = part;
  sum.add(whole);
  EXPECT_EQ(sum.count(), whole.count());
}

TEST(directions, are_boxed_in_also_across_the_seam) {
  const auto expect_box = [](double from_deg, double to_deg, double low_deg, double high_deg) {
    const FieldBox box = directions_of(band(from_deg, to_deg, low_deg, high_deg)).box();
    EXPECT_NEAR(radians_to_degrees(box.azimuth_to_rad - box.azimuth_from_rad), to_deg - from_deg, 2.5);
    EXPECT_NEAR(radians_to_degrees(box.azimuth_from_rad), from_deg, 1.5);
    EXPECT_NEAR(radians_to_degrees(box.elevation_from_rad), low_deg, 1.0);
    EXPECT_NEAR(radians_to_degrees(box.elevation_to_rad), high_deg, 1.0);
  };
  expect_box(-59.9, 60.0, -9.8, 9.9);
  expect_box(150.1, 230.0, -20.2, -5.1);
  const FieldBox whole = directions_of(band(-180.0, 180.0, -5.0, 5.0)).box();
  EXPECT_NEAR(whole.azimuth_to_rad - whole.azimuth_from_rad, 2.0 * kPi, 1e-9);
}

TEST(directions, a_neighbouring_cell_counts_as_seen_also_across_the_seam_and_at_a_pole) {
  const auto towards = [](double azimuth_deg, double elevation_deg) {
    return band(azimuth_deg, azimuth_deg + 0.1, elevation_deg, elevation_deg + 0.1);
  };
  const Directions one = directions_of(towards(179.5, 0.5));
  EXPECT_TRUE(one.has_near(towards(-179.5, 0.5).front())) << "across the seam";
  EXPECT_TRUE(one.has_near(towards(178.5, 1.5).front()));
  EXPECT_FALSE(one.has_near(towards(175.5, 0.5).front()));
  EXPECT_FALSE(one.has_near(towards(179.5, 3.5).front()));
  const Directions up = directions_of({Eigen::Vector3f(0.0F, 0.0F, 5.0F)});
  EXPECT_TRUE(up.has_near(Eigen::Vector3f(0.001F, -0.02F, 3.0F)));
}

TEST(directions, tell_how_much_of_a_turn_they_show) {
  EXPECT_DOUBLE_EQ(directions_of(band(-180.0, 180.0, 20.0, 21.0)).turn_shown(), 1.0);
  EXPECT_NEAR(directions_of(band(-60.0, 60.0, -10.0, 9.9)).turn_shown(), 1.0 / 3.0, 0.06);
  EXPECT_DOUBLE_EQ(Directions().turn_shown(), 0.0);
}

TEST(directions, points_at_the_origin_have_none) {
  EXPECT_TRUE(directions_of({Eigen::Vector3f::Zero()}).empty());
  EXPECT_FALSE(directions_of({Eigen::Vector3f(1.0F, 0.0F, 0.0F)}).empty());
}

}  // namespace
}  // namespace remount::cloud
