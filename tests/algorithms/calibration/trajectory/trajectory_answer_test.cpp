#include "algorithms/calibration/trajectory/trajectory_answer.h"

#include <gtest/gtest.h>

#include "algorithms/calibration/trajectory/trajectory_alignment.h"
#include "tests/algorithms/support/named_quantity.h"
#include "tests/algorithms/support/trajectory_drive.h"

namespace remount::calibration {
namespace {

TEST(trajectory_answer, sessions_that_say_nothing_have_no_part_in_clock_and_scale) {
  testing::TrajectoryDriveOptions drive;
  drive.clock_s = 0.03;
  TrajectoryProblem one;
  one.estimate_clock = true;
  one.sessions.push_back(testing::trajectory_session(drive));
  TrajectoryProblem with_empty = one;
  with_empty.sessions.emplace_back();
  const TrajectoryAnswer alone = solve_alignment(one, {}, {}, Progress{}).answer;
  const TrajectoryAnswer both = solve_alignment(with_empty, {}, {}, Progress{}).answer;
  ASSERT_TRUE(both.result.time_offset.applied);
  EXPECT_NEAR(both.result.time_offset.offset_s, alone.result.time_offset.offset_s, 1e-6);
  EXPECT_NEAR(both.result.time_offset.sigma_s, alone.result.time_offset.sigma_s, 1e-6);
  EXPECT_EQ(both.result.session_time_offset_s.size(), 2u);
  EXPECT_NE(testing::quantity_of(both.quantities, "odometry scale"), nullptr);
  EXPECT_EQ(testing::quantity_of(both.quantities, "odometry scale 2"), nullptr);
}

TEST(trajectory_answer, a_scale_that_the_drive_does_not_show_is_not_observed) {
  TrajectoryProblem problem;
  problem.sessions.push_back(testing::trajectory_session(testing::TrajectoryDriveOptions{}));
  TrajectoryOptions options;
  const TrajectoryAnswer shown = solve_alignment(problem, options, {}, Progress{}).answer;
  ASSERT_NE(testing::quantity_of(shown.quantities, "odometry scale"), nullptr);
  EXPECT_TRUE(testing::quantity_of(shown.quantities, "odometry scale")->observed);
  options.odometry_scale_percent = 1e-4;
  const TrajectoryAnswer assumed = solve_alignment(problem, options, {}, Progress{}).answer;
  ASSERT_NE(testing::quantity_of(assumed.quantities, "odometry scale"), nullptr);
  EXPECT_FALSE(testing::quantity_of(assumed.quantities, "odometry scale")->observed);
  EXPECT_TRUE(std::isnan(testing::quantity_of(assumed.quantities, "odometry scale")->sigma));
}

TEST(trajectory_answer, clock_and_scale_are_those_of_the_state_that_is_kept) {
  testing::TrajectoryDriveOptions flat;
  flat.slope_rad = 0.0;
  flat.clock_s = 0.02;
  flat.scale = 0.01;
  TrajectoryProblem problem;
  problem.estimate_clock = true;
  problem.nominal_ins_from_lidar = flat.ins_from_lidar;
  problem.nominal_ins_from_lidar->translation() += Eigen::Vector3d(0.1, -0.1, 0.4);
  problem.sessions.push_back(testing::trajectory_session(flat));
  const TrajectoryOutcome outcome = solve_alignment(problem, {}, {}, Progress{});
  ASSERT_FALSE(outcome.answer.hold.isZero(0.0));
  const CalibrationResult& result = outcome.answer.result;
  EXPECT_EQ(result.session_time_offset_s.front(), outcome.solution.state.clock_s.front());
  EXPECT_EQ(result.time_offset.offset_s, outcome.solution.state.clock_s.front());
  EXPECT_EQ(testing::quantity_of(outcome.answer.quantities, "odometry scale")->value,
            1.0 + outcome.solution.state.scale.front());
}

}  // namespace
}  // namespace remount::calibration
