// nuScenes, and what is laid out like it.
#pragma once

#include "model/formats/sessions/session_reader.h"

namespace remount::formats {

/// Opens a folder with `v1.0-*/` (tables in JSON) and `samples/`, `sweeps/` of which one scene is there; or a scan
/// (`sweeps/LIDAR_TOP/NAME.pcd.bin`), which stands for its scene. Tables are read row by row, whatever their size.
///
/// Poses: ego_pose of the LiDAR's sweeps, global_from_ego; the ego frame is the middle of the rear axle, x forward, y
/// left, z up. They come from a localisation of the LiDAR in a map, in the plane (heights are all 0), through the
/// mounting that the data have already: calibrated_sensor, ego_from_lidar, which is the nominal. Quaternions are w, x,
/// y, z; stamps microseconds. Scans: five floats a point (x, y, z, intensity, ring); LiDAR axes are the file's
/// (LIDAR_TOP: x right, y forward, z up). The publisher compensates them for motion (H. Caesar et al. 2020, "nuScenes:
/// a multimodal dataset for autonomous driving"), so they count as taken at once. LiDARs go by their channels.
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
