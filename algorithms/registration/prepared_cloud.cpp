#include "algorithms/registration/prepared_cloud.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nanoflann.hpp>
#include <numeric>

namespace remount {
namespace {

constexpr int kNormalNeighbours = 14;
// A neighbourhood this thin against its length is a line (one beam on far ground): it has no normal.
constexpr float kMinWidthRatio = 0.02f;

struct PointsAdaptor {
  const std::vector<Eigen::Vector3f>& points;
  std::size_t kdtree_get_point_count() const { return points.size(); }
  float kdtree_get_pt(std::size_t index, std::size_t dimension) const {
    return points[index][static_cast<int>(dimension)];
  }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

// Collects the two nearest neighbours within a radius.
class TwoNearest {
 public:
  using DistanceType = float;
  explicit TwoNearest(float radius2) : second_(radius2) {}
  bool full() const { return true; }
  float worstDist() const { return second_; }
  bool addPoint(float distance2, std::uint32_t index) {
    if (distance2 < first_) {
      second_ = std::min(first_, second_);
      first_ = distance2;
      index_ = static_cast<int>(index);
    } else {
      second_ = std::min(second_, distance2);
    }
    return true;
  }
  Neighbour neighbour() const { return {index_, std::sqrt(first_), std::sqrt(second_)}; }
  bool empty() const { return index_ < 0; }

 private:
  float first_ = std::numeric_limits<float>::infinity();
  float second_;
  int index_ = -1;
};

std::uint64_t voxel_key(const Eigen::Vector3f& point, float inverse_voxel) {
  // 21 bits an axis: 2^20 voxels to either side, beyond any range limit.
  const auto cell = [&](float v) {
    const long long index = static_cast<long long>(std::floor(v * inverse_voxel)) + (1LL << 20);
    return static_cast<std::uint64_t>(std::clamp(index, 0LL, (1LL << 21) - 1));
  };
  return (cell(point.z()) << 42) | (cell(point.y()) << 21) | cell(point.x());
}

}  // namespace

struct PreparedCloud::Tree {
  using Index =
      nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, PointsAdaptor>, PointsAdaptor, 3>;
  explicit Tree(const std::vector<Eigen::Vector3f>& points)
      : adaptor{points}, index(3, adaptor, nanoflann::KDTreeSingleIndexAdaptorParams(10)) {}
  PointsAdaptor adaptor;
  Index index;
};

std::vector<Eigen::Vector3f> voxel_centroids(const std::vector<Eigen::Vector3f>& points, float voxel_m) {
  std::vector<std::pair<std::uint64_t, std::uint32_t>> order(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    order[i] = {voxel_key(points[i], 1.0f / voxel_m), static_cast<std::uint32_t>(i)};
  std::sort(order.begin(), order.end());
  std::vector<Eigen::Vector3f> centroids;
  for (std::size_t begin = 0; begin < order.size();) {
    std::size_t end = begin;
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    for (; end < order.size() && order[end].first == order[begin].first; ++end) sum += points[order[end].second];
    centroids.push_back(sum / static_cast<float>(end - begin));
    begin = end;
  }
  return centroids;
}

PreparedCloud::PreparedCloud(const PointCloud& cloud_in_lidar, const RegistrationOptions& options,
                             const std::vector<bool>& left_out) {
  const auto min2 = static_cast<float>(options.min_range_m * options.min_range_m);
  const auto max2 = static_cast<float>(options.max_range_m * options.max_range_m);
  std::vector<Eigen::Vector3f> used;
  used.reserve(cloud_in_lidar.size());
  for (std::size_t i = 0; i < cloud_in_lidar.size(); ++i) {
    const float range2 = cloud_in_lidar.points[i].squaredNorm();
    if (range2 >= min2 && range2 <= max2 && (left_out.empty() || !left_out[i]))
      used.push_back(cloud_in_lidar.points[i]);
  }
  std::vector<Eigen::Vector3f> thinned = voxel_centroids(used, static_cast<float>(options.voxel_m));
  if (thinned.size() < static_cast<std::size_t>(kNormalNeighbours)) return;

  const Tree all(thinned);
  std::array<std::uint32_t, kNormalNeighbours> indices{};
  std::array<float, kNormalNeighbours> distances2{};
  for (const Eigen::Vector3f& point : thinned) {
    const std::size_t found = all.index.knnSearch(point.data(), kNormalNeighbours, indices.data(), distances2.data());
    Eigen::Vector3f mean = Eigen::Vector3f::Zero();
    for (std::size_t i = 0; i < found; ++i) mean += thinned[indices[i]] - point;
    mean /= static_cast<float>(found);
    Eigen::Matrix3f covariance = Eigen::Matrix3f::Zero();
    for (std::size_t i = 0; i < found; ++i) {
      const Eigen::Vector3f d = thinned[indices[i]] - point - mean;
      covariance += d * d.transpose();
    }
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> eigen;
    eigen.computeDirect(covariance);
    const Eigen::Vector3f& values = eigen.eigenvalues();
    if (!(values[1] > kMinWidthRatio * values[2])) continue;
    Eigen::Vector3f normal = eigen.eigenvectors().col(0);
    if (normal.dot(point) > 0.0f) normal = -normal;
    points_.push_back(point);
    normals_.push_back(normal);
    planarity_.push_back(1.0f - std::sqrt(std::max(0.0f, values[0]) / values[1]));
  }
  if (!points_.empty()) tree_ = std::make_unique<Tree>(points_);
}

PreparedCloud::~PreparedCloud() = default;

Neighbour PreparedCloud::nearest(const Eigen::Vector3f& query, float radius_m) const {
  TwoNearest found(radius_m * radius_m);
  if (tree_) tree_->index.findNeighbors(found, query.data(), nanoflann::SearchParams(0, 0.0f, false));
  return found.empty() ? Neighbour{} : found.neighbour();
}

std::size_t PreparedCloud::bytes() const {
  constexpr std::size_t kTreeBytesPerPoint = 24;
  return points_.capacity() * (2 * sizeof(Eigen::Vector3f) + sizeof(float) + kTreeBytesPerPoint);
}

}  // namespace remount
