// What the sigmas are made of adds up to them, and names what is really there.
#include "algorithms/calibration/pairwise/sigma_budget.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "algorithms/calibration/observability.h"
#include "algorithms/messages/render.h"
#include "messages/parameters.h"
#include "tests/algorithms/support/simulated_drive.h"

namespace remount::calibration {
namespace {

CalibrationResult solved_with(const NoiseModel& noise, bool with_nominal, const std::optional<Vector6d>& bias = {}) {
  testing::DriveOptions options;
  options.noise = noise;
  const testing::SimulatedDrive drive = testing::simulate(options, 4);
  PairwiseInput input = testing::input_of(drive, options);
  if (with_nominal) input.nominal_ins_from_lidar = testing::mounting();
  input.clock_bias = bias;
  std::vector<motion::Pair> pairs = testing::pairs_of(drive);
  return solve_pairwise(input, pairs, {});
}

double variance_of(const CalibrationResult& result, const Message& source, Parameter parameter) {
  for (const SigmaPart& part : result.sigma_parts)
    if (part.source == source) return part.sigma[parameter] * part.sigma[parameter];
  return 0.0;
}

void print_parts(const char* title, const CalibrationResult& result) {
  std::printf("%s: sigma of x %.2f mm, of yaw %.2f mdeg\n", title,
              1e3 * result.estimate(Parameter::X).sigma.value_or(0),
              1e3 * radians_to_degrees(result.estimate(Parameter::Yaw).sigma.value_or(0)));
  for (const SigmaPart& part : result.sigma_parts)
    std::printf("  %-70s %8.3f mm %8.3f mdeg\n", english(part.source).c_str(), 1e3 * part.sigma[Parameter::X],
                1e3 * radians_to_degrees(part.sigma[Parameter::Yaw]));
}

TEST(sigma_budget, adds_up_to_every_sigma_with_doubts_as_well) {
  Vector6d bias;
  bias << 0.004, -0.002, 0.001, 1e-4, 2e-4, -3e-4;
  for (const bool with_nominal : {true, false})
    for (const auto& clock_bias : {std::optional<Vector6d>(), std::optional(bias)}) {
      const CalibrationResult result = solved_with({}, with_nominal, clock_bias);
      ASSERT_FALSE(result.observed().empty());
      EXPECT_GE(result.sigma_parts.size(), 4U);
      EXPECT_TRUE(sigma_parts_add_up(result));
      print_parts(clock_bias ? "with a clock bias" : "without", result);
      EXPECT_NEAR(variance_of(result, say::unknown_clocks_differ(), Parameter::X), clock_bias ? 1.6e-5 : 0.0, 1e-12);
      for (const SigmaPart& part : result.sigma_parts)
        for (const Parameter parameter : kParameters) EXPECT_GE(part.sigma[parameter], 0.0) << english(part.source);
    }
}

TEST(sigma_budget, does_not_add_up_where_the_covariance_changed_without_a_reason) {
  CalibrationResult result = solved_with({}, true);
  ASSERT_TRUE(sigma_parts_add_up(result));
  result.covariance *= 1.1;
  EXPECT_FALSE(sigma_parts_add_up(result));
  result.sigma_parts.clear();
  EXPECT_FALSE(sigma_parts_add_up(result));
}

TEST(sigma_budget, tells_the_ins_from_the_registrations) {
  NoiseModel good_ins, good_lidar;
  good_ins.ins_position_sigma_m = 2e-4, good_ins.ins_attitude_sigma_rad = 1e-5;
  good_ins.registration_scale = 8.0;
  good_lidar.ins_position_sigma_m = 0.03, good_lidar.ins_attitude_sigma_rad = 1e-3;
  good_lidar.registration_scale = 0.3, good_lidar.registration_floor_m = 1e-4, good_lidar.registration_floor_rad = 1e-5;
  const auto ins_over_registration = [](const CalibrationResult& result, Parameter parameter) {
    return variance_of(result, say::sigma_part_ins(), parameter) /
           variance_of(result, say::sigma_part_registration(), parameter);
  };
  const CalibrationResult by_lidar = solved_with(good_ins, true), by_ins = solved_with(good_lidar, true);
  print_parts("a good INS and poor scans", by_lidar);
  print_parts("a poor INS and good scans", by_ins);
  for (const Parameter parameter : {Parameter::X, Parameter::Y, Parameter::Yaw}) {
    EXPECT_LT(ins_over_registration(by_lidar, parameter), 0.5);
    EXPECT_GT(ins_over_registration(by_ins, parameter), 2.0);
  }
}

TEST(sigma_budget, each_step_is_the_part_of_its_source) {
  SigmaBudget budget(RigidTransform::Identity());
  Matrix6d first = Matrix6d::Identity() * 1e-6, second = 3.0 * first;
  budget.reach(first, say::sigma_part_registration());
  budget.reach(second, say::sigma_part_ins());
  budget.reach(second, say::sigma_part_few());
  CalibrationResult result;
  budget.write(result);
  ASSERT_EQ(result.sigma_parts.size(), 2U) << "what adds nothing is no part";
  EXPECT_NEAR(variance_of(result, say::sigma_part_registration(), Parameter::Y), 1e-6, 1e-15);
  EXPECT_NEAR(variance_of(result, say::sigma_part_ins(), Parameter::Y), 2e-6, 1e-15);
}

}  // namespace
}  // namespace remount::calibration
