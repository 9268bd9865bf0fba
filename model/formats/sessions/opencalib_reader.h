// OpenCalib (PJLab SensorsCalibration): poses as stamped 3x4 matrices, scans as PCD named by their stamps.
#pragma once

#include "model/formats/sessions/session_reader.h"

namespace remount::formats {

/// Opens a folder with pose lines and, in it or in one subfolder, PCD files named `2021-10-26-16-21-29-468.pcd`.
///
/// Which file is whose, by its name: LiDAR poses where it has both "lidar" and "-pose" and does not begin with NovAtel,
/// INS or GNSS; INS poses where it has novatel, ins, gnss or imu as a word, or "-enu". A single pose file is the INS.
/// Several INS files: NovAtel's first, then those with "-enu"; the choice is a finding. `enu` poses begin far from
/// their origin, which matters to nothing but the numbers shown. Scans are used where there are at least as many as INS
/// poses, or no LiDAR poses; LiDAR poses otherwise.
class OpenCalibReader final : public SessionReader {
 public:
  std::string_view id() const override { return "opencalib"; }
  Message description() const override;
  int probe(const std::filesystem::path& path) const override;
  drive::Session open(const std::filesystem::path& path, Progress& progress) const override;
};

}  // namespace remount::formats
