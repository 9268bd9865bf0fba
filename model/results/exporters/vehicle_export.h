// The LiDARs of a vehicle as files of an export format.
#pragma once

#include <string>
#include <vector>

#include "model/results/exporters/exporter.h"

namespace remount::results {

struct ExportedFile {
  std::string name;  ///< under which the format's users look for it
  std::string text;
};

/// A LiDAR that the format has no place for, such as corrections of beams of one that has none.
struct LeftOut {
  std::string lidar;
  Message why;
};

/// One file where the format holds several, or else one a LiDAR, called after it. LiDARs that such a format cannot hold
/// are added to `left_out`. Throws Error(Contract) where it can hold none, or two would be called alike.
std::vector<ExportedFile> export_vehicle(const VehicleFile& vehicle, const Exporter& format, const ExportNames& names,
                                         std::vector<LeftOut>& left_out);

/// Those formats whose files say in which frame LiDARs are can have them in the frame of one of them. Throws
/// Error(Contract) at `where` for another.
void require_frames(const Exporter& format, const std::string& where);

}  // namespace remount::results
