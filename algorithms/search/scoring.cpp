#include "algorithms/search/scoring.h"

#include <Eigen/Cholesky>
#include <array>
#include <cmath>

#include "algorithms/core/error.h"
#include "algorithms/core/index.h"
#include "algorithms/core/symmetric_eigen.h"

namespace remount::search {
namespace {

using Vector9d = Eigen::Matrix<double, 9, 1>;

Eigen::Matrix3d pseudo_inverse(const Eigen::Matrix3d& symmetric, double relative_floor) {
  const auto eigen = symmetric_eigen(symmetric);
  Eigen::Vector3d inverse = Eigen::Vector3d::Zero();
  for (int i = 0; i < 3; ++i)
    if (eigen.eigenvalues()[i] > relative_floor * eigen.eigenvalues()[2] && eigen.eigenvalues()[i] > 0.0)
      inverse[i] = 1.0 / eigen.eigenvalues()[i];
  return eigen.eigenvectors() * inverse.asDiagonal() * eigen.eigenvectors().transpose();
}

// Candidates side by side, one entry of [vec R; t] after the other: every operation then serves a whole block.
constexpr std::size_t kBlock = 8;
using Block = Eigen::Array<double, kBlock, 1>;

std::array<Block, 12> gather(std::span<const RigidTransform> candidates) {
  std::array<Block, 12> entries_of;
  for (std::size_t lane = 0; lane < kBlock; ++lane) {
    const double* column = candidates[std::min(lane, candidates.size() - 1)].data();
    for (std::size_t i = 0; i < 12; ++i) entries_of[i][static_cast<Eigen::Index>(lane)] = column[4 * (i / 3) + i % 3];
  }
  return entries_of;
}

void same_size(std::size_t candidates, std::size_t out) {
  if (candidates != out)
    throw Error(ErrorCode::Contract, "scoring", Message::verbatim("as many values as candidates are expected"));
}

}  // namespace

double frobenius_sum(const std::vector<MotionPair>& pairs, const RigidTransform& ins_from_lidar,
                     double characteristic_length_m) {
  const double inverse_length2 = 1.0 / (characteristic_length_m * characteristic_length_m);
  double sum = 0.0;
  for (const MotionPair& pair : pairs) {
    const RigidTransform& p = pair.ins_b_from_ins_a;
    const RigidTransform& q = pair.lidar_b_from_lidar_a;
    const Eigen::Matrix3d rotation_error = p.linear() * ins_from_lidar.linear() - ins_from_lidar.linear() * q.linear();
    const Eigen::Vector3d translation_error =
        p * ins_from_lidar.translation() - ins_from_lidar * Eigen::Vector3d(q.translation());
    sum += std::sqrt(rotation_error.squaredNorm() + inverse_length2 * translation_error.squaredNorm());
  }
  return sum;
}

QuadraticForm::QuadraticForm(const std::vector<MotionPair>& pairs, double characteristic_length_m) {
  const double inverse_length = 1.0 / characteristic_length_m;
  for (const MotionPair& pair : pairs) {
    const Eigen::Matrix3d r_p = pair.ins_b_from_ins_a.linear(), r_q = pair.lidar_b_from_lidar_a.linear();
    // Rotation error: column c is R_P R's column c less R's columns weighted by column c of R_Q. Its squares,
    // multiplied out, are sums of 3x3 blocks: a sixth of the work of the product of its rows.
    const Eigen::Matrix3d p_squared = r_p.transpose() * r_p, q_squared = r_q * r_q.transpose();
    Matrix13d squares = Matrix13d::Zero();
    for (int k = 0; k < 3; ++k)
      for (int l = 0; l < 3; ++l) {
        auto block = squares.block<3, 3>(3 * k, 3 * l);
        block = -r_q(l, k) * r_p.transpose() - r_q(k, l) * r_p;
        block.diagonal().array() += q_squared(k, l);
        if (k == l) block += p_squared;
      }
    // Translation error, over the characteristic length: -R t_Q + (R_P - 1) t + t_P.
    const Eigen::Vector3d t_q = inverse_length * pair.lidar_b_from_lidar_a.translation();
    Eigen::Matrix<double, 3, 4> of_t;
    of_t << inverse_length * (r_p - Eigen::Matrix3d::Identity()), inverse_length * pair.ins_b_from_ins_a.translation();
    for (int k = 0; k < 3; ++k) {
      for (int l = 0; l < 3; ++l) squares.block<3, 3>(3 * k, 3 * l).diagonal().array() += t_q[k] * t_q[l];
      squares.block<3, 4>(3 * k, 9) = -t_q[k] * of_t;
      squares.block<4, 3>(9, 3 * k) = -t_q[k] * of_t.transpose();
    }
    squares.block<4, 4>(9, 9) = of_t.transpose() * of_t;
    form_ += pair.weight * squares;
  }
  constexpr double kRelativeFloor = 1e-9;
  translation_inverse_ = pseudo_inverse(form_.block<3, 3>(9, 9), kRelativeFloor);
  const Eigen::Matrix<double, 3, 9> t_from_r = form_.block<3, 9>(9, 0);
  const Eigen::Vector3d t_constant = form_.block<3, 1>(9, 12);
  reduced_quadratic_ = form_.block<9, 9>(0, 0) - t_from_r.transpose() * translation_inverse_ * t_from_r;
  reduced_linear_ = form_.block<9, 1>(0, 12) - t_from_r.transpose() * translation_inverse_ * t_constant;
  reduced_constant_ = form_(12, 12) - t_constant.dot(translation_inverse_ * t_constant);
}

double QuadraticForm::value(const RigidTransform& ins_from_lidar) const {
  Vector13d x;
  x << rotation_entries(ins_from_lidar.linear()), ins_from_lidar.translation(), 1.0;
  return x.dot(form_ * x);
}

void QuadraticForm::values(std::span<const RigidTransform> ins_from_lidar, std::span<double> out) const {
  same_size(ins_from_lidar.size(), out.size());
  for (std::size_t first = 0; first < out.size(); first += kBlock) {
    const std::size_t count = std::min(kBlock, out.size() - first);
    const std::array<Block, 12> x = gather(ins_from_lidar.subspan(first, count));
    Block sum = Block::Constant(form_(12, 12));
    for (int row = 0; row < 12; ++row) {
      // The form is symmetric: the diagonal once, the upper triangle twice.
      Block line = Block::Constant(form_(row, 12));
      for (int column = row + 1; column < 12; ++column) line += form_(row, column) * x[index_at(column)];
      const Block& here = x[index_at(row)];
      sum += here * (form_(row, row) * here + 2.0 * line);
    }
    for (std::size_t lane = 0; lane < count; ++lane) out[first + lane] = sum[static_cast<Eigen::Index>(lane)];
  }
}

TranslationGrid QuadraticForm::prepare_grid(std::span<const Eigen::Vector3d> translations_m) const {
  const auto count = static_cast<Eigen::Index>(translations_m.size());
  TranslationGrid grid{Eigen::ArrayXd(count), Eigen::ArrayXd(count), Eigen::ArrayXd(count), Eigen::ArrayXd(count)};
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Vector3d& t = translations_m[index_at(i)];
    grid.x_m[i] = t.x();
    grid.y_m[i] = t.y();
    grid.z_m[i] = t.z();
    grid.quadratic[i] = t.dot(form_.block<3, 3>(9, 9) * t);
  }
  return grid;
}

void QuadraticForm::values_on_grid(const Eigen::Matrix3d& rotation, const TranslationGrid& grid,
                                   std::span<double> out) const {
  same_size(static_cast<std::size_t>(grid.quadratic.size()), out.size());
  const Vector9d r = rotation_entries(rotation);
  const Vector9d r_constant = form_.block<9, 1>(0, 12);
  const double constant = r.dot(form_.block<9, 9>(0, 0) * r + 2.0 * r_constant) + form_(12, 12);
  const Eigen::Vector3d slope = 2.0 * (form_.block<3, 9>(9, 0) * r + form_.block<3, 1>(9, 12));
  Eigen::Map<Eigen::ArrayXd>(out.data(), grid.quadratic.size()) =
      grid.quadratic + slope.x() * grid.x_m + slope.y() * grid.y_m + slope.z() * grid.z_m + constant;
}

Eigen::Vector3d QuadraticForm::best_translation_m(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& near_m,
                                                  double relative_floor) const {
  const Eigen::Matrix3d block = form_.block<3, 3>(9, 9);
  const Eigen::Vector3d pull = form_.block<3, 9>(9, 0) * rotation_entries(rotation) + form_.block<3, 1>(9, 12);
  return near_m - pseudo_inverse(block, relative_floor) * (block * near_m + pull);
}

QuadraticForm::Reduced QuadraticForm::reduced(const Eigen::Matrix3d& rotation) const {
  const Vector9d r = rotation_entries(rotation);
  const Vector9d half_gradient = reduced_quadratic_ * r + reduced_linear_;
  Eigen::Matrix<double, 9, 3> tangent;
  for (int axis = 0; axis < 3; ++axis)
    tangent.col(axis) = rotation_entries(skew(Eigen::Vector3d::Unit(axis)) * rotation);
  Reduced out;
  out.value = r.dot(half_gradient + reduced_linear_) + reduced_constant_;
  out.gradient = 2.0 * tangent.transpose() * half_gradient;
  out.curvature = 2.0 * tangent.transpose() * reduced_quadratic_ * tangent;
  return out;
}

}  // namespace remount::search
