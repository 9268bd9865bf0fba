// Results of one vehicle with several LiDARs, of two days: which LiDAR moved, or whether it was the INS.
#pragma once

#include <string>
#include <vector>

#include "model/report/comparison.h"
#include "model/results/vehicle_file.h"

namespace remount::report {

struct NamedVehicle {
  std::string name;
  results::VehicleFile file;
};

struct ComparedLidar {
  std::string name;
  std::string other_name;   ///< of the second vehicle, where it is another (same_lidars)
  ComparedResults results;  ///< the first vehicle's minus the second's
  bool compared = false;    ///< they have something in common
};

struct ComparedVehicles {
  std::vector<ComparedLidar> lidars;    ///< that both have
  std::vector<std::string> only_first;  ///< LiDARs that one of them has
  std::vector<std::string> only_second;
  std::vector<std::string> moved;  ///< LiDARs that sit otherwise, against the INS or, where that moved, against others
  bool ins_moved = false;          ///< all differ, and more than half of them sit against each other as before
  /// Whether this LiDAR differs for no other reason than that the INS moved.
  bool moved_with_ins(const ComparedLidar& lidar) const;
  std::vector<Message> words;  ///< what to make of it
  std::vector<Message> notes;  ///< which LiDARs are the same though they are not called alike
  bool agree() const;          ///< all were compared and none differs
};

/// Of two results of a LiDAR by how much they differ at most, where that says nothing of the LiDAR itself; empty where
/// they do not differ.
Message words_of_most(const ComparedResults& results, const std::string& first, const std::string& second);

/// That it was the INS that moved, and which LiDARs did as well; empty where nothing says so.
Message words_of_ins(const ComparedVehicles& compared);

ComparedVehicles compare_vehicles(const NamedVehicle& first, const NamedVehicle& second);

}  // namespace remount::report
