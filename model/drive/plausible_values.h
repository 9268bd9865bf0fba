// Values that no drive has: what loggers write in place of what they do not know.
#pragma once

#include <Eigen/Core>
#include <string>

namespace remount::drive {

/// Rotation from a log that may be slightly off: projects to the nearest rotation. `defect` is how far each entry was
/// off at most. Throws Error(Format) at `where` beyond 0.1: that is no rotation.
Eigen::Matrix3d checked_rotation(const Eigen::Matrix3d& logged, const std::string& where, double& defect);

/// True where latitude and longitude (rad) and height (m) are possible. Depths that loggers write for "not known"
/// (-9999) are not.
bool plausible_geodetic(double latitude_rad, double longitude_rad, double height_m);

/// True for what receivers and loggers write in place of any quantity that they do not have: -2e10 ("do not use" of
/// Septentrio, also where a driver turned it into other units), 1e10 and the like.
bool means_not_known(double value);
/// The same for an angle as it was logged, in degrees or radians: nines (-9999), and limits of 16 and 32 bits, too.
bool angle_means_not_known(double logged);

}  // namespace remount::drive
