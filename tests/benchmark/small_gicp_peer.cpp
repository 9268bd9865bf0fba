#include "tests/benchmark/small_gicp_peer.h"

#ifdef REMOUNT_HAS_SMALL_GICP
#include <map>
#include <small_gicp/ann/gaussian_voxelmap.hpp>
#include <small_gicp/ann/kdtree.hpp>
#include <small_gicp/factors/gicp_factor.hpp>
#include <small_gicp/points/point_cloud.hpp>
#include <small_gicp/registration/reduction.hpp>
#include <small_gicp/registration/registration.hpp>
#include <small_gicp/util/downsampling.hpp>
#include <small_gicp/util/normal_estimation.hpp>

#include "algorithms/core/parallel.h"

namespace remount::testing::small_gicp_peer {
namespace {

constexpr int kNeighbours = 20;
constexpr double kVoxel_m = 0.25, kGaussianVoxel_m = 1.0, kCorrespondence_m = 1.0;
constexpr int kIterations = 40;

using Cloud = small_gicp::PointCloud;
using Tree = small_gicp::KdTree<Cloud>;

struct Scan {
  Cloud::Ptr cloud;
  std::shared_ptr<Tree> tree;
  std::shared_ptr<small_gicp::GaussianVoxelMap> voxels;
};

std::map<const registration::PreparedCloud*, Scan>& scans() {
  static std::map<const registration::PreparedCloud*, Scan> all;
  return all;
}

using Registration = small_gicp::Registration<small_gicp::GICPFactor, small_gicp::SerialReduction>;

Registration registration() {
  Registration out;
  out.rejector.max_dist_sq = kCorrespondence_m * kCorrespondence_m;
  out.optimizer.max_iterations = kIterations;
  return out;
}

// Thinned, with the covariances of its points.
Cloud::Ptr thin(const cloud::PointCloud& cloud_in_lidar) {
  const registration::RegistrationOptions options;
  Cloud points;
  std::vector<Eigen::Vector4d> used;
  for (const Eigen::Vector3f& p : cloud_in_lidar.points) {
    const double range_m = p.norm();
    if (range_m >= options.min_range_m && range_m <= options.max_range_m) used.emplace_back(p.x(), p.y(), p.z(), 1.0);
  }
  points.points = std::move(used);
  return small_gicp::voxelgrid_sampling(points, kVoxel_m);
}

std::shared_ptr<small_gicp::GaussianVoxelMap> voxels_of(const Cloud& cloud) {
  auto voxels = std::make_shared<small_gicp::GaussianVoxelMap>(kGaussianVoxel_m);
  voxels->insert(cloud);
  return voxels;
}

}  // namespace

bool available() { return true; }

std::size_t prepare_scan(const cloud::PointCloud& cloud_in_lidar) {
  const Cloud::Ptr thinned = thin(cloud_in_lidar);
  const Tree tree(thinned);
  small_gicp::estimate_covariances(*thinned, tree, kNeighbours);
  return thinned->size();
}

std::vector<RigidTransform> register_scans(const std::vector<cloud::PointCloud>& clouds_in_lidar,
                                           const std::vector<ScanPair>& pairs, Algorithm algorithm, int threads) {
  std::vector<Scan> prepared(clouds_in_lidar.size());
  parallel_for(prepared.size(), threads, [&](std::size_t i) {
    Scan& scan = prepared[i];
    scan.cloud = thin(clouds_in_lidar[i]);
    scan.tree = std::make_shared<Tree>(scan.cloud);
    small_gicp::estimate_covariances(*scan.cloud, *scan.tree, kNeighbours);
    if (algorithm == Algorithm::Vgicp) scan.voxels = voxels_of(*scan.cloud);
  });
  std::vector<RigidTransform> found(pairs.size());
  parallel_for(pairs.size(), threads, [&](std::size_t i) {
    const Scan &from = prepared[pairs[i].source], &to = prepared[pairs[i].target];
    const RigidTransform& start = pairs[i].target_from_source_start;
    found[i] = algorithm == Algorithm::Gicp
                   ? registration().align(*to.cloud, *from.cloud, *to.tree, start).T_target_source
                   : registration().align(*to.voxels, *from.cloud, *to.voxels, start).T_target_source;
  });
  return found;
}

void prepare_set(const DataSet& data) {
  scans().clear();
  for (const auto& prepared : data.prepared) {
    Scan scan;
    scan.cloud = std::make_shared<Cloud>();
    scan.cloud->resize(prepared->size());
    for (std::size_t i = 0; i < prepared->size(); ++i) {
      const Eigen::Vector3d p = prepared->point(i).cast<double>();
      scan.cloud->points[i] = Eigen::Vector4d(p.x(), p.y(), p.z(), 1.0);
    }
    scan.tree = std::make_shared<Tree>(scan.cloud);
    small_gicp::estimate_covariances(*scan.cloud, *scan.tree, kNeighbours);
    scan.voxels = voxels_of(*scan.cloud);
    scans()[prepared.get()] = std::move(scan);
  }
}

RigidTransform align_gicp(const registration::PreparedCloud& source, const registration::PreparedCloud& target,
                          const RigidTransform& start) {
  const Scan &from = scans().at(&source), &to = scans().at(&target);
  return registration().align(*to.cloud, *from.cloud, *to.tree, start).T_target_source;
}

RigidTransform align_vgicp(const registration::PreparedCloud& source, const registration::PreparedCloud& target,
                           const RigidTransform& start) {
  const Scan &from = scans().at(&source), &to = scans().at(&target);
  return registration().align(*to.voxels, *from.cloud, *to.voxels, start).T_target_source;
}

}  // namespace remount::testing::small_gicp_peer
#else
namespace remount::testing::small_gicp_peer {

bool available() { return false; }
std::size_t prepare_scan(const cloud::PointCloud&) { return 0; }
void prepare_set(const DataSet&) {}
RigidTransform align_gicp(const registration::PreparedCloud&, const registration::PreparedCloud&,
                          const RigidTransform& start) {
  return start;
}
RigidTransform align_vgicp(const registration::PreparedCloud&, const registration::PreparedCloud&,
                           const RigidTransform& start) {
  return start;
}
std::vector<RigidTransform> register_scans(const std::vector<cloud::PointCloud>&, const std::vector<ScanPair>&,
                                           Algorithm, int) {
  return {};
}

}  // namespace remount::testing::small_gicp_peer
#endif
