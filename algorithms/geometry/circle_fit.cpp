#include "algorithms/geometry/circle_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <optional>

#include "algorithms/core/decompositions.h"
#include "algorithms/core/median.h"
#include "algorithms/core/symmetric_eigen.h"
#include "algorithms/geometry/lasting_errors.h"
#include "messages/motion.h"

namespace remount {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

struct Plane {
  Vector3d centre = Vector3d::Zero();
  Matrix3d axes = Matrix3d::Identity();  // columns: in the plane twice, then the normal
  Vector3d spread2 = Vector3d::Zero();   // of the points along them
};

Plane plane_of(const std::vector<Vector3d>& points, const std::vector<bool>& used) {
  Plane plane;
  double count = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (used[i]) plane.centre += points[i], count += 1.0;
  plane.centre /= count;
  Matrix3d scatter = Matrix3d::Zero();
  for (std::size_t i = 0; i < points.size(); ++i)
    if (used[i]) scatter += (points[i] - plane.centre) * (points[i] - plane.centre).transpose();
  const auto eigen = symmetric_eigen(Matrix3d(scatter / count));
  plane.axes << eigen.eigenvectors().col(2), eigen.eigenvectors().col(1), eigen.eigenvectors().col(0);
  if (plane.axes.determinant() < 0.0) plane.axes.col(2) = -plane.axes.col(2);
  plane.spread2 << eigen.eigenvalues()[2], eigen.eigenvalues()[1], eigen.eigenvalues()[0];
  return plane;
}

struct Circle {
  Vector2d centre = Vector2d::Zero();
  double radius = 0.0;
  Matrix3d information = Matrix3d::Zero();  // of centre and radius, for unit noise
};

// Points around their own mean: |p|^2 = 2 c.p + (r^2 - |c|^2) is linear in c and the bracket.
Circle algebraic(const std::vector<Vector2d>& points, const std::vector<bool>& used) {
  Matrix3d left = Matrix3d::Zero();
  Vector3d right = Vector3d::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!used[i]) continue;
    const Vector3d row(2.0 * points[i].x(), 2.0 * points[i].y(), 1.0);
    left += row * row.transpose();
    right += points[i].squaredNorm() * row;
  }
  const Vector3d solution = least_norm_solution(left, right);
  return {solution.head<2>(), std::sqrt(std::max(0.0, solution[2] + solution.head<2>().squaredNorm())), {}};
}

double sigma_of(const std::vector<double>& offsets, const std::vector<bool>& used) {
  std::vector<double> sizes;
  for (std::size_t i = 0; i < offsets.size(); ++i)
    if (used[i]) sizes.push_back(std::abs(offsets[i]));
  return std::max(1e-12, 1.4826 * median_of(sizes));
}

void refine(const std::vector<Vector2d>& points, const std::vector<bool>& used, Circle& circle) {
  constexpr int kRounds = 30;
  for (int round = 0; round < kRounds; ++round) {
    std::vector<double> offsets;
    offsets.reserve(points.size());
    for (const Vector2d& point : points) offsets.push_back((point - circle.centre).norm() - circle.radius);
    const double limit = 2.0 * sigma_of(offsets, used);
    Matrix3d normal = Matrix3d::Zero();
    Vector3d gradient = Vector3d::Zero();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vector2d out = points[i] - circle.centre;
      if (!used[i] || out.norm() < 1e-12) continue;
      const double weight = std::min(1.0, limit / std::max(1e-300, std::abs(offsets[i])));
      const Vector3d row(-out.x() / out.norm(), -out.y() / out.norm(), -1.0);
      normal += weight * row * row.transpose();
      gradient += weight * offsets[i] * row;
    }
    circle.information = normal;
    const Vector3d step = -least_norm_solution(normal, gradient);
    circle.centre += step.head<2>();
    circle.radius += step[2];
    if (step.norm() < 1e-12 * (1.0 + circle.radius)) break;
  }
}

// All of the circle but its largest hole.
double covered_rad(std::vector<double> angles) {
  std::sort(angles.begin(), angles.end());
  double hole = angles.front() + 2.0 * kPi - angles.back();
  for (std::size_t i = 1; i < angles.size(); ++i) hole = std::max(hole, angles[i] - angles[i - 1]);
  return 2.0 * kPi - hole;
}

double root_mean_square(const std::vector<double>& values, const std::vector<bool>& used, double unknowns) {
  double sum = 0.0, count = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (used[i]) sum += values[i] * values[i], count += 1.0;
  return std::sqrt(sum / std::max(1.0, count - unknowns));
}

double lasting(const std::vector<double>& offsets, const std::vector<bool>& used) {
  constexpr double kTaken = 3.0;  // unknowns of circle or plane
  std::vector<double> kept;
  for (std::size_t i = 0; i < offsets.size(); ++i)
    if (used[i]) kept.push_back(offsets[i]);
  return lasting_factor(kept, kTaken);
}

void describe(const std::vector<Vector3d>& points, const std::vector<bool>& used, const Plane& plane,
              const Circle& circle, CircleFit& fit) {
  std::vector<double> in_plane, off_plane, angles;
  double turned = 0.0;
  std::optional<Vector2d> before;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector3d local = plane.axes.transpose() * (points[i] - plane.centre);
    const Vector2d out = local.head<2>() - circle.centre;
    in_plane.push_back(out.norm() - circle.radius);
    off_plane.push_back(local.z());
    if (!used[i]) continue;
    angles.push_back(std::atan2(out.y(), out.x()));
    if (before) turned += std::atan2(before->x() * out.y() - before->y() * out.x(), before->dot(out));
    before = out;
    ++fit.inliers;
  }
  fit.found = true;
  fit.centre_m = plane.centre + plane.axes.leftCols<2>() * circle.centre;
  fit.axis = turned < 0.0 ? Vector3d(-plane.axes.col(2)) : Vector3d(plane.axes.col(2));
  fit.radius_m = circle.radius;
  fit.arc_rad = covered_rad(angles);
  fit.in_plane_rms_m = root_mean_square(in_plane, used, 3.0);
  fit.off_plane_rms_m = root_mean_square(off_plane, used, 3.0);
  const auto count = static_cast<double>(fit.inliers);
  const double in2 = fit.in_plane_rms_m * fit.in_plane_rms_m * lasting(in_plane, used),
               off2 = fit.off_plane_rms_m * fit.off_plane_rms_m * lasting(off_plane, used);
  const Matrix3d spread = in2 * pseudo_inverse(circle.information);
  fit.radius_sigma_m = std::sqrt(spread(2, 2));
  const Eigen::Matrix<double, 3, 2> basis = plane.axes.leftCols<2>();
  // Along the axis the centre lies where the plane does; off the mean of the points it tilts with it.
  double along2 = off2 / count;
  for (int k = 0; k < 2; ++k)
    along2 += off2 / count * std::pow(circle.centre[k], 2) / std::max(plane.spread2[k], 1e-12);
  fit.centre_covariance_m2 = basis * spread.topLeftCorner<2, 2>() * basis.transpose() +
                             along2 * plane.axes.col(2) * plane.axes.col(2).transpose();
  for (int k = 0; k < 2; ++k) {
    const Vector3d about = fit.axis.cross(plane.axes.col(k));
    fit.axis_covariance_rad2 += off2 / count / std::max(plane.spread2[k], 1e-12) * about * about.transpose();
  }
}

}  // namespace

CircleFit fit_circle(const std::vector<Vector3d>& points_m) {
  CircleFit fit;
  constexpr std::size_t kFewest = 8;
  if (points_m.size() < kFewest) {
    fit.why = say::circle_few_poses(points_m.size());
    return fit;
  }
  std::vector<bool> used(points_m.size(), true);
  Plane plane;
  Circle circle;
  constexpr int kRounds = 5;
  for (int round = 0; round < kRounds; ++round) {
    plane = plane_of(points_m, used);
    std::vector<Vector2d> flat;
    std::vector<double> off_circle, off_plane;
    for (const Vector3d& point : points_m) {
      const Vector3d local = plane.axes.transpose() * (point - plane.centre);
      flat.push_back(local.head<2>());
      off_plane.push_back(local.z());
    }
    circle = algebraic(flat, used);
    refine(flat, used, circle);
    for (const Vector2d& point : flat) off_circle.push_back((point - circle.centre).norm() - circle.radius);
    // Ten micrometres: exact points are not told apart by rounding.
    const double most_off = std::max(1e-5, 5.0 * sigma_of(off_circle, used));
    const double most_high = std::max(1e-5, 5.0 * sigma_of(off_plane, used));
    std::vector<bool> kept(points_m.size());
    std::size_t count = 0;
    for (std::size_t i = 0; i < kept.size(); ++i) {
      kept[i] = std::abs(off_circle[i]) <= most_off && std::abs(off_plane[i]) <= most_high;
      count += kept[i];
    }
    if (kept == used || count < kFewest) break;
    used = kept;
  }
  if (plane.spread2[1] <= 1e-12 || !std::isfinite(circle.radius)) {
    fit.why = say::circle_on_a_line();
    return fit;
  }
  describe(points_m, used, plane, circle, fit);
  return fit;
}

}  // namespace remount
