#include "algorithms/calibration/measured.h"

#include <gtest/gtest.h>

#include "algorithms/messages/render.h"
#include "tests/algorithms/support/simulated_drive.h"

namespace remount::calibration {
namespace {

MeasuredOptions everything() {
  MeasuredOptions options;
  options.x_m = 1.0, options.x_sigma_m = 0.01;
  options.y_m = -0.5, options.y_sigma_m = 0.01;
  options.z_m = 1.7, options.z_sigma_m = 0.01;
  options.yaw_deg = 70.0, options.yaw_sigma_deg = 0.5;
  options.pitch_deg = 10.0, options.pitch_sigma_deg = 0.5;
  options.roll_deg = -5.0, options.roll_sigma_deg = 0.5;
  options.ins_height_m = 0.6, options.ins_height_sigma_m = 0.02;
  return options;
}

TEST(measured, rows_are_the_derivatives_of_the_residuals) {
  const ObservedGround ground{Eigen::Vector3d(0.1, -0.2, 1.0).normalized(), 1.8, 0.01, 0.002};
  const Measured measured(everything(), ground);
  constexpr double kStep = 1e-6;
  const std::vector<MeasuredRow> rows = measured.rows(testing::mounting());
  ASSERT_EQ(rows.size(), 9U);
  for (int i = 0; i < 6; ++i) {
    const std::vector<MeasuredRow> after = measured.rows(perturb(testing::mounting(), kStep * Vector6d::Unit(i))),
                                   before = measured.rows(perturb(testing::mounting(), -kStep * Vector6d::Unit(i)));
    for (std::size_t r = 0; r < rows.size(); ++r)
      EXPECT_NEAR(rows[r].row[i], -(after[r].residual - before[r].residual) / (2.0 * kStep), 1e-6)
          << "row " << r << ", column " << i;
  }
}

TEST(measured, angles_are_compared_along_the_shorter_way) {
  MeasuredOptions options;
  options.yaw_deg = 179.0, options.yaw_sigma_deg = 1.0;
  const RigidTransform x = rigid_from_six({0.0, 0.0, 0.0, degrees_to_radians(-179.0), 0.0, 0.0});
  EXPECT_NEAR(Measured(options, {}).rows(x).front().residual, degrees_to_radians(-2.0), 1e-12);
}

TEST(measured, the_ground_agrees_with_the_pose_that_sees_it) {
  MeasuredOptions options;
  options.ins_height_m = 0.6, options.ins_height_sigma_m = 0.02;
  const RigidTransform& x = testing::mounting();
  const ObservedGround ground{x.linear().transpose() * Eigen::Vector3d::UnitZ(), 0.6 + x.translation().z(), 0.01,
                              0.002};
  for (const MeasuredRow& row : Measured(options, ground).rows(x)) EXPECT_NEAR(row.residual, 0.0, 1e-12);
}

CalibrationResult solve_flat(const MeasuredOptions& options, const std::optional<ObservedGround>& ground) {
  testing::DriveOptions drive_options;
  drive_options.tilt_rad = 0.0;
  const testing::SimulatedDrive drive = testing::simulate(drive_options, 5);
  PairwiseInput input = testing::input_of(drive, drive_options);
  input.measured = Measured(options, ground);
  std::vector<motion::Pair> pairs = testing::pairs_of(drive);
  return solve_pairwise(input, pairs, {});
}

TEST(measured, height_from_a_tape_stands_where_a_flat_drive_does_not_show_it) {
  MeasuredOptions options;
  EXPECT_FALSE(solve_flat(options, {}).known[Parameter::Z].observed);
  options.z_m = testing::mounting().translation().z() + 0.004;
  options.z_sigma_m = 0.01;
  const CalibrationResult result = solve_flat(options, {});
  ASSERT_TRUE(result.known[Parameter::Z].observed) << english(result.message);
  EXPECT_TRUE(result.known[Parameter::Z].measured);
  EXPECT_FALSE(result.known[Parameter::X].measured);
  EXPECT_NEAR(result.mounting.reference_from_sensor.translation().z(), options.z_m, 2e-3);
  EXPECT_NEAR(*result.estimate(Parameter::Z).sigma, 0.01, 2e-3);
  EXPECT_NE(english(result.message).find("measured"), std::string::npos) << english(result.message);
  EXPECT_TRUE(result.known[Parameter::Z].bootstrap_sigma == std::nullopt) << "resampling pairs says nothing of a tape";
  for (const std::string& advice : english(result.advice))
    EXPECT_EQ(advice.find("measured z"), std::string::npos) << "a flat drive cannot contradict it: " << advice;
  for (const ObservabilityDirection& direction : result.directions)
    if (std::abs(direction.direction[2]) > 0.9) {
      EXPECT_TRUE(direction.observed) << direction.words;
    }
}

TEST(measured, ground_under_an_ins_of_known_height_gives_z) {
  MeasuredOptions options;
  options.ins_height_m = 0.6, options.ins_height_sigma_m = 0.02;
  const ObservedGround ground{testing::mounting().linear().transpose() * Eigen::Vector3d::UnitZ(),
                              0.6 + testing::mounting().translation().z(), 0.005, 0.001};
  const CalibrationResult result = solve_flat(options, ground);
  ASSERT_TRUE(result.known[Parameter::Z].observed) << english(result.message);
  EXPECT_LT(std::abs(result.mounting.reference_from_sensor.translation().z() - testing::mounting().translation().z()),
            3.0 * *result.estimate(Parameter::Z).sigma);
  EXPECT_LT(*result.estimate(Parameter::Z).sigma, 0.05);
}

TEST(measured, what_contradicts_the_drive_is_named) {
  MeasuredOptions options;
  options.x_m = testing::mounting().translation().x() + 0.5;
  options.x_sigma_m = 0.005;
  const CalibrationResult result = solve_flat(options, {});
  bool named = false;
  for (const std::string& advice : english(result.advice))
    named = named || advice.find("measured x") != std::string::npos;
  EXPECT_TRUE(named);
  // Nobody knows whether the tape or the drive is wrong: neither makes sure of the other.
  EXPECT_FALSE(result.known[Parameter::X].observed);
  EXPECT_NEAR(result.mounting.reference_from_sensor.translation().x(), options.x_m, 0.05)
      << "in doubt, not unknown: the value stays";
  options.x_m = testing::mounting().translation().x() + 0.1;
  const CalibrationResult nearer = solve_flat(options, {});
  ASSERT_TRUE(nearer.estimate(Parameter::X).sigma);
  EXPECT_LT(std::abs(nearer.mounting.ins_from_lidar().translation().x() - testing::mounting().translation().x()),
            3.0 * *nearer.estimate(Parameter::X).sigma);
  options.x_sigma_m = 0.3;
  options.x_m = testing::mounting().translation().x() + 1.2;
  const CalibrationResult rough = solve_flat(options, {});
  ASSERT_TRUE(rough.estimate(Parameter::X).sigma) << "a rough measurement does not spoil what the drive knows well";
  EXPECT_GT(*rough.estimate(Parameter::X).sigma, *solve_flat({}, {}).estimate(Parameter::X).sigma)
      << "what contradicts does not make sure";
  options.x_sigma_m = 0.005;
  options.x_m = testing::mounting().translation().x();
  for (const std::string& advice : english(solve_flat(options, {}).advice))
    EXPECT_EQ(advice.find("measured x"), std::string::npos) << advice;
}

}  // namespace
}  // namespace remount::calibration
