// KITTI's odometry benchmark, and what is laid out like it (SemanticKITTI).
#pragma once

#include "model/formats/sessions/session_reader.h"

namespace remount::formats {

/// Opens `sequences/XX` (with times.txt and velodyne/), or a parent that holds exactly one.
///
/// Poses: `poses/XX.txt` beside `sequences`, else poses.txt of the sequence; line i is the left camera (camera 0,
/// rectified, x right, y down, z ahead) at time i, in its own frame at the first. What takes the INS's place is that
/// camera with axes turned to x ahead, y left, z up, its world likewise: the session has forward-left-up axes, and X
/// leads from the LiDAR to the place of the camera. The benchmark's poses came from an INS through a calibration, those
/// of poses.txt from the scans; both know X against the camera already: `Tr` of calib.txt, camera_from_lidar, which
/// serves as the nominal. Without Tr there is none.
/// Scans: velodyne/NNNNNN.bin, of the time of that line. Motion is compensated by the publisher ("this effect has been
/// eliminated from this postprocessed data", readme of the development kit): scans beside a Tr that the benchmark
/// published count as taken at once. Many tools write other data in this layout, and how those were swept is not known.
class KittiOdometryReader final : public SessionReader {
 public:
  std::string_view id() const override { return "kitti-odometry"; }
  Message description() const override;
  int probe(const std::filesystem::path& path) const override;
  drive::Session open(const std::filesystem::path& path, Progress& progress) const override;
};

/// Axes forward-left-up from those of a camera: x right, y down, z ahead.
Eigen::Matrix3d forward_left_up_from_camera();

}  // namespace remount::formats
