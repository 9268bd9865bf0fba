// Simulated drives whose scans are cast once: a simulated scan is cast whenever it is loaded, and a calibration loads
// it two to twenty times.
#pragma once

#include <mutex>

#include "model/simulator/simulator.h"
#include "tests/support/forwarded_scans.h"

namespace remount::testing {

/// Holds every scan that was loaded. Thread-safe.
class KeptScans final : public ForwardedScans {
 public:
  explicit KeptScans(std::shared_ptr<const ScanSource> scans) : ForwardedScans(std::move(scans)), kept_(size()) {}
  cloud::PointCloud load(std::size_t scan) const override {
    Kept& kept = kept_.at(scan);
    std::call_once(kept.once, [&] { kept.cloud = ForwardedScans::load(scan); });
    return kept.cloud;
  }

 private:
  struct Kept {
    std::once_flag once;
    cloud::PointCloud cloud;
  };
  mutable std::vector<Kept> kept_;
};

/// The drive of simulator::simulate_drive, byte for byte.
inline simulator::SimulatedDrive simulate_drive(const simulator::SimulationOptions& options) {
  simulator::SimulatedDrive drive = simulator::simulate_drive(options);
  drive.session.scans = std::make_shared<const KeptScans>(drive.session.scans);
  return drive;
}

}  // namespace remount::testing
