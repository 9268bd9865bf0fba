// Where in its field of view a LiDAR's own errors are unknowns. docs/maths/beams.md (B1)
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace remount::cloud {

/// Nodes around a point of the LiDAR, and how much each counts for it; the shares sum to 1. Of nodes that are at
/// elevations only, two.
struct BeamPlace {
  std::array<Eigen::Index, 4> node{};
  std::array<double, 4> share{};
  std::size_t count = 2;
};

/// More are in no file: twice what the widest field has.
inline constexpr Eigen::Index kMostBeamErrors = 4096;

/// At some elevations over the LiDAR's x-y plane, alike all around; or, of one that looks one way, at azimuths and
/// elevations. In between errors are linear in the azimuth and in the slope z / distance from the z axis, and constant
/// beyond the last. The errors at all nodes are one column: of the elevation (rad, up), of the range (m) and, where
/// there are azimuths, of the azimuth (rad along the circle through the point's direction, to the left); at last the
/// range over itself.
class BeamNodes {
 public:
  /// None: there are no errors, or the field is not known yet.
  BeamNodes() = default;
  /// Two elevations at least, and no azimuth or two at least, all ascending, rad, less than a right angle up and down
  /// and than a turn from the first azimuth to the last. @throws Error (Contract) where they are not
  explicit BeamNodes(std::vector<double> elevations_rad, std::vector<double> azimuths_rad = {});
  /// Every 0.8 degrees, as far as the rings of spinning LiDARs lie apart, to 24 degrees up and down, and at three more
  /// beyond.
  static const BeamNodes& all_around();
  /// As far apart as errors of mirrors and prisms are alike, over a field that does not go all around.
  static BeamNodes over(double azimuth_from_rad, double azimuth_to_rad, double elevation_from_rad,
                        double elevation_to_rad);

  bool empty() const { return elevations_rad_.empty(); }
  bool by_azimuth() const { return !azimuths_rad_.empty(); }
  const std::vector<double>& elevations_rad() const { return elevations_rad_; }
  const std::vector<double>& azimuths_rad() const { return azimuths_rad_; }  ///< empty: all around

  Eigen::Index count() const;  ///< of the nodes
  double elevation_rad(Eigen::Index node) const;
  double azimuth_rad(Eigen::Index node) const;  ///< of nodes by azimuth

  /// Where the errors stand.
  Eigen::Index elevation_at(Eigen::Index node) const { return node; }
  Eigen::Index range_at(Eigen::Index node) const { return count() + node; }
  Eigen::Index azimuth_at(Eigen::Index node) const { return 2 * count() + node; }
  Eigen::Index range_scale() const { return (by_azimuth() ? 3 : 2) * count(); }
  Eigen::Index errors() const { return empty() ? 0 : range_scale() + 1; }

  BeamPlace place_of(const Eigen::Vector3d& point_in_lidar) const;

  friend bool operator==(const BeamNodes& a, const BeamNodes& b) {
    return a.elevations_rad_ == b.elevations_rad_ && a.azimuths_rad_ == b.azimuths_rad_;
  }

 private:
  std::vector<double> elevations_rad_, azimuths_rad_, slopes_;
};

}  // namespace remount::cloud
