// Colours for distances with a side, the same for every pair.
#pragma once

#include "widgets/scene/distance_scale.h"

namespace remount::scene {

/// Behind a surface (negative) blue, on it pale, before it (positive) red, so that also the colour-blind see the sides;
/// beyond the limit it grows no darker. Nothing to compare with is as on the scale of distances.
class SignedScale {
 public:
  explicit SignedScale(double limit_m) : limit_m_(limit_m) {}
  SceneColor color(float distance_m) const;
  /// Of the scale at a share between -1 and 1.
  static SceneColor at(double share);

 private:
  double limit_m_;
};

}  // namespace remount::scene
