// What two scans of a LiDAR can have in common, by the field of view that its scans show. docs/maths/pairwise.md (P22)
#pragma once

#include <optional>
#include <vector>

#include "algorithms/cloud/beam_nodes.h"
#include "algorithms/cloud/directions.h"
#include "model/pipeline/drive_motion.h"

namespace remount::pipeline {

/// Keyframes with a smaller share of the field in common are not paired.
inline constexpr double kLeastShare = 0.2;

/// Of each session, from some of its scans. A LiDAR that looks all around sees nearly the same from a few metres on,
/// however the vehicle turns: of such a one nothing is held, and all is common.
class SharedField {
 public:
  /// Reads up to ten scans of each session; those that cannot be read are left out. All is common where cancelled.
  SharedField(const DriveMotion& motion, const Progress& progress);

  bool any_narrow() const;
  /// Where the errors of the LiDAR's beams are unknowns: over its field, or all around where any session shows that.
  cloud::BeamNodes beam_nodes() const;
  /// Share of what one scan shows that lies in the field of another, [0, 1].
  double share(motion::SessionIndex session, const RigidTransform& lidar_b_from_lidar_a) const;
  /// Of the objects that two scans must share, those that a narrow field may be asked for; one at least of any.
  int objects_needed(motion::SessionIndex session, int all_around) const;

 private:
  struct Seen {
    cloud::Directions field;
    std::vector<Eigen::Vector3f> points_in_lidar;  ///< typical ones
  };
  std::vector<std::optional<Seen>> sessions_;  // nothing: all around, or not known
  bool any_all_around_ = false;
};

}  // namespace remount::pipeline
