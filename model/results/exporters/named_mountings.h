// Which mounting of a file with several belongs to which LiDAR.
#pragma once

#include <string>
#include <vector>

#include "model/results/exporters/exporter.h"

namespace remount::results {

/// The one that is called as the LiDAR is (is_frame_of), or as a part of its topic that no other of `lidars` has:
/// "lidar_front_link" is of "/lidar_front/points". Null where there is none.
const NamedMounting* find_mounting(const std::vector<NamedMounting>& mountings, const std::string& lidar,
                                   const std::vector<std::string>& lidars);

}  // namespace remount::results
