// Poses of a LiDAR relative to its first scan while it turns about an axis; and what moves before one that stands.
#pragma once

#include <functional>
#include <vector>

#include "algorithms/cloud/point_cloud.h"
#include "algorithms/core/progress.h"
#include "algorithms/messages/message.h"
#include "algorithms/motion/ins_sample.h"
#include "algorithms/registration/registration_options.h"

namespace remount::calibration {

/// Scan `i` of a recording, in the lidar frame at its stamp. May throw Error where it cannot be read.
using LoadScan = std::function<cloud::PointCloud(std::size_t scan)>;

struct TurnTrajectory {
  std::vector<motion::StampedPose> first_from_lidar;  ///< of the scans that could be aligned, the first one included
  std::vector<std::size_t> scans;                     ///< which scans these are
  std::size_t failed = 0;                             ///< scans that fitted neither the first nor the one before
  Message first_failure;
};

/// Aligns each scan to the first one, so that errors do not add up; the scan before gives the start, and stands in
/// where the first does not fit. @param start poses of an earlier pass, one for each stamp, or empty
TurnTrajectory turn_trajectory(const std::vector<std::int64_t>& stamps_ns, const LoadScan& load,
                               const registration::RegistrationOptions& options,
                               const std::vector<motion::StampedPose>& start, Progress& progress);

/// Points that move while the LiDAR stands: those in front of what is seen in the same direction at other times.
/// @param within_m points farther away are not looked at
std::vector<Eigen::Vector3d> moving_points(const std::vector<cloud::PointCloud>& scans_in_lidar, double within_m);

}  // namespace remount::calibration
