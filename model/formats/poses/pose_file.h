// Files of poses: LiDAR odometry, motion capture, or an INS in a metric world.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "model/drive/session.h"

namespace remount::formats {

enum class PoseFormat {
  Tum,        ///< `t x y z qx qy qz qw`, t in seconds
  EthCsv,     ///< `t,x,y,z,qx,qy,qz,qw`, t in seconds
  AloamCsv,   ///< nav_msgs/Odometry exported from a bag: columns by name, stamps from .header.stamp (the host's clock)
  PoseLines,  ///< OpenCalib: `2021-10-26-16-21-29-468` and a 3x4 matrix, row by row
  /// Apollo's GNSS odometry: `timestamp,position_type,qw,qx,qy,qz,x,y,z`, seconds, UTM metres, the attitude of axes
  /// right-forward-up; with or without that header line.
  ApolloCsv,
};
std::string_view to_string(PoseFormat format);  ///< "tum", "eth-csv", "aloam-csv", "pose-lines", "apollo-csv"
std::optional<PoseFormat> pose_format_from_string(std::string_view text);

/// From the first line that is no comment; nothing where it is no pose file. Never throws.
std::optional<PoseFormat> recognise_pose_file(const std::filesystem::path& path);

/// Of the INS whose poses the format holds; nothing where it does not say.
std::optional<drive::InsAxes> axes_of(PoseFormat format);

/// Whether attitudes are known to be relative to true north beside positions of UTM, as Apollo's GNSS driver writes
/// them.
bool counts_from_true_north(PoseFormat format);

/// Poses with strictly ascending stamps. Lines that cannot be used, repeated and reversed stamps become findings.
/// Throws Error where the file cannot be read or holds no usable pose.
std::vector<motion::StampedPose> read_pose_file(const std::filesystem::path& path, PoseFormat format,
                                                std::vector<drive::Finding>& findings);
/// The same of a text that was read already; `path` is for messages.
std::vector<motion::StampedPose> parse_poses(std::string_view text, const std::filesystem::path& path,
                                             PoseFormat format, std::vector<drive::Finding>& findings);

}  // namespace remount::formats
