// A spinning LiDAR in the simulated world.
#pragma once

#include <memory>
#include <vector>

#include "model/drive/session.h"
#include "model/simulator/scene.h"

namespace remount::simulator {

/// Elevations of the beams, lowest first, rad: as usual for sensors of 16, 32, 64 and 128 beams.
std::vector<double> beam_elevations_rad(int beams);

/// Ray-casts a scan when it is asked for. The same scan is the same bytes whenever and wherever it is loaded.
class SimulatedScanSource : public drive::ScanSource {
 public:
  explicit SimulatedScanSource(std::shared_ptr<const Scene> scene);

  std::size_t size() const override { return scan_count(scene_->options()); }
  std::int64_t stamp_ns(std::size_t scan) const override;
  std::string name(std::size_t scan) const override;
  cloud::PointCloud load(std::size_t scan) const override;

  const Scene& scene() const { return *scene_; }

 private:
  std::shared_ptr<const Scene> scene_;
  std::vector<double> elevations_rad_;
};

/// What simulated scans are taken from; null for scans of another origin.
inline const Scene* scene_of(const std::shared_ptr<const drive::ScanSource>& scans) {
  const auto* source = dynamic_cast<const SimulatedScanSource*>(scans.get());
  return source ? &source->scene() : nullptr;
}

}  // namespace remount::simulator
