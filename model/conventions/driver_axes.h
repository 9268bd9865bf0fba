// Attitudes of drivers that write them in either of two conventions and do not say in which.
#pragma once

#include <optional>
#include <vector>

#include "model/drive/session.h"

namespace remount::conventions {

/// What the attitudes are that one of these drivers wrote, by the direction of travel.
struct DriverAxes {
  bool enu = false;  ///< forward-left-up of a world whose z is up, instead of forward-right-down of north-east-down
  /// By which the world of the attitudes has to be turned about up, counter-clockwise as seen from above, to be
  /// east-north-up.
  double turn_rad = 0.0;
  /// From the x axis of the INS, forward-left-up, to the direction in which the vehicle goes, about up,
  /// counter-clockwise as seen from above: what is left under these axes.
  double yaw_rad = 0.0;
  bool may_be_turned = false;  ///< a world that is turned goes as well with this road, which leads north or south
  /// The vehicle goes to a side of its INS: that is turned by a quarter turn, or the attitudes are.
  bool goes_sideways() const;
};

/// Of attitudes that were read as forward-right-down of north-east-down: under the right convention a vehicle keeps to
/// one direction of its INS, under the other it does so on a straight road alone. There the one counts under which it
/// goes ahead. Where it does so under neither, it may under that of early versions of the driver, whose world has to be
/// turned about up. Nothing where the vehicle hardly moves.
/// @param early_turn_rad that turn; 0 where no version has one
std::optional<DriverAxes> find_driver_axes(const std::vector<motion::InsSample>& read_as_ned, double early_turn_rad);

}  // namespace remount::conventions
