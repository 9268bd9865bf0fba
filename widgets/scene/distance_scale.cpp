#include "widgets/scene/distance_scale.h"

#include <algorithm>
#include <cmath>

namespace remount::scene {
namespace {

// After Okabe and Ito's blue, bluish green and yellow: none so dark or so light that it is lost before the background.
constexpr std::array<SceneColor, 5> kScale{
    {{0, 90, 170}, {0, 130, 160}, {0, 158, 115}, {110, 190, 90}, {225, 205, 50}}};

}  // namespace

DistanceScale::DistanceScale(double limit_m)
    : limit_m_(std::isfinite(limit_m) ? std::clamp(limit_m, kLeast_m, kMost_m) : kDefault_m) {}

SceneColor DistanceScale::at(double share) {
  const double place = std::clamp(share, 0.0, 1.0) * static_cast<double>(kScale.size() - 1);
  const auto left = std::min(static_cast<std::size_t>(place), kScale.size() - 2);
  const double part = place - static_cast<double>(left);
  SceneColor color;
  for (std::size_t i = 0; i < 3; ++i)
    color[i] = static_cast<unsigned char>(std::lround((1.0 - part) * kScale[left][i] + part * kScale[left + 1][i]));
  return color;
}

SceneColor DistanceScale::color(float distance_m) const {
  if (std::isnan(distance_m)) return kNothingNear;
  const double apart_m = std::abs(static_cast<double>(distance_m));
  return apart_m > limit_m_ ? kOverRange : at(apart_m / limit_m_);
}

std::vector<SceneColor> DistanceScale::colors(const std::vector<float>& distances_m) const {
  std::vector<SceneColor> colors(distances_m.size());
  std::transform(distances_m.begin(), distances_m.end(), colors.begin(), [this](float d) { return color(d); });
  return colors;
}

}  // namespace remount::scene
