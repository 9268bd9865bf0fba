// A LiDAR in the simulated world.
#pragma once

#include <memory>

#include "model/drive/session.h"
#include "model/simulator/lidar_truth.h"
#include "model/simulator/scene.h"

namespace remount::simulator {

/// Ray-casts a scan when it is asked for. The same scan is the same bytes whenever and wherever it is loaded.
class SimulatedScanSource : public drive::ScanSource {
 public:
  explicit SimulatedScanSource(const std::shared_ptr<const Scene>& scene)
      : SimulatedScanSource(scene, scene->options()) {}
  /// @param lidar of one LiDAR of several (options_of_mount)
  SimulatedScanSource(std::shared_ptr<const Scene> scene, SimulationOptions lidar);

  std::size_t size() const override { return scan_count(options_); }
  std::int64_t stamp_ns(std::size_t scan) const override;
  std::string name(std::size_t scan) const override;
  cloud::PointCloud load(std::size_t scan) const override;

  const Scene& scene() const { return *scene_; }
  const SimulationOptions& options() const { return options_; }  ///< of this LiDAR
  const ScanPattern& pattern() const { return *pattern_; }
  const LidarTruth& truth() const { return truth_; }

 private:
  cloud::PointCloud empty_cloud(std::size_t most) const;

  std::shared_ptr<const Scene> scene_;
  SimulationOptions options_;
  std::unique_ptr<const ScanPattern> pattern_;
  LidarTruth truth_;
};

/// What simulated scans are taken from; null for scans of another origin.
inline const Scene* scene_of(const std::shared_ptr<const drive::ScanSource>& scans) {
  const auto* source = dynamic_cast<const SimulatedScanSource*>(scans.get());
  return source ? &source->scene() : nullptr;
}
/// Of the LiDAR that takes them; null for scans of another origin.
inline const SimulationOptions* lidar_options_of(const std::shared_ptr<const drive::ScanSource>& scans) {
  const auto* source = dynamic_cast<const SimulatedScanSource*>(scans.get());
  return source ? &source->options() : nullptr;
}

}  // namespace remount::simulator
