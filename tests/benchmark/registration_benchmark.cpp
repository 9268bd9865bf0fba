// Own registration beside PCL's on the same pairs in the same run, one thread each unless it says otherwise.
// Counters: median_mm, median_mdeg = errors (street: against the truth; kitti: against the own result from a good
// start), x_ours = time against the own engine's, failed = pairs that ended more than 0.2 m off.
#include <benchmark/benchmark.h>
#include <pcl/features/normal_3d.h>
#include <pcl/filters/voxel_grid.h>
#include <pcl/registration/gicp.h>
#include <pcl/registration/icp.h>
#include <pcl/registration/ndt.h>

#include <ctime>
#include <functional>
#include <map>

#include "algorithms/core/parallel.h"
#include "algorithms/registration/registration.h"
#include "tests/benchmark/pair_sets.h"
#include "tests/benchmark/small_gicp_peer.h"

namespace remount::testing {
namespace {

const DataSet& data_set(bool kitti) {
  static const DataSet street = make_street(24), recorded = make_kitti({"05", "07", "10"}, 2);
  return kitti ? recorded : street;
}

// Time of the own engine by data set, for ratios; its benchmarks are registered first.
std::map<std::string, double>& own_seconds() {
  static std::map<std::string, double> seconds;
  return seconds;
}

using Align = std::function<RigidTransform(const registration::PreparedCloud&, const registration::PreparedCloud&,
                                           const RigidTransform&)>;

void run_pairs(benchmark::State& state, bool kitti, bool own, const Align& align) {
  const DataSet& data = data_set(kitti);
  if (data.pairs.empty()) return state.SkipWithError("no recorded data");
  std::vector<double> errors_mm, errors_mdeg;
  double failed = 0.0, seconds = 0.0;
  std::size_t runs = 0;
  for (auto _ : state) {
    for (const BenchmarkPair& pair : data.pairs) {
      const std::clock_t before = std::clock();
      const RigidTransform found = align(*data.prepared[pair.source], *data.prepared[pair.target], pair.start);
      seconds += static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
      const Vector6d error = difference(pair.truth, found);
      errors_mm.push_back(1e3 * error.head<3>().norm());
      errors_mdeg.push_back(1e3 * radians_to_degrees(error.tail<3>().norm()));
      failed += error.head<3>().norm() > 0.2 ? 1.0 : 0.0;
      ++runs;
    }
  }
  seconds /= static_cast<double>(runs);
  const std::string key = kitti ? "align kitti" : "align street";
  if (own) own_seconds()[key] = seconds;
  state.counters["ms_per_pair"] = 1e3 * seconds;
  state.counters["x_ours"] = seconds / own_seconds()[key];
  state.counters["median_mm"] = median(errors_mm);
  state.counters["median_mdeg"] = median(errors_mdeg);
  state.counters["failed_share"] = failed / static_cast<double>(runs);
}

using Points = pcl::PointCloud<pcl::PointNormal>;

Points::Ptr with_normals(const registration::PreparedCloud& cloud) {
  auto out = pcl::make_shared<Points>();
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    pcl::PointNormal point;
    point.getVector3fMap() = cloud.point(i);
    point.getNormalVector3fMap() = cloud.normal(i);
    out->push_back(point);
  }
  return out;
}

// PCL's point-to-plane is not among the product's algorithms: it is here for comparison, with normals as a gift.
RigidTransform point_to_plane(const registration::PreparedCloud& source, const registration::PreparedCloud& target,
                              const RigidTransform& start) {
  pcl::IterativeClosestPointWithNormals<pcl::PointNormal, pcl::PointNormal> icp;
  icp.setInputSource(with_normals(source));
  icp.setInputTarget(with_normals(target));
  icp.setMaxCorrespondenceDistance(1.0);
  icp.setMaximumIterations(40);
  icp.setTransformationEpsilon(1e-9);
  Points aligned;
  icp.align(aligned, start.matrix().cast<float>());
  RigidTransform out;
  out.matrix() = icp.getFinalTransformation().cast<double>();
  return out;
}

Align method(registration::AlignFunction function,
             registration::InstructionSet instructions = registration::InstructionSet::Best) {
  return [=](const registration::PreparedCloud& source, const registration::PreparedCloud& target,
             const RigidTransform& start) {
    registration::RegistrationOptions options;
    options.instructions = instructions;
    return function(source, target, start, options, {}).target_from_source;
  };
}

void prepare_with_pcl(const cloud::PointCloud& cloud) {
  auto points = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (const Eigen::Vector3f& p : cloud.points)
    if (p.squaredNorm() >= 1.5f * 1.5f && p.squaredNorm() <= 80.0f * 80.0f) points->push_back({p.x(), p.y(), p.z()});
  auto thinned = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  pcl::VoxelGrid<pcl::PointXYZ> grid;
  grid.setLeafSize(0.25f, 0.25f, 0.25f);
  grid.setInputCloud(points);
  grid.filter(*thinned);
  auto tree = pcl::make_shared<pcl::search::KdTree<pcl::PointXYZ>>();
  pcl::NormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setInputCloud(thinned);
  estimation.setSearchMethod(tree);
  estimation.setKSearch(20);
  pcl::PointCloud<pcl::Normal> normals;
  estimation.compute(normals);
  benchmark::DoNotOptimize(normals.size());
}

void run_preparation(benchmark::State& state, bool kitti, bool own,
                     const std::function<void(const cloud::PointCloud&)>& body) {
  const DataSet& data = data_set(kitti);
  if (data.clouds.empty()) return state.SkipWithError("no recorded data");
  const std::clock_t before = std::clock();
  std::size_t runs = 0;
  for (auto _ : state)
    for (const cloud::PointCloud& cloud : data.clouds) {
      body(cloud);
      ++runs;
    }
  const double seconds = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC / static_cast<double>(runs);
  const std::string key = kitti ? "prepare kitti" : "prepare street";
  if (own) own_seconds()[key] = seconds;
  state.counters["ms_per_scan"] = 1e3 * seconds;
  state.counters["x_ours"] = seconds / own_seconds()[key];
}

// Scans prepared once, pairs with up to five of the scans before, two workers.
void run_session(benchmark::State& state, registration::RegistrationAlgorithm algorithm, std::size_t scans,
                 std::size_t pairs) {
  static const DataSet data = make_street(120);
  for (auto _ : state) {
    std::vector<std::unique_ptr<registration::PreparedCloud>> prepared(scans);
    registration::RegistrationOptions options;
    options.algorithm = algorithm;
    parallel_for(scans, 2, [&](std::size_t i) {
      prepared[i] = std::make_unique<registration::PreparedCloud>(data.clouds[i], options);
    });
    parallel_for(pairs, 2, [&](std::size_t p) {
      const std::size_t back = 1 + p / (scans - 1) % 5, a = std::min(p % (scans - 1) + back, scans - 1),
                        b = a - std::min(back, a);
      RigidTransform start = RigidTransform::Identity();
      for (std::size_t k = a; k > b; --k) start = data.pairs[k - 1].truth * start;
      start.translation().x() += 0.2;
      benchmark::DoNotOptimize(
          registration::align_scans(*prepared[a], *prepared[b], start, options, {}).quality.overlap);
    });
  }
  state.counters["pairs_per_s"] =
      benchmark::Counter(static_cast<double>(pairs * state.iterations()), benchmark::Counter::kIsRate);
}

const bool kRegistered = [] {
  using benchmark::RegisterBenchmark;
  for (const bool kitti : {false, true}) {
    const std::string on = kitti ? " kitti" : " street";
    const auto prepare = [&](const std::string& name, bool own, std::function<void(const cloud::PointCloud&)> body) {
      RegisterBenchmark((name + on).c_str(), [=](benchmark::State& s) {
        run_preparation(s, kitti, own, body);
      })->Iterations(1);
    };
    const auto align = [&](const std::string& name, bool own, Align body) {
      RegisterBenchmark((name + on).c_str(), [=](benchmark::State& s) {
        run_pairs(s, kitti, own, body);
      })->Iterations(1);
    };
    prepare("prepare ours", true,
            [](const cloud::PointCloud& c) { benchmark::DoNotOptimize(registration::PreparedCloud(c, {}).size()); });
    prepare("prepare ours, portable", false, [](const cloud::PointCloud& c) {
      registration::RegistrationOptions options;
      options.instructions = registration::InstructionSet::Portable;
      benchmark::DoNotOptimize(registration::PreparedCloud(c, options).size());
    });
    prepare("prepare pcl", false, prepare_with_pcl);
    if (small_gicp_peer::available())
      prepare("prepare small_gicp", false,
              [](const cloud::PointCloud& c) { benchmark::DoNotOptimize(small_gicp_peer::prepare_scan(c)); });
    align("align ours", true, method(registration::align_plane_to_plane));
    align("align ours, portable", false,
          method(registration::align_plane_to_plane, registration::InstructionSet::Portable));
    align("align ours with quality", false, method(registration::align_scans));
    const auto peer = [&](const std::string& name, Align body) {
      RegisterBenchmark((name + on).c_str(), [=](benchmark::State& s) {
        if (!small_gicp_peer::available())
          return s.SkipWithError("configure with -D REMOUNT_SMALL_GICP_DIR=<checkout>");
        small_gicp_peer::prepare_set(data_set(kitti));
        run_pairs(s, kitti, false, body);
      })->Iterations(1);
    };
    peer("align small_gicp gicp", small_gicp_peer::align_gicp);
    peer("align small_gicp vgicp", small_gicp_peer::align_vgicp);
    align("align pcl gicp", false, method(registration::align_pcl_gicp));
    align("align pcl point-to-plane", false, point_to_plane);
    align("align pcl icp", false, method(registration::align_pcl_icp));
    align("align pcl ndt", false, method(registration::align_pcl_ndt));
  }
  RegisterBenchmark(
      "session of 120 scans, 500 pairs, 2 workers, ours",
      [](benchmark::State& s) { run_session(s, registration::RegistrationAlgorithm::PlaneToPlane, 120, 500); })
      ->Iterations(1)
      ->UseRealTime();
  RegisterBenchmark("session of 12 scans, 50 pairs, 2 workers, pcl gicp",
                    [](benchmark::State& s) { run_session(s, registration::RegistrationAlgorithm::PclGicp, 12, 50); })
      ->Iterations(1)
      ->UseRealTime();
  return true;
}();

}  // namespace
}  // namespace remount::testing
