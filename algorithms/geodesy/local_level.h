// East, north, up about a fixed place.
#pragma once

#include <memory>

#include "algorithms/geometry/rigid_transform.h"
#include "algorithms/motion/ins_sample.h"
#include "algorithms/motion/sensor_samples.h"

namespace remount::geodesy {

/// A metric frame that touches the ellipsoid at its origin, by way of earth-centred coordinates (GeographicLib, Karney
/// 2011). No grid, hence neither scale nor convergence; but true north and the level change with the place, and
/// attitudes are turned from where they were measured to the axes of the origin: a kilometre east at 49 degrees turns
/// north by 0.01 degrees.
class LocalLevel {
 public:
  /// Throws Error(Contract) where the coordinates are not on the globe.
  LocalLevel(double latitude_rad, double longitude_rad, double height_m);
  ~LocalLevel();
  LocalLevel(LocalLevel&&) noexcept;
  LocalLevel& operator=(LocalLevel&&) noexcept;

  RigidTransform enu_from_ins(const motion::InsSample& sample) const;
  /// Where the antenna was, m.
  Eigen::Vector3d position_enu_m(const motion::GnssFix& fix) const;
  /// The fix's covariance in the axes of the origin.
  Eigen::Matrix3d covariance_enu_m2(const motion::GnssFix& fix) const;

 private:
  /// Axes at a place in those of the origin, and the place.
  RigidTransform enu_from_level(double latitude_rad, double longitude_rad, double height_m) const;
  struct Cartesian;
  std::unique_ptr<Cartesian> cartesian_;
};

}  // namespace remount::geodesy
