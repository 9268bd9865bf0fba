// The rotation between two bodies from their turns: q_a q = q q_b. docs/maths/vehicle-frame.md (V5) to (V7)
#pragma once

#include <array>
#include <vector>

#include "algorithms/geometry/rotation.h"
#include "algorithms/messages/message.h"

namespace remount::calibration {

/// One turn as two sensors on the same rigid body saw it: each rotation takes end axes to start axes of its sensor.
struct TurnPair {
  Eigen::Matrix3d in_a = Eigen::Matrix3d::Identity();
  Eigen::Matrix3d in_b = Eigen::Matrix3d::Identity();
};

struct RotationEquationResult {
  bool solved = false;  ///< false: no turn that could tell anything
  Eigen::Matrix3d a_from_b = Eigen::Matrix3d::Identity();
  /// Of the stacked ([q_a]_L - [q_b]_R), over the root of the number of pairs, largest first. The last is the misfit;
  /// where the one before it is as small, the turns are about one axis and the rotation about it is free.
  std::array<double, 4> singular_values{};
  double residual_rad = 0.0;                                  ///< of each axis, robust: root mean square
  Eigen::Vector3d main_axis_in_a = Eigen::Vector3d::UnitZ();  ///< about which the body turned most
  double main_axis_turn_rad = 0.0;                            ///< root mean square turn about it
  double other_axes_turn_rad = 0.0;                           ///< and about the axes across it
  Eigen::Matrix3d covariance_rad2 = Eigen::Matrix3d::Zero();  ///< of Exp(phi) a_from_b, axes a; observed part only
  bool rotation_about_main_axis_observed = false;
  Message words;  ///< what is observed and what is not
};

/// Weighted null vector by SVD, re-weighted where turns disagree (Cauchy). Where only turns about one axis are there,
/// `a_from_b` is one member of the family: right in the direction of the axis, arbitrary about it.
/// @param noise_rad how well a turn is known at least: what is taken for excitation must exceed it
RotationEquationResult solve_rotation_equation(const std::vector<TurnPair>& turns, double noise_rad);

/// x, y, yaw and scale of planar motion in closed form. docs/maths/vehicle-frame.md (V7) (Cf. Guo, Mirzaei,
/// Roumeliotis 2012.)
struct PlanarMotion {
  double turn_rad = 0.0;                                    ///< about z of the vehicle
  Eigen::Vector2d travel_m = Eigen::Vector2d::Zero();       ///< of the vehicle's origin, axes of the start
  Eigen::Vector2d sensor_travel = Eigen::Vector2d::Zero();  ///< levelled: pitch and roll are taken out
};
struct PlanarMounting {
  bool solved = false;
  double x_m = 0.0, y_m = 0.0, yaw_rad = 0.0;
  double scale = 1.0;              ///< metres per unit of the sensor
  bool position_observed = false;  ///< false: hardly any turn; x and y are then zero
};
/// Linear least squares of (R(turn) - I) [x, y] - scale R(yaw) sensor_travel = -travel.
PlanarMounting solve_planar_mounting(const std::vector<PlanarMotion>& motions, bool scale_known);

}  // namespace remount::calibration
