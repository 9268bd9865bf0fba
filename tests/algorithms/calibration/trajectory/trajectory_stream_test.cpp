// Trajectories that are aligned while they grow.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "algorithms/messages/render.h"
#include "tests/algorithms/calibration/trajectory/solved_trajectories.h"
#include "tests/algorithms/support/size_of_error.h"
#include "tests/support/draws.h"

namespace remount::calibration {
namespace {

TEST(trajectory_stream, a_stream_ends_where_the_batch_does_and_says_when_it_converged) {
  TrajectoryDriveOptions drive;
  const TrajectoryProblem problem = problem_of({drive});
  TrajectoryOptions options;
  options.converged_translation_m = 0.1;
  TrajectoryAligner aligner(options, {}, std::nullopt, false);
  TrajectorySession empty = problem.sessions.front();
  empty.epochs.clear();
  aligner.add_session(empty);
  Progress progress;
  for (const TrajectoryEpoch& epoch : problem.sessions.front().epochs) {
    aligner.push(0, epoch);
    if (aligner.due()) aligner.update(progress);
  }
  const TrajectoryOutcome streamed = aligner.finish(progress), batch = solve(problem);
  EXPECT_EQ(streamed.answer.result.mounting.reference_from_sensor.matrix(),
            batch.answer.result.mounting.reference_from_sensor.matrix());
  EXPECT_EQ(streamed.answer.result.covariance, batch.answer.result.covariance);
  const TrajectorySnapshot& last = aligner.history().back();
  std::printf("  %zu answers; converged after %.1f s\n", aligner.history().size(), streamed.converged_after_s);
  EXPECT_GT(aligner.history().size(), 110u);
  EXPECT_FALSE(aligner.history().front().known);
  EXPECT_TRUE(last.known && last.converged);
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_LT(std::abs(error_of(batch.answer.result, last.mounting.ins_from_lidar())[static_cast<int>(i)]),
              0.5 * *last.sigma[kParameters[i]]);
  EXPECT_GT(streamed.converged_after_s, 10.0);
  EXPECT_LT(streamed.converged_after_s, 100.0);
  EXPECT_THROW(aligner.push(0, problem.sessions.front().epochs.back()), Error);
  EXPECT_THROW(aligner.push(3, {}), Error);
}

// An hour must not cost more an answer than some minutes do, and say the same.
TEST(trajectory_stream, answers_of_a_long_stream_solve_for_its_last_minutes_and_say_what_all_of_it_says) {
  ONLY_IN_LONG_TESTS();
  for (const bool positions_only : {false, true}) {
    TrajectoryDriveOptions drive;
    drive.duration_s = 800.0;
    drive.ins = !positions_only;
    drive.antenna = positions_only;
    drive.outliers = 0.05;
    const TrajectoryProblem problem = problem_of({drive});
    TrajectoryAligner aligner({}, {}, std::nullopt, false);
    aligner.add_session({});
    Progress progress;
    std::size_t most_open = 0;
    std::vector<double> took_ms;
    for (const TrajectoryEpoch& epoch : problem.sessions.front().epochs) {
      aligner.push(0, epoch);
      if (!aligner.due(5.0)) continue;
      const auto before = std::chrono::steady_clock::now();
      aligner.update(progress);
      took_ms.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - before).count());
      most_open = std::max(most_open, aligner.open_epochs());
    }
    const auto mean_ms = [&](std::size_t first, std::size_t last) {
      double sum = 0.0;
      for (std::size_t i = first; i < last; ++i) sum += took_ms[i] / static_cast<double>(last - first);
      return sum;
    };
    const TrajectorySnapshot& last = aligner.history().back();
    const CalibrationResult all = aligner.finish(progress).answer.result;
    std::printf(
        "  %zu epochs, at most %zu open, %zu cold starts; an answer took %.1f ms by minute 5, %.1f ms at the end\n",
        problem.sessions.front().epochs.size(), most_open, aligner.cold_starts(), mean_ms(48, 60),
        mean_ms(took_ms.size() - 12, took_ms.size()));
    EXPECT_LE(most_open, 620u);
    EXPECT_LT(aligner.cold_starts(), 14u);
    const Vector6d apart = error_of(all, last.mounting.reference_from_sensor);
    for (std::size_t i = 0; i < (positions_only ? 3 : 6); ++i) {
      ASSERT_TRUE(last.sigma[kParameters[i]] && all.known[kParameters[i]].observed) << to_string(kParameters[i]);
      const double sigma = all.estimate(kParameters[i]).sigma.value();
      std::printf("  %s: apart by %.2f sigma, sigma %.2f of that of all\n",
                  std::string(to_string(kParameters[i])).c_str(), apart[static_cast<int>(i)] / sigma,
                  *last.sigma[kParameters[i]] / sigma);
      EXPECT_LT(std::abs(apart[static_cast<int>(i)]), 0.5 * sigma) << to_string(kParameters[i]);
      EXPECT_NEAR(*last.sigma[kParameters[i]] / sigma, 1.0, 0.25) << to_string(kParameters[i]);
    }
  }
}

TEST(trajectory_stream, a_session_that_says_nothing_makes_no_answer_start_anew) {
  const TrajectoryProblem problem = problem_of({TrajectoryDriveOptions{}});
  TrajectoryAligner aligner({}, {}, std::nullopt, false);
  aligner.add_session({});
  aligner.add_session({});
  Progress progress;
  for (const TrajectoryEpoch& epoch : problem.sessions.front().epochs) {
    aligner.push(1, epoch);
    if (aligner.due()) aligner.update(progress);
  }
  std::printf("  %zu of %zu answers started anew\n", aligner.cold_starts(), aligner.history().size());
  EXPECT_GT(aligner.history().size(), 110u);
  EXPECT_LT(aligner.cold_starts(), 12u);
  EXPECT_TRUE(aligner.history().back().known);
}

TEST(trajectory_stream, a_cancelled_answer_leaves_no_trace) {
  const TrajectoryProblem problem = problem_of({TrajectoryDriveOptions{}});
  std::stop_source stop;
  stop.request_stop();
  Progress progress, cancelled(stop.get_token());
  TrajectoryAligner straight({}, {}, std::nullopt, false), broken({}, {}, std::nullopt, false);
  for (TrajectoryAligner* aligner : {&straight, &broken}) {
    aligner->add_session({});
    for (int i = 0; i < 80; ++i) aligner->push(0, problem.sessions.front().epochs[static_cast<std::size_t>(i)]);
    aligner->update(progress);
    for (int i = 80; i < 90; ++i) aligner->push(0, problem.sessions.front().epochs[static_cast<std::size_t>(i)]);
  }
  EXPECT_FALSE(broken.update(cancelled).known);
  EXPECT_TRUE(broken.due());
  const TrajectorySnapshot one = straight.update(progress), other = broken.update(progress);
  EXPECT_TRUE(one.known);
  EXPECT_EQ(one.mounting.ins_from_lidar().matrix(), other.mounting.ins_from_lidar().matrix());
  EXPECT_EQ(straight.history().size(), broken.history().size());
}

}  // namespace
}  // namespace remount::calibration
