// The motion equation of one pair, P X = X Q, as a residual with Jacobians.
#pragma once

#include "algorithms/geometry/rigid_transform.h"

namespace remount::calibration {

/// lidar_b_from_lidar_a that the INS motion and X predict: X^-1 P X.
RigidTransform predicted_lidar_motion(const RigidTransform& ins_b_from_ins_a, const RigidTransform& ins_from_lidar);

/// How far the motion that INS and X predict is from the registered one, difference(registered, predicted): translation
/// (m), then rotation vector (rad), in the axes of lidar b. docs/maths/pairwise.md
Vector6d motion_residual(const RigidTransform& ins_b_from_ins_a, const RigidTransform& lidar_b_from_lidar_a,
                         const RigidTransform& ins_from_lidar);

/// Linearisation of the residual r = difference(measured, predicted): translation (m) and rotation (rad) in the axes of
/// lidar b. To first order r + d_x dX + d_a dA + d_b dB, where dX perturbs X as in `perturb`, and dA, dB = [nu;
/// omega] move the INS poses in their own body axes: translation += R nu, R <- R Exp(omega).
struct PairEquation {
  Vector6d residual = Vector6d::Zero();
  Matrix6d d_x = Matrix6d::Zero();
  Matrix6d d_a = Matrix6d::Zero();
  Matrix6d d_b = Matrix6d::Zero();
};
PairEquation linearise_pair(const RigidTransform& ins_b_from_ins_a, const RigidTransform& lidar_b_from_lidar_a,
                            const RigidTransform& ins_from_lidar);

/// The residual and `d_x` alone, for passes over thousands of pairs.
struct MountingEquation {
  Vector6d residual = Vector6d::Zero();
  Matrix6d d_x = Matrix6d::Zero();
};
MountingEquation linearise_in_mounting(const RigidTransform& ins_b_from_ins_a,
                                       const RigidTransform& lidar_b_from_lidar_a,
                                       const RigidTransform& ins_from_lidar);

/// lidar_b_from_lidar_a of two LiDARs of a vehicle, as their mountings predict it: X_b^-1 P X_a.
RigidTransform predicted_cross_motion(const RigidTransform& ins_b_from_ins_a, const RigidTransform& ins_from_lidar_a,
                                      const RigidTransform& ins_from_lidar_b);

/// The same as PairEquation of a scan of LiDAR a and one of LiDAR b. docs/maths/rig.md (G1)
struct CrossEquation {
  Vector6d residual = Vector6d::Zero();
  Matrix6d d_x_a = Matrix6d::Zero(), d_x_b = Matrix6d::Zero();
  Matrix6d d_a = Matrix6d::Zero(), d_b = Matrix6d::Zero();
};
CrossEquation linearise_cross_pair(const RigidTransform& ins_b_from_ins_a, const RigidTransform& lidar_b_from_lidar_a,
                                   const RigidTransform& ins_from_lidar_a, const RigidTransform& ins_from_lidar_b);

/// A pose moved in its own body axes by [nu; omega].
RigidTransform moved_in_body(const RigidTransform& world_from_body, const Vector6d& body_step);

}  // namespace remount::calibration
