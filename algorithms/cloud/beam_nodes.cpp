#include "algorithms/cloud/beam_nodes.h"

#include <algorithm>
#include <cmath>

#include "algorithms/core/error.h"
#include "algorithms/core/index.h"
#include "algorithms/geometry/rotation.h"

namespace remount::cloud {
namespace {

/// Between which two of them a value lies, and the share of the upper one.
struct Between {
  Eigen::Index lower = 0;
  double share = 0.0;
};

Between between(const std::vector<double>& ascending, double value) {
  const double inside = std::clamp(value, ascending.front(), ascending.back());
  const auto upper = std::upper_bound(ascending.begin() + 1, ascending.end() - 1, inside);
  const double from = *(upper - 1), to = *upper;
  return {upper - ascending.begin() - 1, (inside - from) / (to - from)};
}

bool ascend(const std::vector<double>& values) {
  return values.size() >= 2 && std::ranges::adjacent_find(values, std::greater_equal()) == values.end() &&
         std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

std::vector<double> nodes_all_around_rad() {
  constexpr std::array<double, 3> kOuter_deg{30.0, 40.0, 60.0};
  std::vector<double> elevations_rad;
  for (int i = 0; i <= 30; ++i) elevations_rad.push_back(degrees_to_radians(8 * i / 10.0));
  for (const double outer_deg : kOuter_deg) elevations_rad.push_back(degrees_to_radians(outer_deg));
  std::vector<double> both;
  for (auto up = elevations_rad.rbegin(); up != elevations_rad.rend() - 1; ++up) both.push_back(-*up);
  both.insert(both.end(), elevations_rad.begin(), elevations_rad.end());
  return both;
}

// Whole tenths of a degree, as files have them.
std::vector<double> evenly_rad(double from_rad, double to_rad) {
  constexpr double kApart_deg = 9.0;
  const double from_deg = std::floor(radians_to_degrees(from_rad)), to_deg = std::ceil(radians_to_degrees(to_rad));
  const int steps = std::max(1, static_cast<int>(std::ceil((to_deg - from_deg) / kApart_deg)));
  std::vector<double> nodes_rad;
  for (int i = 0; i <= steps; ++i)
    nodes_rad.push_back(degrees_to_radians(std::round(10.0 * (from_deg + i * (to_deg - from_deg) / steps)) / 10.0));
  return nodes_rad;
}

}  // namespace

BeamNodes::BeamNodes(std::vector<double> elevations_rad, std::vector<double> azimuths_rad)
    : elevations_rad_(std::move(elevations_rad)), azimuths_rad_(std::move(azimuths_rad)) {
  const auto require = [](bool sound) {
    if (!sound) throw Error(ErrorCode::Contract, "beam nodes", Message::verbatim("they must ascend"));
  };
  require(ascend(elevations_rad_) && elevations_rad_.front() > -kPi / 2.0 && elevations_rad_.back() < kPi / 2.0);
  require(azimuths_rad_.empty() || (ascend(azimuths_rad_) && azimuths_rad_.back() - azimuths_rad_.front() < 2.0 * kPi));
  for (const double elevation_rad : elevations_rad_) slopes_.push_back(std::tan(elevation_rad));
}

const BeamNodes& BeamNodes::all_around() {
  static const BeamNodes kNodes(nodes_all_around_rad());
  return kNodes;
}

BeamNodes BeamNodes::over(double azimuth_from_rad, double azimuth_to_rad, double elevation_from_rad,
                          double elevation_to_rad) {
  const double steepest_rad = degrees_to_radians(85.0);
  return BeamNodes(evenly_rad(std::clamp(elevation_from_rad, -steepest_rad, steepest_rad),
                              std::clamp(elevation_to_rad, -steepest_rad, steepest_rad)),
                   evenly_rad(azimuth_from_rad, azimuth_to_rad));
}

Eigen::Index BeamNodes::count() const {
  return signed_of(elevations_rad_.size()) * (by_azimuth() ? signed_of(azimuths_rad_.size()) : 1);
}

double BeamNodes::elevation_rad(Eigen::Index node) const {
  return elevations_rad_[static_cast<std::size_t>(node) % elevations_rad_.size()];
}

double BeamNodes::azimuth_rad(Eigen::Index node) const {
  return azimuths_rad_[static_cast<std::size_t>(node) / elevations_rad_.size()];
}

BeamPlace BeamNodes::place_of(const Eigen::Vector3d& point_in_lidar) const {
  const double level_m = std::hypot(point_in_lidar.x(), point_in_lidar.y());
  // On the axis itself there is no slope; the last node is as steep as any.
  const Between up = between(slopes_, level_m > 0.0 ? point_in_lidar.z() / level_m : slopes_.back());
  if (!by_azimuth()) return {{up.lower, up.lower + 1, 0, 0}, {1.0 - up.share, up.share, 0.0, 0.0}, 2};
  // The field may lie across the half turn, where azimuths jump.
  const double middle_rad = 0.5 * (azimuths_rad_.front() + azimuths_rad_.back());
  const double from_middle_rad =
      std::remainder(std::atan2(point_in_lidar.y(), point_in_lidar.x()) - middle_rad, 2.0 * kPi);
  const Between left = between(azimuths_rad_, middle_rad + from_middle_rad);
  const Eigen::Index rows = signed_of(elevations_rad_.size()), first = left.lower * rows + up.lower;
  return {{first, first + 1, first + rows, first + rows + 1},
          {(1.0 - left.share) * (1.0 - up.share), (1.0 - left.share) * up.share, left.share * (1.0 - up.share),
           left.share * up.share},
          4};
}

}  // namespace remount::cloud
