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

const BeamNodes& nodes() { return BeamNodes::all_around(); }

double elevation_of(const Eigen::Vector3f& point) { return std::atan2(point.z(), std::hypot(point.x(), point.y())); }

TEST(beam_errors, mending_raises_lengthens_and_scales) {
  const double elevation_rad = degrees_to_radians(-10.0), range_m = 20.0;
  const auto mended_by = [&](Eigen::Index first, Eigen::Index count, double value) {
    BeamErrors errors(nodes());
    errors.values.segment(first, count).setConstant(value);
    PointCloud cloud;
    cloud.points = {point_at(0.7, elevation_rad, range_m)};
    mend_beams(errors, cloud);
    return cloud.points[0];
  };
  const Eigen::Vector3f raised = mended_by(nodes().elevation_at(0), nodes().count(), 2e-3);
  EXPECT_NEAR(elevation_of(raised) - elevation_rad, 2e-3, 1e-6);
  EXPECT_NEAR(raised.norm(), range_m, 1e-4);
  const Eigen::Vector3f lengthened = mended_by(nodes().range_at(0), nodes().count(), 0.03),
                        scaled = mended_by(nodes().range_scale(), 1, 2e-3);
  EXPECT_NEAR(lengthened.norm(), range_m + 0.03, 1e-5);
  EXPECT_NEAR(scaled.norm(), range_m * 1.002, 1e-5);
  EXPECT_NEAR(elevation_of(scaled), elevation_rad, 1e-6);
  // Of the beam at this elevation alone.
  EXPECT_NEAR(mended_by(nodes().range_at(0), 5, 0.03).norm(), range_m, 1e-5);
}

TEST(beam_errors, a_point_moves_as_its_derivative_says) {
  const Eigen::Vector3d point = point_at(-2.0, degrees_to_radians(14.0), 12.0).cast<double>();
  const BeamMotion moved = moved_by_beam(point);
  constexpr double kStep = 1e-4;
  const double up_rad = degrees_to_radians(14.0);
  const Eigen::Vector3d raised = point_at(-2.0, up_rad + kStep, 12.0).cast<double>(),
                        longer = point_at(-2.0, up_rad, 12.0 + kStep).cast<double>(),
                        turned = point_at(-2.0 + kStep / std::cos(up_rad), up_rad, 12.0).cast<double>();
  EXPECT_LT(((raised - point) / kStep - moved.elevation).norm(), 0.02) << moved.elevation.transpose();
  EXPECT_LT(((longer - point) / kStep - moved.range).norm(), 0.02) << moved.range.transpose();
  EXPECT_LT(((turned - point) / kStep - moved.azimuth).norm(), 0.02) << moved.azimuth.transpose();
}

TEST(beam_errors, what_a_session_declares_is_believed_unless_the_options_say_otherwise) {
  BeamOptions options;
  EXPECT_TRUE(believed_of_beams(options, LidarKind::Perfect, nodes()).empty());
  EXPECT_FALSE(believed_of_beams(options, LidarKind::Unknown, nodes()).empty());
  options.lidar = LidarKind::Spinning;
  const BeamPrior spinning = believed_of_beams(options, LidarKind::Perfect, nodes());
  ASSERT_FALSE(spinning.empty());
  EXPECT_NEAR(std::sqrt(spinning.own(nodes().range_at(3), nodes().range_at(3))), 0.015, 1e-12);
  options.lidar = LidarKind::Own;
  options.beam_range_m = 0.5;
  EXPECT_NEAR(
      std::sqrt(believed_of_beams(options, LidarKind::Perfect, nodes()).own(nodes().range_at(3), nodes().range_at(3))),
      0.5, 1e-12);
  // Neighbours of one that has no rings err alike; those of one that has rings do not.
  options.lidar = LidarKind::SolidState;
  EXPECT_GT(believed_of_beams(options, LidarKind::Unknown, nodes()).own(20, 21), 1e-7);
  EXPECT_EQ(spinning.own(20, 21), 0.0);
}

TEST(beam_errors, of_a_field_are_as_large_as_is_believed_and_turn_nothing) {
  const BeamNodes field = BeamNodes::over(-1.0, 1.0, -0.2, 0.2);
  const BeamPrior believed = believed_of_beams({}, LidarKind::SolidState, field);
  Eigen::VectorXd turn = Eigen::VectorXd::Zero(field.errors());
  for (Eigen::Index node = 0; node < field.count(); ++node) {
    // A turn about x raises what lies to the left, and takes what lies above to the right.
    turn[field.elevation_at(node)] = std::sin(field.azimuth_rad(node));
    turn[field.azimuth_at(node)] = -std::sin(field.elevation_rad(node)) * std::cos(field.azimuth_rad(node));
  }
  turn.normalize();
  EXPECT_LT(turn.dot(believed.own * turn), 1e-12);
  EXPECT_LT((believed.common.transpose() * turn).norm(), 1e-9);
  EXPECT_NEAR(believed.own(field.range_at(4), field.range_at(4)), 0.02 * 0.02, 1e-9);
  const double angle_rad = std::sqrt(believed.own(field.azimuth_at(4), field.azimuth_at(4)));
  EXPECT_GT(angle_rad, 0.3 * degrees_to_radians(0.05));
  EXPECT_LT(angle_rad, degrees_to_radians(0.05));
  // Neighbours err alike, the ends of the field hardly.
  const auto alike = [&](Eigen::Index other) {
    return believed.own(field.range_at(0), field.range_at(other)) / (0.02 * 0.02);
  };
  EXPECT_GT(alike(1), 0.4);
  EXPECT_LT(alike(field.count() - 1), 0.05);
}

TEST(beam_errors, that_an_earlier_drive_told_are_believed_as_well_as_it_told_them) {
  for (const BeamNodes& at : {nodes(), BeamNodes::over(-1.0, 1.0, -0.2, 0.2)}) {
    BeamEstimate known{at,
                       Eigen::VectorXd::Constant(at.errors(), 0.003),
                       Eigen::VectorXd::Constant(at.errors(), 0.002),
                       {0.003, 0.0005, true},
                       {}};
    const BeamPrior believed = believed_of_known(known);
    EXPECT_EQ(believed.mean, known.errors);
    const Eigen::VectorXd sigmas =
        (believed.common * believed.common.transpose() + believed.own).diagonal().cwiseSqrt();
    EXPECT_LT(sigmas.maxCoeff(), 1.05 * 0.002);
    EXPECT_EQ(believed.untold_sigmas, believed_of_beams({}, LidarKind::Unknown, at).untold_sigmas);
    if (at.by_azimuth()) {
      EXPECT_GT(sigmas[at.azimuth_at(0)], 0.0005) << "a turn of the field is none of its errors, the rest is";
      EXPECT_GT(sigmas[at.elevation_at(0)], 0.0005);
      continue;
    }
    EXPECT_LT((sigmas - known.sigmas).cwiseAbs().maxCoeff(), 1e-12) << "each as its file says";
    EXPECT_NEAR(believed.common(at.elevation_at(7), 0), 0.0005, 1e-12) << "of all, as well as their mean is known";
    EXPECT_NEAR(believed.common(at.range_at(7), 1), 0.002 / std::sqrt(3.0), 1e-9)
        << "nobody told: as believed of any LiDAR";
  }
}

TEST(beam_errors, stand_out_where_they_are_large_and_known) {
  BeamEstimate estimate;
  estimate.nodes = nodes();
  estimate.errors.setZero(nodes().errors());
  estimate.sigmas.setConstant(nodes().errors(), 1e-3);
  EXPECT_FALSE(estimate.stands_out_of({}));
  estimate.errors[nodes().range_at(2)] = 0.02;
  EXPECT_TRUE(estimate.stands_out_of({}));
  EXPECT_FALSE(estimate.stands_out_of({nodes(), estimate.errors})) << "they are taken out already";
  estimate.sigmas.setConstant(0.02);
  EXPECT_FALSE(estimate.stands_out_of({}));
}

}  // namespace
}  // namespace remount::cloud
