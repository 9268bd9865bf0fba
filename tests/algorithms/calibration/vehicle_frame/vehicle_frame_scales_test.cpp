// Wheels and IMUs that are wrong by a share: what that does to the sensor's place, and what is said of it.
#include <gtest/gtest.h>

#include "algorithms/calibration/vehicle_frame/vehicle_frame.h"
#include "algorithms/messages/render.h"
#include "tests/algorithms/support/named_quantity.h"
#include "tests/algorithms/support/wheel_drive.h"

namespace remount::calibration {
namespace {

/// Worst errors of x to roll in their sigma over drives whose recording `harm` changed.
template <class Harm>
Vector6d worst_in_sigma(const testing::WheelDriveOptions& options, int first_seed, const Harm& harm) {
  Vector6d worst = Vector6d::Zero();
  for (int seed = first_seed; seed < first_seed + 3; ++seed) {
    testing::WheelDrive drive = testing::wheel_drive(options, seed);
    harm(drive);
    Progress progress;
    const VehicleFrameResult result = solve_vehicle_frame({drive.drive()}, std::nullopt, {}, {}, progress);
    EXPECT_EQ(result.calibration.status, Status::Ok) << result.calibration.message;
    const SixParameters found = six_from_rigid(result.calibration.mounting.reference_from_sensor),
                        exact = six_from_rigid(options.vehicle_from_sensor);
    Vector6d error;
    error << found.x_m - exact.x_m, found.y_m - exact.y_m, found.z_m - exact.z_m, found.yaw_rad - exact.yaw_rad,
        found.pitch_rad - exact.pitch_rad, found.roll_rad - exact.roll_rad;
    worst = worst.cwiseMax(error.cwiseAbs().cwiseQuotient(result.calibration.covariance.diagonal().cwiseSqrt()));
  }
  std::printf("  worst errors in sigma: x %.1f, y %.1f, z %.1f, yaw %.1f, pitch %.1f, roll %.1f\n", worst[0], worst[1],
              worst[2], worst[3], worst[4], worst[5]);
  return worst;
}

TEST(vehicle_frame, a_scale_error_of_the_gyro_does_not_move_the_sensor) {
  testing::WheelDriveOptions options = testing::noisy_drive();
  options.duration_s = 100.0;
  const Eigen::Vector3d errors[] = {{1.0, 1.0, 1.0}, {0.98, 0.98, 0.98}, {1.01, 1.01, 1.01}, {1.0, 1.0, 1.015}};
  for (const bool reference : {true, false})
    for (const Eigen::Vector3d& scale : errors) {
      options.reference = reference;
      const Vector6d worst = worst_in_sigma(options, 820, [&](testing::WheelDrive& drive) {
        for (motion::ImuSample& sample : drive.imu)
          sample.angular_rate_radps = scale.cwiseProduct(sample.angular_rate_radps);
      });
      EXPECT_LT(worst.maxCoeff(), 4.0) << scale.transpose();
    }
}

// Noise alone would make the scale of an axis about which nothing turns small, and a tilt of the IMU of it.
TEST(vehicle_frame, the_scale_of_an_axis_about_which_nothing_turns_is_that_of_the_others) {
  testing::WheelDriveOptions options = testing::noisy_drive();
  options.slope_rad = options.bank_rad = 0.0;
  options.duration_s = 100.0;
  testing::WheelDrive drive = testing::wheel_drive(options, 19);
  for (motion::ImuSample& sample : drive.imu) sample.angular_rate_radps *= 1.01;
  Progress progress;
  const VehicleFrameResult result = solve_vehicle_frame({drive.drive()}, std::nullopt, {}, {}, progress);
  std::printf("  scales %.5f %.5f %.5f\n", result.gyro_scale[0], result.gyro_scale[1], result.gyro_scale[2]);
  for (const double scale : result.gyro_scale) EXPECT_NEAR(scale, 1.0 / 1.01, 0.001);
  EXPECT_EQ(testing::quantity_of(result.quantities, "gyro scale x"), nullptr);
  ASSERT_NE(testing::quantity_of(result.quantities, "gyro scale"), nullptr);
}

TEST(vehicle_frame, one_wheel_that_is_smaller_does_not_move_the_sensor) {
  for (const double scale : {0.96, 1.04})
    for (const bool left : {true, false}) {
      const Vector6d worst = worst_in_sigma(testing::noisy_drive(), 840, [&](testing::WheelDrive& drive) {
        for (motion::WheelSample& wheel : drive.wheels) (left ? wheel.rear_left_mps : wheel.rear_right_mps) *= scale;
      });
      EXPECT_LT(worst.maxCoeff(), 4.0) << scale;
    }
}

TEST(vehicle_frame, rates_in_degrees_are_named_and_not_the_ways) {
  for (const double factor : {radians_to_degrees(1.0), degrees_to_radians(1.0)}) {
    testing::WheelDrive drive = testing::wheel_drive(testing::noisy_drive(), 17);
    for (motion::ImuSample& sample : drive.imu) sample.angular_rate_radps *= factor;
    Progress progress;
    const VehicleFrameResult result = solve_vehicle_frame({drive.drive()}, std::nullopt, {}, {}, progress);
    std::printf("  %s\n", english(result.calibration.message).c_str());
    EXPECT_EQ(result.calibration.status, Status::Inconsistent);
    EXPECT_NE(english(result.calibration.message).find("degrees and radians"), std::string::npos);
    EXPECT_EQ(parameter_names(result.calibration.observed()), "");
  }
}

}  // namespace
}  // namespace remount::calibration
