#include "algorithms/odometry/fusion/feature_map.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <nanoflann.hpp>
#include <optional>

#include "algorithms/core/parallel.h"
#include "algorithms/registration/voxel_grid.h"

namespace remount::odometry {
namespace {

constexpr std::size_t kNeighbours = 5;
constexpr std::size_t kChunk = 64;  // features a task
constexpr double kFlat_m = 0.1;

// Centre and axes of the neighbours; eigenvalues ascending, m^2.
struct Spread {
  Eigen::Vector3d centre;
  Eigen::Vector3d values;
  Eigen::Matrix3d axes;
};

Spread spread_of(const std::array<Eigen::Vector3f, kNeighbours>& points) {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3f& point : points) centre += point.cast<double>();
  centre /= static_cast<double>(kNeighbours);
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3f& point : points) {
    const Eigen::Vector3d arm = point.cast<double>() - centre;
    scatter += arm * arm.transpose();
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen;
  eigen.computeDirect(scatter / static_cast<double>(kNeighbours));
  return {centre, eigen.eigenvalues(), eigen.eigenvectors()};
}

std::optional<FeatureMatch> line_match(const Spread& spread, const Eigen::Vector3d& point_in_map) {
  if (spread.values[1] > kFlat_m * kFlat_m || spread.values[2] < 9.0 * spread.values[1] ||
      spread.values[2] < 0.05 * 0.05)
    return std::nullopt;
  FeatureMatch match;
  match.centre = spread.centre;
  match.direction = spread.axes.col(2);
  match.distance_m = match.direction.cross(point_in_map - spread.centre).norm();
  return match;
}

std::optional<FeatureMatch> plane_match(const Spread& spread, const Eigen::Vector3d& point_in_map) {
  // Neighbours along one beam have no plane.
  if (spread.values[0] > kFlat_m * kFlat_m || spread.values[1] < 0.04 * spread.values[2] ||
      spread.values[0] > 0.1 * spread.values[1])
    return std::nullopt;
  FeatureMatch match;
  match.centre = spread.centre;
  match.direction = spread.axes.col(0);
  match.distance_m = std::abs(match.direction.dot(point_in_map - spread.centre));
  return match;
}

// Evenly over the list, the same ones each time.
std::vector<Eigen::Vector3f> at_most(const std::vector<Eigen::Vector3f>& points, std::size_t most) {
  if (points.size() <= most) return points;
  std::vector<Eigen::Vector3f> kept(most);
  for (std::size_t i = 0; i < most; ++i) kept[i] = points[i * points.size() / most];
  return kept;
}

}  // namespace

class FeatureMap::Tree {
 public:
  explicit Tree(std::vector<Eigen::Vector3f> points) : points_(std::move(points)) {
    if (points_.size() >= kNeighbours) index_.emplace(3, *this, nanoflann::KDTreeSingleIndexAdaptorParams(16));
  }
  std::size_t kdtree_get_point_count() const { return points_.size(); }
  float kdtree_get_pt(std::size_t i, std::size_t axis) const { return points_[i][static_cast<Eigen::Index>(axis)]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
  std::size_t size() const { return points_.size(); }

  std::optional<std::array<Eigen::Vector3f, kNeighbours>> neighbours(const Eigen::Vector3f& at, float within_m) const {
    if (!index_) return std::nullopt;
    std::array<std::size_t, kNeighbours> found{};
    std::array<float, kNeighbours> distance2{};
    nanoflann::KNNResultSet<float, std::size_t> result(kNeighbours);
    result.init(found.data(), distance2.data());
    index_->findNeighbors(result, at.data(), {});  // the name of its parameters differs between versions
    if (result.size() < kNeighbours || distance2.back() > within_m * within_m) return std::nullopt;
    std::array<Eigen::Vector3f, kNeighbours> points;
    for (std::size_t k = 0; k < kNeighbours; ++k) points[k] = points_[found[k]];
    return points;
  }

  template <class Fit>
  std::vector<FeatureMatch> match(const std::vector<Eigen::Vector3f>& points_in_vehicle,
                                  const RigidTransform& map_from_vehicle, double within_m, int threads,
                                  Fit&& fit) const {
    std::vector<std::optional<FeatureMatch>> found(points_in_vehicle.size());
    parallel_for((points_in_vehicle.size() + kChunk - 1) / kChunk, threads, [&](std::size_t chunk) {
      for (std::size_t i = chunk * kChunk; i < std::min((chunk + 1) * kChunk, points_in_vehicle.size()); ++i) {
        const Eigen::Vector3d in_vehicle = points_in_vehicle[i].cast<double>();
        const Eigen::Vector3d in_map = map_from_vehicle * in_vehicle;
        const auto near = neighbours(in_map.cast<float>(), static_cast<float>(within_m));
        if (near) found[i] = fit(spread_of(*near), in_map);
        if (found[i]) found[i]->point_in_vehicle = in_vehicle;
      }
    });
    std::vector<FeatureMatch> matches;
    for (const auto& match : found)
      if (match) matches.push_back(*match);
    return matches;
  }

 private:
  std::vector<Eigen::Vector3f> points_;
  std::optional<nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, Tree>, Tree, 3, std::size_t>>
      index_;
};

FeatureMap::FeatureMap() = default;
FeatureMap::~FeatureMap() = default;
FeatureMap::FeatureMap(FeatureMap&&) noexcept = default;
FeatureMap& FeatureMap::operator=(FeatureMap&&) noexcept = default;

void FeatureMap::add(ScanFeatures features_in_vehicle, const RigidTransform& odometry_from_vehicle,
                     const FusionOptions& options) {
  frames_.push_back({odometry_from_vehicle, std::move(features_in_vehicle)});
  while (frames_.size() > static_cast<std::size_t>(options.map_frames)) frames_.pop_front();
}

void FeatureMap::move(const RigidTransform& odometry_from_odometry_before) {
  for (Frame& frame : frames_)
    frame.odometry_from_vehicle = odometry_from_odometry_before * frame.odometry_from_vehicle;
}

void FeatureMap::rebuild(const FusionOptions& options) {
  origin_ = frames_.empty() ? Eigen::Vector3d::Zero().eval() : frames_.back().odometry_from_vehicle.translation();
  const auto gather = [this](std::vector<Eigen::Vector3f> ScanFeatures::*kind, double voxel_m) {
    std::vector<Eigen::Vector3f> all;
    for (const Frame& frame : frames_) {
      const Eigen::Matrix3f turn = frame.odometry_from_vehicle.linear().cast<float>();
      const Eigen::Vector3f shift = (frame.odometry_from_vehicle.translation() - origin_).cast<float>();
      for (const Eigen::Vector3f& point : frame.features.*kind) all.push_back(turn * point + shift);
    }
    return std::make_unique<Tree>(registration::voxel_centroids(all, static_cast<float>(voxel_m)));
  };
  lines_ = gather(&ScanFeatures::lines, options.line_voxel_m);
  planes_ = gather(&ScanFeatures::planes, options.plane_voxel_m);
}

FeatureMatches FeatureMap::match(const ScanFeatures& features_in_vehicle, const RigidTransform& odometry_from_vehicle,
                                 double within_m, const FusionOptions& options, int threads) const {
  FeatureMatches matches;
  if (!lines_ || !planes_) return matches;
  const RigidTransform about_origin =
      make_rigid(odometry_from_vehicle.linear(), odometry_from_vehicle.translation() - origin_);
  if (options.lines)
    matches.lines = lines_->match(at_most(features_in_vehicle.lines, static_cast<std::size_t>(options.most_lines)),
                                  about_origin, within_m, threads, line_match);
  if (options.planes)
    matches.planes = planes_->match(at_most(features_in_vehicle.planes, static_cast<std::size_t>(options.most_planes)),
                                    about_origin, within_m, threads, plane_match);
  for (FeatureMatch& match : matches.lines) match.centre += origin_;
  for (FeatureMatch& match : matches.planes) match.centre += origin_;
  return matches;
}

std::size_t FeatureMap::line_points() const { return lines_ ? lines_->size() : 0; }
std::size_t FeatureMap::plane_points() const { return planes_ ? planes_->size() : 0; }

}  // namespace remount::odometry
