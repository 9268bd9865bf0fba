// KITTI raw drives, `sync` and `extract`.
#pragma once

#include "model/formats/sessions/session_reader.h"

namespace remount::formats {

/// Opens a drive folder (with oxts/ and velodyne_points/), or a parent that holds exactly one.
///
/// INS: OXTS axes x forward, y left, z up; AttitudeConvention::EnuYaw; position accuracy of field 23 where it is above
/// zero. `sync`: files of one number belong together, so a scan's stamp is the OXTS stamp of its number; where there
/// are more of one, or their own stamps lie apart, scans keep their own. `extract`: OXTS has its own rate and stamps.
/// Scans: the HDL-64E turns counter-clockwise seen from above and timestamps.txt says when it faces forward (A. Geiger
/// et al. 2013, "Vision meets robotics: the KITTI dataset", sections 3.1 and 3.2). timestamps_start and timestamps_end
/// give the period of a turn; they cannot tell the direction, and drives of other sensors are kept in this format:
/// sweep.direction_known is false. Points as published in `sync` are raw in the raw
/// recordings but compensated in copies made from the odometry benchmark; the format does not say which, so
/// sweep.certain is false.
class KittiRawReader final : public SessionReader {
 public:
  std::string_view id() const override { return "kitti-raw"; }
  Message description() const override;
  int probe(const std::filesystem::path& path) const override;
  drive::Session open(const std::filesystem::path& path, Progress& progress) const override;
};

}  // namespace remount::formats
