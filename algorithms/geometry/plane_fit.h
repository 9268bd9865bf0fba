// A plane through points, some of which do not belong to it, with its covariance.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "algorithms/core/options.h"
#include "algorithms/core/progress.h"
#include "algorithms/geometry/rotation.h"
#include "algorithms/messages/message.h"

namespace remount {

struct PlaneFitOptions {
  double inlier_m = 0.05;  ///< points farther from the plane do not belong to it
  int trials = 400;
  int seed = 1;
  /// Unit length; nothing: any plane. Planes whose normal leans more than `most_lean_rad` from this direction (either
  /// sense) are passed over...
  std::optional<Eigen::Vector3d> near_normal;
  /// ... and those whose normal is not within `most_lean_rad` of being square to this one.
  std::optional<Eigen::Vector3d> square_to;
  double most_lean_rad = 0.35;
};

struct PlaneFit {
  bool found = false;
  Message why;                                           ///< where it is not
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();     ///< unit length, towards the origin of the points' frame
  Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();    ///< mean of the points that belong to it
  Eigen::Vector3d long_axis = Eigen::Vector3d::UnitX();  ///< in the plane, along its greater extent
  double long_extent_m = 0.0, short_extent_m = 0.0;      ///< root mean square of the points along and across it
  double rms_m = 0.0;
  std::size_t inliers = 0;
  /// Of the normal under normal <- Exp(phi) normal, axes of the points' frame; nothing about the normal itself.
  Eigen::Matrix3d normal_covariance_rad2 = Eigen::Matrix3d::Zero();
  double offset_sigma_m = 0.0;  ///< along the normal, at the centre

  double height_of(const Eigen::Vector3d& point_m) const { return normal.dot(point_m - centre_m); }
};

/// The plane of most points by random trials, then least squares with a soft limit (Tukey).
/// @param spots empty, or for each point the number of the spot that it lies on, from 0 without gaps: errors within a
///        spot may be alike, by as much as they turn out to be; those of different spots are independent
PlaneFit fit_plane(const std::vector<Eigen::Vector3d>& points_m, const PlaneFitOptions& options,
                   const std::vector<std::size_t>& spots = {}, const Progress& progress = {});

}  // namespace remount
