#include "algorithms/cloud/beam_errors.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "algorithms/cloud/beam_options.h"
#include "algorithms/geometry/rotation.h"

namespace remount::cloud {
namespace {

Eigen::Vector3f point_at(double azimuth_rad, double elevation_rad, double range_m) {
  return (range_m * Eigen::Vector3d(std::cos(elevation_rad) * std::cos(azimuth_rad),
                                    std::cos(elevation_rad) * std::sin(azimuth_rad), std::sin(elevation_rad)))
      .cast<float>();
}

double elevation_of(const Eigen::Vector3f& point) { return std::atan2(point.z(), std::hypot(point.x(), point.y())); }

TEST(beam_errors, nodes_ascend_and_a_point_lies_between_its_two) {
  for (Eigen::Index node = 1; node < kBeamNodes; ++node) EXPECT_GT(beam_node_rad(node), beam_node_rad(node - 1));
  for (const double elevation_deg : {-80.0, -35.0, -10.1, -0.4, 0.0, 0.4, 23.9, 50.0, 89.0}) {
    const double elevation_rad = degrees_to_radians(elevation_deg);
    const BeamPlace place = place_of_beam(point_at(1.0, elevation_rad, 10.0).cast<double>());
    EXPECT_GE(place.share, 0.0) << elevation_deg;
    EXPECT_LE(place.share, 1.0) << elevation_deg;
    if (std::abs(elevation_deg) > 60.0) continue;
    EXPECT_LE(beam_node_rad(place.lower), elevation_rad + 1e-6) << elevation_deg;
    EXPECT_GE(beam_node_rad(place.lower + 1), elevation_rad - 1e-6) << elevation_deg;
  }
}

TEST(beam_errors, mending_raises_lengthens_and_scales) {
  const double elevation_rad = degrees_to_radians(-10.0), range_m = 20.0;
  const auto mended_by = [&](Eigen::Index first, Eigen::Index count, double value) {
    BeamErrors errors = BeamErrors::Zero();
    errors.segment(first, count).setConstant(value);
    PointCloud cloud;
    cloud.points = {point_at(0.7, elevation_rad, range_m)};
    mend_beams(errors, cloud);
    return cloud.points[0];
  };
  const Eigen::Vector3f raised = mended_by(elevation_at(0), kBeamNodes, 2e-3);
  EXPECT_NEAR(elevation_of(raised) - elevation_rad, 2e-3, 1e-6);
  EXPECT_NEAR(raised.norm(), range_m, 1e-4);
  const Eigen::Vector3f lengthened = mended_by(range_at(0), kBeamNodes, 0.03), scaled = mended_by(kRangeScale, 1, 2e-3);
  EXPECT_NEAR(lengthened.norm(), range_m + 0.03, 1e-5);
  EXPECT_NEAR(scaled.norm(), range_m * 1.002, 1e-5);
  EXPECT_NEAR(elevation_of(scaled), elevation_rad, 1e-6);
  // Of the beam at this elevation alone.
  EXPECT_NEAR(mended_by(range_at(0), 5, 0.03).norm(), range_m, 1e-5);
}

TEST(beam_errors, a_point_moves_as_its_derivative_says) {
  const Eigen::Vector3d point = point_at(-2.0, degrees_to_radians(14.0), 12.0).cast<double>();
  const BeamMotion moved = moved_by_beam(point);
  constexpr double kStep = 1e-4;
  const Eigen::Vector3d raised = point_at(-2.0, degrees_to_radians(14.0) + kStep, 12.0).cast<double>(),
                        longer = point_at(-2.0, degrees_to_radians(14.0), 12.0 + kStep).cast<double>();
  EXPECT_LT(((raised - point) / kStep - moved.elevation).norm(), 0.02) << moved.elevation.transpose();
  EXPECT_LT(((longer - point) / kStep - moved.range).norm(), 0.02) << moved.range.transpose();
}

TEST(beam_errors, what_a_session_declares_is_believed_unless_the_options_say_otherwise) {
  BeamOptions options;
  EXPECT_TRUE(believed_of_beams(options, LidarKind::Perfect).empty());
  EXPECT_FALSE(believed_of_beams(options, LidarKind::Unknown).empty());
  options.lidar = LidarKind::Spinning;
  const BeamPrior spinning = believed_of_beams(options, LidarKind::Perfect);
  ASSERT_FALSE(spinning.empty());
  EXPECT_NEAR(std::sqrt(spinning.own(range_at(3), range_at(3))), 0.015, 1e-12);
  options.lidar = LidarKind::Own;
  options.beam_range_m = 0.5;
  EXPECT_NEAR(std::sqrt(believed_of_beams(options, LidarKind::Perfect).own(range_at(3), range_at(3))), 0.5, 1e-12);
  // Neighbours of one that has no rings err alike; those of one that has rings do not.
  options.lidar = LidarKind::SolidState;
  EXPECT_GT(believed_of_beams(options, LidarKind::Unknown).own(20, 21), 1e-7);
  EXPECT_EQ(spinning.own(20, 21), 0.0);
}

TEST(beam_errors, stand_out_where_they_are_large_and_known) {
  BeamEstimate estimate;
  estimate.sigmas.setConstant(1e-3);
  EXPECT_FALSE(estimate.stands_out_of(BeamErrors::Zero()));
  estimate.errors[range_at(2)] = 0.02;
  EXPECT_TRUE(estimate.stands_out_of(BeamErrors::Zero()));
  EXPECT_FALSE(estimate.stands_out_of(estimate.errors)) << "they are taken out already";
  estimate.sigmas.setConstant(0.02);
  EXPECT_FALSE(estimate.stands_out_of(BeamErrors::Zero()));
}

}  // namespace
}  // namespace remount::cloud
