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
#include <filesystem>
#include <functional>
#include <map>
#include <random>

#include "algorithms/core/parallel.h"
#include "algorithms/registration/registration.h"
#include "model/io/session_reader.h"
#include "model/simulator/simulator.h"

namespace remount {
namespace {

struct BenchmarkPair {
  std::size_t source = 0, target = 0;
  RigidTransform truth = RigidTransform::Identity(), start = RigidTransform::Identity();
};

struct DataSet {
  std::vector<PointCloud> clouds;
  std::vector<std::unique_ptr<PreparedCloud>> prepared;
  std::vector<BenchmarkPair> pairs;
};

// Start values off by 0.5 m and 2 degrees.
void set_starts(DataSet& data) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  for (BenchmarkPair& pair : data.pairs) {
    const Eigen::Vector3d shift = Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
    const Eigen::Vector3d turn = Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
    Vector6d step;
    step << 0.5 * shift, degrees_to_radians(2.0) * turn;
    pair.start = perturbed(pair.truth, step);
  }
}

void prepare_all(DataSet& data) {
  for (const PointCloud& cloud : data.clouds)
    data.prepared.push_back(std::make_unique<PreparedCloud>(cloud, RegistrationOptions{}));
}

DataSet make_street(std::size_t scans) {
  SimulationOptions options;
  options.scan_rate_hz = 2.0;
  options.duration_s = static_cast<double>(scans) / options.scan_rate_hz;
  options.azimuth_steps = 2000;
  options.motion_distortion = false;
  const SimulatedDrive drive = simulate_drive(options);
  DataSet data;
  const auto pose = [&](std::size_t i) { return RigidTransform(drive.enu_from_ins[i].pose * drive.ins_from_lidar); };
  for (std::size_t i = 0; i < drive.session.scans->size(); ++i) {
    data.clouds.push_back(drive.session.scans->load(i));
    if (i > 0) data.pairs.push_back({i, i - 1, pose(i - 1).inverse() * pose(i)});
  }
  prepare_all(data);
  set_starts(data);
  return data;
}

// The best of own alignments from several distances travelled.
RigidTransform own_result(const PreparedCloud& source, const PreparedCloud& target) {
  RegistrationResult best;
  for (double ahead_m = 0.0; ahead_m <= 2.5; ahead_m += 0.5) {
    RegistrationOptions options;
    options.max_correspondence_m = 2.0;
    const RigidTransform start = make_rigid(Eigen::Matrix3d::Identity(), {ahead_m, 0.0, 0.0});
    const RegistrationResult result = align_scans(source, target, start, options, {});
    if (result.quality.overlap > best.quality.overlap) best = result;
  }
  return align_scans(source, target, best.target_from_source, {}, {}).target_from_source;
}

DataSet make_kitti() {
  DataSet data;
  const std::filesystem::path folder = std::filesystem::path(REMOUNT_SOURCE_DIR) / ".." / "shared" / "data" / "kitti";
  for (const char* drive : {"05", "07", "10"}) {
    if (!std::filesystem::exists(folder / drive)) continue;
    Progress progress;
    const Session session = open_session(folder / drive, progress);
    for (std::size_t i = 0; i < session.scans->size(); ++i) {
      data.clouds.push_back(session.scans->load(i));
      if (i > 0 && i % 2 == 0) data.pairs.push_back({data.clouds.size() - 1, data.clouds.size() - 2});
    }
  }
  prepare_all(data);
  for (BenchmarkPair& pair : data.pairs)
    pair.truth = own_result(*data.prepared[pair.source], *data.prepared[pair.target]);
  set_starts(data);
  return data;
}

const DataSet& data_set(bool kitti) {
  static const DataSet street = make_street(24), recorded = make_kitti();
  return kitti ? recorded : street;
}

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

// Time of the own engine by data set, for ratios; its benchmarks are registered first.
std::map<std::string, double>& own_seconds() {
  static std::map<std::string, double> seconds;
  return seconds;
}

using Align = std::function<RigidTransform(const PreparedCloud&, const PreparedCloud&, const RigidTransform&)>;

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

Points::Ptr with_normals(const PreparedCloud& cloud) {
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
RigidTransform point_to_plane(const PreparedCloud& source, const PreparedCloud& target, const RigidTransform& start) {
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

Align method(AlignFunction function, InstructionSet instructions = InstructionSet::Best) {
  return [=](const PreparedCloud& source, const PreparedCloud& target, const RigidTransform& start) {
    RegistrationOptions options;
    options.instructions = instructions;
    return function(source, target, start, options, {}).target_from_source;
  };
}

void prepare_with_pcl(const PointCloud& cloud) {
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
                     const std::function<void(const PointCloud&)>& body) {
  const DataSet& data = data_set(kitti);
  if (data.clouds.empty()) return state.SkipWithError("no recorded data");
  const std::clock_t before = std::clock();
  std::size_t runs = 0;
  for (auto _ : state)
    for (const PointCloud& cloud : data.clouds) {
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
void run_session(benchmark::State& state, RegistrationAlgorithm algorithm, std::size_t scans, std::size_t pairs) {
  static const DataSet data = make_street(120);
  for (auto _ : state) {
    std::vector<std::unique_ptr<PreparedCloud>> prepared(scans);
    RegistrationOptions options;
    options.algorithm = algorithm;
    parallel_for(scans, 2,
                 [&](std::size_t i) { prepared[i] = std::make_unique<PreparedCloud>(data.clouds[i], options); });
    parallel_for(pairs, 2, [&](std::size_t p) {
      const std::size_t back = 1 + p / (scans - 1) % 5, a = std::min(p % (scans - 1) + back, scans - 1),
                        b = a - std::min(back, a);
      RigidTransform start = RigidTransform::Identity();
      for (std::size_t k = a; k > b; --k) start = data.pairs[k - 1].truth * start;
      start.translation().x() += 0.2;
      benchmark::DoNotOptimize(align_scans(*prepared[a], *prepared[b], start, options, {}).quality.overlap);
    });
  }
  state.counters["pairs_per_s"] =
      benchmark::Counter(static_cast<double>(pairs * state.iterations()), benchmark::Counter::kIsRate);
}

const bool kRegistered = [] {
  using benchmark::RegisterBenchmark;
  for (const bool kitti : {false, true}) {
    const std::string on = kitti ? " kitti" : " street";
    const auto prepare = [&](const std::string& name, bool own, std::function<void(const PointCloud&)> body) {
      RegisterBenchmark((name + on).c_str(), [=](benchmark::State& s) {
        run_preparation(s, kitti, own, body);
      })->Iterations(1);
    };
    const auto align = [&](const std::string& name, bool own, Align body) {
      RegisterBenchmark((name + on).c_str(), [=](benchmark::State& s) {
        run_pairs(s, kitti, own, body);
      })->Iterations(1);
    };
    prepare("prepare ours", true, [](const PointCloud& c) { benchmark::DoNotOptimize(PreparedCloud(c, {}).size()); });
    prepare("prepare ours, portable", false, [](const PointCloud& c) {
      RegistrationOptions options;
      options.instructions = InstructionSet::Portable;
      benchmark::DoNotOptimize(PreparedCloud(c, options).size());
    });
    prepare("prepare pcl", false, prepare_with_pcl);
    align("align ours", true, method(align_plane_to_plane));
    align("align ours, portable", false, method(align_plane_to_plane, InstructionSet::Portable));
    align("align ours with quality", false, method(align_scans));
    align("align pcl gicp", false, method(align_pcl_gicp));
    align("align pcl point-to-plane", false, point_to_plane);
    align("align pcl icp", false, method(align_pcl_icp));
    align("align pcl ndt", false, method(align_pcl_ndt));
  }
  RegisterBenchmark("session of 120 scans, 500 pairs, 2 workers, ours",
                    [](benchmark::State& s) { run_session(s, RegistrationAlgorithm::PlaneToPlane, 120, 500); })
      ->Iterations(1)
      ->UseRealTime();
  RegisterBenchmark("session of 12 scans, 50 pairs, 2 workers, pcl gicp",
                    [](benchmark::State& s) { run_session(s, RegistrationAlgorithm::PclGicp, 12, 50); })
      ->Iterations(1)
      ->UseRealTime();
  return true;
}();

}  // namespace
}  // namespace remount
