#include "model/conventions/driver_axes.h"

#include <cmath>

#include "model/conventions/metric_poses.h"
#include "model/conventions/travel_direction.h"
#include "model/drive/attitude_convention.h"

namespace remount::conventions {

std::optional<bool> are_east_north_up(const std::vector<motion::InsSample>& read_as_ned) {
  constexpr double kAlike_rad = 0.2;
  drive::Session trial;
  trial.ins = read_as_ned;
  const auto as_ned = travel_direction(MetricPoses(trial));
  for (motion::InsSample& sample : trial.ins)
    sample.enu_from_ins = drive::enu_from_ins(sample.enu_from_ins, drive::QuaternionConvention::NedFromBody);
  const auto as_enu = travel_direction(MetricPoses(trial));
  if (!as_ned && !as_enu) return std::nullopt;
  if (!as_ned || !as_enu) return as_enu.has_value();
  if (std::abs(std::abs(as_ned->yaw_rad) - std::abs(as_enu->yaw_rad)) < kAlike_rad) return std::nullopt;
  return std::abs(as_enu->yaw_rad) < std::abs(as_ned->yaw_rad);
}

}  // namespace remount::conventions
