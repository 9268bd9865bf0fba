#include "model/conventions/driver_axes.h"

#include <cmath>

#include "algorithms/geometry/rotation.h"
#include "model/conventions/metric_poses.h"
#include "model/conventions/travel_direction.h"
#include "model/drive/attitude_convention.h"

namespace remount::conventions {
namespace {

constexpr double kAhead_rad = 0.35;  // boxes that are to point ahead do so within it

struct AxesTravel {
  std::optional<TravelDirection> as_ned, as_enu, as_turned;
};

AxesTravel travel_of_axes(const std::vector<motion::InsSample>& read_as_ned, double early_turn_rad) {
  AxesTravel travel;
  drive::Session trial;
  trial.ins = read_as_ned;
  travel.as_ned = travel_direction(MetricPoses(trial));
  for (motion::InsSample& sample : trial.ins)
    sample.enu_from_ins = drive::enu_from_ins(sample.enu_from_ins, drive::QuaternionConvention::NedFromBody);
  travel.as_enu = travel_direction(MetricPoses(trial));
  if (early_turn_rad == 0.0) return travel;
  const Eigen::AngleAxisd turn(early_turn_rad, Eigen::Vector3d::UnitZ());
  for (motion::InsSample& sample : trial.ins) sample.enu_from_ins = turn * sample.enu_from_ins;
  travel.as_turned = travel_direction(MetricPoses(trial));
  return travel;
}

std::optional<bool> is_enu(const AxesTravel& travel) {
  constexpr double kAlike_rad = 0.2;
  if (!travel.as_ned && !travel.as_enu) return std::nullopt;
  if (!travel.as_ned || !travel.as_enu) return travel.as_enu.has_value();
  const double ned_rad = std::abs(travel.as_ned->yaw_rad), enu_rad = std::abs(travel.as_enu->yaw_rad);
  if (std::abs(ned_rad - enu_rad) < kAlike_rad) return std::nullopt;
  return enu_rad < ned_rad;
}

bool goes_ahead(const std::optional<TravelDirection>& travel) {
  return travel && std::abs(travel->yaw_rad) < kAhead_rad;
}

}  // namespace

bool DriverAxes::goes_sideways() const { return std::abs(std::abs(yaw_rad) - 0.5 * kPi) < kAhead_rad; }

std::optional<DriverAxes> find_driver_axes(const std::vector<motion::InsSample>& read_as_ned, double early_turn_rad) {
  const AxesTravel travel = travel_of_axes(read_as_ned, early_turn_rad);
  const bool turned = goes_ahead(travel.as_turned);
  if (turned && !goes_ahead(travel.as_ned))
    return DriverAxes{.enu = true, .turn_rad = early_turn_rad, .yaw_rad = travel.as_turned->yaw_rad};
  const auto enu = is_enu(travel);
  if (!enu) return std::nullopt;
  return DriverAxes{.enu = *enu, .yaw_rad = (*enu ? travel.as_enu : travel.as_ned)->yaw_rad, .may_be_turned = turned};
}

}  // namespace remount::conventions
