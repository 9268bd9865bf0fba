// The features of the last scans about the vehicle, and what features of a new scan are matched with there.
#pragma once

#include <Eigen/Core>
#include <deque>
#include <memory>
#include <vector>

#include "algorithms/geometry/rigid_transform.h"
#include "algorithms/odometry/fusion/feature_extraction.h"

namespace remount::odometry {

/// A feature of the scan and the line or plane through its five nearest neighbours in the map.
struct FeatureMatch {
  Eigen::Vector3d point_in_vehicle = Eigen::Vector3d::Zero();
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();      ///< of the neighbours, in the odometry's frame
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  ///< of the line, or the normal of the plane
  double distance_m = 0.0;                               ///< under the pose that the match was found with
};

struct FeatureMatches {
  std::vector<FeatureMatch> lines, planes;
};

/// Frames of features, each in the vehicle frame at its scan, under poses of the odometry. Points are kept about the
/// last frame's vehicle, so that float coordinates stay small on a long drive.
class FeatureMap {
 public:
  FeatureMap();
  ~FeatureMap();
  FeatureMap(FeatureMap&&) noexcept;
  FeatureMap& operator=(FeatureMap&&) noexcept;

  bool empty() const { return frames_.empty(); }
  /// Pose of the frame that entered last.
  const RigidTransform& newest() const { return frames_.back().odometry_from_vehicle; }
  /// The oldest frames beyond `options.map_frames` leave.
  void add(ScanFeatures features_in_vehicle, const RigidTransform& odometry_from_vehicle, const FusionOptions& options);
  std::size_t frames() const { return frames_.size(); }
  /// The map as a whole is moved: what was learnt of its place in the world.
  void move(const RigidTransform& odometry_from_odometry_before);
  /// The trees for match(), after add or move.
  void rebuild(const FusionOptions& options);

  /// Each feature with five neighbours that lie along a line or in a plane. A straight line or flat plane is one
  /// whose spread across is within a decimetre and small beside the other spreads.
  FeatureMatches match(const ScanFeatures& features_in_vehicle, const RigidTransform& odometry_from_vehicle,
                       double within_m, const FusionOptions& options, int threads) const;

  std::size_t line_points() const;
  std::size_t plane_points() const;

 private:
  struct Frame {
    RigidTransform odometry_from_vehicle = RigidTransform::Identity();
    ScanFeatures features;
  };
  class Tree;
  std::deque<Frame> frames_;
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  std::unique_ptr<Tree> lines_, planes_;
};

}  // namespace remount::odometry
