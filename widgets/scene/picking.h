// Which point of a cloud was clicked on.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "algorithms/geometry/rigid_transform.h"

namespace remount::scene {

/// The ray through a click, in the frame in which the scene is shown.
struct PickRay {
  Eigen::Vector3d origin_in_view = Eigen::Vector3d::Zero();      ///< where the camera stands, m
  Eigen::Vector3d direction_in_view = Eigen::Vector3d::UnitX();  ///< unit length
  double pixel_rad = 1e-3;                                       ///< the angle that one pixel spans
  int pane = 0;                                                  ///< which of the pictures side by side was clicked on
};

struct PickedPoint {
  std::size_t index = 0;
  double angle_rad = 0.0;   ///< between the ray and the point
  double distance_m = 0.0;  ///< from the camera
};

/// The point nearest to the ray, as seen: by angle. Of those within a pixel of the nearest, which look like one, the
/// one in front. Nothing where none is within `reach_px` pixels; points behind the camera and such that are not finite
/// are not seen.
std::optional<PickedPoint> nearest_to_ray(const std::vector<Eigen::Vector3f>& points_in_cloud,
                                          const RigidTransform& view_from_cloud, const PickRay& ray,
                                          double reach_px = 12.0);

/// The two halves of it, in the cloud's frame; angles as tangents. Of the points within `most` the smallest angle to
/// the ray, and the one in front.
std::optional<double> least_tangent_to_ray(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3d& origin,
                                           const Eigen::Vector3d& direction, double most);
std::optional<PickedPoint> first_within(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3d& origin,
                                        const Eigen::Vector3d& direction, double most);

}  // namespace remount::scene
