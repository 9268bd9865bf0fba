#include "algorithms/motion/screw.h"

#include <algorithm>
#include <cmath>

namespace remount::motion {

ScrewTest screw_test(const RigidTransform& ins_b_from_ins_a, const RigidTransform& lidar_b_from_lidar_a,
                     double rotation_sigma_rad, double translation_sigma_m, double threshold) {
  const Eigen::Vector3d phi_p = so3_log(ins_b_from_ins_a.linear()), phi_q = so3_log(lidar_b_from_lidar_a.linear());
  const Eigen::Vector3d t_p = ins_b_from_ins_a.translation(), t_q = lidar_b_from_lidar_a.translation();
  ScrewTest test;
  test.rotation_difference_rad = phi_p.norm() - phi_q.norm();
  test.score = std::abs(test.rotation_difference_rad) / rotation_sigma_rad;
  const double angle_rad = std::min(phi_p.norm(), phi_q.norm());
  // The axis is known to rotation_sigma / angle: below some ten sigma of rotation there is no axis to speak of.
  if (angle_rad > 10.0 * rotation_sigma_rad && angle_rad > 1e-9) {
    test.translation_difference_m = phi_p.normalized().dot(t_p) - phi_q.normalized().dot(t_q);
    const double axis_sigma_m = rotation_sigma_rad / angle_rad * std::max(t_p.norm(), t_q.norm());
    test.score =
        std::max(test.score, std::abs(test.translation_difference_m) / std::hypot(translation_sigma_m, axis_sigma_m));
  }
  test.passed = test.score <= threshold;
  return test;
}

}  // namespace remount::motion
