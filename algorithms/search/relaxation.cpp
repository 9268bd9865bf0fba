#include "algorithms/search/relaxation.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "algorithms/core/index.h"

namespace remount::search {
namespace {

using Matrix13d = QuadraticForm::Matrix13d;
using Vector13d = QuadraticForm::Vector13d;

constexpr int kEquations = 20;

Matrix13d symmetric_product(const Vector13d& a, const Vector13d& b) {
  return 0.5 * (a * b.transpose() + b * a.transpose());
}

// The quadratic equations that make [c1 c2 c3] a rotation: unit columns at right angles, unit rows at right angles (one
// of these follows), and each column the cross product of the next two. Each as a matrix K with z' K z = 0.
std::vector<Matrix13d> rotation_equations() {
  std::vector<Matrix13d> out;
  const Vector13d one = Vector13d::Unit(12);
  for (int rows = 0; rows < 2; ++rows)
    for (int i = 0; i < 3; ++i)
      for (int j = i; j < 3; ++j) {
        if (rows == 1 && i == 2 && j == 2) continue;
        Matrix13d equation = i == j ? Matrix13d(-one * one.transpose()) : Matrix13d::Zero();
        for (int k = 0; k < 3; ++k)
          equation += rows == 1 ? symmetric_product(rotation_entry(i, k), rotation_entry(j, k))
                                : symmetric_product(rotation_entry(k, i), rotation_entry(k, j));
        out.push_back(equation);
      }
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row) {
      const int b = (column + 1) % 3, c = (column + 2) % 3, u = (row + 1) % 3, v = (row + 2) % 3;
      out.push_back(symmetric_product(rotation_entry(u, b), rotation_entry(v, c)) -
                    symmetric_product(rotation_entry(v, b), rotation_entry(u, c)) -
                    symmetric_product(rotation_entry(row, column), one));
    }
  return out;
}

// Around the centre: R = R0 (I + D), t = t0 + width * d. Rotations stay rotations under R0, so the equations keep their
// form, and near the centre nothing large cancels.
struct Recentred {
  Matrix13d to_original, equations_shift;

  Recentred(const RigidTransform& centre, const Eigen::Vector3d& width_m) {
    Matrix13d turn = Matrix13d::Identity();
    for (int column = 0; column < 3; ++column) turn.block<3, 3>(3 * column, 3 * column) = centre.linear();
    turn.block<3, 3>(9, 9) = width_m.asDiagonal();
    turn.block<3, 1>(9, 12) = centre.translation();
    equations_shift = Matrix13d::Identity();
    for (int i = 0; i < 3; ++i) equations_shift(4 * i, 12) = 1.0;
    to_original = turn * equations_shift;
  }
};

// Maximises the bound s over the multipliers of S = form + sum y_k K_k - sum m_j B_j - s E >= 0, m >= 0, by a barrier.
// docs/maths/search.md (S11)
class DualBarrier {
 public:
  DualBarrier(const Matrix13d& form, const RelaxedRegion& region, const Recentred& around) {
    form_ = around.to_original.transpose() * form * around.to_original;
    scale_ = form_.topLeftCorner<9, 9>().trace() / 9.0;
    if (!(scale_ > 0.0)) scale_ = std::max(1.0, form_(12, 12));
    form_ /= scale_;
    for (const Matrix13d& equation : rotation_equations())
      terms_.push_back(around.equations_shift.transpose() * equation * around.equations_shift);
    std::vector<Vector13d> half_spaces;
    for (const Vector13d& h : region.half_spaces) {
      const Vector13d here = around.to_original.transpose() * h;
      half_spaces.push_back(here / here.norm());
    }
    for (const auto& [a, b] : region.products)
      terms_.push_back(-symmetric_product(half_spaces[index_at(a)], half_spaces[index_at(b)]));
    for (const Vector13d& h : half_spaces) terms_.push_back(-symmetric_product(h, Vector13d::Unit(12)));
    terms_.push_back(-symmetric_product(Vector13d::Unit(12), Vector13d::Unit(12)));
    variables_ = static_cast<Eigen::Index>(terms_.size());
    flat_.resize(169, variables_);
    for (Eigen::Index i = 0; i < variables_; ++i)
      flat_.col(i) = Eigen::Map<const Eigen::VectorXd>(terms_[index_at(i)].data(), 169);
    started_ = start();
  }

  /// Whether there is a point to start from; without one there are no bounds.
  bool started() const { return started_; }
  double bound() const { return value_[variables_ - 1] * scale_; }
  double scale() const { return scale_; }
  double weight() const { return weight_; }
  /// How far the best bound can lie above this one, where the barrier is centred.
  double slack() const { return static_cast<double>(13 + variables_ - 1 - kEquations) * weight_ * scale_; }
  void sharpen() { weight_ *= 0.1; }

  /// One Newton step; returns its length in the barrier's own measure, or nothing where rounding stops it.
  std::optional<double> step() {
    const Matrix13d inverse = factor_.solve(Matrix13d::Identity());
    Eigen::MatrixXd turned(169, variables_);
    for (Eigen::Index i = 0; i < variables_; ++i) {
      const Matrix13d product = inverse * terms_[index_at(i)] * inverse;
      turned.col(i) = Eigen::Map<const Eigen::VectorXd>(product.data(), 169);
    }
    Eigen::VectorXd gradient = flat_.transpose() * Eigen::Map<const Eigen::VectorXd>(inverse.data(), 169);
    Eigen::MatrixXd curvature = flat_.transpose() * turned;
    gradient[variables_ - 1] += 1.0 / weight_;
    for (Eigen::Index i = kEquations; i < variables_ - 1; ++i) {
      gradient[i] += 1.0 / value_[i];
      curvature(i, i) += 1.0 / (value_[i] * value_[i]);
    }
    // The unknowns differ by many powers of ten: solve for them in units of their own curvature.
    const Eigen::VectorXd unit = curvature.diagonal().cwiseSqrt().cwiseInverse();
    const Eigen::MatrixXd scaled = unit.asDiagonal() * curvature * unit.asDiagonal();
    const Eigen::VectorXd direction = unit.cwiseProduct(scaled.ldlt().solve(unit.cwiseProduct(gradient)));
    const double length = std::sqrt(std::max(0.0, direction.dot(gradient)));
    if (!std::isfinite(length) || !direction.allFinite()) return std::nullopt;
    double share = 1.0;
    for (Eigen::Index i = kEquations; i < variables_ - 1; ++i)
      if (direction[i] < 0.0) share = std::min(share, -0.9 * value_[i] / direction[i]);
    for (; share > 1e-6; share *= 0.6)
      if (move(value_ + share * direction)) return length;
    return std::nullopt;
  }

  /// The relaxed minimum's first moments, as [vec R; t; 1] around the centre.
  Vector13d moments() const {
    const Vector13d column = factor_.solve(Vector13d(Vector13d::Unit(12)));
    return column / column[12];
  }

 private:
  // A point inside: large multipliers of |R|^2 = 3 and of the boxes of t make all but the last row positive; then s low
  // enough makes it so.
  bool start() {
    value_ = Eigen::VectorXd::Zero(variables_);
    for (const int diagonal : {0, 3, 5}) value_[diagonal] = 1.0;
    for (Eigen::Index i = kEquations; i < variables_ - 1; ++i) value_[i] = 0.05;
    for (int attempt = 0; attempt < 60; ++attempt) {
      value_[variables_ - 1] = 0.0;
      const Matrix13d slack = assemble(value_);
      const Eigen::LLT<Eigen::Matrix<double, 12, 12>> block(slack.topLeftCorner<12, 12>());
      if (block.info() == Eigen::Success) {
        const Eigen::Matrix<double, 12, 1> side = slack.block<12, 1>(0, 12);
        value_[variables_ - 1] = slack(12, 12) - side.dot(block.solve(side)) - 1.0;
        if (move(value_)) return true;
      }
      for (const int diagonal : {0, 3, 5}) value_[diagonal] *= 2.0;
    }
    return false;
  }

  Matrix13d assemble(const Eigen::VectorXd& value) const {
    const Eigen::VectorXd sum = flat_ * value;
    return form_ + Eigen::Map<const Matrix13d>(sum.data());
  }

  bool move(const Eigen::VectorXd& value) {
    const Eigen::LLT<Matrix13d> factor(assemble(value));
    if (factor.info() != Eigen::Success) return false;
    factor_ = factor;
    value_ = value;
    return true;
  }

  Matrix13d form_;
  double scale_ = 1.0;
  double weight_ = 1.0;
  Eigen::Index variables_ = 0;
  std::vector<Matrix13d> terms_;  // equations, products, half-spaces, and last the bound itself
  Eigen::MatrixXd flat_;
  Eigen::VectorXd value_;
  Eigen::LLT<Matrix13d> factor_;
  bool started_ = false;
};

RigidTransform to_rigid(const Vector13d& x) {
  return make_rigid(nearest_rotation(Eigen::Map<const Eigen::Matrix3d>(x.data())), x.segment<3>(9));
}

}  // namespace

RelaxedMinimum relaxed_minimum(const Matrix13d& form, const RelaxedRegion& region, const RigidTransform& centre,
                               double target, const Progress& progress) {
  constexpr int kMostSteps = 150;
  constexpr double kLeastWeight = 1e-17;
  const Recentred around(centre, region.t_half_width_m);
  DualBarrier barrier(form, region, around);
  RelaxedMinimum out;
  out.nearest = centre;
  if (!barrier.started()) return out;  // zero bounds a positive semidefinite form
  double best = barrier.bound();
  for (; out.steps < kMostSteps && best < target && !progress.cancelled(); ++out.steps) {
    const std::optional<double> length = barrier.step();
    best = std::max(best, barrier.bound());
    if (!length || barrier.weight() < kLeastWeight) break;
    if (*length > 1.0) continue;
    if (barrier.bound() + 2.0 * barrier.slack() < target) break;  // no multipliers reach the target
    barrier.sharpen();
  }
  out.lower_bound = best;
  out.nearest = to_rigid(around.to_original * barrier.moments());
  return out;
}

}  // namespace remount::search
