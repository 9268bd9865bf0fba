// small_gicp (Koide, MIT) beside our engine, where REMOUNT_SMALL_GICP_DIR names a checkout at configuration. Benchmarks
// only: nothing of it is in the product.
#pragma once

#include "tests/benchmark/pair_sets.h"

namespace remount::testing::small_gicp_peer {

bool available();
/// Thinning, tree and covariances of one scan, one thread.
std::size_t prepare_scan(const cloud::PointCloud& cloud_in_lidar);
/// Covariances and voxel maps of every scan of the set, from the same thinned points as ours; kept until the next call.
void prepare_set(const DataSet& data);
/// One thread, its own stop criteria. Both scans must be of the set prepared last.
RigidTransform align_gicp(const registration::PreparedCloud& source, const registration::PreparedCloud& target,
                          const RigidTransform& start);
RigidTransform align_vgicp(const registration::PreparedCloud& source, const registration::PreparedCloud& target,
                           const RigidTransform& start);

enum class Algorithm { Gicp, Vgicp };
/// Places of two scans in a list of clouds, and where the alignment starts.
struct ScanPair {
  std::size_t source = 0, target = 0;
  RigidTransform target_from_source_start = RigidTransform::Identity();
};
/// target_from_source of each pair, from points as they were measured: every scan is prepared once.
std::vector<RigidTransform> register_scans(const std::vector<cloud::PointCloud>& clouds_in_lidar,
                                           const std::vector<ScanPair>& pairs, Algorithm algorithm, int threads);

}  // namespace remount::testing::small_gicp_peer
