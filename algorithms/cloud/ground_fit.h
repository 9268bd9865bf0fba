// The ground near the vehicle as a plane.
#pragma once

#include <optional>

#include "algorithms/cloud/objects.h"
#include "algorithms/cloud/point_cloud.h"

namespace remount::cloud {

/// Plane of the ground in the lidar frame.
struct GroundFit {
  Eigen::Vector3d up_in_lidar = Eigen::Vector3d::UnitZ();  ///< normal, unit length
  double lidar_height_m = 0.0;                             ///< of the lidar's origin above the plane
  int points = 0;
  double rms_m = 0.0;  ///< of the points that were kept
};

/// Robust fit to the ground within `radius_m` of the lidar. Nothing where too little of it is seen, or none of it
/// over 150 deg of azimuth and more (on one side only): the plane below the vehicle would be a guess.
/// @param up_in_lidar rough direction away from the ground, unit length
std::optional<GroundFit> fit_ground(const PointCloud& cloud_in_lidar, const Eigen::Vector3f& up_in_lidar,
                                    const ObjectOptions& options, double radius_m);

}  // namespace remount::cloud
