// Small valid files, one function a format.
#pragma once

#include <string>

#include "model/results/vehicle_file.h"

namespace remount::formats::samples {

using Bytes = std::string;

Bytes compressed_pcd(int count);
Bytes ply(const std::string& encoding, int count);
Bytes ascii_pcd(int count);
Bytes binary_pcd(int count);
Bytes kitti_bin(int count);
Bytes poses(const char* separator, int count);
Bytes pose_lines(int count);
Bytes odometry_csv(int count);
Bytes inspvax_csv(int count);
Bytes apollo_odometry(int count);
Bytes nmea(int count);
Bytes nmea_headings(int count);  ///< positions, each with a heading
Bytes nmea_short(int count);     ///< the same in lines as short as receivers write
Bytes gpx(int count);
Bytes smartloc(int count);
Bytes inspvax_log(int count);
Bytes inspva_log(int count);      ///< with INSSTDEV and others, in ASCII
Bytes novatel_binary(int count);  ///< the same in binary, with what stands among it
Bytes sbet(int count);            ///< of the times of `poses`, without their date
Bytes smrmsg(int count);          ///< the same every tenth of a second
Bytes ncom(int count);            ///< at the times of `poses`
Bytes sbf_log(int count);         ///< likewise: INSNavGeod, and what a receiver says beside it
Bytes explorer_table(int count);  ///< of Inertial Explorer, at the times of `poses`
Bytes oxts_csv(int count);
Bytes rtklib(int count);
Bytes motion_pairs(int count);
results::ResultFile result();
results::VehicleFile vehicle();  ///< of two LiDARs
Bytes project();

}  // namespace remount::formats::samples
