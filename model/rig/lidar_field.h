// Where a LiDAR looks, and how much of what it sees another one has in its field of view.
#pragma once

#include <vector>

#include "algorithms/cloud/directions.h"
#include "algorithms/core/progress.h"
#include "model/drive/session.h"

namespace remount::rig {

class LidarField {
 public:
  /// From some scans of the sessions; those that cannot be read are passed over. Nothing is seen where cancelled.
  LidarField(const std::vector<std::shared_ptr<const drive::Session>>& sessions, const Progress& progress);

  bool empty() const { return points_in_lidar_.empty(); }
  /// Some of what it usually sees, m.
  const std::vector<Eigen::Vector3f>& points_in_lidar() const { return points_in_lidar_; }
  /// Share of what this LiDAR usually sees that lies in the field of `other`, [0, 1].
  double share_in(const LidarField& other, const RigidTransform& other_from_this) const;

 private:
  cloud::Directions field_;
  std::vector<Eigen::Vector3f> points_in_lidar_;  // typical ones
  float farthest_m_ = 0.0f;                       // of nine in ten of them
};

}  // namespace remount::rig
