#include "algorithms/cloud/beam_options.h"

#include <cmath>

#include "algorithms/geometry/rotation.h"

namespace remount::cloud {
namespace {

// Of single beams as makers and those who measured them say; what all of them share is more, for it is where the
// optics as a whole look (an HDL-64's was found 0.2 degrees off).
BeamOptions numbers_of(const BeamOptions& options, LidarKind kind) {
  if (kind == LidarKind::Own) return options;
  BeamOptions numbers;
  numbers.beam_range_m = kind == LidarKind::Spinning ? 0.015 : 0.02;
  return numbers;
}

// Rings err each for itself; what a mirror or a prism does changes smoothly with the elevation.
bool by_ring(LidarKind kind) { return kind != LidarKind::SolidState; }
bool smooth(LidarKind kind) { return kind == LidarKind::SolidState || kind == LidarKind::Unknown; }

// The same for all nodes together, and each for itself or like its neighbours.
void believe(LidarKind kind, double common_sigma, double own_sigma, Eigen::Index column, BeamPrior& prior) {
  const Eigen::Index first = column * kBeamNodes;
  prior.common.col(column).segment(first, kBeamNodes).setConstant(common_sigma);
  constexpr double kAlike_rad = 0.14;
  for (Eigen::Index i = 0; i < kBeamNodes; ++i)
    for (Eigen::Index j = 0; j < kBeamNodes; ++j) {
      const double apart = (beam_node_rad(i) - beam_node_rad(j)) / kAlike_rad;
      double alike = i == j && by_ring(kind) ? 1.0 : 0.0;
      if (smooth(kind)) alike += std::exp(-0.5 * apart * apart);
      prior.own(first + i, first + j) = own_sigma * own_sigma * alike;
    }
}

}  // namespace

BeamPrior believed_of_beams(const BeamOptions& options, LidarKind declared) {
  const LidarKind kind = options.lidar == LidarKind::Auto ? declared : options.lidar;
  if (kind == LidarKind::Perfect) return {};
  const BeamOptions numbers = numbers_of(options, kind);
  BeamPrior believed{Eigen::MatrixXd::Zero(kBeamErrors, 3), Eigen::MatrixXd::Zero(kBeamErrors, kBeamErrors)};
  believe(kind, degrees_to_radians(numbers.common_elevation_deg), degrees_to_radians(numbers.beam_elevation_deg), 0,
          believed);
  believe(kind, numbers.common_range_m, numbers.beam_range_m, 1, believed);
  believed.common(kRangeScale, 2) = numbers.range_scale;
  return believed;
}

}  // namespace remount::cloud
