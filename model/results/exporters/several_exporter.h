// What formats have in common of which one file holds several LiDARs: a file of one is that of a vehicle with one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "model/results/exporters/exporter.h"

namespace remount::results {

class SeveralExporter : public Exporter {
 public:
  bool holds_several() const final { return true; }
  std::string write(const ResultFile& result, const ExportNames& names) const final {
    VehicleFile vehicle;
    vehicle.lidars.push_back({"", false, result});
    return write_all(vehicle, names);
  }
  std::string write_all(const VehicleFile& vehicle, const ExportNames& names) const override = 0;
  std::vector<NamedTransform> read_all(std::string_view text, const std::string& where) const override = 0;
  void require_own(std::string_view text, const std::string& where) const override { (void)read_all(text, where); }
};

/// What the frames of a file are called, as the names say or the format has it.
struct FrameNames {
  std::string parent;               ///< of the INS, or of the LiDAR in whose frame the others are
  std::vector<std::string> lidars;  ///< in the order of the vehicle
};
/// @param usual_ins, usual_lidar of one LiDAR without a name @param ending of what is called after a LiDAR
/// `ins_frame` counts where the frame of the INS is the parent. Throws Error(Contract) where two are called alike.
FrameNames frame_names(const VehicleFile& vehicle, const ExportNames& names, const std::string& usual_ins,
                       const std::string& usual_lidar, const std::string& ending = {});

/// What files and transforms of a LiDAR are called after: its frame where that was named, or else its name.
std::string called_after(const LidarResult& lidar, const ExportNames& names);

/// "ins_from_front": of what places each LiDAR. Throws Error(Contract) where two are called alike.
std::vector<std::string> transform_names(const VehicleFile& vehicle, const ExportNames& names);

/// Names that LiDARs have in an export, in the order of the vehicle. Throws Error(Contract) where two are alike.
void require_different(const VehicleFile& vehicle, const std::vector<std::string>& names);

/// All but one, in the frame of that LiDAR: `mounting` of each is lidar_from_lidar then, and observed what of it is.
/// Throws Error(Contract) at `where` for a name that is none.
VehicleFile relative_to(const VehicleFile& vehicle, std::string_view lidar, const std::string& where);

}  // namespace remount::results
