// In which directions a LiDAR has measured something: what one scan shows of the field that several show.
// docs/maths/pairwise.md (P20)
#pragma once

#include <cstddef>
#include <vector>

#include "algorithms/cloud/point_cloud.h"

namespace remount::cloud {

/// In the lidar frame, rad; the azimuth from x towards y, from the right end of the field to its left one, which may be
/// beyond half a turn.
struct FieldBox {
  double azimuth_from_rad = 0.0, azimuth_to_rad = 0.0, elevation_from_rad = 0.0, elevation_to_rad = 0.0;
};

/// Cells of about a degree on the sphere around a LiDAR, whichever way it is mounted.
class Directions {
 public:
  Directions();

  /// Those of points in the lidar frame; a point at the origin has none.
  void add(const std::vector<Eigen::Vector3f>& points_in_lidar);
  void add(const Directions& other);

  std::size_t count() const;  ///< of the cells in which something was measured
  bool empty() const { return count() == 0; }
  /// Whether something was measured in the cell of this direction or in one next to it.
  bool has_near(const Eigen::Vector3f& direction_in_lidar) const;
  /// Share of a turn about z in which something was measured, in steps of ten degrees, at whatever elevation.
  double turn_shown() const;
  /// What contains all of them. They must not be none.
  FieldBox box() const;
  /// Share of the cells of `whole` in which something was measured here, too; 0 where there are none.
  double share_of(const Directions& whole) const;

 private:
  bool has_near(int row, int column) const;

  std::vector<bool> seen_;
};

}  // namespace remount::cloud
