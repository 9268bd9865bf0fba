// The multi-sensor odometry against real time: a scan of 64 beams every tenth of a second.
#include <benchmark/benchmark.h>

#include <filesystem>
#include <vector>

#include "model/formats/session_readers.h"
#include "tests/support/tunnel_drive.h"

namespace remount::testing {
namespace {

constexpr double kPeriod_s = 0.1;

odometry::OdometryScan scan_of(const drive::Session& session, std::size_t index) {
  odometry::OdometryScan scan{session.scans->stamp_ns(index), session.scans->load(index), {}};
  scan.time_from_stamp_s = scan.cloud_in_lidar.time_from_stamp_s;
  return scan;
}

void run_scans(benchmark::State& state, const std::vector<odometry::OdometryScan>& scans,
               const odometry::FusionMounting& mounting, const odometry::SensorStreams& streams,
               const odometry::FusionOptions& options) {
  std::size_t points = 0;
  for (const odometry::OdometryScan& scan : scans) points += scan.cloud_in_lidar.size();
  for (auto _ : state) {
    odometry::FusionOdometry odometry(mounting, streams, options, static_cast<int>(state.range(0)));
    for (const odometry::OdometryScan& scan : scans) benchmark::DoNotOptimize(odometry.add(scan));
  }
  const double count = static_cast<double>(scans.size());
  state.counters["scans/s"] = benchmark::Counter(count, benchmark::Counter::kIsIterationInvariantRate);
  state.counters["times real time"] =
      benchmark::Counter(count * kPeriod_s, benchmark::Counter::kIsIterationInvariantRate);
  state.counters["points a scan"] = static_cast<double>(points) / count;
}

// All terms; 64 beams, 1800 firings a turn, points with times.
void fusion_odometry_street(benchmark::State& state) {
  simulator::SimulationOptions options;
  options.duration_s = 4.0;
  options.azimuth_steps = 1800;
  const simulator::SimulatedDrive drive = simulator::simulate_drive(options);
  std::vector<odometry::OdometryScan> scans;
  for (std::size_t i = 0; i < drive.session.scans->size(); ++i) scans.push_back(scan_of(drive.session, i));
  const odometry::FusionMounting mounting{drive.sensors.vehicle_from_ins * drive.ins_from_lidar,
                                          drive.sensors.vehicle_from_ins * drive.sensors.ins_from_imu};
  run_scans(state, scans, mounting, {drive.session.imu, drive.session.wheels, drive.session.barometer},
            settings_of(drive).fusion);
}
BENCHMARK(fusion_odometry_street)
    ->Arg(1)
    ->Arg(2)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();

// The LiDAR alone, recorded scans.
void fusion_odometry_kitti(benchmark::State& state) {
  const std::filesystem::path folder =
      std::filesystem::path(REMOUNT_SOURCE_DIR) / ".." / "shared" / "data" / "kitti" / "05";
  if (!std::filesystem::exists(folder)) {
    state.SkipWithError("no recorded data beside the checkout");
    return;
  }
  Progress progress;
  const drive::Session session = formats::open_session(folder, progress);
  std::vector<odometry::OdometryScan> scans;
  for (std::size_t i = 0; i < session.scans->size(); ++i) scans.push_back(scan_of(session, i));
  run_scans(state, scans, {}, {}, {});
}
BENCHMARK(fusion_odometry_kitti)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();

}  // namespace
}  // namespace remount::testing
