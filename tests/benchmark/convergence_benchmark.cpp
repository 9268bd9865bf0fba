// From how far away a pair is found: starts off by exactly so much in a random direction, about a random axis.
// Counters: found_share = within 0.2 m and 0.5 deg of the truth without a failure; wrong_share = off and not said so;
// p50_ms, p95_ms = time of a start; searched_share = starts for which others around were tried.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <ctime>
#include <random>

#include "tests/benchmark/pair_sets.h"

namespace remount::testing {
namespace {

const DataSet& data_set(bool kitti) {
  static const DataSet street = make_street(24), recorded = make_kitti({"00", "05", "07", "10"}, 1);
  return kitti ? recorded : street;
}

Eigen::Vector3d random_direction(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const double x = normal(random), y = normal(random), z = normal(random);
  return Eigen::Vector3d(x, y, z).normalized();
}

void run_starts(benchmark::State& state, bool kitti, double off_m, double off_deg, bool search, std::size_t least) {
  const DataSet& data = data_set(kitti);
  if (data.pairs.empty()) return state.SkipWithError("no recorded data");
  registration::RegistrationOptions options;
  options.search_when_doubtful = search;
  std::mt19937_64 random(7);
  double found = 0.0, wrong = 0.0, starts = 0.0;
  std::vector<double> times_ms;
  for (auto _ : state)
    while (starts < static_cast<double>(least))
      for (const BenchmarkPair& pair : data.pairs) {
        Vector6d step;
        step.head<3>() = off_m * random_direction(random);
        step.tail<3>() = degrees_to_radians(off_deg) * random_direction(random);
        const std::clock_t before = std::clock();
        const registration::RegistrationResult result = registration::align_scans(
            *data.prepared[pair.source], *data.prepared[pair.target], perturb(pair.truth, step), options, {});
        times_ms.push_back(1e3 * static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC);
        const Vector6d error = difference(pair.truth, result.target_from_source);
        const bool near = error.head<3>().norm() < 0.2 && error.tail<3>().norm() < degrees_to_radians(0.5);
        const bool claimed = result.quality.failure.empty();
        found += near && claimed;
        wrong += !near && claimed;
        starts += 1.0;
      }
  std::sort(times_ms.begin(), times_ms.end());
  state.counters["starts"] = starts;
  state.counters["pairs"] = static_cast<double>(data.pairs.size());
  state.counters["found_share"] = found / starts;
  state.counters["wrong_share"] = wrong / starts;
  state.counters["p50_ms"] = times_ms[times_ms.size() / 2];
  state.counters["p95_ms"] = times_ms[times_ms.size() * 19 / 20];
}

const bool kRegistered = [] {
  constexpr std::size_t kLeastStarts = 200;
  for (const bool kitti : {false, true})
    for (const auto& [off_m, off_deg] : {std::pair{0.5, 2.0}, std::pair{2.0, 10.0}, std::pair{5.0, 30.0}})
      for (const bool search : {false, true}) {
        char name[120];
        std::snprintf(name, sizeof name, "convergence %s from %g m, %g deg%s", kitti ? "kitti" : "street", off_m,
                      off_deg, search ? "" : ", without search");
        const double m = off_m, deg = off_deg;
        benchmark::RegisterBenchmark(name, [=](benchmark::State& s) {
          run_starts(s, kitti, m, deg, search, kLeastStarts);
        })->Iterations(1);
      }
  return true;
}();

}  // namespace
}  // namespace remount::testing
