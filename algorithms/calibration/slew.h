// Where a LiDAR sits on a slewing machine: a plane, another plane and a circle (seeds 004).
//
// The machine frame: z along the slew axis, up; the xz plane is that in which the arm moves, the arm in the direction
// of x; y left. The origin lies on the slew axis, at the height of the LiDAR's circle or on the ground.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "algorithms/calibration/calibration_result.h"
#include "algorithms/calibration/method_details.h"
#include "algorithms/calibration/solve_options.h"
#include "algorithms/core/progress.h"
#include "algorithms/geometry/circle_fit.h"
#include "algorithms/geometry/plane_fit.h"

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

/// All in the lidar frame at a standstill; the LiDAR turns with the upper structure.
struct SlewData {
  std::vector<Eigen::Vector3d> ground_points;              ///< m; may be empty with FirstPlane::Turn
  std::vector<Eigen::Vector3d> arm_points;                 ///< m; what moved while the arm was swept
  std::vector<RigidTransform> first_from_lidar;            ///< poses of the LiDAR while the machine turned, in order
  Eigen::Vector3d up_in_lidar = Eigen::Vector3d::UnitZ();  ///< rough, within 30 deg; unit length
};

struct SlewResult {
  CalibrationResult calibration;  ///< reference_frame "machine": ins_from_lidar is machine_from_lidar
  PlaneFit ground, arm;
  CircleFit circle;
  double ground_to_turn_rad = std::numeric_limits<double>::quiet_NaN();  ///< angle between their normals
  double ground_to_turn_sigma_rad = std::numeric_limits<double>::quiet_NaN();
  double arm_square_error_rad = std::numeric_limits<double>::quiet_NaN();  ///< 0: arm and first plane are square
  std::vector<NamedQuantity> quantities;
  std::vector<Plot> plots;
};

/// Planes, circle, axes n1, n2, n1 x n2 made orthonormal, translation from the circle's centre. A short arc, a missing
/// ground or arm plane, an arm that is not square and a ground that is tilted against the slew axis are refused:
/// nothing is then observed, and the message says why. Throws Error(Contract) for options out of range.
SlewResult solve_slew(const SlewData& data, const std::optional<RigidTransform>& nominal_machine_from_lidar,
                      const SlewOptions& options, const SolveOptions& solve, Progress& progress);

}  // namespace remount
