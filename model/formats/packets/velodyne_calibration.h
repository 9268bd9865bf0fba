// The calibration file by which drivers of Velodyne's LiDARs make points of what these measure.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace remount::formats {

/// A number where it stands in a text.
struct NumberInText {
  std::size_t begin = 0, length = 0;
  double value = 0.0;  ///< in the units of its file
};

struct CalibratedLaser {
  NumberInText elevation;  ///< up is positive
  /// What is added to its ranges: everywhere, and, where the file has these too, near along x and y.
  std::vector<NumberInText> distances;

  std::size_t id = 0;  ///< in a packet, the upper block's first
  /// In the units of the file: what is taken off the head's azimuth, and where the beam begins.
  double azimuth = 0.0, height = 0.0, aside = 0.0;
  /// What is added to ranges where they are short along x and y, instead of the first of `distances`.
  double near_x = 0.0, near_y = 0.0;
  bool two_points = false;  ///< these are to be used
};

struct VelodyneCalibration {
  std::string text;
  double elevation_unit_rad = 1.0, distance_unit_m = 1.0;
  double range_unit_m = 0.002;          ///< of what packets have
  std::vector<CalibratedLaser> lasers;  ///< those that are in use, in the order of the file
};

/// "db.xml" as the maker delivers it (degrees, cm), or the YAML that ROS drivers make of it (rad, m). Throws
/// Error(Format) with file, line and what was expected.
VelodyneCalibration read_velodyne_calibration(std::string text, const std::string& where);

}  // namespace remount::formats
