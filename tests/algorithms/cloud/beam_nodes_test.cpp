#include "algorithms/cloud/beam_nodes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "algorithms/core/error.h"
#include "algorithms/geometry/rotation.h"

namespace remount::cloud {
namespace {

Eigen::Vector3d point_at(double azimuth_rad, double elevation_rad) {
  return 10.0 * Eigen::Vector3d(std::cos(elevation_rad) * std::cos(azimuth_rad),
                                std::cos(elevation_rad) * std::sin(azimuth_rad), std::sin(elevation_rad));
}

TEST(beam_nodes, all_around_a_point_lies_between_its_two) {
  const BeamNodes& nodes = BeamNodes::all_around();
  EXPECT_EQ(nodes.count(), 67);
  EXPECT_EQ(nodes.errors(), 135);
  for (const double elevation_deg : {-80.0, -35.0, -10.1, -0.4, 0.0, 0.4, 23.9, 50.0, 89.0}) {
    const double elevation_rad = degrees_to_radians(elevation_deg);
    const BeamPlace place = nodes.place_of(point_at(1.0, elevation_rad));
    ASSERT_EQ(place.count, 2U);
    EXPECT_EQ(place.node[1], place.node[0] + 1);
    EXPECT_NEAR(place.share[0] + place.share[1], 1.0, 1e-12) << elevation_deg;
    EXPECT_GE(place.share[0], 0.0) << elevation_deg;
    EXPECT_GE(place.share[1], 0.0) << elevation_deg;
    if (std::abs(elevation_deg) > 60.0) continue;
    EXPECT_LE(nodes.elevation_rad(place.node[0]), elevation_rad + 1e-6) << elevation_deg;
    EXPECT_GE(nodes.elevation_rad(place.node[1]), elevation_rad - 1e-6) << elevation_deg;
  }
}

// Where a field lies does not matter: also across the half turn, where azimuths jump.
TEST(beam_nodes, over_a_field_the_four_around_a_point_give_back_what_is_linear) {
  for (const double middle_deg : {0.0, 90.0, 178.0, -170.0}) {
    const double middle_rad = degrees_to_radians(middle_deg);
    const BeamNodes nodes = BeamNodes::over(middle_rad - 1.0, middle_rad + 1.0, -0.2, 0.25);
    ASSERT_TRUE(nodes.by_azimuth());
    for (const double aside_rad : {-0.9, -0.3, 0.0, 0.4, 0.99})
      for (const double up_rad : {-0.15, 0.0, 0.2}) {
        const BeamPlace place = nodes.place_of(point_at(middle_rad + aside_rad, up_rad));
        ASSERT_EQ(place.count, 4U);
        double azimuth_rad = 0.0, slope = 0.0;
        for (std::size_t i = 0; i < 4; ++i) {
          azimuth_rad += place.share[i] * nodes.azimuth_rad(place.node[i]);
          slope += place.share[i] * std::tan(nodes.elevation_rad(place.node[i]));
        }
        EXPECT_NEAR(std::accumulate(place.share.begin(), place.share.end(), 0.0), 1.0, 1e-12);
        EXPECT_NEAR(azimuth_rad, middle_rad + aside_rad, 1e-9) << middle_deg << " " << aside_rad;
        EXPECT_NEAR(slope, std::tan(up_rad), 1e-9) << middle_deg << " " << up_rad;
      }
    const BeamPlace beyond = nodes.place_of(point_at(middle_rad + 1.6, 0.0));
    EXPECT_NEAR(beyond.share[2] + beyond.share[3], 1.0, 1e-12) << "constant beyond the last";
  }
}

TEST(beam_nodes, over_a_field_lie_no_further_apart_than_errors_are_alike) {
  const BeamNodes nodes = BeamNodes::over(degrees_to_radians(-60.0), degrees_to_radians(60.0),
                                          degrees_to_radians(-12.5), degrees_to_radians(12.5));
  EXPECT_EQ(nodes.azimuths_rad().size(), 15U);
  EXPECT_EQ(nodes.elevations_rad().size(), 4U);
  EXPECT_EQ(nodes.errors(), 3 * 60 + 1);
  EXPECT_NEAR(radians_to_degrees(nodes.azimuths_rad().front()), -60.0, 1e-9);
  EXPECT_NEAR(radians_to_degrees(nodes.elevations_rad().back()), 13.0, 1e-9);
}

TEST(beam_nodes, that_do_not_ascend_are_refused) {
  using Angles = std::vector<double>;
  for (const auto& [elevations, azimuths] : {std::pair{Angles{0.1}, Angles{}},
                                             {Angles{0.2, 0.1}, Angles{}},
                                             {Angles{0.1, 0.1}, Angles{}},
                                             {Angles{-1.6, 0.0}, Angles{}},
                                             {Angles{0.0, std::nan("")}, Angles{}},
                                             {Angles{0.0, 0.1}, Angles{0.3}},
                                             {Angles{0.0, 0.1}, Angles{-3.2, 3.2}}})
    EXPECT_THROW(BeamNodes(elevations, azimuths), Error);
}

}  // namespace
}  // namespace remount::cloud
