// Which mounting of a file with several belongs to which LiDAR.
#pragma once

#include <string>
#include <vector>

#include "model/results/exporters/exporter.h"

namespace remount::results {

/// The first that is called after the LiDAR (is_called_after). Null where there is none.
const NamedMounting* find_mounting(const std::vector<NamedMounting>& mountings, const std::string& lidar,
                                   const std::vector<std::string>& lidars);

}  // namespace remount::results
