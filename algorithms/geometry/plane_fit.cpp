#include "algorithms/geometry/plane_fit.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <random>

#include "algorithms/core/median.h"
#include "messages/motion.h"

namespace remount {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

struct TrialPlane {
  Vector3d normal, centre;
};

bool allowed(const Vector3d& normal, const PlaneFitOptions& options) {
  if (options.near_normal && std::abs(normal.dot(*options.near_normal)) < std::cos(options.most_lean_rad)) return false;
  return !options.square_to || std::abs(normal.dot(*options.square_to)) <= std::sin(options.most_lean_rad);
}

// Truncated squares: among planes with as many points the thinner one wins.
double cost_of(const TrialPlane& plane, const std::vector<Vector3d>& points, std::size_t stride, double inlier_m) {
  double cost = 0.0;
  for (std::size_t i = 0; i < points.size(); i += stride) {
    const double off = plane.normal.dot(points[i] - plane.centre) / inlier_m;
    cost += std::min(1.0, off * off);
  }
  return cost;
}

std::optional<TrialPlane> best_of_trials(const std::vector<Vector3d>& points, const PlaneFitOptions& options,
                                         const Progress& progress) {
  constexpr std::size_t kMostScored = 4000;
  const std::size_t stride = std::max<std::size_t>(1, points.size() / kMostScored);
  std::mt19937_64 random(static_cast<std::uint64_t>(options.seed));
  const auto pick = [&] { return points[static_cast<std::size_t>(random() % points.size())]; };
  std::optional<TrialPlane> best;
  double least = 0.0;
  for (int trial = 0; trial < options.trials && !progress.cancelled(); ++trial) {
    const Vector3d a = pick(), b = pick(), c = pick();
    const Vector3d across = (b - a).cross(c - a);
    const double area = across.norm();
    if (area < 1e-9) continue;
    const TrialPlane plane{across / area, a};
    if (!allowed(plane.normal, options)) continue;
    const double cost = cost_of(plane, points, stride, options.inlier_m);
    if (best && cost >= least) continue;
    best = plane;
    least = cost;
  }
  return best;
}

// Tukey's biweight.
double weight_of(const TrialPlane& plane, const Vector3d& point, double inlier_m) {
  const double share = plane.normal.dot(point - plane.centre) / inlier_m;
  return std::abs(share) < 1.0 ? std::pow(1.0 - share * share, 2) : 0.0;
}

struct Moments {
  double weight = 0.0, stiffness = 0.0, squares = 0.0;
  Vector3d mean = Vector3d::Zero();
  Matrix3d scatter = Matrix3d::Zero();
  std::size_t inliers = 0;
};

Moments moments_of(const TrialPlane& plane, const std::vector<Vector3d>& points, double inlier_m) {
  Moments sum;
  for (const Vector3d& point : points) {
    const double weight = weight_of(plane, point, inlier_m);
    if (weight <= 0.0) continue;
    sum.mean += weight * point;
    sum.weight += weight;
    ++sum.inliers;
  }
  if (sum.weight <= 0.0) return sum;
  sum.mean /= sum.weight;
  for (const Vector3d& point : points) {
    const double weight = weight_of(plane, point, inlier_m);
    if (weight <= 0.0) continue;
    sum.scatter += weight * (point - sum.mean) * (point - sum.mean).transpose();
    const double off = plane.normal.dot(point - sum.mean);
    sum.squares += off * off;
    const double share2 = off * off / (inlier_m * inlier_m);
    sum.stiffness += (1.0 - share2) * (1.0 - 5.0 * share2);
  }
  return sum;
}

// Covariance of offset and slopes along the axes: of an estimate with a soft limit (Huber 1964), squared pull over
// squared stiffness, which falls off faster than the weights do; pulls of one spot are added before they are squared
// (Liang and Zeger 1986). docs/maths/slew.md (M2)
Matrix3d spread_of(const TrialPlane& plane, const Eigen::SelfAdjointEigenSolver<Matrix3d>& eigen, const Moments& sum,
                   const std::vector<Vector3d>& points, const std::vector<std::size_t>& spots, double inlier_m) {
  const Matrix3d& axes = eigen.eigenvectors();
  const Vector3d& spread2 = eigen.eigenvalues();
  const std::size_t count = spots.empty() ? points.size() : 1 + *std::max_element(spots.begin(), spots.end());
  std::vector<Vector3d> pulls(count, Vector3d::Zero());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double weight = weight_of(plane, points[i], inlier_m);
    if (weight <= 0.0) continue;
    const Vector3d out = points[i] - sum.mean;
    pulls[spots.empty() ? i : spots[i]] +=
        weight * plane.normal.dot(out) * Vector3d(1.0, axes.col(1).dot(out), axes.col(2).dot(out));
  }
  Matrix3d squares = Matrix3d::Zero();
  double used = 0.0;
  for (const Vector3d& pull : pulls) squares += pull * pull.transpose(), used += pull.isZero(0.0) ? 0.0 : 1.0;
  constexpr double kUnknowns = 3.0;
  squares *= used / std::max(1.0, used - kUnknowns);
  const double stiffness = std::max(sum.stiffness, 0.1 * sum.weight);
  const Vector3d compliance =
      Vector3d(1.0, 1.0 / std::max(spread2[1], 1e-12), 1.0 / std::max(spread2[2], 1e-12)) / stiffness;
  return compliance.asDiagonal() * squares * compliance.asDiagonal();
}

// Where the points are finer than the limit allows for, a plane next to this one (the stick beside the boom) would
// tilt it: the limit follows the scatter.
double limit_of(const TrialPlane& plane, const std::vector<Vector3d>& points, double inlier_m) {
  std::vector<double> off;
  for (const Vector3d& point : points) {
    const double distance = std::abs(plane.normal.dot(point - plane.centre));
    if (distance < inlier_m) off.push_back(distance);
  }
  if (off.empty()) return inlier_m;
  return std::clamp(3.5 * 1.4826 * median_of(std::move(off)), 0.2 * inlier_m, inlier_m);
}

}  // namespace

PlaneFit fit_plane(const std::vector<Vector3d>& points_m, const PlaneFitOptions& options,
                   const std::vector<std::size_t>& spots, const Progress& progress) {
  PlaneFit fit;
  constexpr std::size_t kFewest = 10;
  if (points_m.size() < kFewest) {
    fit.why = say::plane_few_points(points_m.size());
    return fit;
  }
  const std::optional<TrialPlane> start = best_of_trials(points_m, options, progress);
  if (!start) {
    fit.why = progress.cancelled() ? say::fit_cancelled() : say::plane_of_other_direction();
    return fit;
  }
  TrialPlane plane = *start;
  double limit_m = options.inlier_m;
  Moments sum;
  Eigen::SelfAdjointEigenSolver<Matrix3d> eigen;
  constexpr int kRounds = 20;
  for (int round = 0; round < kRounds; ++round) {
    limit_m = limit_of(plane, points_m, options.inlier_m);
    sum = moments_of(plane, points_m, limit_m);
    if (sum.inliers < kFewest) {
      fit.why = say::plane_few_inliers(sum.inliers);
      return fit;
    }
    eigen.compute(sum.scatter / sum.weight);
    plane = {eigen.eigenvectors().col(0), sum.mean};
  }
  if (!allowed(plane.normal, options)) {
    fit.why = say::plane_of_other_direction();
    return fit;
  }
  fit.found = true;
  fit.normal = plane.normal.dot(plane.centre) > 0.0 ? Vector3d(-plane.normal) : plane.normal;
  fit.centre_m = plane.centre;
  fit.long_axis = eigen.eigenvectors().col(2);
  fit.long_extent_m = std::sqrt(std::max(0.0, eigen.eigenvalues()[2]));
  fit.short_extent_m = std::sqrt(std::max(0.0, eigen.eigenvalues()[1]));
  fit.inliers = sum.inliers;
  fit.rms_m = std::sqrt(sum.squares / static_cast<double>(sum.inliers));
  const Matrix3d spread = spread_of(plane, eigen, sum, points_m, spots, limit_m);
  fit.offset_sigma_m = std::sqrt(spread(0, 0));
  // The normal leans against a slope along an axis about the other one.
  Eigen::Matrix<double, 3, 2> turned_about;
  for (int k = 1; k <= 2; ++k) turned_about.col(k - 1) = fit.normal.cross(eigen.eigenvectors().col(k));
  fit.normal_covariance_rad2 = turned_about * spread.bottomRightCorner<2, 2>() * turned_about.transpose();
  return fit;
}

}  // namespace remount
