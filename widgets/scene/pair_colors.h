// Colours of the pair's scene, for what draws it and for its legend.
#pragma once

#include "widgets/scene/distance_scale.h"

namespace remount::scene {

/// Of the scans, told apart by the colour-blind too.
struct ScanColors {
  SceneColor target, orange, blue;  ///< scan b; scan a in either colour
};
constexpr ScanColors scan_colors(bool dark) {
  return dark ? ScanColors{{158, 166, 176}, {255, 158, 51}, {86, 180, 255}}
              : ScanColors{{117, 122, 133}, {217, 74, 5}, {0, 95, 175}};
}

/// Of boxes and of what joins them, on light and dark alike.
inline constexpr SceneColor kObjectA{20, 160, 110}, kObjectB{30, 120, 200}, kLink{20, 140, 150}, kMoving{220, 30, 40};

}  // namespace remount::scene
