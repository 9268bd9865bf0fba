#include "algorithms/calibration/joint/pair_equation.h"

namespace remount::calibration {

using Eigen::Matrix3d;
using Eigen::Vector3d;

RigidTransform predicted_lidar_motion(const RigidTransform& ins_b_from_ins_a, const RigidTransform& ins_from_lidar) {
  return ins_from_lidar.inverse() * ins_b_from_ins_a * ins_from_lidar;
}

Vector6d motion_residual(const RigidTransform& ins_b_from_ins_a, const RigidTransform& lidar_b_from_lidar_a,
                         const RigidTransform& ins_from_lidar) {
  return difference(lidar_b_from_lidar_a, predicted_lidar_motion(ins_b_from_ins_a, ins_from_lidar));
}

MountingEquation linearise_in_mounting(const RigidTransform& ins_b_from_ins_a,
                                       const RigidTransform& lidar_b_from_lidar_a,
                                       const RigidTransform& ins_from_lidar) {
  const Matrix3d lidar_from_ins = ins_from_lidar.linear().transpose();
  const Matrix3d turn = lidar_from_ins * (ins_b_from_ins_a.linear() - Matrix3d::Identity());
  const Vector3d travel_m = ins_b_from_ins_a * ins_from_lidar.translation() - ins_from_lidar.translation();

  MountingEquation equation;
  equation.residual = motion_residual(ins_b_from_ins_a, lidar_b_from_lidar_a, ins_from_lidar);
  equation.d_x.topLeftCorner<3, 3>() = turn;
  equation.d_x.topRightCorner<3, 3>() = lidar_from_ins * skew(travel_m);
  // The rotation part is Log(R_predicted R_measured'): a left perturbation passes through the inverse left Jacobian.
  equation.d_x.bottomRightCorner<3, 3>() = so3_left_jacobian_inverse(equation.residual.tail<3>()) * turn;
  return equation;
}

PairEquation linearise_pair(const RigidTransform& ins_b_from_ins_a, const RigidTransform& lidar_b_from_lidar_a,
                            const RigidTransform& ins_from_lidar) {
  const Matrix3d r_p = ins_b_from_ins_a.linear();
  const Matrix3d lidar_from_ins = ins_from_lidar.linear().transpose();
  const Vector3d arm = r_p * ins_from_lidar.translation();      // lever arm of a, in the axes of INS b
  const Vector3d reach = arm + ins_b_from_ins_a.translation();  // lidar a's origin, seen from INS b
  const MountingEquation in_x = linearise_in_mounting(ins_b_from_ins_a, lidar_b_from_lidar_a, ins_from_lidar);
  const Matrix3d log_jacobian = so3_left_jacobian_inverse(in_x.residual.tail<3>());

  PairEquation equation{in_x.residual, in_x.d_x};
  equation.d_a.topLeftCorner<3, 3>() = lidar_from_ins * r_p;
  equation.d_a.topRightCorner<3, 3>() = -lidar_from_ins * skew(arm) * r_p;
  equation.d_a.bottomRightCorner<3, 3>() = log_jacobian * lidar_from_ins * r_p;

  equation.d_b.topLeftCorner<3, 3>() = -lidar_from_ins;
  equation.d_b.topRightCorner<3, 3>() = lidar_from_ins * skew(reach);
  equation.d_b.bottomRightCorner<3, 3>() = -log_jacobian * lidar_from_ins;
  return equation;
}

RigidTransform predicted_cross_motion(const RigidTransform& ins_b_from_ins_a, const RigidTransform& ins_from_lidar_a,
                                      const RigidTransform& ins_from_lidar_b) {
  return ins_from_lidar_b.inverse() * ins_b_from_ins_a * ins_from_lidar_a;
}

CrossEquation linearise_cross_pair(const RigidTransform& ins_b_from_ins_a, const RigidTransform& lidar_b_from_lidar_a,
                                   const RigidTransform& ins_from_lidar_a, const RigidTransform& ins_from_lidar_b) {
  const Matrix3d lidar_from_ins = ins_from_lidar_b.linear().transpose();
  const Matrix3d carried = lidar_from_ins * ins_b_from_ins_a.linear();
  const Vector3d arm = ins_b_from_ins_a.linear() * ins_from_lidar_a.translation();
  const Vector3d reach = arm + ins_b_from_ins_a.translation();  // lidar a's origin, seen from INS b

  CrossEquation equation;
  equation.residual =
      difference(lidar_b_from_lidar_a, predicted_cross_motion(ins_b_from_ins_a, ins_from_lidar_a, ins_from_lidar_b));
  const Matrix3d log_jacobian = so3_left_jacobian_inverse(equation.residual.tail<3>());
  equation.d_x_a.topLeftCorner<3, 3>() = carried;
  equation.d_x_a.bottomRightCorner<3, 3>() = log_jacobian * carried;
  equation.d_x_b.topLeftCorner<3, 3>() = -lidar_from_ins;
  equation.d_x_b.topRightCorner<3, 3>() = lidar_from_ins * skew(Vector3d(reach - ins_from_lidar_b.translation()));
  equation.d_x_b.bottomRightCorner<3, 3>() = -log_jacobian * lidar_from_ins;

  equation.d_a.topLeftCorner<3, 3>() = carried;
  equation.d_a.topRightCorner<3, 3>() = -lidar_from_ins * skew(arm) * ins_b_from_ins_a.linear();
  equation.d_a.bottomRightCorner<3, 3>() = log_jacobian * carried;
  equation.d_b.topLeftCorner<3, 3>() = -lidar_from_ins;
  equation.d_b.topRightCorner<3, 3>() = lidar_from_ins * skew(reach);
  equation.d_b.bottomRightCorner<3, 3>() = -log_jacobian * lidar_from_ins;
  return equation;
}

RigidTransform moved_in_body(const RigidTransform& world_from_body, const Vector6d& body_step) {
  return make_rigid(world_from_body.linear() * so3_exp(body_step.tail<3>()),
                    world_from_body.translation() + world_from_body.linear() * body_step.head<3>());
}

}  // namespace remount::calibration
