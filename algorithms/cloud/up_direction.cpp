#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <random>
#include <unordered_set>

#include "algorithms/cloud/objects.h"

namespace remount::cloud {

using Eigen::Vector3f;

namespace {

constexpr float kNear_m = 25.0f;       ///< the ground farther away may slope differently
constexpr float kVoxel_m = 0.5f;       ///< one point each, so that a plane counts by its area and not by its density
constexpr float kThickness_m = 0.12f;  ///< ground within this of a plane belongs to it
constexpr float kLowest_m = 0.4f, kHighest_m = 5.0f;  ///< height of a sensor above the ground
constexpr int kTrials = 600;
constexpr float kLeastShare = 0.08f;

struct Plane {
  Vector3f normal = Vector3f::Zero();  ///< towards the sensor
  float sensor_height_m = 0.0f;
};

std::vector<Vector3f> thin(const PointCloud& cloud) {
  std::vector<Vector3f> kept;
  std::unordered_set<std::uint64_t> taken;
  for (const Vector3f& p : cloud.points) {
    if (!(p.squaredNorm() < kNear_m * kNear_m)) continue;
    std::uint64_t key = 0;
    for (int axis = 0; axis < 3; ++axis)
      key = key << 20 | static_cast<std::uint64_t>(std::floor(p[axis] / kVoxel_m) + 512.0f);
    if (taken.insert(key).second) kept.push_back(p);
  }
  return kept;
}

/// Points of the plane less those well below it: below the ground there is nothing.
float score(const Plane& plane, const std::vector<Vector3f>& points, const Vector3f& hint) {
  int on = 0, below = 0;
  for (const Vector3f& p : points) {
    const float height = plane.normal.dot(p) + plane.sensor_height_m;
    on += std::abs(height) < kThickness_m;
    below += height < -4.0f * kThickness_m;
  }
  const float preference = hint.isZero() ? 1.0f : 1.0f + 0.15f * plane.normal.dot(hint);
  return (static_cast<float>(on) - 1.5f * static_cast<float>(below)) * preference;
}

/// The plane through the points near the given one, by least squares.
Plane refit(const Plane& plane, const std::vector<Vector3f>& points) {
  Vector3f mean = Vector3f::Zero();
  Eigen::Matrix3f moments = Eigen::Matrix3f::Zero();
  int count = 0;
  for (const Vector3f& p : points) {
    if (std::abs(plane.normal.dot(p) + plane.sensor_height_m) > 2.0f * kThickness_m) continue;
    mean += p;
    moments += p * p.transpose();
    ++count;
  }
  if (count < 10) return plane;
  mean /= static_cast<float>(count);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> solver(moments / static_cast<float>(count) -
                                                              mean * mean.transpose());
  Vector3f normal = solver.eigenvectors().col(0);
  if (normal.dot(plane.normal) < 0.0f) normal = -normal;
  return {normal, -normal.dot(mean)};
}

}  // namespace

GroundPlane estimate_ground_plane(const PointCloud& cloud_in_lidar, const Vector3f& hint) {
  const GroundPlane fallback{hint.isZero() ? Vector3f(Vector3f::UnitZ()) : hint, 0.0f, false};
  const std::vector<Vector3f> points = thin(cloud_in_lidar);
  if (points.size() < 30) return fallback;
  std::mt19937 random(
      20260101u);  // its numbers are the same everywhere; distributions are not, hence the remainder below
  const auto pick = [&] { return points[random() % points.size()]; };
  Plane best;
  float best_score = kLeastShare * static_cast<float>(points.size());
  for (int trial = 0; trial < kTrials; ++trial) {
    const Vector3f a = pick(), b = pick(), c = pick();
    Vector3f normal = (b - a).cross(c - a);
    if (normal.norm() < 4.0f) continue;  // m^2: too small or too slim a triangle
    normal.normalize();
    if (normal.dot(a) > 0.0f) normal = -normal;
    const Plane plane{normal, -normal.dot(a)};
    if (plane.sensor_height_m < kLowest_m || plane.sensor_height_m > kHighest_m) continue;
    const float found = score(plane, points, hint);
    if (found <= best_score) continue;
    best_score = found;
    best = plane;
  }
  if (best.normal.isZero()) return fallback;
  for (int i = 0; i < 3; ++i) best = refit(best, points);
  return {best.normal, best.sensor_height_m, true};
}

Vector3f estimate_up(const PointCloud& cloud_in_lidar, const Vector3f& hint) {
  return estimate_ground_plane(cloud_in_lidar, hint).up_in_lidar;
}

}  // namespace remount::cloud
