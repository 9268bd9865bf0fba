#include "algorithms/cloud/beam_errors.h"

#include <cmath>

namespace remount::cloud {

BeamMotion moved_by_beam(const Eigen::Vector3d& point_in_lidar) {
  const double level_m = std::hypot(point_in_lidar.x(), point_in_lidar.y()), range_m = point_in_lidar.norm();
  BeamMotion moved{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  if (level_m > 0.0) {
    moved.elevation.head<2>() = -point_in_lidar.z() / level_m * point_in_lidar.head<2>();
    moved.elevation.z() = level_m;
    // Across: as much for a point high up as for one beside it.
    moved.azimuth = range_m / level_m * Eigen::Vector3d(-point_in_lidar.y(), point_in_lidar.x(), 0.0);
  }
  if (range_m > 0.0) moved.range = point_in_lidar / range_m;
  return moved;
}

void mend_beams(const BeamErrors& errors, PointCloud& cloud) {
  if (errors.none()) return;
  const BeamNodes& nodes = errors.nodes;
  for (Eigen::Vector3f& point : cloud.points) {
    const Eigen::Vector3d measured = point.cast<double>();
    const BeamPlace place = nodes.place_of(measured);
    const BeamMotion moved = moved_by_beam(measured);
    Eigen::Vector3d step = errors.values[nodes.range_scale()] * measured;
    for (std::size_t i = 0; i < place.count; ++i) {
      const Eigen::Index node = place.node[i];
      step += place.share[i] * (errors.values[nodes.elevation_at(node)] * moved.elevation +
                                errors.values[nodes.range_at(node)] * moved.range);
      if (nodes.by_azimuth()) step += place.share[i] * errors.values[nodes.azimuth_at(node)] * moved.azimuth;
    }
    point += step.cast<float>();
  }
}

bool BeamEstimate::stands_out_of(const BeamErrors& mended) const {
  constexpr double kSigmas = 3.0, kAngle_rad = 3.5e-4, kRange_m = 0.004, kScale = 2e-4;
  const Eigen::VectorXd taken_out = mended.at(nodes);
  for (Eigen::Index i = 0; i < errors.size(); ++i) {
    const bool of_range = i >= nodes.range_at(0) && i < nodes.range_at(nodes.count());
    const double worth = i == nodes.range_scale() ? kScale : of_range ? kRange_m : kAngle_rad;
    const double left = std::abs(errors[i] - taken_out[i]);
    if (left > worth && left > kSigmas * sigmas[i]) return true;
  }
  return false;
}

}  // namespace remount::cloud
