// A decision in the window waits for solve_again: it must be quick, and say what the decision changed.
#include <gtest/gtest.h>

#include <chrono>

#include "model/pipeline.h"
#include "tests/support/registered_drive.h"

namespace remount {
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
  ASSERT_EQ(output.result.status, Status::Ok) << output.result.message;
  EXPECT_LT((output.result.ins_from_lidar.translation() - rigid_from_six(kTruth).translation()).norm(), 0.06);
  const RigidTransform before = output.result.ins_from_lidar;
  reject(output, 30, 25);
  const double at_once_ms = taken_ms([&] { EXPECT_TRUE(solve_at_once(input, output, progress)); });
  const RigidTransform quick = output.result.ins_from_lidar;
  const int accepted = output.result.pairs_accepted;
  solve_again(input, output, progress);
  const double moved = difference(before, output.result.ins_from_lidar).norm();
  const double missed = difference(quick, output.result.ins_from_lidar).norm();
  std::printf("%zu pairs: whole solution %.0f ms, first answer %.0f ms, which is %.3g off of %.3g that X moved\n",
              output.pairs.size(), whole_ms, at_once_ms, missed, moved);
  EXPECT_GT(moved, 0.0) << "good pairs less change something";
  EXPECT_LT(missed, 0.3 * moved);
  EXPECT_NEAR(accepted, output.result.pairs_accepted, 3) << "those on the edge may be judged otherwise";
}

TEST(solve_again, nothing_is_answered_at_once_without_a_result_or_pairs) {
  const PipelineInput input = drive();
  PipelineOutput output = registered(input, 20);
  Progress progress;
  EXPECT_FALSE(solve_at_once(input, output, progress)) << "nothing was solved yet";
  output.result.status = Status::Ok;
  output.result.observed.fill(true);
  EXPECT_FALSE(solve_at_once(input, output, progress)) << "no pair takes part";
}

}  // namespace
}  // namespace remount
