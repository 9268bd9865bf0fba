// How a world of poses is turned and scaled against east and north, by fixes of the same drive.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "model/drive/session.h"

namespace remount::conventions {

struct TurnedByFixes {
  double angle_rad = 0.0;  ///< counterclockwise, of east in the world
  double scale = 1.0;      ///< metres of the world in one metre
  double sigma = 0.0;      ///< of both, radians and parts
  Eigen::Vector3d middle_in_world = Eigen::Vector3d::Zero();
  double latitude_rad = 0.0, longitude_rad = 0.0;  ///< of the fixes, in the mean
};

/// Nothing where there are no fixes, where they do not follow the poses, or where the vehicle hardly goes anywhere. The
/// lever arm of the antenna is taken out.
std::optional<TurnedByFixes> turned_by_fixes(const drive::Session& session);

}  // namespace remount::conventions
