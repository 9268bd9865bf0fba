// A start for registration from far away: both scans are levelled by their ground, then what stands on it is compared
// over yaw and position.
#pragma once

#include <vector>

#include "algorithms/core/progress.h"
#include "algorithms/geometry/rigid_transform.h"
#include "algorithms/registration/prepared_cloud.h"

namespace remount::registration {

/// A transform under which what stands on the ground coincides better than under those around it.
struct CoarseMode {
  RigidTransform target_from_source = RigidTransform::Identity();
  double score = 0.0;  ///< 0 to 1: share of upright structure that meets structure
};

/// The best modes within `search_reach_m` and `search_reach_deg` of the start, best first, at most `most`. Ground under
/// both scans gives roll, pitch and height; where one shows none, those of the start are kept. Correlative scan
/// matching (Olson 2009) on cells of half a metre in layers of height. Empty where a scan has no upright structure, or
/// where `progress` is cancelled.
std::vector<CoarseMode> coarse_modes(const PreparedCloud& source, const PreparedCloud& target,
                                     const RigidTransform& target_from_source_start, const RegistrationOptions& options,
                                     std::size_t most, const Progress& progress);

}  // namespace remount::registration
