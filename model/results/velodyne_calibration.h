// The calibration file by which drivers of Velodyne's LiDARs make points of what these measure, with corrections added.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "algorithms/cloud/beam_errors.h"

namespace remount::results {

/// A number where it stands in a text.
struct NumberInText {
  std::size_t begin = 0, length = 0;
  double value = 0.0;  ///< in the units of its file
};

struct VelodyneLaser {
  NumberInText elevation;  ///< up is positive
  /// What is added to its ranges: everywhere, and, where the file has these too, near along x and y.
  std::vector<NumberInText> distances;
};

struct VelodyneCalibration {
  std::string text;
  double elevation_unit_rad = 1.0, distance_unit_m = 1.0;
  std::vector<VelodyneLaser> lasers;  ///< those that are in use, in the order of the file
};

/// "db.xml" as the maker delivers it (degrees, cm), or the YAML that ROS drivers make of it (rad, m). Throws
/// Error(Format) with file, line and what was expected.
VelodyneCalibration read_velodyne_calibration(std::string text, const std::string& where);

/// The same text but for elevations and distances, each with what is to be added to it at its elevation. The scale of
/// ranges has no place in it.
std::string with_beams_mended(const VelodyneCalibration& calibration, const cloud::BeamErrors& errors);

}  // namespace remount::results
