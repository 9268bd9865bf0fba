// Where the camera should look: robust against stray points.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "algorithms/geometry/rigid_transform.h"

namespace remount::scene {

/// A ball that holds what matters of a cloud, in the frame the points were brought to.
struct Framing {
  Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();
  double radius_m = 10.0;
};

/// Frames by percentiles (5 to 95) of each axis: one bad coordinate among a hundred thousand would otherwise leave
/// nothing to see. Points that are not finite are ignored; without points the default ball is returned.
Framing robust_framing(const std::vector<Eigen::Vector3f>& points_in_lidar, const RigidTransform& view_from_lidar);

}  // namespace remount::scene
