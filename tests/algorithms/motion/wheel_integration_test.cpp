#include "algorithms/motion/wheel_integration.h"

#include <gtest/gtest.h>

#include "tests/algorithms/support/wheel_drive.h"

namespace remount::motion {
namespace {

constexpr WheelIntegration kAll[] = {WheelIntegration::ClosedForm, WheelIntegration::Euler, WheelIntegration::Planar};

double end_error_m(const testing::WheelDriveOptions& options, WheelIntegration integration) {
  const testing::WheelDrive drive = testing::wheel_drive(options);
  const StampedPose& first = drive.world_from_vehicle.front();
  const StampedPose& last = drive.world_from_vehicle.back();
  const auto steps = drive.drive().sensed.steps(first.stamp_ns, last.stamp_ns);
  const auto poses =
      integrate_steps(*steps, first.pose, options.vehicle_from_imu, Eigen::Vector3d::Zero(), integration);
  return (poses.back().translation() - last.pose.translation()).norm();
}

TEST(wheel_integration, closed_form_beats_planar_twenty_times_on_two_kilometres_of_hills) {
  testing::WheelDriveOptions options;  // 200 s at 10 m/s
  options.imu_rate_hz = 50.0;
  double error_m[3];
  for (int i = 0; i < 3; ++i) error_m[i] = end_error_m(options, kAll[i]);
  std::printf("  end error after 2 km: closed form %.4f, Euler %.3f, planar %.3f m\n", error_m[0], error_m[1],
              error_m[2]);
  EXPECT_LT(error_m[0], error_m[2] / 20.0);
  EXPECT_LT(error_m[0], error_m[1]);
}

// At the rate of a slow log and in tight turns: the arc within a step is then no tangent.
TEST(wheel_integration, closed_form_beats_euler_at_a_low_rate_on_a_winding_road) {
  for (const double rate_hz : {5.0, 10.0, 20.0}) {
    testing::WheelDriveOptions options;
    options.imu_rate_hz = rate_hz;
    options.winding_radpm = 1.0 / 15.0;
    options.climb_rad = degrees_to_radians(4.0);
    const double closed_m = end_error_m(options, WheelIntegration::ClosedForm);
    const double euler_m = end_error_m(options, WheelIntegration::Euler);
    std::printf("  end error after 2 km at %.0f Hz: closed form %.3f, Euler %.3f m\n", rate_hz, closed_m, euler_m);
    EXPECT_LT(closed_m, euler_m / 3.0);
  }
}

TEST(wheel_integration, planar_is_exact_where_the_ground_is_a_plane) {
  testing::WheelDriveOptions options;
  options.duration_s = 60.0;
  options.slope_rad = options.bank_rad = 0.0;
  EXPECT_LT(end_error_m(options, WheelIntegration::Planar), 0.02);
  EXPECT_LT(end_error_m(options, WheelIntegration::ClosedForm), 0.02);
}

TEST(wheel_integration, closed_form_is_exact_for_a_constant_twist_of_any_length) {
  const Eigen::Vector3d rate(0.02, -0.05, 0.4);
  const RigidTransform once = advance(RigidTransform::Identity(), 3.0 * rate, 3.0 * 7.0, WheelIntegration::ClosedForm);
  RigidTransform parts = RigidTransform::Identity();
  for (int i = 0; i < 3000; ++i) parts = advance(parts, 1e-3 * rate, 1e-3 * 7.0, WheelIntegration::ClosedForm);
  EXPECT_LT(testing::distance_of(once, parts), 1e-9);
  RigidTransform euler = advance(RigidTransform::Identity(), 3.0 * rate, 21.0, WheelIntegration::Euler);
  EXPECT_GT(testing::distance_of(euler, parts), 1.0);
}

TEST(wheel_integration, straight_driving_needs_no_special_case) {
  for (const WheelIntegration integration : kAll) {
    const RigidTransform end = advance(RigidTransform::Identity(), Eigen::Vector3d::Zero(), 2.5, integration);
    EXPECT_LT((end.translation() - Eigen::Vector3d(2.5, 0, 0)).norm(), 1e-15);
    const RigidTransform nearly = advance(RigidTransform::Identity(), {0, 0, 1e-12}, 2.5, integration);
    EXPECT_LT(testing::distance_of(end, nearly), 1e-11);
  }
}

TEST(wheel_integration, preintegration_is_the_sum_of_steps_whatever_the_mounting_of_the_imu) {
  testing::WheelDriveOptions options;
  options.duration_s = 8.0;
  const testing::WheelDrive drive = testing::wheel_drive(options);
  const auto steps = drive.drive().sensed.steps(1'003'000'000, 7'998'000'000);
  ASSERT_TRUE(steps);
  const Eigen::Vector3d bias(0.01, -0.02, 0.03);
  const auto poses =
      integrate_steps(*steps, RigidTransform::Identity(), options.vehicle_from_imu, bias, WheelIntegration::ClosedForm);
  const WheelPreintegration sum = preintegrate(*steps, bias);
  EXPECT_LT(testing::distance_of(sum.start_from_end(options.vehicle_from_imu), poses.back()), 1e-9);
  EXPECT_NEAR(sum.duration_s, 6.995, 1e-9);
}

TEST(wheel_integration, nothing_is_made_up_outside_the_data_or_across_a_gap) {
  testing::WheelDriveOptions options;
  options.duration_s = 10.0;
  testing::WheelDrive drive = testing::wheel_drive(options);
  WheelImuSignals whole(drive.imu, drive.wheels);
  EXPECT_TRUE(whole.steps(0, whole.end_ns()));
  EXPECT_FALSE(whole.steps(-1, 1'000'000'000));
  EXPECT_FALSE(whole.steps(9'000'000'000, whole.end_ns() + 1));
  EXPECT_FALSE(whole.steps(2'000'000'000, 2'000'000'000));
  drive.wheels.erase(drive.wheels.begin() + 400, drive.wheels.begin() + 500);
  const WheelImuSignals torn(drive.imu, drive.wheels);
  EXPECT_FALSE(torn.steps(3'000'000'000, 6'000'000'000));
  EXPECT_TRUE(torn.steps(6'000'000'000, 7'000'000'000));
  EXPECT_FALSE(WheelImuSignals({}, drive.wheels).steps(0, 1));
  drive.imu[5].angular_rate_radps.x() = std::numeric_limits<double>::quiet_NaN();
  const auto steps = WheelImuSignals(drive.imu, drive.wheels).steps(0, 1'000'000'000);
  ASSERT_TRUE(steps);
  for (const MotionStep& step : *steps) EXPECT_TRUE(step.turn_in_imu_rad.allFinite());
}

}  // namespace
}  // namespace remount::motion
