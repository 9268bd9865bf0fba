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

std::map<const PreparedCloud*, Scan>& scans() {
  static std::map<const PreparedCloud*, Scan> all;
  return all;
}

using Registration = small_gicp::Registration<small_gicp::GICPFactor, small_gicp::SerialReduction>;

Registration registration() {
  Registration out;
  out.rejector.max_dist_sq = kCorrespondence_m * kCorrespondence_m;
  out.optimizer.max_iterations = kIterations;
  return out;
}

}  // namespace

bool available() { return true; }

std::size_t prepare_scan(const PointCloud& cloud_in_lidar) {
  const RegistrationOptions options;
  Cloud points;
  std::vector<Eigen::Vector4d> used;
  for (const Eigen::Vector3f& p : cloud_in_lidar.points) {
    const double range_m = p.norm();
    if (range_m >= options.min_range_m && range_m <= options.max_range_m) used.emplace_back(p.x(), p.y(), p.z(), 1.0);
  }
  points.points = std::move(used);
  const auto thinned = small_gicp::voxelgrid_sampling(points, kVoxel_m);
  const Tree tree(thinned);
  small_gicp::estimate_covariances(*thinned, tree, kNeighbours);
  return thinned->size();
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
    scan.voxels = std::make_shared<small_gicp::GaussianVoxelMap>(kGaussianVoxel_m);
    scan.voxels->insert(*scan.cloud);
    scans()[prepared.get()] = std::move(scan);
  }
}

RigidTransform align_gicp(const PreparedCloud& source, const PreparedCloud& target, const RigidTransform& start) {
  const Scan &from = scans().at(&source), &to = scans().at(&target);
  return registration().align(*to.cloud, *from.cloud, *to.tree, start).T_target_source;
}

RigidTransform align_vgicp(const PreparedCloud& source, const PreparedCloud& target, const RigidTransform& start) {
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

}  // namespace remount::testing::small_gicp_peer
#endif
