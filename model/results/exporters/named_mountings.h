// Which mounting of a file with several belongs to which LiDAR.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "model/results/exporters/exporter.h"

namespace remount::results {

/// The first that is called after the LiDAR (is_called_after). Null where there is none.
const NamedMounting* find_mounting(const std::vector<NamedMounting>& mountings, const std::string& lidar,
                                   const std::vector<std::string>& lidars);

struct MountingsOfLidars {
  std::map<std::string, ReadMounting> of;  ///< by names of LiDARs
  std::vector<std::string> others;         ///< names of mountings that are of none of the LiDARs
};

/// Each LiDAR's own among those of a file. Throws Error(Contract) at `file` where two are called alike, or one that is
/// of a LiDAR is not in the frame of the INS.
MountingsOfLidars mountings_of_lidars(const std::vector<NamedMounting>& mountings,
                                      const std::vector<std::string>& lidars, const std::string& file);

/// None of the LiDARs has a mounting in the file: an Error(Contract) with the names of both.
[[noreturn]] void no_lidar_is_named(const std::vector<NamedMounting>& mountings, const std::vector<std::string>& lidars,
                                    const std::string& file);

/// Throws Error(Contract) at `where` unless the mounting is one in the frame of the INS.
void require_ins_frame(const ReadMounting& mounting, const std::string& where);

}  // namespace remount::results
