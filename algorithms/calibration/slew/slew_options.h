// Options of the method for slewing machines.
#pragma once

#include "algorithms/core/options.h"

namespace remount {

enum class FirstPlane { Ground, Turn };
enum class MachineOrigin { Turn, Ground };

struct SlewOptions {
  FirstPlane first_plane = FirstPlane::Ground;
  MachineOrigin origin = MachineOrigin::Turn;
  double min_arc_deg = 270.0;
  double max_plane_angle_deg = 0.5;
  double max_square_error_deg = 2.0;
  double ground_radius_m = 15.0;
  double arm_reach_m = 15.0;
  double plane_inlier_m = 0.06;
  double surface_sigma_deg = 0.01;
  int ground_session = 0, arm_session = 0, turn_session = 0;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor.choice({"first_plane", "",
                    "Which plane is square to the slew axis: the ground (A), or that of the LiDAR's circle (B)."},
                   self.first_plane, {"ground", "turn"});
    visitor.choice(
        {"origin", "", "Height of the machine's origin on the slew axis: that of the LiDAR's circle, or the ground."},
        self.origin, {"turn", "ground"});
    visitor({"min_arc_deg", "deg", "A turn over a shorter arc is refused.", 30.0, 360.0}, self.min_arc_deg);
    visitor({"max_plane_angle_deg", "deg",
             "Where ground and turn are farther from parallel, the ground is tilted against the machine.", 0.01, 30.0},
            self.max_plane_angle_deg);
    visitor({"max_square_error_deg", "deg",
             "Where the plane of the arm is farther from square to the first plane, it is not the arm's.", 0.01, 30.0},
            self.max_square_error_deg);
    visitor({"ground_radius_m", "m", "Ground is taken from so far around the LiDAR.", 2.0, 100.0},
            self.ground_radius_m);
    visitor({"arm_reach_m", "m", "What moves farther away from the LiDAR is not the arm.", 1.0, 100.0},
            self.arm_reach_m);
    visitor({"plane_inlier_m", "m", "Points farther from a fitted plane do not belong to it.", 0.001, 1.0},
            self.plane_inlier_m);
    visitor(
        {"surface_sigma_deg", "deg",
         "How far ground and arm may lean against what they stand for, by their make; part of every sigma.", 0.0, 5.0},
        self.surface_sigma_deg);
    visitor({"ground_session", "", "Which session shows the ground, counted from 1; 0: by name or order.", 0, 1000},
            self.ground_session);
    visitor({"arm_session", "", "Which session shows the arm swept up and down, counted from 1; 0: by name or order.",
             0, 1000},
            self.arm_session);
    visitor({"turn_session", "", "Which session is the full turn, counted from 1; 0: by name or order.", 0, 1000},
            self.turn_session);
  }
};

}  // namespace remount
