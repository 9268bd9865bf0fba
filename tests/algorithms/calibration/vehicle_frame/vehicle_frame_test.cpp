#include "algorithms/calibration/vehicle_frame/vehicle_frame.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "algorithms/calibration/linear_solutions.h"
#include "algorithms/calibration/observability.h"
#include "algorithms/calibration/vehicle_frame/vehicle_frame_equations.h"
#include "algorithms/core/error.h"
#include "algorithms/messages/render.h"
#include "tests/algorithms/support/named_quantity.h"
#include "tests/algorithms/support/size_of_error.h"
#include "tests/algorithms/support/wheel_drive.h"

namespace remount::calibration {
using testing::WheelDriveOptions;
namespace {

VehicleFrameResult solve(const WheelDriveOptions& drive, int seed, const VehicleFrameOptions& options = {},
                         const std::optional<RigidTransform>& nominal = std::nullopt) {
  Progress progress;
  return solve_vehicle_frame({testing::wheel_drive(drive, seed).drive()}, nominal, options, SolveOptions{}, progress);
}

struct Errors {
  double rotation_deg;
  Eigen::Vector3d lever_m;
};

Errors errors_of(const VehicleFrameResult& result, const WheelDriveOptions& drive) {
  const RigidTransform& found = result.calibration.mounting.reference_from_sensor;
  Errors errors{radians_to_degrees(rotation_angle_between_rad(found, drive.vehicle_from_sensor)),
                found.translation() - drive.vehicle_from_sensor.translation()};
  std::printf("  %s: rotation %.4f deg, x %.4f, y %.4f, z %.4f m; scale %.5f; sigma",  //
              std::string(to_string(result.calibration.status)).c_str(), errors.rotation_deg, errors.lever_m.x(),
              errors.lever_m.y(), errors.lever_m.z(), result.scale);
  for (std::size_t i = 0; i < 6; ++i) {
    const double sigma = result.calibration.estimate(kParameters[i]).sigma.value_or(NAN);
    std::printf(" %.4f%s", i < 3 ? sigma : radians_to_degrees(sigma), i < 3 ? " m" : " deg");
  }
  std::printf("; %d intervals\n", result.intervals);
  return errors;
}

TEST(vehicle_frame, exact_signals_give_the_exact_mounting) {
  WheelDriveOptions drive;
  drive.imu_rate_hz = 200.0;
  drive.duration_s = 100.0;
  drive.gyro_bias_radps = {0.01, -0.02, 0.005};
  const VehicleFrameResult result = solve(drive, 1);
  const Errors errors = errors_of(result, drive);
  EXPECT_EQ(result.calibration.status, Status::Ok) << english(result.calibration.message);
  EXPECT_EQ(result.calibration.mounting.reference, BodyFrame::Vehicle);
  EXPECT_LT(errors.rotation_deg, 0.005);
  EXPECT_LT(errors.lever_m.norm(), 0.002);
  EXPECT_LT((result.gyro_bias_radps - drive.gyro_bias_radps).norm(), 1e-4);
  EXPECT_LT(so3_log(result.vehicle_from_imu * drive.vehicle_from_imu.transpose()).norm(), 1e-4);
}

TEST(vehicle_frame, hills_determine_rotation_position_and_height) {
  const WheelDriveOptions drive = testing::noisy_drive();
  const VehicleFrameResult result = solve(drive, 2);
  const Errors errors = errors_of(result, drive);
  EXPECT_EQ(result.calibration.status, Status::Ok) << english(result.calibration.message);
  EXPECT_LT(errors.rotation_deg, 0.1);
  EXPECT_LT(std::abs(errors.lever_m.x()), 0.02);
  EXPECT_LT(std::abs(errors.lever_m.y()), 0.02);
  EXPECT_LT(std::abs(errors.lever_m.z()), 0.05);
}

TEST(vehicle_frame, without_an_ins_wheels_and_turns_stand_in_for_it) {
  WheelDriveOptions drive = testing::noisy_drive();
  drive.reference = false;
  const VehicleFrameResult result = solve(drive, 3);
  const Errors errors = errors_of(result, drive);
  ASSERT_TRUE(result.imu_to_reference);
  EXPECT_TRUE(result.imu_to_reference->solved) << result.imu_to_reference->words;
  ASSERT_TRUE(result.calibration.estimate(Parameter::Roll).sigma);
  const double roll_sigma = *result.calibration.estimate(Parameter::Roll).sigma;
  EXPECT_LT(radians_to_degrees(roll_sigma), 0.5);
  EXPECT_LT(degrees_to_radians(errors.rotation_deg), std::max(degrees_to_radians(0.1), 4.0 * roll_sigma));
  EXPECT_LT(errors.lever_m.norm(), 0.06);
}

// Hairpins that all turn one way and climb: the vehicle turns about its x axis as well, and that is no tilt of the IMU.
TEST(vehicle_frame, a_road_that_winds_up_one_way_tilts_nothing) {
  for (const double climb_deg : {6.0, -6.0}) {
    WheelDriveOptions drive = testing::noisy_drive();
    drive.reference = false;
    drive.winding_radpm = 1.0 / 18.0;
    drive.climb_rad = degrees_to_radians(climb_deg);
    drive.turn_rad = 0.3;
    drive.slope_rad = drive.bank_rad = degrees_to_radians(0.5);
    const VehicleFrameResult result = solve(drive, 15);
    const Errors errors = errors_of(result, drive);
    const double imu_deg =
        radians_to_degrees(so3_log(result.vehicle_from_imu * drive.vehicle_from_imu.transpose()).norm());
    std::printf("  IMU off by %.3f deg\n", imu_deg);
    double sum = 0.0;
    for (const std::size_t i : {3u, 4u, 5u})
      sum += std::pow(result.calibration.estimate(kParameters[i]).sigma.value(), 2);
    EXPECT_LT(radians_to_degrees(std::sqrt(sum)), 0.5);
    EXPECT_LT(degrees_to_radians(errors.rotation_deg), 3.0 * std::sqrt(sum));
    EXPECT_LT(imu_deg, 0.5);
  }
}

TEST(vehicle_frame, an_imu_mounted_in_any_way_is_found) {
  WheelDriveOptions drive = testing::noisy_drive();
  drive.vehicle_from_imu = rotation_from_yaw_pitch_roll({2.5, 0.3, -1.2});
  VehicleFrameOptions options;
  options.imu_mounting_sigma_deg = 180.0;
  const VehicleFrameResult result = solve(drive, 4, options);
  const Errors errors = errors_of(result, drive);
  EXPECT_LT(errors.rotation_deg, 0.1);
  EXPECT_LT(so3_log(result.vehicle_from_imu * drive.vehicle_from_imu.transpose()).norm(), degrees_to_radians(0.1));
  drive.reference = false;
  const VehicleFrameResult alone = solve(drive, 4, options);
  const double alone_deg = errors_of(alone, drive).rotation_deg;
  ASSERT_TRUE(alone.calibration.estimate(Parameter::Roll).sigma) << english(alone.calibration.message);
  EXPECT_LT(alone_deg, std::max(0.1, 4.0 * radians_to_degrees(*alone.calibration.estimate(Parameter::Roll).sigma)));
}

TEST(vehicle_frame, flat_ground_leaves_the_height_unobserved_at_its_nominal) {
  WheelDriveOptions drive = testing::noisy_drive();
  drive.slope_rad = drive.bank_rad = 0.0;
  RigidTransform nominal = drive.vehicle_from_sensor;
  nominal.translation() += Eigen::Vector3d(0.2, -0.1, 0.3);
  for (const bool reference : {true, false}) {
    drive.reference = reference;
    const VehicleFrameResult result = solve(drive, 5, {}, nominal);
    const Errors errors = errors_of(result, drive);
    EXPECT_EQ(result.calibration.status, Status::Degenerate);
    EXPECT_FALSE(result.calibration.known[Parameter::Z].observed);
    EXPECT_FALSE(result.calibration.estimate(Parameter::Z).sigma);
    for (const std::size_t i : {0u, 1u, 3u, 4u, 5u})
      EXPECT_TRUE(result.calibration.known[kParameters[i]].observed) << i;
    for (const std::size_t i : {3u, 4u})
      EXPECT_LT(radians_to_degrees(result.calibration.estimate(kParameters[i]).sigma.value_or(NAN)), 0.1) << i;
    EXPECT_NEAR(result.calibration.mounting.reference_from_sensor.translation().z(), nominal.translation().z(), 1e-9);
    EXPECT_LT(std::abs(errors.lever_m.x()), 0.02);
    EXPECT_LT(std::abs(errors.lever_m.y()), 0.02);
    std::string words;
    for (const ObservabilityDirection& direction : result.calibration.directions)
      words += english(direction.words) + "\n";
    EXPECT_NE(words.find("z (height): not observable, flat driving"), std::string::npos) << words;
    EXPECT_FALSE(result.calibration.advice.empty());
  }
}

TEST(vehicle_frame, the_scale_of_one_camera_is_recovered) {
  for (const double scale : {0.037, 1.0, 12.5}) {
    WheelDriveOptions drive = testing::noisy_drive();
    drive.scale = scale;
    VehicleFrameOptions options;
    options.scale = ScaleMode::Estimated;
    const VehicleFrameResult result = solve(drive, 6, options);
    const Errors errors = errors_of(result, drive);
    std::printf("  scale %g: off by %.4f %%\n", scale, 100.0 * (result.scale / scale - 1.0));
    EXPECT_LT(std::abs(result.scale / scale - 1.0), 0.005);
    EXPECT_LT(errors.rotation_deg, 0.1);
    const NamedQuantity* found = testing::quantity_of(result.quantities, "scale");
    ASSERT_NE(found, nullptr);
    EXPECT_TRUE(found->observed);
    EXPECT_LT(std::abs(found->value - scale), 5.0 * found->sigma);
  }
}

TEST(vehicle_frame, straight_driving_claims_neither_position_nor_roll) {
  WheelDriveOptions drive = testing::noisy_drive();
  drive.turn_rad = drive.slope_rad = drive.bank_rad = 0.0;
  drive.reference = false;
  // A sensor that looks ahead: its roll is the turn about the way, which a straight drive leaves open.
  drive.vehicle_from_sensor.linear() = rotation_from_yaw_pitch_roll({0.0, 0.0, 0.08});
  const RigidTransform nominal = drive.vehicle_from_sensor;
  const VehicleFrameResult result = solve(drive, 7, {}, nominal);
  errors_of(result, drive);
  EXPECT_EQ(result.calibration.status, Status::Degenerate) << english(result.calibration.message);
  for (const int i : {0, 1, 2, 5}) EXPECT_FALSE(result.calibration.known[kParameters[i]].observed) << i;
  EXPECT_TRUE(result.calibration.known[Parameter::Yaw].observed);
  EXPECT_TRUE(result.calibration.known[Parameter::Pitch].observed);
  EXPECT_LT((result.calibration.mounting.reference_from_sensor.translation() - nominal.translation()).norm(), 1e-9);
}

TEST(vehicle_frame, a_straight_drive_says_what_it_does_observe_however_the_sensor_looks) {
  for (const double yaw_rad : {0.0, 0.4, 2.0}) {
    WheelDriveOptions drive = testing::noisy_drive();
    drive.turn_rad = drive.slope_rad = drive.bank_rad = 0.0;
    drive.vehicle_from_sensor.linear() = rotation_from_yaw_pitch_roll({yaw_rad, 0.0, 0.08});
    const VehicleFrameResult result = solve(drive, 8, {}, drive.vehicle_from_sensor);
    errors_of(result, drive);
    ASSERT_TRUE(result.calibration.known[Parameter::Yaw].observed);
    // A sensor that leans shows a little of the turn about the way, which is open, as yaw.
    EXPECT_LT(radians_to_degrees(*result.calibration.estimate(Parameter::Yaw).sigma), 0.5);
    const auto seen = std::count_if(result.calibration.directions.begin(), result.calibration.directions.end(),
                                    [](const auto& direction) { return direction.observed; });
    EXPECT_EQ(seen, 2);  // the direction of the way, in the sensor's axes
    for (const int i : {0, 1, 2}) EXPECT_FALSE(result.calibration.known[kParameters[i]].observed) << i;
  }
}

TEST(vehicle_frame, noise_of_a_long_straight_drive_is_no_information_about_roll) {
  WheelDriveOptions drive = testing::noisy_drive();
  drive.duration_s = 600.0;
  drive.turn_rad = drive.slope_rad = drive.bank_rad = 0.0;
  drive.sensor_turn_noise_rad = 1e-3;
  drive.vehicle_from_sensor.linear() = rotation_from_yaw_pitch_roll({0.0, 0.0, 0.08});
  const VehicleFrameResult result = solve(drive, 12, {}, drive.vehicle_from_sensor);
  errors_of(result, drive);
  EXPECT_FALSE(result.calibration.known[Parameter::Roll].observed);
  EXPECT_TRUE(result.calibration.known[Parameter::Yaw].observed);
  EXPECT_TRUE(result.calibration.known[Parameter::Pitch].observed);
}

TEST(vehicle_frame, an_unobserved_quantity_has_no_sigma) {
  WheelDriveOptions drive = testing::noisy_drive();
  drive.turn_rad = drive.slope_rad = drive.bank_rad = 0.0;
  drive.reference = false;
  const VehicleFrameResult result = solve(drive, 13, {}, drive.vehicle_from_sensor);
  int unobserved = 0;
  for (const NamedQuantity& quantity : result.quantities) {
    if (quantity.observed) continue;
    ++unobserved;
    EXPECT_TRUE(std::isnan(quantity.sigma)) << quantity.id;
  }
  EXPECT_GT(unobserved, 0);
}

TEST(vehicle_frame, errors_are_as_large_as_the_covariance_says) {
  WheelDriveOptions drive = testing::noisy_drive();
  drive.duration_s = 100.0;
  VehicleFrameOptions options;
  options.ins_alignment_sigma_deg = 0.01;  // the simulated INS is aligned
  double chi2[7] = {};
  constexpr int kSeeds = 40;
  for (int seed = 0; seed < kSeeds; ++seed) {
    const VehicleFrameResult result = solve(drive, 100 + seed, options);
    const SixParameters found = six_from_rigid(result.calibration.mounting.reference_from_sensor),
                        exact = six_from_rigid(drive.vehicle_from_sensor);
    Vector6d error;
    error << found.x_m - exact.x_m, found.y_m - exact.y_m, found.z_m - exact.z_m, found.yaw_rad - exact.yaw_rad,
        found.pitch_rad - exact.pitch_rad, found.roll_rad - exact.roll_rad;
    ASSERT_EQ(result.calibration.status, Status::Ok);
    for (int i = 0; i < 6; ++i) chi2[i] += error[i] * error[i] / result.calibration.covariance(i, i);
    chi2[6] += testing::squared_over_sigma(error, result.calibration.covariance);
  }
  for (int i = 0; i < 6; ++i)
    std::printf("  %s: chi2 / n = %.2f\n", to_string(kParameters[i]).data(), chi2[i] / kSeeds);
  std::printf("  all: chi2 / n = %.2f\n", chi2[6] / (6.0 * kSeeds));
  // 40 degrees of freedom: the 1% limits are 0.52 and 1.67; 240: 0.78 and 1.25.
  for (int i = 0; i < 6; ++i) EXPECT_LT(chi2[i] / kSeeds, 1.67) << to_string(kParameters[i]);
  EXPECT_LT(chi2[6] / (6.0 * kSeeds), 1.25);
  EXPECT_GT(chi2[6] / (6.0 * kSeeds), 0.5);
}

TEST(vehicle_frame, jacobian_is_that_of_the_integration) {
  const WheelDriveOptions options = testing::noisy_drive();
  const VehicleDrive drive = testing::wheel_drive(options, 9).drive();
  const std::vector<VehicleInterval> intervals = vehicle_intervals({drive}, {});
  VehicleFrameState state;
  state.vehicle_from_sensor = options.vehicle_from_sensor;
  state.vehicle_from_imu = options.vehicle_from_imu;
  state.gyro_bias_radps = {0.004, 0.001, -0.002};
  state.log_gyro_scale = 0.003;
  state.gyro_scale_apart = {0.002, -0.001, 0.004};
  const IntervalJacobian jacobian = jacobian_of(integrate(intervals[3], RateErrors::Zero()), state);
  // Columns with a closed form: lever arm, both scales, track width.
  const IntegratedInterval at_bias = integrate(intervals[3], rate_errors(state));
  const IntervalJacobian exact = jacobian_of(at_bias, state);
  const RigidTransform p = at_bias.nominal.start_from_end(state.vehicle_from_imu);
  const auto expect_near = [](const Eigen::VectorXd& found, const Eigen::VectorXd& wanted, const char* name) {
    EXPECT_LT((found - wanted).norm(), 1e-7 * std::max(1.0, wanted.norm())) << name;
  };
  for (int k = 0; k < 3; ++k)
    expect_near(exact.col(k).head<3>(), p.linear().col(k) - Eigen::Vector3d::Unit(k), "lever arm");
  expect_near(exact.col(6).head<3>(),
              -(state.vehicle_from_sensor.linear() * intervals[3].sensor_begin_from_sensor_end.translation()),
              "scale of the sensor");
  expect_near(exact.col(7).head<3>(), p.translation(), "scale of the wheels");
  expect_near(exact.col(6).tail<8>(), Eigen::VectorXd::Zero(8), "turns and the scale of the sensor");
  EXPECT_NEAR(exact(6, 14), -(state.vehicle_from_imu * at_bias.nominal.turn_in_imu_rad).z(), 1e-7);
  // The bias enters to first order only: compare with integrating anew.
  for (int k = 0; k < VehicleFrameState::kUnknowns; ++k) {
    const StateVector step = 1e-4 * StateVector::Unit(k);
    const VehicleFrameState up = state_after(state, step), down = state_after(state, -step);
    const IntervalResidual slope = (residual_of(integrate(intervals[3], rate_errors(up)), up) -
                                    residual_of(integrate(intervals[3], rate_errors(down)), down)) /
                                   2e-4;
    EXPECT_LT((slope - jacobian.col(k)).norm(), 2e-2 * std::max(1e-3, slope.norm())) << k;
  }
  EXPECT_LT(state_difference(state, state_after(state, StateVector::Constant(0.01))).cwiseAbs().maxCoeff(), 0.011);
}

TEST(vehicle_frame, too_little_data_is_said_so) {
  WheelDriveOptions drive;
  drive.duration_s = 2.0;
  const VehicleFrameResult result = solve(drive, 10);
  EXPECT_EQ(result.calibration.status, Status::TooLittleData);
  EXPECT_FALSE(english(result.calibration.message).empty());
  EXPECT_FALSE(result.calibration.advice.empty());
}

TEST(vehicle_frame, cancelled_claims_nothing) {
  std::stop_source stop;
  stop.request_stop();
  Progress progress(stop.get_token());
  const VehicleFrameResult result =
      solve_vehicle_frame({testing::wheel_drive({}, 1).drive()}, std::nullopt, {}, SolveOptions{}, progress);
  EXPECT_EQ(result.calibration.status, Status::Cancelled);
  EXPECT_EQ(parameter_names(result.calibration.observed()), "");
}

TEST(vehicle_frame, two_unknown_scales_are_refused) {
  VehicleFrameOptions options;
  options.scale = ScaleMode::Estimated;
  options.estimate_wheel_scale = true;
  EXPECT_THROW(solve({}, 1, options), Error);
}

TEST(vehicle_frame, a_worn_tyre_is_found_by_a_sensor_in_metres) {
  WheelDriveOptions options = testing::noisy_drive();
  testing::WheelDrive drive = testing::wheel_drive(options, 11);
  for (motion::WheelSample& wheel : drive.wheels) {
    wheel.rear_left_mps /= 0.98;
    wheel.rear_right_mps /= 0.98;
  }
  VehicleFrameOptions wanted;
  wanted.estimate_wheel_scale = true;
  Progress progress;
  const VehicleFrameResult result = solve_vehicle_frame({drive.drive()}, std::nullopt, wanted, {}, progress);
  errors_of(result, options);
  EXPECT_NEAR(result.wheel_scale, 0.98, 0.001);
}

TEST(vehicle_frame, a_worn_tyre_that_nobody_asked_for_does_not_move_the_sensor) {
  const WheelDriveOptions options = testing::noisy_drive();
  testing::WheelDrive drive = testing::wheel_drive(options, 14);
  for (motion::WheelSample& wheel : drive.wheels) {
    wheel.rear_left_mps /= 0.98;
    wheel.rear_right_mps /= 0.98;
  }
  Progress progress;
  const VehicleFrameResult result = solve_vehicle_frame({drive.drive()}, std::nullopt, {}, {}, progress);
  const Errors errors = errors_of(result, options);
  EXPECT_NEAR(result.wheel_scale, 0.98, 0.001);
  EXPECT_LT(errors.lever_m.norm(), 0.03);
  EXPECT_LT(result.calibration.translation_rms_m, 0.03);
}

// What widening leaves less information than the prior has is no direction of X any more, and what leans on it stays
// as wide as it was found to be.
TEST(vehicle_frame, states_no_sigma_below_what_lasting_errors_make_of_it) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const SolveOptions solve;
  const Vector6d limits = observation_limits(solve);
  Vector6d prior_sigma;
  prior_sigma << Eigen::Vector3d::Constant(2.0), Eigen::Vector3d::Constant(0.2);
  const Vector6d prior = prior_sigma.cwiseAbs2().cwiseInverse();
  int stated = 0;
  double least = 10.0, least_by_information = 10.0;
  for (int draw = 0; draw < 3000; ++draw) {
    Matrix6d mixed = Matrix6d::Zero();
    for (int k = 0; k < 6; ++k) {
      Vector6d row;
      row << testing::random_vector(random, 1.0), testing::random_vector(random, 1.0);
      row = row.normalized().cwiseQuotient(limits);
      mixed += std::pow(10.0, 8.0 * unit(random) - 4.0) * row * row.transpose();
    }
    Matrix6d with_prior = mixed;
    with_prior.diagonal() += prior;
    Vector6d factors;
    for (int k = 0; k < 6; ++k) factors[k] = 1.0 + 2.0 * unit(random);
    const Matrix6d widened = factors.asDiagonal() * inverse_by_lu(with_prior) * factors.asDiagonal();
    Matrix6d information = inverse_by_lu(widened);
    information.diagonal() -= prior;
    SpuriousInformation none;
    none.apparent = Matrix6d::Identity();
    const std::vector<ObservabilityDirection> directions = observed_directions(information, none, {}, solve);
    const Matrix6d covariance = stated_covariance(widened, prior, directions, solve);
    Matrix6d trusted = trusted_information(directions, solve);
    trusted.diagonal() += prior;
    const Matrix6d by_information = inverse_by_lu(trusted);
    for (int k = 0; k < 6; ++k) {
      if (!(covariance(k, k) < limits[k] * limits[k])) continue;
      ++stated;
      least = std::min(least, std::sqrt(covariance(k, k) / widened(k, k)));
      least_by_information = std::min(least_by_information, std::sqrt(by_information(k, k) / widened(k, k)));
    }
  }
  std::printf("  %d sigmas, at least %.3f of the widened ones; by trusted information alone %.3f\n", stated, least,
              least_by_information);
  EXPECT_GT(stated, 100);
  EXPECT_GT(least, 0.999);
  EXPECT_LT(least_by_information, 0.9) << "else the test shows nothing";
}

}  // namespace
}  // namespace remount::calibration
