// One scan as scenes show it, shared by all pairs that it belongs to. VTK inside.
#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "algorithms/core/progress.h"
#include "algorithms/quality/surface_distance.h"
#include "model/pipeline/pair_clouds.h"
#include "widgets/scene/cloud_actor.h"

namespace remount::scene {

/// Immutable but for its surfaces and its ground, which are found when somebody asks for them. Thread-safe.
class ScanScene {
 public:
  ScanScene(pipeline::KeyframeScanPtr scan, const Progress& progress);
  const cloud::PointCloud& cloud() const { return scan_->cloud; }
  const pipeline::KeyframeScanPtr& scan() const { return scan_; }
  const std::shared_ptr<const CloudGeometry>& geometry() const { return geometry_; }
  /// Where cancelled, of nothing; the next who asks finds them.
  std::shared_ptr<const quality::SurfaceDistance> surfaces(const Progress& progress = {}) const;
  /// The places of the points that are not of the ground, in the order in which the scene draws them; found when they
  /// are asked for.
  std::shared_ptr<const std::vector<std::uint32_t>> above_ground() const;
  std::size_t bytes() const;  ///< about what it takes, surfaces included

 private:
  pipeline::KeyframeScanPtr scan_;
  std::shared_ptr<const CloudGeometry> geometry_;
  mutable std::mutex mutex_;
  mutable std::shared_ptr<const quality::SurfaceDistance> surfaces_;
  mutable std::shared_ptr<const std::vector<std::uint32_t>> above_ground_;
};
using ScanScenePtr = std::shared_ptr<const ScanScene>;

/// Finds a scan's scene again while a pair holds it. Thread-safe.
class ScanScenes {
 public:
  /// Null where cancelled.
  ScanScenePtr prepare(const pipeline::KeyframeScanPtr& scan, const Progress& progress);
  /// Whether the ground is told apart where scans are prepared: it is hidden.
  void tell_ground_apart(bool on) { ground_apart_ = on; }

 private:
  ScanScenePtr scene_of(const pipeline::KeyframeScanPtr& scan, const Progress& progress);

  std::atomic<bool> ground_apart_ = false;
  std::mutex mutex_;
  // A scene holds its scan, so that no other can come to lie at its address.
  std::map<const pipeline::KeyframeScan*, std::weak_ptr<const ScanScene>> prepared_;
};

}  // namespace remount::scene
