#include "algorithms/search/boxed_form.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "algorithms/core/index.h"
#include "algorithms/core/symmetric_eigen.h"

namespace remount::search {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Vector9d = Eigen::Matrix<double, 9, 1>;

// First and second derivatives of the entries of R by three parameters.
struct Chart {
  Eigen::Matrix<double, 9, 3> first;
  std::array<std::array<Vector9d, 3>, 3> second;
};

// R <- Exp(phi) R at phi = 0.
Chart turn_chart(const Matrix3d& rotation) {
  Chart chart;
  for (int i = 0; i < 3; ++i) {
    const Matrix3d a = skew(Vector3d::Unit(i));
    chart.first.col(i) = rotation_entries(a * rotation);
    for (int j = 0; j < 3; ++j) {
      const Matrix3d b = skew(Vector3d::Unit(j));
      chart.second[index_at(i)][index_at(j)] = rotation_entries(0.5 * (a * b + b * a) * rotation);
    }
  }
  return chart;
}

// d^order/dangle^order of a turn about an axis.
Matrix3d turn_derivative(int axis, double angle_rad, int order) {
  const Matrix3d turn = so3_exp(angle_rad * Vector3d::Unit(axis));
  const Matrix3d generator = skew(Vector3d::Unit(axis));
  return order == 0 ? turn : order == 1 ? Matrix3d(generator * turn) : Matrix3d(generator * generator * turn);
}

Matrix3d angles_derivative(const Vector3d& angles, const std::array<int, 3>& orders) {
  return turn_derivative(2, angles[0], orders[0]) * turn_derivative(1, angles[1], orders[1]) *
         turn_derivative(0, angles[2], orders[2]);
}

Chart angles_chart(const Vector3d& angles) {
  Chart chart;
  for (std::size_t i = 0; i < 3; ++i) {
    std::array<int, 3> orders{};
    ++orders[i];
    chart.first.col(static_cast<Eigen::Index>(i)) = rotation_entries(angles_derivative(angles, orders));
    for (std::size_t j = 0; j < 3; ++j) {
      std::array<int, 3> twice = orders;
      ++twice[j];
      chart.second[i][j] = rotation_entries(angles_derivative(angles, twice));
    }
  }
  return chart;
}

Vector3d angles_of(const Matrix3d& rotation) {
  const YawPitchRoll angles = yaw_pitch_roll_from_rotation(rotation);
  return {angles.yaw_rad, angles.pitch_rad, angles.roll_rad};
}

// Entry by entry: next to pitch +-90 deg the small ones then keep the digits that the canonical yaw and roll live on.
Matrix3d rotation_of(const Vector3d& angles) {
  const double cy = std::cos(angles[0]), sy = std::sin(angles[0]), cp = std::cos(angles[1]), sp = std::sin(angles[1]),
               cr = std::cos(angles[2]), sr = std::sin(angles[2]);
  Matrix3d rotation;
  rotation << cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr,  //
      sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr,          //
      -sp, cp * sr, cp * cr;
  return rotation;
}

// Newton's step on the directions that are free; curvature is lifted where it is not positive.
Vector3d newton_step(const Matrix3d& curvature, const Vector3d& gradient, const std::array<bool, 3>& held,
                     double damping) {
  Matrix3d matrix = curvature;
  Vector3d side = gradient;
  const double size = curvature.cwiseAbs().maxCoeff() + 1e-300;
  for (int i = 0; i < 3; ++i) {
    if (!held[index_at(i)]) continue;
    matrix.row(i).setZero();
    matrix.col(i).setZero();
    matrix(i, i) = size;
    side[i] = 0.0;
  }
  const auto eigen = symmetric_eigen(matrix);
  const double lift = std::max(0.0, -1.5 * eigen.eigenvalues()[0]) + damping * size;
  const Vector3d step = -(eigen.eigenvectors() * (eigen.eigenvalues().array() + lift).inverse().matrix().asDiagonal() *
                          eigen.eigenvectors().transpose() * side);
  return step.norm() > 0.5 ? Vector3d(0.5 * step.normalized()) : step;
}

struct LocalModel {
  Vector3d gradient;
  Matrix3d curvature;
};

// The envelope theorem gives the gradient; the translations that are not at a limit follow the rotation.
LocalModel local_model(const QuadraticForm::Matrix13d& form, const RigidTransform& x, const Chart& chart,
                       const Matrix3d& free_inverse) {
  QuadraticForm::Vector13d all;
  all << rotation_entries(x.linear()), x.translation(), 1.0;
  const Vector9d pull = (form * all).head<9>();
  const Eigen::Matrix<double, 3, 9> coupling = form.block<3, 9>(9, 0);
  const Eigen::Matrix<double, 3, 3> through_t = coupling * chart.first;
  LocalModel model;
  model.gradient = 2.0 * chart.first.transpose() * pull;
  model.curvature = 2.0 * (chart.first.transpose() * form.topLeftCorner<9, 9>() * chart.first -
                           through_t.transpose() * free_inverse * through_t);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      model.curvature(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) += 2.0 * pull.dot(chart.second[i][j]);
  return model;
}

constexpr int kMostIterations = 100;

}  // namespace

BoxedForm::BoxedForm(const QuadraticForm& form, const calibration::SearchRange& range, const Vector3d& near_m)
    : form_(form),
      t_low_m_(range.x_min_m, range.y_min_m, range.z_min_m),
      t_high_m_(range.x_max_m, range.y_max_m, range.z_max_m),
      near_m_(near_m.cwiseMax(t_low_m_).cwiseMin(t_high_m_)) {
  constexpr double kRounding = 1e-13;  // curvature beneath it says nothing
  const Matrix3d block = form.matrix().block<3, 3>(9, 9);
  for (int free_axes = 0; free_axes < 8; ++free_axes) {
    Matrix3d part = Matrix3d::Zero();
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        if ((free_axes >> i & 1) && (free_axes >> j & 1)) part(i, j) = block(i, j);
    const auto eigen = symmetric_eigen(part);
    Vector3d inverse = Vector3d::Zero();
    for (int i = 0; i < 3; ++i)
      if (eigen.eigenvalues()[i] > kRounding * block.trace()) inverse[i] = 1.0 / eigen.eigenvalues()[i];
    inverse_of_[index_at(free_axes)] = eigen.eigenvectors() * inverse.asDiagonal() * eigen.eigenvectors().transpose();
  }
}

// The minimum over the free axes with the others held: what is not determined stays where it is.
Vector3d BoxedForm::translation_with(int free_axes, const Vector3d& fixed, const Vector3d& pull) const {
  const Matrix3d block = form_.matrix().block<3, 3>(9, 9);
  return fixed - inverse_of_[index_at(free_axes)] * (block * fixed + pull);
}

RigidTransform BoxedForm::best_at(const Matrix3d& rotation) const {
  const auto& form = form_.matrix();
  const Vector3d pull = form.block<3, 9>(9, 0) * rotation_entries(rotation) + form.block<3, 1>(9, 12);
  const auto inside = [&](const Vector3d& t) {
    return (t.array() >= t_low_m_.array()).all() && (t.array() <= t_high_m_.array()).all();
  };
  Vector3d best = translation_with(7, near_m_, pull);
  if (inside(best)) return make_rigid(rotation, best);
  // A convex problem of three unknowns: every set of limits that may hold, the least of what is inside.
  double least = std::numeric_limits<double>::infinity();
  for (int choice = 0; choice < 27; ++choice) {
    Vector3d t = near_m_;
    int free_axes = 0;
    for (int axis = 0, rest = choice; axis < 3; ++axis, rest /= 3) {
      if (rest % 3 == 0) free_axes |= 1 << axis;
      if (rest % 3 == 1) t[axis] = t_low_m_[axis];
      if (rest % 3 == 2) t[axis] = t_high_m_[axis];
    }
    t = translation_with(free_axes, t, pull).cwiseMax(t_low_m_).cwiseMin(t_high_m_);
    const double value = t.dot(form.block<3, 3>(9, 9) * t + 2.0 * pull);
    if (value < least) {
      least = value;
      best = t;
    }
  }
  return make_rigid(rotation, best);
}

namespace {

int free_axes_of(const Vector3d& t, const Vector3d& low, const Vector3d& high) {
  int axes = 0;
  for (int i = 0; i < 3; ++i) axes |= t[i] > low[i] && t[i] < high[i] ? 1 << i : 0;
  return axes;
}

}  // namespace

RigidTransform BoxedForm::minimise(const Matrix3d& start) const {
  RigidTransform x = best_at(start);
  double value = form_.value(x), damping = 1e-3;
  for (int iteration = 0; iteration < kMostIterations && damping < 1e6; ++iteration) {
    const int free_axes = free_axes_of(x.translation(), t_low_m_, t_high_m_);
    const LocalModel model = local_model(form_.matrix(), x, turn_chart(x.linear()), inverse_of_[index_at(free_axes)]);
    const Vector3d step = newton_step(model.curvature, model.gradient, {}, damping);
    const RigidTransform trial = best_at(nearest_rotation(so3_exp(step) * x.linear()));
    const double trial_value = form_.value(trial);
    damping = trial_value < value ? std::max(1e-14, damping * 0.05) : damping * 10.0;
    if (trial_value < value) {
      x = trial;
      value = trial_value;
    }
    if (step.norm() < 1e-13) break;
  }
  return x;
}

RigidTransform BoxedForm::minimise(const Matrix3d& start, const AngleBox& box) const {
  Vector3d angles = angles_of(start).cwiseMax(box.low).cwiseMin(box.high);
  RigidTransform x = best_at(rotation_of(angles));
  double value = form_.value(x), damping = 1e-3;
  for (int iteration = 0; iteration < kMostIterations && damping < 1e6; ++iteration) {
    const int free_axes = free_axes_of(x.translation(), t_low_m_, t_high_m_);
    const LocalModel model = local_model(form_.matrix(), x, angles_chart(angles), inverse_of_[index_at(free_axes)]);
    std::array<bool, 3> held{};
    for (int i = 0; i < 3; ++i)
      held[index_at(i)] =
          (angles[i] <= box.low[i] && model.gradient[i] > 0.0) || (angles[i] >= box.high[i] && model.gradient[i] < 0.0);
    const Vector3d step = newton_step(model.curvature, model.gradient, held, damping);
    const Vector3d next = (angles + step).cwiseMax(box.low).cwiseMin(box.high);
    const RigidTransform trial = best_at(rotation_of(next));
    const double trial_value = form_.value(trial);
    damping = trial_value < value ? std::max(1e-14, damping * 0.05) : damping * 10.0;
    if (trial_value < value) {
      angles = next;
      x = trial;
      value = trial_value;
    }
    if (step.norm() < 1e-13) break;
  }
  return x;
}

Matrix6d BoxedForm::curvature(const RigidTransform& ins_from_lidar) const {
  const auto& form = form_.matrix();
  const Chart chart = turn_chart(ins_from_lidar.linear());
  Matrix6d out;
  out.topLeftCorner<3, 3>() = 2.0 * form.block<3, 3>(9, 9);
  out.topRightCorner<3, 3>() = 2.0 * form.block<3, 9>(9, 0) * chart.first;
  out.bottomLeftCorner<3, 3>() = out.topRightCorner<3, 3>().transpose();
  out.bottomRightCorner<3, 3>() = local_model(form, ins_from_lidar, chart, Matrix3d::Zero()).curvature;
  return out;
}

}  // namespace remount::search
