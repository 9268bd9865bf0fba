#include "algorithms/cloud/ground_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <vector>

#include "algorithms/cloud/level_frame.h"
#include "algorithms/core/index.h"
#include "algorithms/geometry/rotation.h"

namespace remount::cloud {
namespace {

using Eigen::Vector3d;

// Mean of the ground's points in each cell: near the sensor points lie a hundred times denser than at the edge, and
// what is seen from nearby is not more of the ground.
std::vector<Vector3d> cell_means(const std::vector<Vector3d>& points, double radius_m) {
  constexpr double kCell_m = 1.0;
  const int half = static_cast<int>(std::ceil(radius_m / kCell_m)), side = 2 * half;
  std::vector<Vector3d> sums(cell_count(side, side), Vector3d::Zero());
  std::vector<int> counts(sums.size(), 0);
  for (const Vector3d& p : points) {
    const int column = static_cast<int>(std::floor(p.x() / kCell_m)) + half,
              row = static_cast<int>(std::floor(p.y() / kCell_m)) + half;
    if (column < 0 || row < 0 || column >= side || row >= side) continue;
    const std::size_t cell = cell_at(row, column, side);
    sums[cell] += p;
    ++counts[cell];
  }
  constexpr int kFewest = 4;
  std::vector<Vector3d> means;
  for (std::size_t cell = 0; cell < sums.size(); ++cell)
    if (counts[cell] >= kFewest) means.push_back(sums[cell] / counts[cell]);
  return means;
}

constexpr double kLimit_m = 0.15;  // farther from the plane a point is no ground

// z = c0 x + c1 y + c2, by iteratively reweighted least squares (Tukey).
struct LevelPlane {
  Vector3d coefficients = Vector3d::Zero();
  double rms_m = 0.0;
  bool valid = false;
};

LevelPlane fit_plane(const std::vector<Vector3d>& points) {
  constexpr int kRounds = 10;
  LevelPlane plane;
  for (int round = 0; round < kRounds; ++round) {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Vector3d side = Vector3d::Zero();
    double weights = 0.0, sum2 = 0.0;
    for (const Vector3d& p : points) {
      const Vector3d row(p.x(), p.y(), 1.0);
      const double residual = p.z() - row.dot(plane.coefficients);
      const double ratio2 = round == 0 ? 0.0 : residual * residual / (kLimit_m * kLimit_m);
      if (ratio2 >= 1.0) continue;
      const double weight = (1.0 - ratio2) * (1.0 - ratio2);
      normal += weight * row * row.transpose();
      side += weight * p.z() * row;
      weights += weight;
      sum2 += weight * residual * residual;
    }
    const Eigen::LDLT<Eigen::Matrix3d> factors(normal);
    // Points in a line do not hold a plane.
    constexpr double kFewest = 20.0, kLeastSpread_m2 = 1.0;
    plane.valid =
        weights >= kFewest && factors.info() == Eigen::Success && factors.vectorD().minCoeff() > kLeastSpread_m2;
    if (!plane.valid) return plane;
    plane.coefficients = factors.solve(side);
    plane.rms_m = std::sqrt(sum2 / weights);
  }
  return plane;
}

// Whether the ground lies around the sensor: below it, a plane that is held on one side only is a guess.
bool surrounds_sensor(const std::vector<Vector3d>& points, const LevelPlane& plane) {
  constexpr double kWidestGap_rad = 150.0 / 180.0 * kPi;  // half a plane leaves 180 deg, a car beside the sensor 90
  std::vector<double> azimuths_rad;
  for (const Vector3d& p : points)
    if (std::abs(p.z() - Vector3d(p.x(), p.y(), 1.0).dot(plane.coefficients)) < kLimit_m)
      azimuths_rad.push_back(std::atan2(p.y(), p.x()));
  if (azimuths_rad.empty()) return false;
  std::sort(azimuths_rad.begin(), azimuths_rad.end());
  double gap_rad = azimuths_rad.front() + 2.0 * kPi - azimuths_rad.back();
  for (std::size_t i = 1; i < azimuths_rad.size(); ++i)
    gap_rad = std::max(gap_rad, azimuths_rad[i] - azimuths_rad[i - 1]);
  return gap_rad < kWidestGap_rad;
}

}  // namespace

std::optional<GroundFit> fit_ground(const PointCloud& cloud_in_lidar, const Eigen::Vector3f& up_in_lidar,
                                    const ObjectOptions& options, double radius_m) {
  const std::vector<bool> mask = ground_mask(cloud_in_lidar, up_in_lidar, options);
  const Eigen::Matrix3d level = level_from_lidar(up_in_lidar).cast<double>();
  std::vector<Vector3d> ground;
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (!mask[i]) continue;
    const Vector3d p = level * cloud_in_lidar.points[i].cast<double>();
    if (p.head<2>().norm() < radius_m) ground.push_back(p);
  }
  const std::vector<Vector3d> means = cell_means(ground, radius_m);
  const LevelPlane plane = fit_plane(means);
  if (!plane.valid || !surrounds_sensor(means, plane)) return std::nullopt;
  const Vector3d up_level = Vector3d(-plane.coefficients.x(), -plane.coefficients.y(), 1.0).normalized();
  return GroundFit{level.transpose() * up_level, -plane.coefficients.z() * up_level.z(),
                   static_cast<int>(ground.size()), plane.rms_m};
}

}  // namespace remount::cloud
