// nuScenes, and what is laid out like it.
#pragma once

#include "model/formats/sessions/session_reader.h"

namespace remount::formats {

/// Opens a folder with `v1.0-*/` (tables in JSON) and `samples/`, `sweeps/` of which one scene is there; or a scan
/// (`sweeps/LIDAR_TOP/NAME.pcd.bin`), which stands for its scene; or a folder of tables, which stands for the data set
/// with these tables alone. Of several versions those are taken that have most of the scans that are there. Tables are
/// read row by row, whatever their size, and once for all sessions; rows that cannot be used are left out.
///
/// Poses: ego_pose of the LiDAR's sweeps, global_from_ego; the ego frame is the middle of the rear axle, x forward, y
/// left, z up. nuScenes has them from a localisation of the LiDAR in a map, in the plane (the table's schema says that
/// z is always 0, and so does that of MAN TruckScenes), through the mounting that the data have already:
/// calibrated_sensor, ego_from_lidar, which is the nominal. Quaternions are w, x, y, z; stamps microseconds.
///
/// Scans: five floats a point (x, y, z, intensity, ring), or PCD; LiDAR axes are the file's (LIDAR_TOP: x right, y
/// forward, z up). Points of nuScenes' own sweeps are compensated for motion, by the sensor, to the last packet of a
/// turn: so its publishers answer (forum.nuscenes.org/t/821 and /t/245); their paper (H. Caesar et al. 2020) leaves it
/// open. Only sweeps that are named as theirs count as taken at once. Others have the times of their points, as those
/// of MAN TruckScenes (PCD with `timestamp`, microseconds, not compensated), or how they were swept is not known.
/// LiDARs go by their channels.
class NuscenesReader final : public SessionReader {
 public:
  std::string_view id() const override { return "nuscenes"; }
  Message description() const override;
  int probe(const std::filesystem::path& path) const override;
  drive::Session open(const std::filesystem::path& path, Progress& progress) const override;
  drive::Session open_topics(const std::filesystem::path& path, const drive::TopicChoice& topics,
                             Progress& progress) const override;
  std::optional<drive::TopicOffer> offer_topics(const std::filesystem::path& path, Progress& progress) const override;
  std::vector<drive::LidarOffer> offer_lidars(const std::filesystem::path& path, Progress& progress) const override;
};

}  // namespace remount::formats
