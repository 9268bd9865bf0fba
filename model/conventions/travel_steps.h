// The path of an INS in stretches: what its attitude is compared with.
#pragma once

#include <vector>

#include "algorithms/motion/ins_sample.h"
#include "model/conventions/metric_poses.h"

namespace remount::conventions {

/// A stretch of travel in the world, and the attitude in its middle.
struct TravelStep {
  Eigen::Vector3d direction;  ///< unit
  double speed_mps = 0.0;
  Eigen::Matrix3d world_from_ins;
  double turn_rate_radps = 0.0;  ///< about the z axis of the INS, over the stretch
};

/// Between the mean positions of successive half seconds, for single samples are noisy; those at 2 to 100 m/s. From 1
/// m/s on of whole seconds, where their halves lead the same way.
std::vector<TravelStep> travel_steps(const std::vector<motion::StampedPose>& world_from_ins);
std::vector<TravelStep> travel_steps(const MetricPoses& world_from_ins);

}  // namespace remount::conventions
