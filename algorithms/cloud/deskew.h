// Motion compensation: a scan as it would be had all its points been measured at its stamp.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "algorithms/cloud/point_cloud.h"
#include "algorithms/geometry/rigid_transform.h"

namespace remount::cloud {

/// lidar frame at the stamp <- lidar frame at a time, in s from the stamp.
using LidarMotion = std::function<RigidTransform(double time_from_stamp_s)>;

/// Takes each point from the lidar frame of its own time to the lidar frame at the stamp. The motion is asked for at
/// least every 2 ms over the sweep and interpolated in between (error under 0.1 mm at 80 m for 90 deg/s). The result
/// has the same points in the same order, and no times any more, so that it cannot be compensated twice. It has none at
/// all where the sensor would have moved by a kilometre meanwhile: nobody knows then where they are. Throws
/// Error(Contract) where the times are not as many as the points, not finite, or spread over more than 10 s.
PointCloud deskew(const PointCloud& cloud_in_lidar, std::span<const float> time_from_stamp_s,
                  const LidarMotion& lidar_at_stamp_from_lidar_at);

/// Times of the points of a spinning sensor from their azimuths atan2(y, x), s from the stamp, in (-period_s / 2,
/// period_s / 2]: the sensor faces `stamp_azimuth_rad` at the stamp. `clockwise` is seen from the +z side.
std::vector<float> sweep_times(const PointCloud& cloud_in_lidar, double period_s, double stamp_azimuth_rad,
                               bool clockwise);

}  // namespace remount::cloud
