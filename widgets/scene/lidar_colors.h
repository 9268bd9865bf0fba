// The colour of each LiDAR of a vehicle, the same in maps, lists and drawings.
#pragma once

#include <array>

#include "algorithms/motion/pair.h"
#include "widgets/scene/distance_scale.h"

namespace remount::scene {

/// Colours that also the colour-blind can tell apart (after Okabe and Ito); of more LiDARs than there are, two have
/// one.
inline SceneColor lidar_color(motion::LidarIndex lidar) {
  static constexpr std::array<SceneColor, 8> kColors{{{230, 159, 0},
                                                      {86, 180, 233},
                                                      {0, 158, 115},
                                                      {204, 121, 167},
                                                      {213, 94, 0},
                                                      {0, 114, 178},
                                                      {170, 160, 40},
                                                      {140, 140, 140}}};
  return kColors[static_cast<std::size_t>(signed_of(lidar)) % kColors.size()];
}

}  // namespace remount::scene
