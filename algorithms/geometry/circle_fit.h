// A circle in space through points, with its covariance and how much of it they cover.
#pragma once

#include <string>
#include <vector>

#include "algorithms/geometry/rotation.h"
#include "algorithms/messages/message.h"

namespace remount {

struct CircleFit {
  bool found = false;
  Message why;  ///< where it is not
  Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< unit length; the points run around it counter-clockwise
  double radius_m = 0.0;
  double arc_rad = 0.0;          ///< of the circle, without its largest hole
  double in_plane_rms_m = 0.0;   ///< of the distances from the circle
  double off_plane_rms_m = 0.0;  ///< of those from its plane
  std::size_t inliers = 0;
  Eigen::Matrix3d centre_covariance_m2 = Eigen::Matrix3d::Zero();
  double radius_sigma_m = 0.0;
  /// Of the axis under axis <- Exp(phi) axis; nothing about the axis itself.
  Eigen::Matrix3d axis_covariance_rad2 = Eigen::Matrix3d::Zero();
};

/// Plane, then circle in it: algebraic start (Kasa 1976), then the sum of squared distances with a soft limit (Huber);
/// points beyond five sigma are left out. The order of the points says the sense of the axis. The covariances allow for
/// errors that neighbours have in common, as far as the residuals show them; an error that all points have in common,
/// or that goes once around with the points, moves centre and axis without a residual and is not in them.
CircleFit fit_circle(const std::vector<Eigen::Vector3d>& points_m);

}  // namespace remount
