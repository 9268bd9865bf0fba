#include "algorithms/cloud/beam_errors.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "algorithms/geometry/rotation.h"

namespace remount::cloud {
namespace {

constexpr Eigen::Index kOuter = 3;
constexpr std::array<double, kOuter> kOuter_deg{30.0, 40.0, 60.0};

using Slopes = std::array<double, static_cast<std::size_t>(kBeamNodes)>;

const Slopes& node_slopes() {
  static const Slopes kSlopes = [] {
    Slopes slopes;
    for (Eigen::Index node = 0; node < kBeamNodes; ++node)
      slopes[static_cast<std::size_t>(node)] = std::tan(beam_node_rad(node));
    return slopes;
  }();
  return kSlopes;
}

}  // namespace

double beam_node_rad(Eigen::Index node) {
  constexpr double kStep_deg = 0.8;
  const Eigen::Index from_middle = node - kBeamNodes / 2, inner = kBeamNodes / 2 - kOuter;
  const Eigen::Index beyond = std::abs(from_middle) - inner;
  const double size_deg = beyond > 0 ? kOuter_deg.at(static_cast<std::size_t>(beyond - 1))
                                     : kStep_deg * static_cast<double>(std::abs(from_middle));
  return degrees_to_radians(from_middle < 0 ? -size_deg : size_deg);
}

BeamPlace place_of_beam(const Eigen::Vector3d& point_in_lidar) {
  const double level_m = std::hypot(point_in_lidar.x(), point_in_lidar.y());
  // On the axis itself there is no slope; the last node is as steep as any.
  const Slopes& slopes = node_slopes();
  const double slope =
      std::clamp(level_m > 0.0 ? point_in_lidar.z() / level_m : slopes.back(), slopes.front(), slopes.back());
  const auto upper = std::upper_bound(slopes.begin() + 1, slopes.end() - 1, slope);
  const double from = *(upper - 1), to = *upper;
  return {upper - slopes.begin() - 1, (slope - from) / (to - from)};
}

BeamMotion moved_by_beam(const Eigen::Vector3d& point_in_lidar) {
  const double level_m = std::hypot(point_in_lidar.x(), point_in_lidar.y()), range_m = point_in_lidar.norm();
  BeamMotion moved{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  if (level_m > 0.0) {
    moved.elevation.head<2>() = -point_in_lidar.z() / level_m * point_in_lidar.head<2>();
    moved.elevation.z() = level_m;
  }
  if (range_m > 0.0) moved.range = point_in_lidar / range_m;
  return moved;
}

void mend_beams(const BeamErrors& errors, PointCloud& cloud) {
  if (errors.isZero(0.0)) return;
  for (Eigen::Vector3f& point : cloud.points) {
    const Eigen::Vector3d measured = point.cast<double>();
    const BeamPlace place = place_of_beam(measured);
    const BeamMotion moved = moved_by_beam(measured);
    const auto at_place = [&](Eigen::Index first) {
      return (1.0 - place.share) * errors[first + place.lower] + place.share * errors[first + place.lower + 1];
    };
    point += (moved.elevation * at_place(elevation_at(0)) + moved.range * at_place(range_at(0)) +
              measured * errors[kRangeScale])
                 .cast<float>();
  }
}

bool BeamEstimate::stands_out_of(const BeamErrors& mended) const {
  constexpr double kSigmas = 3.0, kElevation_rad = 3.5e-4, kRange_m = 0.004, kScale = 2e-4;
  for (Eigen::Index i = 0; i < kBeamErrors; ++i) {
    const double worth = i < kBeamNodes ? kElevation_rad : i < kRangeScale ? kRange_m : kScale;
    const double left = std::abs(errors[i] - mended[i]);
    if (left > worth && left > kSigmas * sigmas[i]) return true;
  }
  return false;
}

}  // namespace remount::cloud
