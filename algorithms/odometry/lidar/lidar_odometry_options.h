// Options of the LiDAR odometry.
#pragma once

#include "algorithms/core/options.h"

namespace remount {

struct LidarOdometryOptions {
  double voxel_m = 0.4;
  double keyframe_distance_m = 2.0;
  double keyframe_angle_deg = 10.0;
  int map_keyframes = 15;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor({"voxel_m", "m", "Edge of the voxels that thin scans and map.", 0.05, 5.0}, self.voxel_m);
    visitor({"keyframe_distance_m", "m", "A scan joins the local map this far from the last one that did.", 0.1, 100.0},
            self.keyframe_distance_m);
    visitor(
        {"keyframe_angle_deg", "deg", "A scan joins the local map where the LiDAR has turned this far.", 0.5, 180.0},
        self.keyframe_angle_deg);
    visitor({"map_keyframes", "", "Scans in the local map.", 1, 200}, self.map_keyframes);
  }
};

}  // namespace remount
