// Scoring of candidates: the naive sum beside the quadratic form, one by one, in blocks and on a grid. Then the search
// for the best of all.
#include <benchmark/benchmark.h>

#include "algorithms/search/certified_search.h"
#include "algorithms/search/scoring.h"
#include "tests/algorithms/support/random_motion.h"

namespace remount::testing {
namespace {

std::vector<search::MotionPair> noisy_pairs(int count) {
  std::mt19937_64 random(1);
  const RigidTransform truth = make_rigid(so3_exp({0.1, -0.2, 1.3}), {1.0, 0.5, 1.5});
  std::vector<search::MotionPair> pairs = exact_pairs(random, truth, count);
  for (search::MotionPair& pair : pairs)
    pair.lidar_b_from_lidar_a = perturb(pair.lidar_b_from_lidar_a, random_step(random, 0.01, 1e-3));
  return pairs;
}

std::vector<RigidTransform> random_candidates(int count) {
  std::mt19937_64 random(2);
  std::vector<RigidTransform> candidates;
  for (int i = 0; i < count; ++i) candidates.push_back(random_rigid(random, 2.0));
  return candidates;
}

void count_candidates(benchmark::State& state, std::size_t each) {
  state.counters["candidates/s"] = benchmark::Counter(
      static_cast<double>(state.iterations()) * static_cast<double>(each), benchmark::Counter::kIsRate);
}

void score_naive_sum_of_squares(benchmark::State& state) {
  const std::vector<search::MotionPair> pairs = noisy_pairs(static_cast<int>(state.range(0)));
  const std::vector<RigidTransform> candidates = random_candidates(64);
  for (auto _ : state)
    for (const RigidTransform& x : candidates) {
      double sum = 0.0;
      for (const search::MotionPair& pair : pairs)
        sum += (pair.ins_b_from_ins_a.matrix() * x.matrix() - x.matrix() * pair.lidar_b_from_lidar_a.matrix())
                   .squaredNorm();
      benchmark::DoNotOptimize(sum);
    }
  count_candidates(state, candidates.size());
}
BENCHMARK(score_naive_sum_of_squares)->Arg(1000);

void score_frobenius_sum(benchmark::State& state) {
  const std::vector<search::MotionPair> pairs = noisy_pairs(static_cast<int>(state.range(0)));
  const std::vector<RigidTransform> candidates = random_candidates(64);
  for (auto _ : state)
    for (const RigidTransform& x : candidates) benchmark::DoNotOptimize(search::frobenius_sum(pairs, x, 1.0));
  count_candidates(state, candidates.size());
}
BENCHMARK(score_frobenius_sum)->Arg(1000);

void build_quadratic_form(benchmark::State& state) {
  const std::vector<search::MotionPair> pairs = noisy_pairs(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(search::QuadraticForm(pairs, 1.0));
}
BENCHMARK(build_quadratic_form)->Arg(1000)->Unit(benchmark::kMicrosecond);

void score_quadratic_form_one_by_one(benchmark::State& state) {
  const search::QuadraticForm form(noisy_pairs(1000), 1.0);
  const std::vector<RigidTransform> candidates = random_candidates(4096);
  for (auto _ : state)
    for (const RigidTransform& x : candidates) benchmark::DoNotOptimize(form.value(x));
  count_candidates(state, candidates.size());
}
BENCHMARK(score_quadratic_form_one_by_one);

void score_quadratic_form_in_blocks(benchmark::State& state) {
  const search::QuadraticForm form(noisy_pairs(1000), 1.0);
  const std::vector<RigidTransform> candidates = random_candidates(4096);
  std::vector<double> values(candidates.size());
  for (auto _ : state) {
    form.values(candidates, values);
    benchmark::DoNotOptimize(values.data());
    benchmark::ClobberMemory();
  }
  count_candidates(state, candidates.size());
}
BENCHMARK(score_quadratic_form_in_blocks);

void score_quadratic_form_on_grid(benchmark::State& state) {
  const search::QuadraticForm form(noisy_pairs(1000), 1.0);
  std::vector<Eigen::Vector3d> translations;
  for (int x = -5; x <= 5; ++x)
    for (int y = -5; y <= 5; ++y)
      for (int z = -5; z <= 5; ++z) translations.emplace_back(x, y, z);
  const search::TranslationGrid grid = form.prepare_grid(translations);
  const std::vector<RigidTransform> candidates = random_candidates(64);
  std::vector<double> values(translations.size());
  for (auto _ : state)
    for (const RigidTransform& x : candidates) {
      form.values_on_grid(x.linear(), grid, values);
      benchmark::DoNotOptimize(values.data());
      benchmark::ClobberMemory();
    }
  count_candidates(state, candidates.size() * translations.size());
}
BENCHMARK(score_quadratic_form_on_grid);

void certified_search_of_pairs(benchmark::State& state) {
  const std::vector<search::MotionPair> pairs = noisy_pairs(static_cast<int>(state.range(0)));
  search::SearchResult result;
  for (auto _ : state) {
    const search::QuadraticForm form(pairs, 1.0);  // the only part that depends on the number of pairs
    result = search::certified_search(form, {}, RigidTransform::Identity(), {}, {});
  }
  state.counters["relative gap"] = result.gap() / result.value;
  state.counters["regions"] = result.regions;
}
BENCHMARK(certified_search_of_pairs)->Arg(10)->Arg(1000)->Arg(100000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace remount::testing
