// Which way a vehicle travels, seen from its INS.
#pragma once

#include <optional>

#include "model/conventions/metric_poses.h"

namespace remount::conventions {

/// Of a vehicle that goes where it points: without side slip in the mean, whatever its INS is turned by. What a lever
/// arm from the axle that does not slip adds in turns is taken out.
struct TravelDirection {
  double yaw_rad = 0.0;    ///< of the direction of travel about the z axis of the INS, from its x axis
  double sigma_rad = 0.0;  ///< of that mean: scatter of the drive, and a tenth of a degree of roads that fall to a side
  bool forwards = false;   ///< at a speed at which nobody reverses: otherwise it may be half a turn off
};

/// Nothing where the vehicle moves for less than some ten seconds, follows no direction of its INS, or where the z axis
/// of the INS is not upright.
std::optional<TravelDirection> travel_direction(const MetricPoses& world_from_ins);

}  // namespace remount::conventions
