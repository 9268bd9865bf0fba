// How well a candidate X explains the pairs. docs/maths/search.md (S1) to (S4)
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "algorithms/geometry/rigid_transform.h"

namespace remount::search {

/// P and Q of one pair, with a weight.
struct MotionPair {
  RigidTransform ins_b_from_ins_a = RigidTransform::Identity();
  RigidTransform lidar_b_from_lidar_a = RigidTransform::Identity();
  double weight = 1.0;
};

/// E(X) = sum_i ||P_i X - X Q_i||_F, the translation block divided by the characteristic length (m): what candidates
/// are ranked by; dimensionless. Weights are not used: every accepted pair counts once. (S1)
double frobenius_sum(const std::vector<MotionPair>& pairs, const RigidTransform& ins_from_lidar,
                     double characteristic_length_m);

/// Translations (m) to be scored with every rotation of a grid, prepared once by a quadratic form.
struct TranslationGrid {
  Eigen::ArrayXd x_m, y_m, z_m;
  Eigen::ArrayXd quadratic;  ///< the part of the score that depends on the translation alone
};

/// E2(X) = sum_i w_i ||P_i X - X Q_i||_F^2 as one quadratic form in the twelve entries of (R, t): accumulated once,
/// then O(1) for each candidate whatever the number of pairs.
class QuadraticForm {
 public:
  QuadraticForm(const std::vector<MotionPair>& pairs, double characteristic_length_m);
  double value(const RigidTransform& ins_from_lidar) const;

  /// The value of every candidate, many at a time. Throws Error(Contract) where the sizes differ.
  void values(std::span<const RigidTransform> ins_from_lidar, std::span<double> out) const;

  /// The value of one rotation with every translation of a grid: four multiplications a candidate. Throws
  /// Error(Contract) where the sizes differ.
  TranslationGrid prepare_grid(std::span<const Eigen::Vector3d> translations_m) const;
  void values_on_grid(const Eigen::Matrix3d& rotation, const TranslationGrid& grid, std::span<double> out) const;

  using Matrix13d = Eigen::Matrix<double, 13, 13>;
  using Vector13d = Eigen::Matrix<double, 13, 1>;
  /// The form itself, of [vec R; t; 1] with R by columns.
  const Matrix13d& matrix() const { return form_; }

  /// The translation that minimises E2 for a rotation, pulled to `near_m` where the pairs do not determine it
  /// (directions whose curvature is below `relative_floor` of the largest).
  Eigen::Vector3d best_translation_m(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& near_m,
                                     double relative_floor = 1e-6) const;

  /// E2 minimised over translation, and its gradient and Gauss-Newton curvature for R <- Exp(phi) R.
  struct Reduced {
    double value = 0.0;
    Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
    Eigen::Matrix3d curvature = Eigen::Matrix3d::Zero();
  };
  Reduced reduced(const Eigen::Matrix3d& rotation) const;

 private:
  Matrix13d form_ = Matrix13d::Zero();
  Eigen::Matrix3d translation_inverse_ = Eigen::Matrix3d::Zero();  // pseudo-inverse of the t block
  Eigen::Matrix<double, 9, 9> reduced_quadratic_ = Eigen::Matrix<double, 9, 9>::Zero();
  Eigen::Matrix<double, 9, 1> reduced_linear_ = Eigen::Matrix<double, 9, 1>::Zero();
  double reduced_constant_ = 0.0;
};

/// vec R, by columns as in the form.
inline Eigen::Matrix<double, 9, 1> rotation_entries(const Eigen::Matrix3d& rotation) {
  return Eigen::Map<const Eigen::Matrix<double, 9, 1>>(rotation.data());
}

/// The unit vector e of [vec R; t; 1] with e . [vec R; t; 1] = R(row, column).
inline QuadraticForm::Vector13d rotation_entry(int row, int column) {
  return QuadraticForm::Vector13d::Unit(3 * column + row);
}

}  // namespace remount::search
