// Variance components of the joint problem, by restricted maximum likelihood. docs/maths/covariance.md (C7)
#include <cmath>
#include <limits>

#include "algorithms/calibration/joint/joint_equations.h"

namespace remount::calibration {
namespace {

std::array<double, 7> log_ratios(const NoiseModel& noise, const NoiseModel& expected) {
  const auto ratio = [](double value, double reference) { return reference > 0.0 ? std::log(value / reference) : 0.0; };
  return {ratio(noise.ins_position_sigma_m, expected.ins_position_sigma_m),
          ratio(noise.ins_attitude_sigma_rad, expected.ins_attitude_sigma_rad),
          ratio(noise.registration_scale, expected.registration_scale),
          ratio(noise.registration_floor_m, expected.registration_floor_m),
          ratio(noise.registration_floor_rad, expected.registration_floor_rad),
          ratio(noise.ins_position_drift, expected.ins_position_drift),
          ratio(noise.ins_attitude_drift, expected.ins_attitude_drift)};
}

}  // namespace

NoiseModel estimate_noise(const JointProblem& problem, const NoiseModel& expected,
                          const std::array<double, 7>& log_spread, const RigidTransform& ins_from_lidar,
                          const std::optional<NoiseModel>& start, const Progress& progress) {
  const Layout layout = layout_of(problem, expected);
  const State state = start_state(problem, layout, {ins_from_lidar});
  const auto with = [&](const std::array<double, 7>& logs) {
    return NoiseModel{
        expected.ins_position_sigma_m * std::exp(logs[0]),   expected.ins_attitude_sigma_rad * std::exp(logs[1]),
        expected.registration_scale * std::exp(logs[2]),     expected.registration_floor_m * std::exp(logs[3]),
        expected.registration_floor_rad * std::exp(logs[4]), expected.ins_position_drift * std::exp(logs[5]),
        expected.ins_attitude_drift * std::exp(logs[6])};
  };
  const std::vector<LinearTerm> terms = linearise(problem, state, layout);
  // What changes with the registrations' components alone, while those of the INS are searched.
  NoiseModel summed_with = with({});
  NormalEquations of_terms = sum_terms(problem, terms, summed_with, layout);
  Eliminated solved;
  const auto objective = [&](const std::array<double, 7>& logs) {
    double value = 0.0;
    for (std::size_t i = 0; i < logs.size(); ++i)
      if (log_spread[i] > 0.0) value += logs[i] * logs[i] / (log_spread[i] * log_spread[i]);
    const NoiseModel noise = with(logs);
    if (!same_terms(noise, summed_with)) {
      summed_with = noise;
      of_terms = sum_terms(problem, terms, noise, layout);
    }
    NormalEquations equations = of_terms;
    add_priors(problem, noise, state, layout, equations);
    eliminate(equations, solved);
    return solved.valid ? value + solved.minus_two_log_likelihood : std::numeric_limits<double>::infinity();
  };
  // Coordinate search with shrinking steps: a few smooth, weakly coupled logarithms do not need more.
  std::array<double, 7> best = start ? log_ratios(*start, expected) : std::array<double, 7>{};
  double least = objective(best);
  const auto move = [&](std::size_t component, double step) {
    if (!(log_spread[component] > 0.0)) return false;
    for (const double by : {step, -step}) {
      std::array<double, 7> trial = best;
      trial[component] += by;
      const double value = objective(trial);
      if (!(value < least)) continue;
      least = value;
      best = trial;
      return true;
    }
    return false;
  };
  for (double step = start ? 0.2 : 0.8; step > 0.04; step *= 0.5) {
    // Ends where none of the components moves: what was tried since the last that did need not be tried again.
    constexpr std::size_t kMostRounds = 6;
    std::size_t unmoved = 0;
    for (std::size_t i = 0; unmoved < best.size() && i < kMostRounds * best.size() && !progress.cancelled(); ++i)
      unmoved = move(i % best.size(), step) ? 0 : unmoved + 1;
  }
  return with(best);
}

}  // namespace remount::calibration
