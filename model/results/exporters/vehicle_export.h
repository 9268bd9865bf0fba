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

/// One file where the format holds several, or else one a LiDAR, called after it. Throws Error(Contract) where the
/// format cannot hold a LiDAR, which is named, or two would be called alike.
std::vector<ExportedFile> export_vehicle(const VehicleFile& vehicle, const Exporter& format, const ExportNames& names);

/// Those formats whose files say in which frame LiDARs are can have them in the frame of one of them. Throws
/// Error(Contract) at `where` for another.
void require_frames(const Exporter& format, const std::string& where);

}  // namespace remount::results
