// How the points of one scan lie around the sensor, and in which order.
#pragma once

#include <optional>

#include "algorithms/cloud/point_cloud.h"

namespace remount::cloud {

/// The way in which points follow each other in a scan: those of a sensor that spins, in the order of their times.
struct SweepOrder {
  bool clockwise = true;
  double first_azimuth_rad = 0.0;
};
/// Nothing where the order is another: by rings, by place, or of a sensor that does not spin.
std::optional<SweepOrder> sweep_order(const PointCloud& cloud);

/// Whether there are points all around.
bool looks_around(const PointCloud& cloud);

}  // namespace remount::cloud
