// A picture of a pair without a window, for reports. VTK inside, no Qt.
#pragma once

#include <vector>

#include "widgets/scene/pair_scene.h"

namespace remount {

struct RgbImage {
  int width = 0, height = 0;
  std::vector<unsigned char> rgb;  ///< rows from the top, three bytes a pixel
};

/// Only where there is OpenGL (missing_gl_reason): VTK ends the program elsewhere. On the thread that owns the display.
RgbImage picture_of_pair(const PairClouds& clouds, const PairTransforms& transforms, PairAlignment alignment, int width,
                         int height);

}  // namespace remount
