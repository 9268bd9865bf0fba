// A decision in the window waits for solve_again: it must be quick, and say what the decision changed.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "algorithms/calibration/joint/pair_equation.h"
#include "algorithms/messages/render.h"
#include "model/pipeline/first_answer.h"
#include "model/pipeline/pipeline.h"
#include "tests/support/registered_drive.h"

namespace remount::pipeline {
namespace {

using testing::drive;
using testing::kTruth;
using testing::registered;
using testing::reject;

template <class Solve>
double taken_ms(const Solve& solve) {
  const auto start = std::chrono::steady_clock::now();
  solve();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

TEST(solve_again, is_answered_at_once_nearly_as_it_is_in_the_end) {
  const PipelineInput input = drive();
  PipelineOutput output = registered(input, 50);
  Progress progress;
  const double whole_ms = taken_ms([&] { solve_again(input, output, progress); });
  ASSERT_EQ(output.result.status, calibration::Status::Ok) << english(output.result.message);
  EXPECT_LT((output.result.mounting.reference_from_sensor.translation() - rigid_from_six(kTruth).translation()).norm(),
            0.06);
  const RigidTransform before = output.result.mounting.reference_from_sensor;
  reject(output, 30, 25);
  const double at_once_ms = taken_ms([&] { EXPECT_TRUE(solve_at_once(input, output, progress)); });
  const RigidTransform quick = output.result.mounting.reference_from_sensor;
  const int accepted = output.result.pairs_accepted;
  solve_again(input, output, progress);
  const double moved = difference(before, output.result.mounting.reference_from_sensor).norm();
  const double missed = difference(quick, output.result.mounting.reference_from_sensor).norm();
  std::printf("%zu pairs: whole solution %.0f ms, first answer %.0f ms, which is %.3g off of %.3g that X moved\n",
              output.pairs.size(), whole_ms, at_once_ms, missed, moved);
  EXPECT_GT(moved, 0.0) << "good pairs less change something";
  EXPECT_LT(missed, 0.3 * moved);
  EXPECT_NEAR(accepted, output.result.pairs_accepted, 3) << "those on the edge may be judged otherwise";
}

void expect_residuals_under_its_x(const PipelineOutput& output, const char* of) {
  double translation2 = 0.0;
  for (const motion::Pair& pair : output.pairs) {
    const Vector6d residual = difference(
        pair.lidar_b_from_lidar_a,
        calibration::predicted_lidar_motion(pair.ins_b_from_ins_a, output.result.mounting.reference_from_sensor));
    ASSERT_NEAR(pair.residual_translation_m, residual.head<3>().norm(), 1e-12) << of;
    ASSERT_NEAR(pair.residual_rotation_rad, residual.tail<3>().norm(), 1e-12) << of;
    if (pair.state == motion::PairState::Accepted) translation2 += residual.head<3>().squaredNorm();
  }
  EXPECT_NEAR(output.result.translation_rms_m, std::sqrt(translation2 / output.result.pairs_accepted), 1e-12) << of;
}

TEST(solve_again, residuals_are_under_the_x_that_is_told_before_and_after_a_decision) {
  PipelineInput input = drive();
  input.settings.solve.max_translation_sigma_m = 0.002;  // so that z is not observed, and held
  input.nominal_ins_from_lidar = rigid_from_six({1.0, 0, 2.1, 0, 0, 0});
  PipelineOutput output = registered(input, 50);
  Progress progress;
  ASSERT_TRUE(solve_again(input, output, progress));
  ASSERT_FALSE(output.result.known[calibration::Parameter::Z].observed);
  expect_residuals_under_its_x(output, "the solution");
  const double rms_m = output.result.translation_rms_m;
  reject(output, 30, 5);
  ASSERT_TRUE(solve_at_once(input, output, progress));
  expect_residuals_under_its_x(output, "the first answer");
  EXPECT_NEAR(output.result.translation_rms_m, rms_m, 0.2 * rms_m) << "five good pairs less";
  answer_with(rigid_from_six({1.1, -0.3, 1.5, 0.03, -0.02, 0.015}), output);
  expect_residuals_under_its_x(output, "another X");
  ASSERT_TRUE(solve_again(input, output, progress));
  expect_residuals_under_its_x(output, "the solution after it");
  EXPECT_NEAR(output.result.translation_rms_m, rms_m, 0.2 * rms_m);
}

TEST(solve_again, nothing_is_answered_at_once_without_a_result_or_pairs) {
  const PipelineInput input = drive();
  PipelineOutput output = registered(input, 20);
  Progress progress;
  EXPECT_FALSE(solve_at_once(input, output, progress)) << "nothing was solved yet";
  output.result.status = calibration::Status::Ok;
  output.result.set_observed(calibration::ParameterSet::all(), {});
  EXPECT_FALSE(solve_at_once(input, output, progress)) << "no pair takes part";
}

}  // namespace
}  // namespace remount::pipeline
