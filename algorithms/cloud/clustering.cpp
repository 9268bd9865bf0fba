#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>

#include "algorithms/cloud/level_frame.h"
#include "algorithms/cloud/objects.h"
#include "algorithms/core/index.h"

namespace remount::cloud {

using Eigen::Vector2f;
using Eigen::Vector3f;

namespace {

/// Beams leave gaps that grow with range: points above one another are linked over more than points side by side.
constexpr float kUpwardsReach = 4.0f;
constexpr float kPiece_m = 5.0f;  ///< edge of the pieces of too large clusters, in cells of the ground

constexpr float kMostColumns = 2000.0f;  ///< from the sensor to the longest range: bounds the memory of the grid

/// A point of the level plane's grid, and the points of the cloud in it.
struct Voxel {
  int column = 0, row = 0, layer = 0;
  Vector3f sum = Vector3f::Zero();  ///< level frame
  int count = 0;
  Vector3f mean() const { return sum / static_cast<float>(count); }
};

class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }
  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  /// The smaller index becomes the root, so that the outcome does not depend on the order of unions.
  void unite(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    if (a != b) parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

/// Points above the ground within range, thinned to voxels of half the cluster distance, sorted by column of the plane.
class VoxelGrid {
 public:
  VoxelGrid(const PointCloud& cloud, const Eigen::Matrix3f& level, const std::vector<bool>& ground,
            const ObjectOptions& options)
      : edge_m_(std::max(0.5f * static_cast<float>(options.cluster_distance_m),
                         static_cast<float>(options.max_range_m) / kMostColumns)),
        side_(2 * static_cast<int>(std::ceil(options.max_range_m / edge_m_)) + 1) {
    const float range2 = static_cast<float>(options.max_range_m * options.max_range_m);
    std::vector<std::pair<std::uint64_t, std::size_t>> keyed;
    std::vector<Vector3f> levelled;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      if (ground[i] || !(cloud.points[i].squaredNorm() < range2)) continue;
      const Vector3f p = level * cloud.points[i];
      keyed.emplace_back(key(p), points_.size());
      points_.push_back(static_cast<int>(i));
      levelled.push_back(p);
    }
    std::sort(keyed.begin(), keyed.end());
    voxel_of_.resize(points_.size());
    std::uint64_t last = ~std::uint64_t{0};
    for (const auto& [voxel_key, point] : keyed) {
      if (voxel_key != last) voxels.push_back(from_key(last = voxel_key));
      voxels.back().sum += levelled[point];
      ++voxels.back().count;
      voxel_of_[point] = static_cast<std::uint32_t>(voxels.size() - 1);
    }
    index_columns();
  }

  /// Calls body(a, b) for voxels a < b that may be within two voxel edges of one another in the plane.
  template <class Body>
  void for_neighbours(Body&& body) const {
    for (std::size_t a = 0; a < voxels.size(); ++a)
      for (int dy = -2; dy <= 2; ++dy)
        for (int dx = -2; dx <= 2; ++dx) {
          const int column = voxels[a].column + dx, row = voxels[a].row + dy;
          if (column < 0 || row < 0 || column >= side_ || row >= side_) continue;
          const std::size_t cell = cell_at(row, column, side_);
          for (std::size_t b = std::max<std::size_t>(begin_[cell], a + 1); b < begin_[cell + 1]; ++b) body(a, b);
        }
  }

  std::size_t point_count() const { return points_.size(); }
  int cloud_index(std::size_t point) const { return points_[point]; }
  std::uint32_t voxel_of(std::size_t point) const { return voxel_of_[point]; }

  std::vector<Voxel> voxels;

 private:
  std::uint64_t key(const Vector3f& p) const {
    const auto at = [&](float v) {
      return static_cast<std::uint64_t>(static_cast<int>(std::floor(v / edge_m_)) + side_ / 2);
    };
    return at(p.y()) << 40 | at(p.x()) << 20 | at(p.z());
  }
  static Voxel from_key(std::uint64_t key) {
    constexpr std::uint64_t mask = (1u << 20) - 1;
    Voxel voxel;
    voxel.row = static_cast<int>(key >> 40);
    voxel.column = static_cast<int>(key >> 20 & mask);
    voxel.layer = static_cast<int>(key & mask);
    return voxel;
  }
  void index_columns() {
    begin_.assign(cell_count(side_, side_) + 1, 0);
    for (const Voxel& voxel : voxels) ++begin_[cell_at(voxel.row, voxel.column, side_) + 1];
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  }

  float edge_m_;
  int side_;
  std::vector<int> points_;              ///< indices into the cloud
  std::vector<std::uint32_t> voxel_of_;  ///< of each of points_
  std::vector<std::uint32_t> begin_;     ///< first voxel of each column of the plane
};

struct Cluster {
  std::vector<int> points;  ///< indices into the cloud, ascending
  std::vector<std::uint32_t> voxels;
};

/// Cluster of each voxel: linked voxels share one, named by its lowest voxel.
std::vector<std::uint32_t> link_voxels(const VoxelGrid& grid, float distance_m) {
  DisjointSets sets(grid.voxels.size());
  std::vector<Vector3f> mean;
  for (const Voxel& voxel : grid.voxels) mean.push_back(voxel.mean());
  const float side2 = distance_m * distance_m, up = kUpwardsReach * distance_m;
  grid.for_neighbours([&](std::size_t a, std::size_t b) {
    const Vector3f d = mean[a] - mean[b];
    if (std::abs(d.z()) < up && d.head<2>().squaredNorm() < side2)
      sets.unite(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b));
  });
  std::vector<std::uint32_t> root(grid.voxels.size());
  for (std::size_t i = 0; i < root.size(); ++i) root[i] = sets.find(static_cast<std::uint32_t>(i));
  return root;
}

std::vector<Cluster> gather_clusters(const VoxelGrid& grid, const std::vector<std::uint32_t>& root) {
  std::vector<Cluster> clusters;
  std::vector<std::optional<std::size_t>> number(root.size());
  for (std::size_t voxel = 0; voxel < root.size(); ++voxel) {
    std::optional<std::size_t>& of_root = number[root[voxel]];
    if (!of_root) {
      of_root = clusters.size();
      clusters.emplace_back();
    }
    clusters[*of_root].voxels.push_back(static_cast<std::uint32_t>(voxel));
  }
  for (std::size_t i = 0; i < grid.point_count(); ++i)
    clusters[number[root[grid.voxel_of(i)]].value()].points.push_back(grid.cloud_index(i));
  return clusters;
}

/// Gives the voxels of too large clusters new roots, one for each piece of the plane.
void cut_large(const VoxelGrid& grid, const ObjectOptions& options, std::vector<std::uint32_t>& root) {
  std::vector<int> size(root.size(), 0);
  for (std::size_t voxel = 0; voxel < root.size(); ++voxel) size[root[voxel]] += grid.voxels[voxel].count;
  const float piece_m = kPiece_m * static_cast<float>(options.ground_cell_m);
  std::vector<std::pair<std::array<std::int64_t, 3>, std::uint32_t>> pieces;
  for (std::size_t voxel = 0; voxel < root.size(); ++voxel) {
    if (size[root[voxel]] <= options.max_points) continue;
    const Vector3f mean = grid.voxels[voxel].mean() / piece_m;
    pieces.push_back(
        {{root[voxel], std::llround(mean.x()), std::llround(mean.y())}, static_cast<std::uint32_t>(voxel)});
  }
  std::sort(pieces.begin(), pieces.end());
  for (std::size_t i = 0, first = 0; i < pieces.size(); ++i) {
    if (pieces[i].first != pieces[first].first) first = i;
    root[pieces[i].second] = pieces[first].second;
  }
}

ObjectShape shape_of(float height_m, float length_m, float width_m) {
  if (length_m < 0.9f) return height_m > 1.0f && height_m > 2.0f * length_m ? ObjectShape::Pole : ObjectShape::Small;
  if (length_m < 1.2f) return ObjectShape::Small;
  if (length_m < 6.5f && width_m < 3.0f && height_m < (width_m > 1.2f && length_m > 3.0f ? 3.0f : 2.0f))
    return ObjectShape::VehicleSized;
  return width_m < 0.35f * length_m ? ObjectShape::Facade : ObjectShape::Large;
}

/// Length, width and height of a cluster: along and across its direction in the plane, and upwards.
ObjectShape shape_of(const Cluster& cluster, const VoxelGrid& grid) {
  Vector2f mean = Vector2f::Zero();
  Eigen::Matrix2f moments = Eigen::Matrix2f::Zero();
  for (const std::uint32_t voxel : cluster.voxels) mean += grid.voxels[voxel].mean().head<2>();
  mean /= static_cast<float>(cluster.voxels.size());
  for (const std::uint32_t voxel : cluster.voxels) {
    const Vector2f d = grid.voxels[voxel].mean().head<2>() - mean;
    moments += d * d.transpose();
  }
  const Eigen::Matrix2f axes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2f>(moments).eigenvectors();
  Vector3f low = Vector3f::Constant(1e9f), high = -low;
  for (const std::uint32_t voxel : cluster.voxels) {
    const Vector3f p = grid.voxels[voxel].mean();
    const Vector2f turned = axes.transpose() * p.head<2>();
    const Vector3f q(turned.x(), turned.y(), p.z());
    low = low.cwiseMin(q);
    high = high.cwiseMax(q);
  }
  const Vector3f size = high - low;
  return shape_of(size.z(), size.y(), size.x());
}

SceneObject describe(const Cluster& cluster, const VoxelGrid& grid, const PointCloud& cloud,
                     const Eigen::Matrix3f& level) {
  SceneObject object;
  object.points = cluster.points;
  object.box_min_in_lidar = Vector3f::Constant(std::numeric_limits<float>::max());
  object.box_max_in_lidar = -object.box_min_in_lidar;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const int i : cluster.points) {
    const Vector3f& p = cloud.points[index_at(i)];
    object.box_min_in_lidar = object.box_min_in_lidar.cwiseMin(p);
    object.box_max_in_lidar = object.box_max_in_lidar.cwiseMax(p);
    sum += p.cast<double>();
  }
  object.centroid_in_lidar = (sum / static_cast<double>(cluster.points.size())).cast<float>();
  Eigen::Matrix3f covariance = Eigen::Matrix3f::Zero();
  for (const int i : cluster.points) {
    const Vector3f d = cloud.points[index_at(i)] - object.centroid_in_lidar;
    covariance += d * d.transpose();
  }
  covariance /= static_cast<float>(cluster.points.size());
  object.extent_m = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f>(covariance, Eigen::EigenvaluesOnly)
                        .eigenvalues()
                        .cwiseMax(0.0f)
                        .cwiseSqrt();
  object.shape = shape_of(cluster, grid);
  for (const std::uint32_t voxel : cluster.voxels)
    object.outline_in_lidar.push_back(level.transpose() * grid.voxels[voxel].mean());
  return object;
}

}  // namespace

std::vector<SceneObject> find_objects(const PointCloud& cloud_in_lidar, const Vector3f& up_in_lidar,
                                      const ObjectOptions& options) {
  const Eigen::Matrix3f level = level_from_lidar(up_in_lidar);
  const VoxelGrid grid(cloud_in_lidar, level, ground_mask(cloud_in_lidar, up_in_lidar, options), options);
  std::vector<std::uint32_t> root = link_voxels(grid, static_cast<float>(options.cluster_distance_m));
  cut_large(grid, options, root);
  std::vector<SceneObject> objects;
  for (const Cluster& cluster : gather_clusters(grid, root))
    if (static_cast<int>(cluster.points.size()) >= options.min_points)
      objects.push_back(describe(cluster, grid, cloud_in_lidar, level));
  return objects;
}

}  // namespace remount::cloud
