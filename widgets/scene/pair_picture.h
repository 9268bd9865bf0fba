// Pictures of pairs without a window, for reports. VTK inside, no Qt.
#pragma once

#include <memory>
#include <vector>

#include "widgets/scene/pair_scene.h"

namespace remount::scene {

struct RgbImage {
  int width = 0, height = 0;
  std::vector<unsigned char> rgb;  ///< rows from the top, three bytes a pixel
};

/// Only where there is OpenGL (missing_gl_reason): VTK ends the program elsewhere. On the thread that owns the display.
class PairPainter {
 public:
  PairPainter(int width, int height);
  ~PairPainter();
  RgbImage paint(PairSceneDataPtr data, const PairTransforms& transforms, PairAlignment alignment);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;  // kept from picture to picture: shaders are compiled once
};

}  // namespace remount::scene
