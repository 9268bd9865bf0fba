// Small valid files, one function a format.
#pragma once

#include <string>

#include "model/result_file.h"

namespace remount::samples {

using Bytes = std::string;

Bytes compressed_pcd();
Bytes ply(const std::string& encoding);
Bytes ascii_pcd();
Bytes binary_pcd();
Bytes kitti_bin(int count);
Bytes poses(const char* separator, int count);
Bytes pose_lines(int count);
Bytes odometry_csv(int count);
Bytes inspvax_csv(int count);
Bytes apollo_odometry(int count);
Bytes nmea();
Bytes gpx();
Bytes smartloc();
Bytes inspvax_log(int count);
Bytes motion_pairs(int count);
ResultFile result();
Bytes project();

}  // namespace remount::samples
