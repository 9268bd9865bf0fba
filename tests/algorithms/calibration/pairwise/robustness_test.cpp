// Gross outliers: registrations that went wrong by 5 deg and a metre.
#include <gtest/gtest.h>

#include <cstdio>
#include <ctime>

#include "algorithms/calibration/pairwise/pairwise.h"
#include "algorithms/calibration/pairwise/robust_start.h"
#include "algorithms/messages/render.h"
#include "algorithms/motion/screw.h"
#include "tests/algorithms/support/simulated_drive.h"

namespace remount::calibration {
namespace {

// 200 pairs; each keyframe with the next few.
testing::DriveOptions two_hundred_pairs() {
  testing::DriveOptions options;
  options.keyframes = 68;
  options.partners = 3;
  options.noise.ins_position_sigma_m = 0.003;
  options.noise.ins_attitude_sigma_rad = 2e-4;
  options.noise.registration_scale = 2.0;
  return options;
}

// Wrong by 5 deg about any axis and by a metre in any direction.
std::vector<motion::Pair> with_outliers(std::vector<motion::Pair> pairs, double share, int seed) {
  std::mt19937_64 random(static_cast<std::uint64_t>(seed));
  std::vector<std::size_t> order(pairs.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random() % i]);
  for (std::size_t k = 0; k < static_cast<std::size_t>(share * static_cast<double>(pairs.size())); ++k) {
    Vector6d wrong;
    wrong << testing::random_vector(random, 1.0).normalized(),
        degrees_to_radians(5.0) * testing::random_vector(random, 1.0).normalized();
    RigidTransform& measured = pairs[order[k]].lidar_b_from_lidar_a;
    measured = perturb(measured, wrong);
  }
  for (motion::Pair& pair : pairs)
    pair.screw = motion::screw_test(pair.ins_b_from_ins_a, pair.lidar_b_from_lidar_a, 1e-3, 0.03, 5.0);
  return pairs;
}

std::vector<motion::PairIndex> all_of(const std::vector<motion::Pair>& pairs) {
  std::vector<motion::PairIndex> all;
  for (motion::PairIndex i; i < pairs.size(); ++i) all.push_back(i);
  return all;
}

double error_m(const RigidTransform& x) { return (x.translation() - testing::mounting().translation()).norm(); }
double error_deg(const RigidTransform& x) {
  return radians_to_degrees(rotation_angle_between_rad(x, testing::mounting()));
}

bool gives_an_answer(const CalibrationResult& result) {
  return result.status == Status::Ok || result.status == Status::Degenerate;
}

// Four drives, each with and without a nominal: solved within the limits, whatever is wrong with a share of the pairs.
void expect_solved(double wrong_share, int first_seed, double most_deg, double most_m) {
  const testing::DriveOptions options = two_hundred_pairs();
  for (int seed = 1; seed <= 4; ++seed)
    for (const bool with_nominal : {true, false}) {
      const testing::SimulatedDrive drive = testing::simulate(options, seed);
      std::vector<motion::Pair> pairs = with_outliers(testing::pairs_of(drive), wrong_share, first_seed + seed);
      PairwiseInput input = testing::input_of(drive, options);
      if (with_nominal) input.nominal_ins_from_lidar = perturb(testing::mounting(), Vector6d::Constant(0.05));
      const CalibrationResult result = solve_pairwise(input, pairs, {});
      std::printf("  %zu pairs, %d rejected: %.4f deg, %.1f mm\n", pairs.size(), result.pairs_rejected,
                  error_deg(result.mounting.reference_from_sensor),
                  1e3 * error_m(result.mounting.reference_from_sensor));
      ASSERT_TRUE(gives_an_answer(result)) << english(result.message);
      EXPECT_LE(error_deg(result.mounting.reference_from_sensor), most_deg) << "seed " << seed;
      EXPECT_LE(error_m(result.mounting.reference_from_sensor), most_m) << "seed " << seed;
    }
}

TEST(robustness, forty_percent_gross_outliers_leave_five_hundredths_of_a_degree_and_a_centimetre) {
  expect_solved(0.4, 100, 0.05, 0.01);
}

TEST(robustness, sixty_percent_gross_outliers_are_rejected_too) { expect_solved(0.6, 200, 0.1, 0.02); }

TEST(robust_start, sixty_percent_gross_outliers_do_not_pull_it) {
  const testing::DriveOptions options = two_hundred_pairs();
  for (int seed = 1; seed <= 4; ++seed) {
    const std::vector<motion::Pair> pairs =
        with_outliers(testing::pairs_of(testing::simulate(options, seed)), 0.6, 200 + seed);
    const RobustStart start = robust_start(pairs, all_of(pairs), options.noise, std::nullopt, {}, {0, 0, 0});
    std::printf("  %.4f deg, %.1f mm\n", error_deg(start.ins_from_lidar), 1e3 * error_m(start.ins_from_lidar));
    EXPECT_LT(error_deg(start.ins_from_lidar), 0.1) << "seed " << seed;
    EXPECT_LT(error_m(start.ins_from_lidar), 0.05) << "seed " << seed;
  }
}

TEST(robust_start, is_exact_on_exact_pairs_with_outliers_of_any_kind) {
  testing::DriveOptions options = two_hundred_pairs();
  options.noise = testing::no_noise();
  const testing::SimulatedDrive drive = testing::simulate(options, 3);
  for (const double share : {0.0, 0.2, 0.4, 0.6}) {
    const std::vector<motion::Pair> pairs = with_outliers(testing::pairs_of(drive), share, 7);
    const RobustStart start = robust_start(pairs, all_of(pairs), NoiseModel{}, std::nullopt, {}, {0, 0, 0});
    EXPECT_LT(error_deg(start.ins_from_lidar), 0.01) << share;
    EXPECT_LT(error_m(start.ins_from_lidar), 0.01) << share;
  }
}

TEST(robust_start, a_wrong_nominal_does_not_hold_it_back) {
  const testing::DriveOptions options = two_hundred_pairs();
  const testing::SimulatedDrive drive = testing::simulate(options, 4);
  const std::vector<motion::Pair> pairs = with_outliers(testing::pairs_of(drive), 0.4, 8);
  const RigidTransform wrong = perturb(testing::mounting(), (Vector6d() << 2, -2, 1, 0.5, -0.5, 2.0).finished());
  RotationReference reference;
  reference.ins_from_lidar = wrong.linear();
  const RobustStart start = robust_start(pairs, all_of(pairs), options.noise, wrong, reference, wrong.translation());
  EXPECT_LT(error_deg(start.ins_from_lidar), 0.2);
  EXPECT_LT(error_m(start.ins_from_lidar), 0.05);
}

TEST(robust_start, straight_driving_turns_about_the_track_as_the_reference_says) {
  testing::DriveOptions options = two_hundred_pairs();
  options.tilt_rad = options.turn_rad = 0.0;
  options.noise = testing::no_noise();
  const testing::SimulatedDrive drive = testing::simulate(options, 5);
  const std::vector<motion::Pair> pairs = testing::pairs_of(drive);
  RotationReference reference;
  reference.ins_from_lidar = testing::mounting().linear();
  const RobustStart start =
      robust_start(pairs, all_of(pairs), NoiseModel{}, std::nullopt, reference, testing::mounting().translation());
  EXPECT_LT(error_deg(start.ins_from_lidar), 0.01);
}

TEST(robust_start, stays_near_where_a_nearly_straight_road_shows_little) {
  testing::DriveOptions options = two_hundred_pairs();
  options.tilt_rad = options.turn_rad = 0.01;
  options.noise.registration_scale = 10.0;
  RotationReference reference;
  reference.up_in_lidar = testing::mounting().linear().transpose() * Eigen::Vector3d::UnitZ();
  double most_m = 0.0, most_deg = 0.0;
  for (int seed = 1; seed <= 5; ++seed) {
    const std::vector<motion::Pair> pairs =
        with_outliers(testing::pairs_of(testing::simulate(options, seed)), 0.3, 20 + seed);
    const RobustStart start = robust_start(pairs, all_of(pairs), options.noise, std::nullopt, reference, {0, 0, 0});
    most_m = std::max(most_m, start.ins_from_lidar.translation().norm());
    most_deg = std::max(most_deg, error_deg(start.ins_from_lidar));
  }
  std::printf("  at most %.2f m and %.2f deg\n", most_m, most_deg);
  EXPECT_LT(most_m, 6.0);
  EXPECT_LT(most_deg, 15.0);
}

TEST(robust_start, the_noise_scale_says_how_far_the_model_is_off) {
  testing::DriveOptions options = two_hundred_pairs();
  const testing::SimulatedDrive drive = testing::simulate(options, 6);
  const std::vector<motion::Pair> pairs = testing::pairs_of(drive);
  NoiseModel optimistic = options.noise;
  optimistic.ins_position_sigma_m *= 0.1;
  optimistic.ins_attitude_sigma_rad *= 0.1;
  optimistic.registration_scale *= 0.1;
  optimistic.registration_floor_m *= 0.1;
  optimistic.registration_floor_rad *= 0.1;
  EXPECT_NEAR(robust_start(pairs, all_of(pairs), options.noise, std::nullopt, {}, {0, 0, 0}).noise_scale, 1.0, 0.25);
  EXPECT_NEAR(robust_start(pairs, all_of(pairs), optimistic, std::nullopt, {}, {0, 0, 0}).noise_scale, 10.0, 2.5);
}

TEST(robust_start, two_thousand_pairs_take_milliseconds_a_pass) {
  testing::DriveOptions options;
  options.keyframes = 668;
  const testing::SimulatedDrive drive = testing::simulate(options, 7);
  const std::vector<motion::Pair> pairs = with_outliers(testing::pairs_of(drive), 0.4, 9);
  const std::clock_t begin = std::clock();
  const RobustStart start = robust_start(pairs, all_of(pairs), options.noise, std::nullopt, {}, {0, 0, 0});
  const double all_ms = 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  std::printf("  %zu pairs: %.1f ms in %d passes, %.2f ms each\n", pairs.size(), all_ms, start.passes,
              all_ms / start.passes);
  EXPECT_LT(error_deg(start.ins_from_lidar), 0.05);
}

}  // namespace
}  // namespace remount::calibration
