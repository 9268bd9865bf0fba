#include "algorithms/registration/prepared_cloud.h"

#include <algorithm>
#include <cmath>

#include "algorithms/registration/matcher.h"
#include "algorithms/registration/voxel_grid.h"

namespace remount::registration {
namespace {

constexpr std::size_t kFewestPoints = 14;
// The neighbourhood of a normal, in voxels: some twenty points where the surface is fully covered.
constexpr float kNormalRadius_voxels = 2.4f;
constexpr std::int32_t kBlocksPerCheck = 512;

std::vector<Eigen::Vector3f> points_in_use(const cloud::PointCloud& cloud_in_lidar, const RegistrationOptions& options,
                                           const std::vector<bool>& left_out) {
  const auto min2 = static_cast<float>(options.min_range_m * options.min_range_m);
  const auto max2 = static_cast<float>(options.max_range_m * options.max_range_m);
  std::vector<Eigen::Vector3f> used;
  used.reserve(cloud_in_lidar.size());
  for (std::size_t i = 0; i < cloud_in_lidar.size(); ++i) {
    const float range2 = cloud_in_lidar.points[i].squaredNorm();
    // False for what is not a number.
    if (range2 >= min2 && range2 <= max2 && (left_out.empty() || !left_out[i]))
      used.push_back(cloud_in_lidar.points[i]);
  }
  return used;
}

void fit_normals(BlockTree& tree, const RegistrationOptions& options, const Progress& progress) {
  std::vector<std::int32_t> scratch(tree.blocks().size());
  const BlockTreeView view = tree.view();
  NormalTask task;
  task.blocks = tree.blocks().data();
  task.radius_m = kNormalRadius_voxels * static_cast<float>(options.voxel_m);
  task.scratch = scratch.data();
  for (task.first = 0; task.first < view.block_count && !progress.cancelled(); task.first = task.last) {
    task.last = std::min(task.first + kBlocksPerCheck, view.block_count);
    kernels(options.instructions).fit_normals(view, task);
  }
}

}  // namespace

PreparedCloud::PreparedCloud(const cloud::PointCloud& cloud_in_lidar, const RegistrationOptions& options,
                             const std::vector<bool>& left_out, const Progress& progress) {
  const std::vector<Eigen::Vector3f> thinned =
      voxel_centroids(points_in_use(cloud_in_lidar, options, left_out), static_cast<float>(options.voxel_m), progress);
  if (thinned.size() < kFewestPoints) return;
  BlockTree tree(thinned, progress);
  fit_normals(tree, options, progress);
  if (progress.cancelled()) return;
  tree.drop_points_without_surface();
  tree_ = std::move(tree);
}

Eigen::Vector3f PreparedCloud::point(std::size_t i) const {
  const PointBlock& block = block_of(i);
  return {block.x[lane_of(i)], block.y[lane_of(i)], block.z[lane_of(i)]};
}

Eigen::Vector3f PreparedCloud::normal(std::size_t i) const {
  const PointBlock& block = block_of(i);
  return {block.nx[lane_of(i)], block.ny[lane_of(i)], block.nz[lane_of(i)]};
}

std::vector<Eigen::Vector3f> PreparedCloud::copy_points() const {
  std::vector<Eigen::Vector3f> out(size());
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = point(i);
  return out;
}

Neighbour PreparedCloud::nearest(const Eigen::Vector3f& query, float radius_m) const {
  std::vector<PointBlock> source(1, BlockTree({query}).blocks().front());
  Matcher matcher(source, *this, radius_m, InstructionSet::Best);
  matcher.update(RigidTransform::Identity(), 1, {});
  const MatchBlock& match = matcher.matches().front();
  Neighbour found{match.index[0], 0.0f, std::sqrt(std::max(0.0f, match.reach2_m2[0]))};
  if (found.index >= 0) found.distance_m = (point(static_cast<std::size_t>(found.index)) - query).norm();
  return found.distance_m <= radius_m ? found : Neighbour{-1, 0.0f, 0.0f};
}

std::size_t PreparedCloud::bytes() const { return sizeof *this + tree_.bytes(); }

}  // namespace remount::registration
