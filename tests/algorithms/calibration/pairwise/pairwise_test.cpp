#include "algorithms/calibration/pairwise/pairwise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

#include "algorithms/calibration/observability.h"
#include "algorithms/calibration/pairwise/uncertainty.h"
#include "algorithms/messages/render.h"
#include "messages/pairs.h"
#include "tests/algorithms/support/simulated_drive.h"

namespace remount::calibration {

using motion::Pair;
using testing::DriveOptions;

namespace {

const RigidTransform kNominal =
    perturb(testing::mounting(), (Vector6d() << 0.1, -0.1, 0.1, 0.03, -0.02, 0.03).finished());

struct Solved {
  CalibrationResult result;
  std::vector<Pair> pairs;
};

Solved solve(const testing::SimulatedDrive& drive, const DriveOptions& options, const std::vector<Pair>& pairs,
             bool with_nominal = true, const Progress& progress = {}) {
  PairwiseInput input = testing::input_of(drive, options);
  if (with_nominal) input.nominal_ins_from_lidar = kNominal;
  Solved solved{{}, pairs};
  solved.result = solve_pairwise(input, solved.pairs, progress);
  return solved;
}

Solved solve(const DriveOptions& options, int seed, bool with_nominal = true) {
  const testing::SimulatedDrive drive = testing::simulate(options, seed);
  return solve(drive, options, testing::pairs_of(drive), with_nominal);
}

double error_m(const CalibrationResult& result) {
  return (result.mounting.reference_from_sensor.translation() - testing::mounting().translation()).norm();
}
double error_rad(const CalibrationResult& result) {
  return rotation_angle_between_rad(result.mounting.reference_from_sensor, testing::mounting());
}

TEST(pairwise, is_exact_on_exact_data_with_and_without_a_nominal) {
  DriveOptions options;
  options.noise = testing::no_noise();
  for (const bool with_nominal : {true, false}) {
    const CalibrationResult result = solve(options, 1, with_nominal).result;
    EXPECT_EQ(result.status, Status::Ok) << english(result.message);
    EXPECT_LT(error_m(result), 1e-6);
    EXPECT_LT(error_rad(result), 1e-7);
    EXPECT_EQ(result.pairs_rejected, 0);
    EXPECT_LT(result.translation_rms_m, 1e-6);
    EXPECT_LT(result.frobenius_sum, 1e-5);
  }
}

TEST(pairwise, noisy_errors_are_within_the_sigmas_and_every_parameter_is_observed) {
  DriveOptions options;
  options.keyframes = 80;
  double sum = 0.0;
  constexpr int kProblems = 8;
  for (int seed = 1; seed <= kProblems; ++seed) {
    const CalibrationResult result = solve(options, seed).result;
    ASSERT_EQ(result.status, Status::Ok) << english(result.message);
    const SixParameters found = six_from_rigid(result.mounting.reference_from_sensor),
                        truth = six_from_rigid(testing::mounting());
    const double errors[] = {found.x_m - truth.x_m,
                             found.y_m - truth.y_m,
                             found.z_m - truth.z_m,
                             found.yaw_rad - truth.yaw_rad,
                             found.pitch_rad - truth.pitch_rad,
                             found.roll_rad - truth.roll_rad};
    // These drives have exactly the modelled errors, so what is added for real registrations is taken off again.
    const Matrix6d allowance = parameter_covariance(result.mounting.reference_from_sensor, registration_limits(false));
    for (std::size_t i = 0; i < 6; ++i) {
      ASSERT_TRUE(result.estimate(kParameters[i]).sigma) << to_string(kParameters[i]);
      const auto at = static_cast<Eigen::Index>(i);
      const double modelled2 =
          *result.estimate(kParameters[i]).sigma * *result.estimate(kParameters[i]).sigma - allowance(at, at);
      ASSERT_GT(modelled2, 0.0) << to_string(kParameters[i]);
      const double ratio = errors[i] / std::sqrt(modelled2);
      EXPECT_LT(std::abs(ratio), 4.0) << to_string(kParameters[i]) << ", seed " << seed;
      sum += ratio * ratio;
    }
  }
  std::printf("  mean squared normalised error %.2f\n", sum / (6 * kProblems));
  EXPECT_GT(sum / (6 * kProblems), 0.3);
  EXPECT_LT(sum / (6 * kProblems), 1.8);
}

TEST(pairwise, thirty_percent_outliers_are_rejected_each_with_a_reason) {
  const DriveOptions options;
  const testing::SimulatedDrive drive = testing::simulate(options, 2);
  for (const bool with_nominal : {true, false}) {
    std::vector<Pair> pairs = testing::pairs_of(drive);
    std::mt19937_64 random(9);
    std::set<std::size_t> wrong;
    for (std::size_t i = 0; i < pairs.size(); ++i)
      if (i % 10 < 3) {
        wrong.insert(i);
        pairs[i].lidar_b_from_lidar_a = perturb(pairs[i].lidar_b_from_lidar_a, testing::random_step(random, 1.0, 0.1));
      }
    const Solved solved = solve(drive, options, pairs, with_nominal);
    int good_rejected = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const Pair& pair = solved.pairs[i];
      if (!wrong.contains(i)) {
        good_rejected += pair.state == motion::PairState::Rejected ? 1 : 0;
        continue;
      }
      EXPECT_EQ(pair.state, motion::PairState::Rejected) << i;
      EXPECT_EQ(pair.weight, 0.0) << i;
      EXPECT_NE(english(pair.reason).find("contradicts the INS motion"), std::string::npos)
          << i << ": " << english(pair.reason);
    }
    EXPECT_LE(good_rejected, 3);
    EXPECT_LT(error_m(solved.result), 0.05) << english(solved.result.message);
    EXPECT_LT(error_rad(solved.result), 2e-3);
    EXPECT_EQ(solved.result.pairs_accepted + solved.result.pairs_rejected, solved.result.pairs_proposed);
  }
}

TEST(pairwise, what_the_user_decided_stays) {
  const DriveOptions options;
  const testing::SimulatedDrive drive = testing::simulate(options, 3);
  std::vector<Pair> pairs = testing::pairs_of(drive);
  pairs[4].state = motion::PairState::Rejected;  // a good one
  pairs[4].decided_by = motion::DecidedBy::User;
  pairs[4].reason = Message::verbatim("rain");
  pairs[7].state = motion::PairState::Accepted;  // a wrong one
  pairs[7].decided_by = motion::DecidedBy::User;
  pairs[7].lidar_b_from_lidar_a.translation().x() += 0.5;
  const Solved solved = solve(drive, options, pairs);
  EXPECT_EQ(solved.pairs[4].state, motion::PairState::Rejected);
  EXPECT_EQ(english(solved.pairs[4].reason), "rain");
  EXPECT_EQ(solved.pairs[7].state, motion::PairState::Accepted);
  EXPECT_EQ(solved.pairs[7].decided_by, motion::DecidedBy::User);
  EXPECT_GT(solved.pairs[7].weight, 0.0);
  EXPECT_EQ(solved.pairs[5].decided_by, motion::DecidedBy::Program);
}

TEST(pairwise, as_many_pairs_are_counted_as_are_used_whatever_was_accepted) {
  const DriveOptions options;
  const testing::SimulatedDrive drive = testing::simulate(options, 3);
  std::vector<Pair> pairs = testing::pairs_of(drive);
  const auto accept = [&](std::size_t i) {
    pairs[i].state = motion::PairState::Accepted;
    pairs[i].decided_by = motion::DecidedBy::User;
    pairs[i].lidar_b_from_lidar_a.translation().x() += 3.0;
  };
  accept(4);
  pairs[4].registration.converged = true;
  pairs[4].registration.failure = Message::verbatim("only 12% of the points overlap");
  accept(6);
  pairs[6].registration.attempted = false;
  const Solved solved = solve(drive, options, pairs);
  const std::size_t used = static_cast<std::size_t>(
      std::count_if(solved.pairs.begin(), solved.pairs.end(), [](const Pair& pair) { return pair.weight > 0.0; }));
  EXPECT_EQ(static_cast<std::size_t>(solved.result.pairs_accepted), used);
  EXPECT_EQ(solved.pairs[4].state, motion::PairState::Rejected);
  EXPECT_EQ(english(solved.pairs[4].reason), "only 12% of the points overlap");
  EXPECT_EQ(solved.pairs[6].state, motion::PairState::Rejected);
  EXPECT_NE(english(solved.pairs[6].reason), "");
  EXPECT_LT(solved.result.translation_rms_m, 0.5) << "their motion is in the residuals";
}

TEST(pairwise, takes_nothing_from_a_pair_where_its_scans_determine_nothing) {
  const DriveOptions options;
  const testing::SimulatedDrive drive = testing::simulate(options, 3);
  std::vector<Pair> pairs = testing::pairs_of(drive);
  // A corridor's length: whatever stands there does not count, and the pair is good for the rest.
  for (const std::size_t i : {2U, 5U, 8U}) {
    Matrix6d& information = pairs[i].registration.information;
    information.row(0).setZero();
    information.col(0).setZero();
    pairs[i].registration.undetermined = Message::verbatim("x (axes of the lidar)");
    pairs[i].lidar_b_from_lidar_a.translation().x() += i == 8U ? 2.0 : 0.6;
  }
  pairs[6].registration.information.setZero();
  const Solved solved = solve(drive, options, pairs);
  for (const std::size_t i : {2U, 5U}) {
    EXPECT_EQ(solved.pairs[i].state, motion::PairState::Accepted) << english(solved.pairs[i].reason);
    EXPECT_EQ(english(solved.pairs[i].reason), "does not determine x (axes of the lidar)");
  }
  EXPECT_EQ(solved.pairs[8].state, motion::PairState::Rejected) << "so far off it was never there";
  EXPECT_TRUE(english(solved.pairs[8].reason).starts_with("aligned ")) << english(solved.pairs[8].reason);
  EXPECT_TRUE(english(solved.pairs[8].reason).ends_with("the INS was; does not determine x (axes of the lidar)"))
      << english(solved.pairs[8].reason);
  EXPECT_NE(solved.pairs[6].state, motion::PairState::Accepted);
  const Solved plain = solve(drive, options, testing::pairs_of(drive));
  const Vector6d apart =
      difference(plain.result.mounting.reference_from_sensor, solved.result.mounting.reference_from_sensor);
  EXPECT_LT(apart.head<3>().norm(), 0.02) << apart.transpose();
  EXPECT_LT(apart.tail<3>().norm(), degrees_to_radians(0.1)) << apart.transpose();
}

TEST(pairwise, flat_driving_keeps_the_nominal_height_and_says_so) {
  DriveOptions options;
  options.tilt_rad = 0.0;
  for (const bool noisy : {false, true}) {
    if (!noisy)
      options.noise = testing::no_noise();
    else
      options.noise = NoiseModel{};
    const CalibrationResult result = solve(options, 4).result;
    EXPECT_EQ(result.status, Status::Degenerate) << english(result.message);
    EXPECT_FALSE(result.known[Parameter::Z].observed);
    EXPECT_FALSE(result.estimate(Parameter::Z).sigma);
    EXPECT_TRUE(std::isnan(result.covariance(2, 2)) && !result.known[Parameter::Z].bootstrap_sigma);
    EXPECT_NEAR(result.mounting.reference_from_sensor.translation().z(), kNominal.translation().z(), 1e-9);
    EXPECT_TRUE(result.known[Parameter::X].observed && result.known[Parameter::Y].observed &&
                result.known[Parameter::Yaw].observed);
    EXPECT_LT(
        (result.mounting.reference_from_sensor.translation() - testing::mounting().translation()).head<2>().norm(),
        0.1);
    EXPECT_NE(english(result.message).find(" z"), std::string::npos) << english(result.message);
    ASSERT_FALSE(result.advice.empty());
    EXPECT_NE(english(result.advice.front()).find("Height"), std::string::npos) << english(result.advice.front());
    EXPECT_FALSE(result.directions.front().observed);
  }
}

TEST(pairwise, straight_driving_shows_no_translation_and_no_roll) {
  DriveOptions options;
  options.tilt_rad = options.turn_rad = 0.0;
  const CalibrationResult result = solve(options, 5).result;
  EXPECT_EQ(result.status, Status::Degenerate) << english(result.message);
  for (const std::size_t i : {0, 1, 2, 5})
    EXPECT_FALSE(result.known[kParameters[i]].observed) << to_string(kParameters[i]);
  EXPECT_LT((result.mounting.reference_from_sensor.translation() - kNominal.translation()).norm(), 1e-9)
      << "kept at the nominal";
  EXPECT_FALSE(result.advice.empty());
}

TEST(pairwise, a_bias_by_the_clock_joins_the_sigmas_and_what_it_covers_is_not_observed) {
  const DriveOptions options;
  const testing::SimulatedDrive drive = testing::simulate(options, 4);
  PairwiseInput input = testing::input_of(drive, options);
  std::vector<Pair> pairs = testing::pairs_of(drive);
  const CalibrationResult right = solve_pairwise(input, pairs, {});
  ASSERT_EQ(right.status, Status::Ok) << english(right.message);
  input.clock_bias = Vector6d::Unit(0) * 0.03;
  const CalibrationResult biased = solve_pairwise(input, pairs, {});
  EXPECT_NEAR(*biased.estimate(Parameter::X).sigma, std::hypot(*right.estimate(Parameter::X).sigma, 0.03), 1e-9);
  EXPECT_NEAR(*biased.estimate(Parameter::Y).sigma, *right.estimate(Parameter::Y).sigma, 1e-9);
  ASSERT_FALSE(biased.advice.empty());
  EXPECT_NE(english(biased.advice.back()).find("did not settle"), std::string::npos) << english(biased.advice.back());
  input.options.apply_time_offset = ClockOffsetUse::No;
  const CalibrationResult as_set = solve_pairwise(input, pairs, {});
  ASSERT_FALSE(as_set.advice.empty());
  EXPECT_NE(english(as_set.advice.back()).find("apply_time_offset"), std::string::npos)
      << english(as_set.advice.back());
  input.clock_bias = Vector6d::Unit(0) * 1.0;
  const CalibrationResult lost = solve_pairwise(input, pairs, {});
  EXPECT_EQ(lost.status, Status::Degenerate);
  EXPECT_FALSE(lost.known[Parameter::X].observed);
  EXPECT_TRUE(lost.known[Parameter::Y].observed);
  EXPECT_FALSE(lost.directions.front().observed);
  EXPECT_NE(english(lost.directions.front().words).find("clocks"), std::string::npos) << lost.directions.front().words;
  for (const std::string& advice : english(lost.advice))
    EXPECT_EQ(advice.find("figure of eight"), std::string::npos) << advice;
}

TEST(pairwise, without_a_nominal_nothing_is_claimed_while_yaw_is_unknown) {
  DriveOptions options;
  options.tilt_rad = options.turn_rad = 0.0;
  const testing::SimulatedDrive drive = testing::simulate(options, 5);
  PairwiseInput input = testing::input_of(drive, options);
  input.options.max_rotation_sigma_deg = 1e-4;
  input.nominal_ins_from_lidar.reset();
  std::vector<Pair> pairs = testing::pairs_of(drive);
  const CalibrationResult result = solve_pairwise(input, pairs, {});
  ASSERT_FALSE(result.known[Parameter::Yaw].observed) << english(result.message);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_FALSE(result.known[kParameters[i]].observed) << to_string(kParameters[i]);
  for (const ObservabilityDirection& direction : result.directions)
    EXPECT_FALSE(direction.observed || english(direction.words).ends_with("observed")) << direction.words;
}

TEST(pairwise, what_a_chance_few_of_many_pairs_say_is_not_claimed_without_a_nominal) {
  const DriveOptions options;
  const testing::SimulatedDrive drive = testing::simulate(options, 6);
  std::vector<Pair> pairs = testing::pairs_of(drive);
  for (std::size_t i = 0; i < pairs.size(); ++i)
    if (i % 25 != 0) pairs[i].registration.failure = Message::verbatim("overlap too small");
  const CalibrationResult lost = solve(drive, options, pairs, false).result;
  EXPECT_EQ(lost.status, Status::Degenerate);
  EXPECT_EQ(english(lost.message), "Nothing is known: hardly any pairs go together.");
  EXPECT_EQ(parameter_names(lost.observed()), "") << lost.pairs_accepted << " of " << pairs.size();
  const CalibrationResult guided = solve(drive, options, pairs, true).result;
  EXPECT_NE(parameter_names(guided.observed()), "") << english(guided.message);
  // Those that the user took out were not tried in vain.
  for (Pair& pair : pairs)
    if (!pair.registration.failure.empty()) {
      pair.state = motion::PairState::Rejected;
      pair.decided_by = motion::DecidedBy::User;
    }
  EXPECT_NE(parameter_names(solve(drive, options, pairs, false).result.observed()), "");
  // Nor were those that a cancelled calibration never came to.
  for (Pair& pair : pairs)
    if (!pair.registration.failure.empty()) {
      pair.decided_by = motion::DecidedBy::Program;
      pair.reason = say::pair_not_reached();
      pair.registration.failure = pair.reason;
    }
  EXPECT_NE(parameter_names(solve(drive, options, pairs, false).result.observed()), "");
}

TEST(pairwise, too_few_pairs_is_a_result_with_advice) {
  const DriveOptions options;
  const testing::SimulatedDrive drive = testing::simulate(options, 6);
  std::vector<Pair> pairs = testing::pairs_of(drive);
  for (std::size_t i = 2; i < pairs.size(); ++i)
    pairs[i].registration.failure = Message::verbatim("overlap too small: 0.1, limit 0.3");
  const Solved failed = solve(drive, options, pairs);
  EXPECT_EQ(failed.result.status, Status::TooFewPairs);
  EXPECT_NE(english(failed.result.message).find("2 usable"), std::string::npos) << english(failed.result.message);
  EXPECT_FALSE(failed.result.advice.empty());
  EXPECT_EQ(solve(drive, options, {}).result.status, Status::TooFewPairs);
}

TEST(pairwise, a_solution_outside_the_search_range_says_which_parameter) {
  const DriveOptions options;
  const testing::SimulatedDrive drive = testing::simulate(options, 7);
  PairwiseInput input = testing::input_of(drive, options);
  input.range.z_max_m = 1.0;
  std::vector<Pair> pairs = testing::pairs_of(drive);
  const CalibrationResult result = solve_pairwise(input, pairs, {});
  EXPECT_EQ(result.status, Status::OutOfRange);
  EXPECT_NE(english(result.message).find("z 1.6"), std::string::npos) << english(result.message);
}

TEST(pairwise, cancelled_is_a_result) {
  std::stop_source stop;
  stop.request_stop();
  const DriveOptions options;
  const testing::SimulatedDrive drive = testing::simulate(options, 8);
  EXPECT_EQ(solve(drive, options, testing::pairs_of(drive), true, Progress(stop.get_token())).result.status,
            Status::Cancelled);
}

TEST(pairwise, same_input_same_bytes) {
  const DriveOptions options;
  const CalibrationResult first = solve(options, 9).result, second = solve(options, 9).result;
  EXPECT_TRUE(first.mounting.ins_from_lidar().matrix() == second.mounting.ins_from_lidar().matrix());
  EXPECT_TRUE(first.covariance == second.covariance);
  for (const Parameter parameter : kParameters)
    EXPECT_EQ(first.known[parameter].bootstrap_sigma, second.known[parameter].bootstrap_sigma);
  ASSERT_EQ(first.candidates.size(), second.candidates.size());
  for (std::size_t i = 0; i < first.candidates.size(); ++i)
    EXPECT_EQ(first.candidates[i].source, second.candidates[i].source);
}

TEST(pairwise, the_list_of_candidates_is_limited_and_holds_the_refined_one) {
  const DriveOptions options;
  const testing::SimulatedDrive drive = testing::simulate(options, 10);
  PairwiseInput input = testing::input_of(drive, options);
  input.options.max_listed_candidates = 5;
  std::vector<Pair> pairs = testing::pairs_of(drive);
  const CalibrationResult result = solve_pairwise(input, pairs, {});
  ASSERT_EQ(result.candidates.size(), 5U);
  EXPECT_TRUE(std::any_of(result.candidates.begin(), result.candidates.end(),
                          [](const Candidate& candidate) { return candidate.source == MountingSource::Refined; }));
}

}  // namespace
}  // namespace remount::calibration
