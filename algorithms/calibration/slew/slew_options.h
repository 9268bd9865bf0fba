// Options of the method for slewing machines.
#pragma once

#include "algorithms/core/options.h"
#include "messages/method_options.h"

namespace remount::calibration {

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
    visitor.choice({"first_plane", "", say::option_slew_first_plane, say::option_slew_first_plane_help},
                   self.first_plane, {"ground", "turn"});
    visitor.choice({"origin", "", say::option_slew_origin, say::option_slew_origin_help}, self.origin,
                   {"turn", "ground"});
    visitor({"min_arc_deg", "deg", say::option_slew_min_arc_deg, say::option_slew_min_arc_deg_help, 30.0, 360.0},
            self.min_arc_deg);
    visitor({"max_plane_angle_deg", "deg", say::option_slew_max_plane_angle_deg,
             say::option_slew_max_plane_angle_deg_help, 0.01, 30.0},
            self.max_plane_angle_deg);
    visitor({"max_square_error_deg", "deg", say::option_slew_max_square_error_deg,
             say::option_slew_max_square_error_deg_help, 0.01, 30.0},
            self.max_square_error_deg);
    visitor(
        {"ground_radius_m", "m", say::option_slew_ground_radius_m, say::option_slew_ground_radius_m_help, 2.0, 100.0},
        self.ground_radius_m);
    visitor({"arm_reach_m", "m", say::option_slew_arm_reach_m, say::option_slew_arm_reach_m_help, 1.0, 100.0},
            self.arm_reach_m);
    visitor({"plane_inlier_m", "m", say::option_slew_plane_inlier_m, say::option_slew_plane_inlier_m_help, 0.001, 1.0},
            self.plane_inlier_m);
    visitor({"surface_sigma_deg", "deg", say::option_slew_surface_sigma_deg, say::option_slew_surface_sigma_deg_help,
             0.0, 5.0},
            self.surface_sigma_deg);
    visitor({"ground_session", "", say::option_slew_ground_session, say::option_slew_ground_session_help, 0, 1000},
            self.ground_session);
    visitor({"arm_session", "", say::option_slew_arm_session, say::option_slew_arm_session_help, 0, 1000},
            self.arm_session);
    visitor({"turn_session", "", say::option_slew_turn_session, say::option_slew_turn_session_help, 0, 1000},
            self.turn_session);
  }
};

}  // namespace remount::calibration
