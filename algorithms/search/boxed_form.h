// The quadratic form with the translation eliminated under its box constraint, and its minima near a start.
#pragma once

#include <array>

#include "algorithms/calibration/search_range.h"
#include "algorithms/geometry/rigid_transform.h"
#include "algorithms/search/scoring.h"

namespace remount::search {

/// Yaw, pitch and roll (rad) of a part of the rotations, pitch within +-pi/2.
struct AngleBox {
  Eigen::Vector3d low = Eigen::Vector3d::Zero(), high = Eigen::Vector3d::Zero();
  bool empty() const { return !(low.array() <= high.array()).all(); }
};

/// E2 as a function of the rotation alone: for each, the best translation within the box.
class BoxedForm {
 public:
  /// Translations that the form does not determine are taken as near to `near_m` as the box allows.
  BoxedForm(const QuadraticForm& form, const calibration::SearchRange& range, const Eigen::Vector3d& near_m);

  RigidTransform best_at(const Eigen::Matrix3d& rotation) const;

  /// Local minimum over all rotations, from a start.
  RigidTransform minimise(const Eigen::Matrix3d& start) const;
  /// Local minimum over a box of angles.
  RigidTransform minimise(const Eigen::Matrix3d& start, const AngleBox& box) const;

  /// Curvature of E2 for `perturb` (translation and rotation together) at X.
  Matrix6d curvature(const RigidTransform& ins_from_lidar) const;

  double value(const RigidTransform& ins_from_lidar) const { return form_.value(ins_from_lidar); }
  const Eigen::Vector3d& t_low_m() const { return t_low_m_; }
  const Eigen::Vector3d& t_high_m() const { return t_high_m_; }

 private:
  Eigen::Vector3d translation_with(int free_axes, const Eigen::Vector3d& fixed, const Eigen::Vector3d& pull) const;

  const QuadraticForm& form_;
  Eigen::Vector3d t_low_m_, t_high_m_, near_m_;
  std::array<Eigen::Matrix3d, 8> inverse_of_;  // of the translation's block, by the set of axes that are free (bits)
};

}  // namespace remount::search
