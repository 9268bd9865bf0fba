#include "widgets/scene/signed_scale.h"

#include <algorithm>
#include <cmath>

namespace remount::scene {
namespace {
// Blue and vermilion of Okabe and Ito, and between them a grey green that is seen on white and on black.
constexpr SceneColor kBehind{0, 90, 190}, kOn{120, 175, 120}, kBefore{213, 60, 0};
}  // namespace

SceneColor SignedScale::at(double share) {
  const SceneColor& end = share < 0.0 ? kBehind : kBefore;
  const double part = std::min(1.0, std::abs(share));
  SceneColor color;
  for (std::size_t i = 0; i < color.size(); ++i)
    color[i] = static_cast<unsigned char>(std::lround((1.0 - part) * kOn[i] + part * end[i]));
  return color;
}

SceneColor SignedScale::color(float distance_m) const {
  return std::isnan(distance_m) ? DistanceScale::kNothingNear : at(static_cast<double>(distance_m) / limit_m_);
}

}  // namespace remount::scene
