#include "model/pipeline/first_ground.h"

#include <algorithm>

#include "algorithms/cloud/objects.h"
#include "algorithms/core/error.h"

namespace remount::pipeline {

std::optional<Eigen::Vector3d> up_of_first_scans(const drive::Session& session) {
  constexpr std::size_t kMostFirstScans = 10;
  const std::size_t count = session.scans ? std::min(session.scans->size(), kMostFirstScans) : 0;
  for (std::size_t scan = 0; scan < count; ++scan) {
    try {
      const cloud::GroundPlane ground =
          cloud::estimate_ground_plane(session.scans->load(scan), Eigen::Vector3f::Zero());
      if (ground.found) return ground.up_in_lidar.cast<double>();
    } catch (const Error&) {
      // Unreadable scans are reported where all are read.
    }
  }
  return std::nullopt;
}

}  // namespace remount::pipeline
