#include "algorithms/quality/surface_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "algorithms/core/median.h"
#include "algorithms/registration/matcher.h"

namespace remount::quality {
namespace {

constexpr double kVoxel_m = 0.2;
constexpr float kPlane = 0.5F;  // planarity above which a normal says more than the nearest point
constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();
constexpr auto kBlock = static_cast<std::size_t>(registration::kBlockSize);

registration::RegistrationOptions surface_options() {
  registration::RegistrationOptions options;
  options.voxel_m = kVoxel_m;
  options.min_range_m = 0.0;
  options.max_range_m = 1e4;
  return options;
}

/// Finite points, neighbours next to each other: a block of them is searched for at once.
std::vector<std::size_t> in_spatial_order(const std::vector<Eigen::Vector3f>& points) {
  constexpr float kCell_m = 2.0F, kMost = 1e6F;
  std::vector<std::pair<std::array<int, 3>, std::size_t>> cells;
  cells.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].allFinite()) continue;
    const Eigen::Vector3i cell =
        (points[i] / kCell_m).cwiseMax(-kMost).cwiseMin(kMost).array().floor().matrix().cast<int>();
    cells.push_back({{cell.x(), cell.y(), cell.z()}, i});
  }
  std::sort(cells.begin(), cells.end());
  std::vector<std::size_t> order(cells.size());
  std::transform(cells.begin(), cells.end(), order.begin(), [](const auto& cell) { return cell.second; });
  return order;
}

std::vector<registration::PointBlock> blocks_of(const std::vector<Eigen::Vector3f>& points,
                                                const std::vector<std::size_t>& order) {
  registration::PointBlock empty{};
  std::fill_n(empty.x, registration::kBlockSize, registration::kFarAway_m);
  std::fill_n(empty.y, registration::kBlockSize, registration::kFarAway_m);
  std::fill_n(empty.z, registration::kBlockSize, registration::kFarAway_m);
  std::vector<registration::PointBlock> blocks((order.size() + kBlock - 1) / kBlock, empty);
  for (std::size_t i = 0; i < order.size(); ++i) {
    registration::PointBlock& block = blocks[i / kBlock];
    const Eigen::Vector3f& point = points[order[i]];
    block.x[i % kBlock] = point.x();
    block.y[i % kBlock] = point.y();
    block.z[i % kBlock] = point.z();
  }
  return blocks;
}

/// Positive before a plane: normals look to the LiDAR.
float signed_distance_m(const registration::MatchBlock& match, std::size_t lane) {
  if (match.index[lane] < 0) return kNothing;
  const registration::PointBlock& target = match.target;
  const Eigen::Vector3f apart(match.at_x[lane] - target.x[lane], match.at_y[lane] - target.y[lane],
                              match.at_z[lane] - target.z[lane]);
  const float nearest_m = apart.norm();
  if (nearest_m > SurfaceDistance::kReach_m) return kNothing;
  if (target.planarity[lane] < kPlane) return nearest_m;
  return apart.dot(Eigen::Vector3f(target.nx[lane], target.ny[lane], target.nz[lane]));
}

}  // namespace

SurfaceDistance::SurfaceDistance(const cloud::PointCloud& target_in_lidar, const Progress& progress)
    : target_(std::make_unique<const registration::PreparedCloud>(target_in_lidar, surface_options(),
                                                                  std::vector<bool>{}, progress)) {}
SurfaceDistance::~SurfaceDistance() = default;
SurfaceDistance::SurfaceDistance(SurfaceDistance&&) noexcept = default;
SurfaceDistance& SurfaceDistance::operator=(SurfaceDistance&&) noexcept = default;

std::vector<float> SurfaceDistance::of(const std::vector<Eigen::Vector3f>& points_in_source,
                                       const RigidTransform& target_from_source, const Progress& progress) const {
  std::vector<float> distances_m = signed_of(points_in_source, target_from_source, progress);
  for (float& distance : distances_m) distance = std::abs(distance);
  return distances_m;
}

std::vector<float> SurfaceDistance::signed_of(const std::vector<Eigen::Vector3f>& points_in_source,
                                              const RigidTransform& target_from_source,
                                              const Progress& progress) const {
  std::vector<float> distances_m(points_in_source.size(), kNothing);
  if (target_->size() == 0) return distances_m;
  const std::vector<std::size_t> order = in_spatial_order(points_in_source);
  const std::vector<registration::PointBlock> source = blocks_of(points_in_source, order);
  registration::Matcher matcher(source, *target_, kReach_m, registration::InstructionSet::Best);
  matcher.update(target_from_source, 1, progress);
  if (progress.cancelled()) return {};
  for (std::size_t i = 0; i < order.size(); ++i)
    distances_m[order[i]] = signed_distance_m(matcher.matches()[i / kBlock], i % kBlock);
  return distances_m;
}

float median_distance_m(std::vector<float> distances_m) {
  std::erase_if(distances_m, [](float distance) { return std::isnan(distance); });
  if (distances_m.empty()) return kNothing;
  for (float& distance : distances_m) distance = std::abs(distance);
  return median_of(std::move(distances_m));
}

}  // namespace remount::quality
