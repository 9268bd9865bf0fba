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
  VehicleHistory(const FleetVehicle& vehicle, const DriftLimits& limits);

  /// Of each LiDAR, in the order of the calibration.
  std::vector<LidarChange> changes_of(const report::NamedVehicle& now);
  /// From now on the usable ones of its LiDARs are their last calibrations.
  void add(const std::shared_ptr<const report::NamedVehicle>& vehicle);

 private:
  struct NamedFile {
    std::string path;
    std::shared_ptr<const report::NamedVehicle> vehicle;
    Message problem;
  };
  struct LidarHistory {
    Earlier last, reference;
    bool reference_is_last;  ///< names do not tell: files of different folders may have one
  };
  static NamedFile load(const std::filesystem::path& path);
  static Earlier find(const NamedFile& file, const std::string& lidar, bool stays);
  LidarHistory& history_of(const std::string& lidar);
  FleetChange change_since(const Earlier& earlier, const std::string& name, const results::ResultFile& now) const;

  DriftLimits limits_;
  NamedFile last_, reference_;
  bool reference_is_last_;
  std::map<std::string, LidarHistory> lidars_;
};

}  // namespace remount::fleet
