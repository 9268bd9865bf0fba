// Options of the LiDAR odometry.
#pragma once

#include "algorithms/core/options.h"
#include "messages/method_options.h"

namespace remount::odometry {

struct LidarOdometryOptions {
  double voxel_m = 0.4;
  double keyframe_distance_m = 2.0;
  double keyframe_angle_deg = 10.0;
  int map_keyframes = 15;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor({"voxel_m", "m", say::option_lidar_odometry_voxel_m, say::option_lidar_odometry_voxel_m_help, 0.05, 5.0},
            self.voxel_m);
    visitor({"keyframe_distance_m", "m", say::option_lidar_odometry_keyframe_distance_m,
             say::option_lidar_odometry_keyframe_distance_m_help, 0.1, 100.0},
            self.keyframe_distance_m);
    visitor({"keyframe_angle_deg", "deg", say::option_lidar_odometry_keyframe_angle_deg,
             say::option_lidar_odometry_keyframe_angle_deg_help, 0.5, 180.0},
            self.keyframe_angle_deg);
    visitor({"map_keyframes", "", say::option_lidar_odometry_map_keyframes,
             say::option_lidar_odometry_map_keyframes_help, 1, 200},
            self.map_keyframes);
  }
};

}  // namespace remount::odometry
