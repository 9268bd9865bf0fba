// A whole calibration beside what an engineer would write instead, who does not know which pairs are enough: scans read
// once, small_gicp for the motions of all pairs that ours proposes, and X by robust Gauss-Newton over them. Counters:
// cpu_s = processor time of all threads, x_ours = that against ours, rotation_mdeg and travel_mm = error of X
// (translation across the vehicle's plane, for a drive on a road hardly shows its height).
#include <benchmark/benchmark.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <ctime>
#include <filesystem>

#include "algorithms/calibration/joint/pair_equation.h"
#include "algorithms/core/parallel.h"
#include "model/formats/session_readers.h"
#include "model/methods/calibrate.h"
#include "model/simulator/simulator.h"
#include "tests/benchmark/small_gicp_peer.h"

namespace remount::testing {
namespace {

constexpr int kThreads = 2;

// 150 scans of 64 beams in a folder, as long as this lives. Without motion distortion: what compensating it takes is no
// matter of the comparison.
class WrittenDrive {
 public:
  WrittenDrive() : folder_(std::filesystem::temp_directory_path() / "remount-calibration-benchmark") {
    simulator::SimulationOptions options;
    options.duration_s = 15.0;
    options.azimuth_steps = 1800;
    options.motion_distortion = false;
    const simulator::SimulatedDrive simulated = simulator::simulate_drive(options);
    ins_from_lidar_ = simulated.ins_from_lidar;
    std::filesystem::remove_all(folder_);
    Progress progress;
    simulator::write_drive(simulated, folder_, "native", kThreads, progress);
  }
  ~WrittenDrive() { std::filesystem::remove_all(folder_); }
  WrittenDrive(const WrittenDrive&) = delete;
  WrittenDrive& operator=(const WrittenDrive&) = delete;

  const std::filesystem::path& folder() const { return folder_; }
  const RigidTransform& ins_from_lidar() const { return ins_from_lidar_; }

 private:
  std::filesystem::path folder_;
  RigidTransform ins_from_lidar_;
};

const WrittenDrive& written_drive() {
  static const WrittenDrive drive;
  return drive;
}

// Off by as much as a mounting is known from a drawing.
RigidTransform nominal_of(const RigidTransform& ins_from_lidar) {
  return perturb(ins_from_lidar, (Vector6d() << 0.01, -0.01, 0.01, 5e-4, -5e-4, 5e-4).finished());
}

pipeline::PipelineInput input_of(const WrittenDrive& drive) {
  pipeline::PipelineInput input;
  Progress progress;
  input.sessions = {std::make_shared<const drive::Session>(formats::open_session(drive.folder(), progress))};
  input.nominal_ins_from_lidar = nominal_of(drive.ins_from_lidar());
  input.threads = kThreads;
  return input;
}

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// Of the first benchmarks, for the others.
struct Ours {
  pipeline::PipelineOutput all_pairs;
  double cpu_s = 0.0;
};
Ours& ours() {
  static Ours of_first;
  return of_first;
}

void tell(benchmark::State& state, double cpu_s, std::size_t pairs, const RigidTransform& found) {
  const Vector6d error = difference(written_drive().ins_from_lidar(), found);
  state.counters["cpu_s"] = cpu_s;
  state.counters["x_ours"] = cpu_s / ours().cpu_s;
  state.counters["pairs"] = static_cast<double>(pairs);
  state.counters["rotation_mdeg"] = 1e3 * radians_to_degrees(error.tail<3>().norm());
  state.counters["travel_mm"] = 1e3 * error.head<2>().norm();
}

pipeline::PipelineOutput calibrate(benchmark::State& state, motion::PairChoice choice, double& cpu_s) {
  pipeline::PipelineOutput output;
  const WrittenDrive& drive = written_drive();
  for (auto _ : state) {
    const double before = cpu_seconds();
    Progress progress;
    pipeline::PipelineInput input = input_of(drive);
    input.settings.pairing.choice = choice;
    output = methods::calibrate(input, progress);
    cpu_s = cpu_seconds() - before;
  }
  return output;
}

void calibrate_ours(benchmark::State& state) {
  const pipeline::PipelineOutput output = calibrate(state, motion::PairChoice::Auto, ours().cpu_s);
  tell(state, ours().cpu_s, output.pairs.size(), output.result.mounting.ins_from_lidar());
}
BENCHMARK(calibrate_ours)->Iterations(1)->Unit(benchmark::kMillisecond)->UseRealTime();

void calibrate_ours_by_all_pairs(benchmark::State& state) {
  double cpu_s = 0.0;
  ours().all_pairs = calibrate(state, motion::PairChoice::All, cpu_s);
  tell(state, cpu_s, ours().all_pairs.pairs.size(), ours().all_pairs.result.mounting.ins_from_lidar());
}
BENCHMARK(calibrate_ours_by_all_pairs)->Iterations(1)->Unit(benchmark::kMillisecond)->UseRealTime();

struct Motion {
  RigidTransform ins_b_from_ins_a, lidar_b_from_lidar_a;
};

// One kernel for all six components, in units of what they scatter.
RigidTransform solve_robustly(const std::vector<Motion>& motions, RigidTransform x) {
  constexpr double kUnit_m = 0.02, kUnit_rad = 1e-3;
  constexpr int kIterations = 30;
  Vector6d units;
  units << Eigen::Vector3d::Constant(kUnit_m), Eigen::Vector3d::Constant(kUnit_rad);
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    Matrix6d hessian = 1e-9 * Matrix6d::Identity();
    Vector6d side = Vector6d::Zero();
    for (const Motion& motion : motions) {
      const calibration::MountingEquation equation =
          calibration::linearise_in_mounting(motion.ins_b_from_ins_a, motion.lidar_b_from_lidar_a, x);
      const Matrix6d jacobian = units.cwiseInverse().asDiagonal() * equation.d_x;
      const Vector6d residual = equation.residual.cwiseQuotient(units);
      const double weight = 1.0 / std::pow(1.0 + residual.squaredNorm(), 2);
      hessian += weight * jacobian.transpose() * jacobian;
      side -= weight * jacobian.transpose() * residual;
    }
    x = perturb(x, hessian.ldlt().solve(side));
  }
  return x;
}

void calibrate_by_peer(benchmark::State& state, small_gicp_peer::Algorithm algorithm) {
  if (!small_gicp_peer::available()) return state.SkipWithError("configure with -D REMOUNT_SMALL_GICP_DIR=<checkout>");
  if (ours().all_pairs.pairs.empty()) return state.SkipWithError("the pairs are those of calibrate_ours_by_all_pairs");
  const pipeline::PipelineOutput& chosen = ours().all_pairs;
  const RigidTransform nominal = nominal_of(written_drive().ins_from_lidar());
  for (auto _ : state) {
    const double before = cpu_seconds();
    const pipeline::PipelineInput input = input_of(written_drive());
    std::vector<cloud::PointCloud> clouds(chosen.keyframes.size());
    parallel_for(clouds.size(), kThreads,
                 [&](std::size_t k) { clouds[k] = input.sessions.front()->scans->load(chosen.keyframes[k].scan); });
    std::vector<small_gicp_peer::ScanPair> pairs;
    for (const motion::Pair& pair : chosen.pairs)
      pairs.push_back(
          {pair.keyframe_a, pair.keyframe_b, calibration::predicted_lidar_motion(pair.ins_b_from_ins_a, nominal)});
    const std::vector<RigidTransform> found = small_gicp_peer::register_scans(clouds, pairs, algorithm, kThreads);
    std::vector<Motion> motions;
    for (std::size_t i = 0; i < found.size(); ++i) motions.push_back({chosen.pairs[i].ins_b_from_ins_a, found[i]});
    const RigidTransform x = solve_robustly(motions, nominal);
    tell(state, cpu_seconds() - before, motions.size(), x);
  }
}

void calibrate_by_small_gicp_gicp(benchmark::State& state) {
  calibrate_by_peer(state, small_gicp_peer::Algorithm::Gicp);
}
BENCHMARK(calibrate_by_small_gicp_gicp)->Iterations(1)->Unit(benchmark::kMillisecond)->UseRealTime();

void calibrate_by_small_gicp_vgicp(benchmark::State& state) {
  calibrate_by_peer(state, small_gicp_peer::Algorithm::Vgicp);
}
BENCHMARK(calibrate_by_small_gicp_vgicp)->Iterations(1)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace remount::testing
