// What the calibrations of a vehicle are compared with, LiDAR by LiDAR.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "model/fleet/fleet_rows.h"
#include "model/report/vehicle_comparison.h"

namespace remount::fleet {

/// An earlier calibration of a LiDAR.
struct Earlier {
  std::shared_ptr<const report::NamedVehicle> vehicle;  ///< of which it is; null: there is none
  const results::ResultFile* file = nullptr;            ///< that of the LiDAR
  Message problem;                                      ///< why the one that the fleet names cannot be had
  bool stays = false;                                   ///< no later one takes the place of what cannot be had
};

/// How one LiDAR sits otherwise than before.
struct LidarChange {
  FleetChange last, reference;
  bool has_reference_of_its_own = false;
};

/// The calibrations of one vehicle from its first job to its last.
class VehicleHistory {
 public:
  /// @param vehicle is to outlive this
  VehicleHistory(const FleetVehicle& vehicle, const DriftLimits& limits) : vehicle_(vehicle), limits_(limits) {}

  /// Of each LiDAR, in the order of the calibration.
  std::vector<LidarChange> changes_of(const report::NamedVehicle& now);
  /// From now on the usable ones of its LiDARs are their last calibrations.
  void add(const std::shared_ptr<const report::NamedVehicle>& vehicle);

 private:
  struct NamedFile {
    std::shared_ptr<const report::NamedVehicle> vehicle;
    Message problem;
  };
  struct LidarHistory {
    Earlier last, reference;
    bool reference_is_last;  ///< names do not tell: files of different folders may have one
  };
  Earlier find(const EarlierFiles& files, const std::string& lidar, bool stays);
  const NamedFile& load(const std::filesystem::path& path);
  LidarHistory& history_of(const std::string& lidar);
  FleetChange change_since(const Earlier& earlier, const std::string& name, const results::ResultFile& now) const;

  const FleetVehicle& vehicle_;
  DriftLimits limits_;
  std::map<std::filesystem::path, NamedFile> files_;  ///< each is read once
  std::map<std::string, LidarHistory> lidars_;
};

}  // namespace remount::fleet
