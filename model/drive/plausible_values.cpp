#include "model/drive/plausible_values.h"

#include <cmath>

#include "algorithms/core/error.h"
#include "algorithms/geometry/rotation.h"
#include "messages/poses.h"

namespace remount::drive {

Eigen::Matrix3d checked_rotation(const Eigen::Matrix3d& logged, const std::string& where, double& defect) {
  if (!logged.allFinite()) throw Error(ErrorCode::Format, where, say::pose_not_finite());
  const Eigen::Matrix3d rotation = nearest_rotation(logged);
  defect = (rotation - logged).cwiseAbs().maxCoeff();
  if (defect > 0.1) throw Error(ErrorCode::Format, where, say::pose_no_rotation(defect));
  return rotation;
}

bool plausible_geodetic(double latitude_rad, double longitude_rad, double height_m) {
  constexpr double kLowest_m = -9000.0, kHighest_m = 1e5;
  return std::abs(latitude_rad) <= kPi / 2.0 && std::abs(longitude_rad) <= 2.0 * kPi && height_m > kLowest_m &&
         height_m < kHighest_m;
}

bool means_not_known(double value) { return !(std::abs(value) < 1e8); }

bool angle_means_not_known(double logged) {
  constexpr double kMostTurns_deg = 1e6;  // of a yaw that counts on
  const double size = std::abs(logged);
  if (!(size < kMostTurns_deg)) return true;
  for (const double nines : {999.0, 9999.0, 99999.0, 999999.0, 32767.0, 32768.0, 65535.0})
    if (size == nines) return true;
  return false;
}

}  // namespace remount::drive
