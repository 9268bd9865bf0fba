// Which LiDAR is meant where one is not called quite as it is: by its frame, or by a part of its topic.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace remount::results {

/// What is called after a LiDAR: its name, of which other letters than those of names of files and frames become '_';
/// "/front/points" is front_points.
std::string usual_frame(std::string_view lidar);

/// Whether a frame is that of a LiDAR: it is called as the LiDAR is, with "_link" or "_base_link" behind it or without.
bool is_frame_of(std::string_view frame, std::string_view lidar);

/// Whether a frame is called as the LiDAR is (is_frame_of), or as a part of its topic that no other of `lidars` has,
/// with "lidar_" before it or without: "lidar_front_link" and "front" are of "/lidar_front/points".
bool is_called_after(std::string_view frame, const std::string& lidar, const std::vector<std::string>& lidars);

/// That of the LiDARs which is meant by a name; empty where it is none of them, or not clear which.
std::string lidar_meant_by(const std::string& name, const std::vector<std::string>& lidars);

/// LiDARs of one recording by those of another that are not called alike and are the same; where it is not clear which
/// is which there are none.
std::map<std::string, std::string> same_lidars(const std::vector<std::string>& lidars,
                                               const std::vector<std::string>& others);

}  // namespace remount::results
