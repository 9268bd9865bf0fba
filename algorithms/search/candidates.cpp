#include "algorithms/search/candidates.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

#include "algorithms/core/decompositions.h"
#include "algorithms/core/symmetric_eigen.h"
#include "algorithms/geometry/shortest_rotation.h"
#include "algorithms/search/certified_search.h"

namespace remount::search {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Least change of `near_m` that satisfies the stacked equations (R_P - I) t = R t_Q - t_P where they determine t.
Vector3d translation_near(const std::vector<MotionPair>& pairs, const Matrix3d& rotation, const Vector3d& near_m,
                          double relative_floor) {
  Eigen::MatrixXd matrix(3 * pairs.size(), 3);
  Eigen::VectorXd side(3 * pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(3 * i);
    matrix.middleRows<3>(row) = pairs[i].ins_b_from_ins_a.linear() - Matrix3d::Identity();
    side.segment<3>(row) =
        rotation * pairs[i].lidar_b_from_lidar_a.translation() - pairs[i].ins_b_from_ins_a.translation();
  }
  Eigen::JacobiSVD<Eigen::MatrixXd> svd = singular_values(matrix, Eigen::ComputeThinU | Eigen::ComputeThinV);
  svd.setThreshold(relative_floor);
  return near_m + least_norm_solution(svd, side - matrix * near_m);
}

// Rotation that best takes the vectors `from` to `to` (Kabsch), and the singular values of their correlation.
std::pair<Matrix3d, Vector3d> kabsch(const std::vector<Vector3d>& from, const std::vector<Vector3d>& to) {
  Matrix3d correlation = Matrix3d::Zero();
  for (std::size_t i = 0; i < from.size(); ++i) correlation += to[i] * from[i].transpose();
  const Eigen::JacobiSVD<Matrix3d> svd = singular_values(correlation);
  Matrix3d u = svd.matrixU();
  if ((u * svd.matrixV().transpose()).determinant() < 0.0) u.col(2) = -u.col(2);
  return {u * svd.matrixV().transpose(), svd.singularValues()};
}

struct DualQuaternion {
  Eigen::Vector4d real, dual;  // w x y z
};

Eigen::Vector4d product(const Eigen::Vector4d& a, const Eigen::Vector4d& b) {
  const Eigen::Quaterniond q = Eigen::Quaterniond(a[0], a[1], a[2], a[3]) * Eigen::Quaterniond(b[0], b[1], b[2], b[3]);
  return {q.w(), q.x(), q.y(), q.z()};
}

DualQuaternion to_dual_quaternion(const RigidTransform& transform) {
  Eigen::Quaterniond q(transform.linear());
  if (q.w() < 0.0) q.coeffs() = -q.coeffs();  // scalar parts of both motions must agree in sign
  const Vector3d t = transform.translation();
  const Eigen::Vector4d real(q.w(), q.x(), q.y(), q.z());
  return {real, 0.5 * product(Eigen::Vector4d(0.0, t.x(), t.y(), t.z()), real)};
}

}  // namespace

RigidTransform single_pair_candidate(const MotionPair& pair, const RigidTransform& nominal, double min_rotation_rad) {
  const Vector3d phi_p = so3_log(pair.ins_b_from_ins_a.linear()), phi_q = so3_log(pair.lidar_b_from_lidar_a.linear());
  if (std::min(phi_p.norm(), phi_q.norm()) > min_rotation_rad) {
    const Matrix3d rotation =
        shortest_rotation(Vector3d(nominal.linear() * phi_q.normalized()), phi_p.normalized()) * nominal.linear();
    return make_rigid(rotation, translation_near({pair}, rotation, nominal.translation(), 1e-6));
  }
  const Vector3d t_p = pair.ins_b_from_ins_a.translation(), t_q = pair.lidar_b_from_lidar_a.translation();
  if (t_p.norm() < 1e-9 || t_q.norm() < 1e-9) return nominal;
  return make_rigid(
      shortest_rotation(Vector3d(nominal.linear() * t_q.normalized()), t_p.normalized()) * nominal.linear(),
      nominal.translation());
}

std::optional<RigidTransform> two_pair_candidate(const MotionPair& first, const MotionPair& second,
                                                 const RigidTransform& nominal, double min_rotation_rad,
                                                 double min_axis_angle_rad) {
  std::vector<Vector3d> axes_p, axes_q;
  for (const MotionPair* pair : {&first, &second}) {
    const Vector3d phi_p = so3_log(pair->ins_b_from_ins_a.linear()),
                   phi_q = so3_log(pair->lidar_b_from_lidar_a.linear());
    if (std::min(phi_p.norm(), phi_q.norm()) <= min_rotation_rad) return std::nullopt;
    axes_p.push_back(phi_p.normalized());
    axes_q.push_back(phi_q.normalized());
  }
  if (std::min(axes_p[0].cross(axes_p[1]).norm(), axes_q[0].cross(axes_q[1]).norm()) < std::sin(min_axis_angle_rad))
    return std::nullopt;
  // The cross product as a third direction makes the best rotation unique.
  axes_p.push_back(axes_p[0].cross(axes_p[1]).normalized());
  axes_q.push_back(axes_q[0].cross(axes_q[1]).normalized());
  const Matrix3d rotation = kabsch(axes_q, axes_p).first;
  return make_rigid(rotation, translation_near({first, second}, rotation, nominal.translation(), 1e-6));
}

std::optional<RigidTransform> park_martin(const std::vector<MotionPair>& pairs, const RigidTransform& nominal) {
  std::vector<Vector3d> from, to;
  for (const MotionPair& pair : pairs) {
    from.push_back(so3_log(pair.lidar_b_from_lidar_a.linear()));
    to.push_back(so3_log(pair.ins_b_from_ins_a.linear()));
  }
  const auto [rotation, singular] = kabsch(from, to);
  // The rotation needs two axes; a second singular value near zero means that all are parallel.
  if (!(singular[1] > 1e-4 * singular[0]) || !(singular[1] > 0.0)) return std::nullopt;
  return make_rigid(rotation, translation_near(pairs, rotation, nominal.translation(), 1e-3));
}

std::optional<RigidTransform> dual_quaternion(const std::vector<MotionPair>& pairs) {
  if (pairs.size() < 2) return std::nullopt;
  Eigen::Matrix<double, 8, 8> gram = Eigen::Matrix<double, 8, 8>::Zero();
  for (const MotionPair& pair : pairs) {
    const DualQuaternion p = to_dual_quaternion(pair.ins_b_from_ins_a),
                         q = to_dual_quaternion(pair.lidar_b_from_lidar_a);
    const Vector3d a = p.real.tail<3>(), a_dual = p.dual.tail<3>(), b = q.real.tail<3>(), b_dual = q.dual.tail<3>();
    Eigen::Matrix<double, 6, 8> rows = Eigen::Matrix<double, 6, 8>::Zero();
    rows.block<3, 1>(0, 0) = a - b;
    rows.block<3, 3>(0, 1) = skew(a + b);
    rows.block<3, 1>(3, 0) = a_dual - b_dual;
    rows.block<3, 3>(3, 1) = skew(a_dual + b_dual);
    rows.block<3, 1>(3, 4) = a - b;
    rows.block<3, 3>(3, 5) = skew(a + b);
    gram.noalias() += rows.transpose() * rows;
  }
  const auto eigen = symmetric_eigen(Eigen::MatrixXd(gram));
  const auto& values = eigen.eigenvalues();
  // Parallel axes leave four dimensions: on exact data the third value then is nothing but rounding.
  constexpr double kRounding = 1e-12;
  if (!(values[2] > kRounding * values[7]) || values[1] > 0.2 * values[2]) return std::nullopt;
  const Eigen::Matrix<double, 8, 1> first = eigen.eigenvectors().col(0), second = eigen.eigenvectors().col(1);
  const Eigen::Vector4d u1 = first.head<4>(), v1 = first.tail<4>(), u2 = second.head<4>(), v2 = second.tail<4>();
  // l1 first + l2 second must have a unit real part orthogonal to its dual part: a quadratic in s = l1 / l2.
  const double a = u1.dot(v1), b = u1.dot(v2) + u2.dot(v1), c = u2.dot(v2);
  const double root = std::sqrt(std::max(0.0, b * b - 4.0 * a * c));
  Eigen::Vector2d best = Eigen::Vector2d::Zero();
  double largest = 0.0;
  const std::vector<Eigen::Vector2d> ratios =
      std::abs(a) > 1e-15 ? std::vector<Eigen::Vector2d>{{(-b + root) / (2.0 * a), 1.0}, {(-b - root) / (2.0 * a), 1.0}}
                          : std::vector<Eigen::Vector2d>{{1.0, 0.0}, {-c, b}};
  for (const Eigen::Vector2d& ratio : ratios) {
    const double norm2 = (ratio[0] * u1 + ratio[1] * u2).squaredNorm() / ratio.squaredNorm();
    if (std::isfinite(norm2) && norm2 > largest) {
      largest = norm2;
      best = ratio / (ratio[0] * u1 + ratio[1] * u2).norm();
    }
  }
  if (!(largest > 1e-6)) return std::nullopt;
  const Eigen::Vector4d real = best[0] * u1 + best[1] * u2, dual = best[0] * v1 + best[1] * v2;
  const Eigen::Vector4d conjugate(real[0], -real[1], -real[2], -real[3]);
  const Eigen::Vector4d translation = 2.0 * product(dual, conjugate);
  return make_rigid(Eigen::Quaterniond(real[0], real[1], real[2], real[3]).normalized().toRotationMatrix(),
                    translation.tail<3>());
}

RigidTransform joint_quadratic(const QuadraticForm& form, const Vector3d& near_m) {
  Matrix3d best = Matrix3d::Identity();
  double least = std::numeric_limits<double>::infinity();
  // A net finer than the basins of a form of second degree on the rotations: every 45 degrees of each angle.
  for (int yaw = 0; yaw < 8; ++yaw)
    for (int pitch = -1; pitch <= 1; ++pitch)
      for (int roll = 0; roll < 8; ++roll) {
        Matrix3d rotation = rotation_from_yaw_pitch_roll({yaw * kPi / 4.0, pitch * kPi / 4.0, roll * kPi / 4.0});
        QuadraticForm::Reduced here = form.reduced(rotation);
        double damping = 1e-3;
        for (int iteration = 0; iteration < 50; ++iteration) {
          const Matrix3d damped = here.curvature + damping * (here.curvature.trace() + 1e-300) * Matrix3d::Identity();
          const Vector3d step = -damped.ldlt().solve(here.gradient);
          const Matrix3d trial = so3_exp(step) * rotation;
          const QuadraticForm::Reduced there = form.reduced(trial);
          if (there.value < here.value) {
            rotation = trial;
            here = there;
            damping = std::max(1e-12, damping * 0.1);
          } else {
            damping *= 10.0;
          }
          if (step.norm() < 1e-10 || damping > 1e6) break;
        }
        if (here.value < least) {
          least = here.value;
          best = rotation;
        }
      }
  best = nearest_rotation(best);
  return make_rigid(best, form.best_translation_m(best, near_m, 1e-4));
}

void rank_candidates(std::vector<calibration::Candidate>& candidates, const std::vector<MotionPair>& pairs,
                     const calibration::SearchRange& range, const calibration::SolveOptions& options) {
  for (calibration::Candidate& candidate : candidates) {
    candidate.out_of_range = calibration::outside_range(candidate.ins_from_lidar, range);
    candidate.in_range = candidate.out_of_range.empty();
    candidate.frobenius_sum = frobenius_sum(pairs, candidate.ins_from_lidar, options.characteristic_length_m);
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const calibration::Candidate& left, const calibration::Candidate& right) {
                     return left.in_range != right.in_range ? left.in_range : left.frobenius_sum < right.frobenius_sum;
                   });
}

std::vector<calibration::Candidate> find_candidates(const std::vector<MotionPair>& pairs,
                                                    const std::vector<motion::PairIndex>& pair_names,
                                                    const RigidTransform& nominal,
                                                    const calibration::SearchRange& range,
                                                    const calibration::SolveOptions& options,
                                                    const Progress& progress) {
  std::vector<calibration::Candidate> candidates;
  const auto add = [&](const calibration::MountingSource& source, const std::optional<RigidTransform>& found) {
    if (!found || !found->matrix().allFinite()) return;
    calibration::Candidate candidate;
    candidate.source = source;
    candidate.ins_from_lidar = *found;
    candidates.push_back(std::move(candidate));
  };
  const double min_rotation_rad = 30.0 * degrees_to_radians(options.ins_attitude_sigma_deg);
  for (std::size_t i = 0; i < pairs.size(); ++i)
    add(calibration::MountingSource::pair(pair_names[i]), single_pair_candidate(pairs[i], nominal, min_rotation_rad));
  // Two-pair candidates: the pairs with the largest rotations, each with each.
  std::vector<std::size_t> order(pairs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::vector<double> angle_rad;
  for (const MotionPair& pair : pairs) angle_rad.push_back(so3_log(pair.ins_b_from_ins_a.linear()).norm());
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t l, std::size_t r) { return angle_rad[l] > angle_rad[r]; });
  constexpr std::size_t kLargest = 24;
  for (std::size_t i = 0; i < std::min(order.size(), kLargest); ++i)
    for (std::size_t j = i + 1; j < std::min(order.size(), kLargest); ++j)
      add(calibration::MountingSource::pairs(pair_names[order[i]], pair_names[order[j]]),
          two_pair_candidate(pairs[order[i]], pairs[order[j]], nominal, min_rotation_rad, degrees_to_radians(5.0)));
  if (!pairs.empty()) {
    add(calibration::MountingSource::ParkMartin, park_martin(pairs, nominal));
    add(calibration::MountingSource::DualQuaternion, dual_quaternion(pairs));
    const QuadraticForm form(pairs, options.characteristic_length_m);
    add(calibration::MountingSource::JointQuadratic, joint_quadratic(form, nominal.translation()));
    const SearchResult searched = certified_search(form, range, nominal, {}, progress);
    if (searched.outcome == SearchOutcome::Certified || searched.outcome == SearchOutcome::GapOpen) {
      const bool proved = searched.outcome == SearchOutcome::Certified;
      const std::size_t before = candidates.size();
      add(proved ? calibration::MountingSource::CertifiedOptimum : calibration::MountingSource::BestInRange,
          searched.ins_from_lidar);
      if (candidates.size() > before) candidates.back().certified_gap = searched.relative_gap();
    }
  }
  rank_candidates(candidates, pairs, range, options);
  return candidates;
}

}  // namespace remount::search
