// Values measured of one LiDAR by its name on the command line.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace remount::cli {

/// As apply_measured takes them, by the names of LiDARs.
using NamedMeasured = std::map<std::string, std::vector<std::string>>;

/// Takes values that name their LiDAR ("front:z=1.73,0.01") out of those that hold for all. Names of LiDARs may have
/// colons, those of values have none. Throws Error(Contract) for a LiDAR that is not among these, for a value that is
/// given twice of one, and for the height of the INS, which is of the vehicle: one LiDAR would be solved with another
/// than the others.
NamedMeasured take_named_measured(std::vector<std::string>& measured, const std::vector<std::string>& lidars);

/// Gives the values of the only LiDAR back to those without a name. Throws Error(Contract) for a value of it that is
/// given without the name as well.
void give_measured_to_only(std::vector<std::string>& measured, const std::string& lidar);

}  // namespace remount::cli
