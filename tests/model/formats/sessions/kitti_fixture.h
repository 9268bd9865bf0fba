// A small drive in KITTI's raw layout.
#pragma once

#include <string>

#include "model/formats/files/number_text.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::formats {

inline std::string oxts(double latitude_deg, double yaw_rad) {
  std::string line = exact_text(latitude_deg) + " 8.4 115 0.01 0.02 " + exact_text(yaw_rad);
  for (int i = 6; i < 30; ++i) line += i == 23 ? " 0.05" : " 0";
  return line + "\n";
}

/// A drive with four INS samples and scans.
inline void write_kitti(const TemporaryFolder& folder, const std::string& drive) {
  std::string stamps;
  for (int i = 0; i < 4; ++i) {
    stamps += "2011-09-26 13:02:25." + std::to_string(i) + "00000000\n";
    folder.write(drive + "/oxts/data/000000000" + std::to_string(i) + ".txt", oxts(49.0 + 1e-6 * i, 0.1 * i));
    folder.write(drive + "/velodyne_points/data/000000000" + std::to_string(i) + ".bin", std::string(32, '\x3f'));
  }
  folder.write(drive + "/oxts/timestamps.txt", stamps);
  folder.write(drive + "/velodyne_points/timestamps.txt", stamps);
}

}  // namespace remount::formats
