// Users are told one X: residuals of pairs, their sums, and the reasons of rejection are all under that one.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "algorithms/calibration/joint/pair_equation.h"
#include "algorithms/calibration/pairwise/pairwise.h"
#include "algorithms/messages/render.h"
#include "tests/algorithms/support/simulated_drive.h"

namespace remount::calibration {
namespace {

struct Told {
  CalibrationResult result;
  std::vector<motion::Pair> pairs;
};

/// Hardly tilted, so that z is not observed and yet shows in the residuals; the nominal is a metre off in it. Every
/// ninth pair went wrong, and the user rejected one.
Told nearly_flat_drive() {
  testing::DriveOptions options;
  options.tilt_rad = 0.004;
  const testing::SimulatedDrive drive = testing::simulate(options, 3);
  PairwiseInput input = testing::input_of(drive, options);
  input.nominal_ins_from_lidar = testing::mounting();
  input.nominal_ins_from_lidar->translation().z() += 1.0;
  Told told{{}, testing::pairs_of(drive)};
  for (std::size_t i = 0; i < told.pairs.size(); i += 9) told.pairs[i].lidar_b_from_lidar_a.translation().y() += 0.7;
  told.pairs[1].state = motion::PairState::Rejected;
  told.pairs[1].decided_by = motion::DecidedBy::User;
  told.result = solve_pairwise(input, told.pairs, {});
  return told;
}

Vector6d residual_under(const RigidTransform& x, const motion::Pair& pair) {
  return difference(pair.lidar_b_from_lidar_a, predicted_lidar_motion(pair.ins_b_from_ins_a, x));
}

TEST(told_residuals, are_under_the_x_that_is_exported_where_z_is_not_observed) {
  const Told told = nearly_flat_drive();
  ASSERT_EQ(told.result.status, Status::Degenerate) << english(told.result.message);
  ASSERT_FALSE(told.result.known[Parameter::Z].observed);
  double translation2 = 0.0, rotation2 = 0.0;
  for (const motion::Pair& pair : told.pairs) {
    const Vector6d residual = residual_under(told.result.mounting.reference_from_sensor, pair);
    EXPECT_NEAR(pair.residual_translation_m, residual.head<3>().norm(), 1e-12);
    EXPECT_NEAR(pair.residual_rotation_rad, residual.tail<3>().norm(), 1e-12);
    if (pair.state != motion::PairState::Accepted) continue;
    translation2 += pair.residual_translation_m * pair.residual_translation_m;
    rotation2 += pair.residual_rotation_rad * pair.residual_rotation_rad;
  }
  ASSERT_GT(told.result.pairs_accepted, 50);
  EXPECT_NEAR(told.result.translation_rms_m, std::sqrt(translation2 / told.result.pairs_accepted), 1e-12);
  EXPECT_NEAR(told.result.rotation_rms_rad, std::sqrt(rotation2 / told.result.pairs_accepted), 1e-12);
  std::printf("z told %.3f m, rms %.4f m\n", told.result.mounting.reference_from_sensor.translation().z(),
              told.result.translation_rms_m);
}

TEST(told_residuals, reasons_of_rejection_give_the_numbers_of_their_pairs) {
  const Told told = nearly_flat_drive();
  int rejected = 0;
  for (const motion::Pair& pair : told.pairs) {
    if (pair.state != motion::PairState::Rejected || pair.decided_by != motion::DecidedBy::Program) continue;
    ++rejected;
    char numbers[80];
    std::snprintf(numbers, sizeof numbers, "%.3f m, %.3f deg", pair.residual_translation_m,
                  radians_to_degrees(pair.residual_rotation_rad));
    EXPECT_NE(english(pair.reason).find(numbers), std::string::npos) << english(pair.reason) << " but " << numbers;
  }
  EXPECT_GT(rejected, 10);
}

}  // namespace
}  // namespace remount::calibration
