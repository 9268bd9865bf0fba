// What points of a scan can be coloured by, beside distances to another scan.
#pragma once

#include <vector>

#include "algorithms/geometry/rigid_transform.h"
#include "widgets/scene/scan_scene.h"

namespace remount::scene {

enum class PointProperty { Height, Intensity, Ring, Time };

/// Of each point in the order in which the scene draws it: m above the origin of the view, as recorded, number of the
/// beam, or s from the stamp of the scan. Empty where the scan has none.
std::vector<float> property_of(const ScanScene& scan, PointProperty property, const RigidTransform& level_from_lidar);

/// Between which nearly all values lie: a few strays do not spread the colours. Both 0 for none.
struct ValueRange {
  float low = 0.0F, high = 0.0F;
};
ValueRange range_of(const std::vector<float>& first, const std::vector<float>& second);

/// On the scale of distances, from low to high.
std::vector<SceneColor> colors_of(const std::vector<float>& values, const ValueRange& range);

}  // namespace remount::scene
