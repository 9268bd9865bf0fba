#include "widgets/scene/point_property.h"

#include <algorithm>
#include <cmath>

namespace remount::scene {
namespace {

constexpr double kStrays = 0.02;          // of the values, at either end
constexpr std::size_t kLookedAt = 20000;  // of the values, evenly

template <class Value>
std::vector<float> in_drawn_order(const LevelCloud& drawn, const std::vector<Value>& recorded) {
  std::vector<float> values;
  if (recorded.empty()) return values;
  values.reserve(drawn.size());
  for (const std::uint32_t point : drawn.original) values.push_back(static_cast<float>(recorded[point]));
  return values;
}

std::vector<float> heights(const LevelCloud& drawn, const RigidTransform& level_from_lidar) {
  const Eigen::Vector3f up = level_from_lidar.linear().row(2).transpose().cast<float>();
  const auto offset = static_cast<float>(level_from_lidar.translation().z());
  std::vector<float> values;
  values.reserve(drawn.size());
  for (const Eigen::Vector3f& point : drawn.points) values.push_back(up.dot(point) + offset);
  return values;
}

}  // namespace

std::vector<float> property_of(const ScanScene& scan, PointProperty property, const RigidTransform& level_from_lidar) {
  const LevelCloud& drawn = *scan.geometry()->cloud;
  switch (property) {
    case PointProperty::Intensity:
      return in_drawn_order(drawn, scan.cloud().intensity);
    case PointProperty::Ring:
      return in_drawn_order(drawn, scan.cloud().ring);
    case PointProperty::Time:
      return in_drawn_order(drawn, scan.cloud().time_from_stamp_s);
    case PointProperty::Height:
      break;
  }
  return heights(drawn, level_from_lidar);
}

ValueRange range_of(const std::vector<float>& first, const std::vector<float>& second) {
  std::vector<float> values;
  for (const std::vector<float>* all : {&first, &second}) {
    const std::size_t step = std::max<std::size_t>(1, all->size() / kLookedAt);
    for (std::size_t i = 0; i < all->size(); i += step)
      if (std::isfinite((*all)[i])) values.push_back((*all)[i]);
  }
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
  };
  return {at(kStrays), at(1.0 - kStrays)};
}

std::vector<SceneColor> colors_of(const std::vector<float>& values, const ValueRange& range) {
  const float width = std::max(range.high - range.low, 1e-6F);
  std::vector<SceneColor> colors(values.size());
  std::transform(values.begin(), values.end(), colors.begin(), [&](float value) {
    return std::isfinite(value) ? DistanceScale::at(static_cast<double>((value - range.low) / width))
                                : DistanceScale::kNothingNear;
  });
  return colors;
}

}  // namespace remount::scene
