// Curves without points yet, by how they are drawn.
#pragma once

#include <utility>

#include "algorithms/calibration/method_details.h"

namespace remount::calibration {

inline Curve line_curve(Message name) {
  Curve curve;
  curve.name = std::move(name);
  return curve;
}

inline Curve dot_curve(Message name) {
  Curve curve = line_curve(std::move(name));
  curve.dots = true;
  return curve;
}

}  // namespace remount::calibration
