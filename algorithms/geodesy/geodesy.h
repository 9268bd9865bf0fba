// From geodetic INS samples to a metric frame, through UTM with meridian convergence and point scale.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "algorithms/geometry/rigid_transform.h"
#include "algorithms/motion/ins_sample.h"

namespace remount::geodesy {

/// A position on the UTM grid. Grid distances are `point_scale` times true distances on the ellipsoid; grid north lies
/// `convergence_rad` clockwise from true north.
struct GridFix {
  double easting_m = 0.0;
  double northing_m = 0.0;
  double point_scale = 1.0;
  double convergence_rad = 0.0;
};

/// UTM in one fixed zone: a drive that crosses a zone boundary stays in the zone of its first fix, so that its
/// trajectory has no jump. Latitudes beyond UTM's use the polar stereographic grid (UPS).
class UtmGrid {
 public:
  /// Zone of this fix. Throws Error(Contract) where the coordinates are not on the globe.
  UtmGrid(double latitude_rad, double longitude_rad);
  GridFix project(double latitude_rad, double longitude_rad) const;
  int zone() const { return zone_; }

 private:
  int zone_ = 0;
  bool north_ = true;
};

/// Convergence and point scale at a place that is known by its coordinates on the grid: the same in every zone. Nothing
/// where no zone reaches.
std::optional<GridFix> grid_fix_at(double easting_m, double northing_m, bool northern);

/// True metres of a metre of the grid: on the ellipsoid divided by the point scale, at a height by as much more.
double metres_per_grid_metre(double point_scale, double height_m);

/// local_from_ins for each sample: axes of the UTM grid, origin at the first sample. Attitude is turned from true to
/// grid north by the convergence; each step of the trajectory is divided by the grid's point scale and carried from the
/// ellipsoid to the vehicle's height, so that differences of positions are true metres.
/// Without convergence and scale, the motion P of the INS would be off by up to degrees and parts in a thousand.
/// Projection by GeographicLib (Karney 2011).
std::vector<motion::StampedPose> local_from_ins(std::span<const motion::InsSample> samples);

}  // namespace remount::geodesy
