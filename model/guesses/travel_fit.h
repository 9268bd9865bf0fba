// How well attitudes keep to the direction of travel: what tells one convention from another.
#pragma once

#include <cstddef>
#include <vector>

#include "algorithms/motion/ins_sample.h"

namespace remount::guesses {

/// Whether the nose goes up and down with the road.
enum class SlopeFit { NotTold, Agrees, Opposite, Unrelated };

struct TravelFit {
  std::size_t steps = 0;  ///< stretches of half a second in which the vehicle moved
  double residual_rad =
      0.0;                  ///< 1-sigma of what the heading is off the direction of travel, a constant angle taken out
  double offset_rad = 0.0;  ///< that angle, from x of the INS; half a turn is not told where it drives slowly
  double turned_rad = 0.0;  ///< over how wide a range of directions the vehicle travelled
  double upright = 0.0;     ///< mean of the z axis' upward part: 1 where it is level
  SlopeFit slope = SlopeFit::NotTold;
  double slope_sigma_rad = 0.0;  ///< how much the road rises and falls
};

TravelFit travel_fit(const std::vector<motion::StampedPose>& world_from_ins);

/// Fewer steps than these tell nothing.
inline constexpr std::size_t kFewestTravelSteps = 10;
/// A drive that turns less does not tell which way a heading counts.
inline constexpr double kLeastTurned_rad = 0.35;

}  // namespace remount::guesses
