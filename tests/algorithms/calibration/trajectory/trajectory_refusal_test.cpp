#include "algorithms/calibration/trajectory/trajectory_refusal.h"

#include <gtest/gtest.h>

#include "algorithms/calibration/trajectory/trajectory_alignment.h"
#include "algorithms/messages/render.h"
#include "tests/algorithms/support/trajectory_drive.h"

namespace remount::calibration {
namespace {

constexpr double kFoot_m = 0.3048;

// Positions of the INS in feet, or poses of the LiDAR: the odometry then has `units_per_metre`.
TrajectoryProblem of_scale(double units_per_metre, unsigned seed, bool over_scans) {
  testing::TrajectoryDriveOptions drive;
  drive.scale = units_per_metre - 1.0;
  drive.duration_s = 60.0;
  drive.seed = seed;
  TrajectoryProblem problem;
  problem.sessions.push_back(testing::trajectory_session(drive));
  problem.sessions.back().odometry_over_scans = over_scans;
  return problem;
}

TEST(trajectory_refusal, a_scale_that_is_far_from_one_is_refused_with_that_reason) {
  for (const double units_per_metre : {kFoot_m, 1.0 / kFoot_m, 0.75, 1.3})
    for (const bool over_scans : {false, true})
      for (unsigned seed = 31; seed <= 33; ++seed) {
        const CalibrationResult result =
            solve_alignment(of_scale(units_per_metre, seed, over_scans), {}, {}, Progress{}).answer.result;
        EXPECT_EQ(result.status, Status::Inconsistent) << units_per_metre << ": " << english(result.message);
        EXPECT_EQ(
            english(result.message).find(units_per_metre < 1.0 ? "The way of the INS is" : "The way of the LiDAR is"),
            0u)
            << english(result.message);
        EXPECT_EQ(english(result.message).find("slipped") != std::string::npos, over_scans) << english(result.message);
        EXPECT_EQ(english(result.message).find("another drive") == std::string::npos, over_scans)
            << english(result.message);
        EXPECT_EQ(result.advice.size(), 1u);
      }
}

TEST(trajectory_refusal, a_scale_that_the_settings_expect_is_none_to_refuse) {
  for (const double units_per_metre : {0.98, 1.02, 1.12}) {
    const CalibrationResult result =
        solve_alignment(of_scale(units_per_metre, 34, true), {}, {}, Progress{}).answer.result;
    EXPECT_EQ(result.status, Status::Ok) << units_per_metre << ": " << english(result.message);
  }
  TrajectoryOptions options;
  options.odometry_scale_percent = 20.0;
  const CalibrationResult wide = solve_alignment(of_scale(1.3, 35, false), options, {}, Progress{}).answer.result;
  EXPECT_EQ(wide.status, Status::Ok) << english(wide.message);
}

TEST(trajectory_refusal, what_only_does_not_come_together_is_of_no_other_scale) {
  const TrajectoryProblem problem = of_scale(1.0, 36, true);
  TrajectoryState state;
  state.scale = {0.0};
  const auto refusal = refusal_of(problem, {}, state, false);
  ASSERT_TRUE(refusal);
  EXPECT_EQ(refusal->result.status, Status::NotConverged);
  EXPECT_FALSE(refusal_of(problem, {}, state, true));
}

}  // namespace
}  // namespace remount::calibration
