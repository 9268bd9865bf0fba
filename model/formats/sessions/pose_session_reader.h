// Two pose files: an INS, motion capture or robot hand on one side, LiDAR (or camera) odometry on the other.
#pragma once

#include <utility>

#include "model/formats/poses/pose_file.h"
#include "model/formats/sessions/session_reader.h"

namespace remount::formats {

/// Opens a folder with exactly two pose files (TUM, ETH CSV, A-LOAM CSV or pose lines): one whose name has a word of
/// (ins, imu, gnss, hand, vicon, body), one with a word of (lidar, camera, cam, odom, laser). The first gives
/// world_from_ins, the second odometry_from_lidar. Clocks are aligned where they do not agree (see pose_pairing.h).
/// A single pose file opens as well, so that it can be inspected; a finding says what is missing. The truth of EuRoC
/// and TUM-VI (data.csv in state_groundtruth_estimate0 or mocap0) is of the body by its folder. It is found from any
/// parent up to the one of mav0, and goes with the LiDAR's poses that lie in the folder that is given.
class PoseSessionReader final : public SessionReader {
 public:
  std::string_view id() const override { return "poses"; }
  Message description() const override;
  int probe(const std::filesystem::path& path) const override;
  drive::Session open(const std::filesystem::path& path, Progress& progress) const override;
};

/// A file of poses, and how it writes them.
using PoseFileChoice = std::pair<std::filesystem::path, PoseFormat>;

/// Of files that lie beside the log of an INS the one with the LiDAR's poses: the only one, or the only one that is
/// named after a LiDAR. Throws Error(Unsupported) at `folder` where it is not clear.
const PoseFileChoice& lidar_poses_of(const std::vector<PoseFileChoice>& poses, const std::filesystem::path& folder);

/// True where one of the words of a file's name (between anything that is neither letter nor digit) is among `words`.
bool name_has_word(const std::filesystem::path& file, std::initializer_list<std::string_view> words);

}  // namespace remount::formats
