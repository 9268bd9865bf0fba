#include "algorithms/calibration/pairwise/session_agreement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "algorithms/messages/render.h"
#include "tests/algorithms/support/simulated_drive.h"

namespace remount::calibration {
namespace {

CalibrationResult solve(const testing::DriveOptions& options, int seed, double second_turned_rad,
                        std::vector<motion::Pair>* judged = nullptr) {
  testing::SimulatedDrive drive = testing::simulate(options, seed);
  std::vector<motion::Pair> pairs = testing::pairs_of(drive);
  // A lidar that was turned between the sessions.
  const RigidTransform turn =
      make_rigid(so3_exp(Eigen::Vector3d(0.0, 0.0, second_turned_rad)), Eigen::Vector3d::Zero());
  for (motion::Pair& pair : pairs)
    if (drive.problem.nodes[pair.keyframe_a].session == motion::SessionIndex{1})
      pair.lidar_b_from_lidar_a = turn.inverse() * pair.lidar_b_from_lidar_a * turn;
  PairwiseInput input = testing::input_of(drive, options);
  input.session_names = {"monday", "tuesday", "wednesday"};
  const CalibrationResult result = solve_pairwise(input, pairs, {});
  if (judged != nullptr) *judged = pairs;
  return result;
}

TEST(session_agreement, is_about_one_where_the_errors_are_as_modelled) {
  testing::DriveOptions options;
  options.sessions = 3;
  double sum = 0.0;
  constexpr int kProblems = 5;
  for (int seed = 1; seed <= kProblems; ++seed) sum += solve(options, seed, 0.0).session_disagreement;
  EXPECT_GT(sum / kProblems, 0.6);
  EXPECT_LT(sum / kProblems, 1.4);
}

TEST(session_agreement, sessions_that_contradict_each_other_enlarge_every_sigma_and_are_reported) {
  testing::DriveOptions options;
  options.sessions = 2;
  const CalibrationResult together = solve(options, 3, 0.0), apart = solve(options, 3, 0.003);
  EXPECT_GT(apart.session_disagreement, 3.0);
  ASSERT_TRUE(together.estimate(Parameter::Yaw).sigma && apart.estimate(Parameter::Yaw).sigma);
  EXPECT_GT(*apart.estimate(Parameter::Yaw).sigma, 2.5 * *together.estimate(Parameter::Yaw).sigma);
  bool reported = false;
  for (const std::string& advice : english(apart.advice))
    reported = reported || advice.find("contradict") != std::string::npos;
  EXPECT_TRUE(reported);
}

TEST(session_agreement, a_session_that_all_others_contradict_is_left_out_with_the_reason) {
  testing::DriveOptions options;
  options.sessions = 3;
  std::vector<motion::Pair> pairs;
  const CalibrationResult result = solve(options, 4, 0.004, &pairs);
  EXPECT_LT(rotation_angle_between_rad(result.mounting.reference_from_sensor, testing::mounting()), 5e-4);
  EXPECT_LT(result.session_disagreement, 2.0);
  const auto of_second =
      static_cast<std::size_t>(std::count_if(pairs.begin(), pairs.end(), [](const motion::Pair& pair) {
        return english(pair.reason).find("its session contradicts") != std::string::npos;
      }));
  EXPECT_EQ(of_second, pairs.size() / 3);
  bool reported = false;
  for (const std::string& advice : english(result.advice))
    reported = reported || advice.find("Session 2 (tuesday)") != std::string::npos;
  EXPECT_TRUE(reported);
}

TEST(session_agreement, two_mountings_are_no_result_and_a_third_session_decides) {
  testing::DriveOptions options;
  options.sessions = 2;
  const CalibrationResult two = solve(options, 4, 1.5);
  EXPECT_EQ(two.status, Status::Inconsistent) << english(two.message);
  options.sessions = 3;
  const CalibrationResult three = solve(options, 4, 1.5);
  EXPECT_EQ(three.status, Status::Ok) << english(three.message);
  EXPECT_LT(rotation_angle_between_rad(three.mounting.ins_from_lidar(), testing::mounting()), 5e-4);
  bool reported = false;
  for (const std::string& advice : english(three.advice))
    reported = reported || advice.find("Session 2 (tuesday)") != std::string::npos;
  EXPECT_TRUE(reported);
}

TEST(session_agreement, a_scatter_that_may_be_chance_widens_less_than_one_that_cannot) {
  constexpr double kStated = 0.3, kAssumed = 1.5;
  EXPECT_EQ(widening({0.5, 6}, kStated), 1.0) << "agreeing by chance makes nothing smaller";
  EXPECT_EQ(widening({}, kStated), 1.0);
  EXPECT_NEAR(widening({2.0, 100000}, kStated), 2.0, 1e-3) << "many sessions are no chance";
  EXPECT_NEAR(widening({2.0, 6}, kAssumed), 2.0, 0.05) << "a noise that was only assumed is not defended";
  const double few = widening({2.0, 6}, kStated);
  EXPECT_GT(few, 1.4);
  EXPECT_LT(few, 1.7);
  // Over sessions whose errors are as stated, the mean square is hardly widened.
  std::mt19937 random(7);
  std::chi_squared_distribution<double> chi2(6.0);
  double sum = 0.0, plain = 0.0;
  constexpr int kDraws = 20000;
  for (int i = 0; i < kDraws; ++i) {
    const double ratio = std::sqrt(chi2(random) / 6.0);
    sum += std::pow(widening({ratio, 6}, kStated), 2) / kDraws;
    plain += std::max(1.0, ratio * ratio) / kDraws;
  }
  EXPECT_LT(sum, 1.0 + 0.6 * (plain - 1.0)) << "mean widening " << sum << " instead of " << plain;
}

TEST(session_agreement, a_single_session_says_nothing_of_it) {
  EXPECT_TRUE(std::isnan(solve({}, 1, 0.0).session_disagreement));
}

}  // namespace
}  // namespace remount::calibration
