// Where a LiDAR sits on a slewing machine: a plane, another plane and a circle. docs/maths/slew.md
//
// The machine frame: z along the slew axis, up; the xz plane is that in which the arm moves, the arm in the direction
// of x; y left. The origin lies on the slew axis, at the height of the LiDAR's circle or on the ground.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "algorithms/calibration/calibration_result.h"
#include "algorithms/calibration/method_details.h"
#include "algorithms/calibration/slew/slew_axis.h"
#include "algorithms/calibration/slew/slew_options.h"
#include "algorithms/calibration/solve_options.h"
#include "algorithms/core/progress.h"
#include "algorithms/geometry/circle_fit.h"
#include "algorithms/geometry/plane_fit.h"

namespace remount::calibration {

/// All in the lidar frame at a standstill; the LiDAR turns with the upper structure.
struct SlewData {
  std::vector<Eigen::Vector3d> ground_points;  ///< m; may be empty with FirstPlane::Turn
  std::vector<Eigen::Vector3d> arm_points;     ///< m; what moved while the arm was swept
  /// Poses of the LiDAR while the machine turned, in order; an error that all have in common does no harm.
  std::vector<RigidTransform> first_from_lidar;
  std::size_t turn_scans = 0, turn_scans_failed = 0;       ///< of the turn; those that gave no pose
  Eigen::Vector3d up_in_lidar = Eigen::Vector3d::UnitZ();  ///< rough, within 30 deg; unit length
};

struct SlewResult {
  CalibrationResult calibration;  ///< its mounting is machine_from_lidar
  PlaneFit ground, arm;
  CircleFit circle;  ///< of the LiDAR's places as they were aligned: shows whether the turn is one
  SlewAxis axis;
  double ground_to_turn_rad = std::numeric_limits<double>::quiet_NaN();  ///< angle between their normals
  double ground_to_turn_sigma_rad = std::numeric_limits<double>::quiet_NaN();
  /// Of the lean of the ground against the turn beyond its noise, LiDAR axes; zero where noise explains it. Part of the
  /// covariance where the ground is the first plane.
  Eigen::Matrix3d ground_lean_variance_rad2 = Eigen::Matrix3d::Zero();
  double arm_square_error_rad = std::numeric_limits<double>::quiet_NaN();  ///< 0: arm and first plane are square
  std::vector<NamedQuantity> quantities;
  std::vector<Plot> plots;
};

/// Planes, circle, axes n1, n2, n1 x n2 made orthonormal, translation from the circle's centre. The centre, and the
/// direction of the slew axis where the turn gives the first plane, are taken as the LiDAR sees them (slew_axis.h). A
/// short arc, a missing ground or arm plane, an arm that is not square and a ground that is tilted against the slew
/// axis are refused: nothing is then observed, and the message says why. Throws Error(Contract) for options out of
/// range.
SlewResult solve_slew(const SlewData& data, const std::optional<RigidTransform>& nominal_machine_from_lidar,
                      const SlewOptions& options, const SolveOptions& solve, Progress& progress);

}  // namespace remount::calibration
