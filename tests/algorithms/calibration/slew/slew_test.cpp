#include "algorithms/calibration/slew/slew.h"

#include <gtest/gtest.h>

#include "algorithms/calibration/linear_solutions.h"
#include "algorithms/core/error.h"
#include "algorithms/messages/render.h"
#include "tests/algorithms/support/slew_yard.h"

namespace remount::calibration {

using testing::YardTruth;

namespace {

SlewResult solve(const YardTruth& yard, const SlewOptions& options = {}, int seed = 1) {
  Progress progress;
  return solve_slew(testing::slew_yard(yard, seed), std::nullopt, options, SolveOptions{}, progress);
}

void expect_refused(const SlewResult& result, Status status, const char* reason) {
  EXPECT_EQ(result.calibration.status, status) << to_string(result.calibration.status);
  EXPECT_NE(english(result.calibration.message).find(reason), std::string::npos) << english(result.calibration.message);
  EXPECT_FALSE(result.calibration.advice.empty());
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_FALSE(result.calibration.known[kParameters[i]].observed);
    EXPECT_FALSE(result.calibration.estimate(kParameters[i]).sigma);
  }
}

double rotation_deg(const SlewResult& result, const YardTruth& yard) {
  return radians_to_degrees(
      rotation_angle_between_rad(result.calibration.mounting.reference_from_sensor, yard.machine_from_lidar));
}

TEST(slew, exact_recordings_give_the_exact_mounting) {
  for (const FirstPlane first : {FirstPlane::Ground, FirstPlane::Turn}) {
    SlewOptions options;
    options.first_plane = first;
    const YardTruth yard;
    const SlewResult result = solve(yard, options);
    EXPECT_EQ(result.calibration.status, Status::Ok) << english(result.calibration.message);
    EXPECT_EQ(result.calibration.mounting.reference, BodyFrame::Machine);
    EXPECT_LT(testing::distance_of(result.calibration.mounting.reference_from_sensor, yard.machine_from_lidar), 2e-3);
    EXPECT_FALSE(result.quantities.empty());
    EXPECT_EQ(result.plots.size(), 2u);
  }
}

TEST(slew, noisy_recordings_find_rotation_and_slew_centre) {
  for (const FirstPlane first : {FirstPlane::Ground, FirstPlane::Turn}) {
    SlewOptions options;
    options.first_plane = first;
    const YardTruth yard = testing::noisy_yard();
    const SlewResult result = solve(yard, options, 3);
    const Eigen::Vector3d off =
        result.calibration.mounting.reference_from_sensor.translation() - yard.machine_from_lidar.translation();
    std::printf("  rotation %.4f deg, centre %.4f m\n", rotation_deg(result, yard), off.norm());
    EXPECT_EQ(result.calibration.status, Status::Ok) << english(result.calibration.message);
    EXPECT_LT(rotation_deg(result, yard), 0.05);
    EXPECT_LT(off.norm(), 0.01);
  }
}

TEST(slew, a_turn_the_other_way_and_another_mounting_are_the_same) {
  YardTruth yard = testing::noisy_yard();
  yard.turn_rad = -yard.turn_rad;
  yard.machine_from_lidar = make_rigid(rotation_from_yaw_pitch_roll({2.9, -0.1, 0.2}), {-0.8, 1.2, 0.0});
  const SlewResult result = solve(yard);
  EXPECT_LT(rotation_deg(result, yard), 0.05);
  EXPECT_LT(
      (result.calibration.mounting.reference_from_sensor.translation() - yard.machine_from_lidar.translation()).norm(),
      0.01);
}

TEST(slew, the_origin_may_lie_on_the_ground) {
  SlewOptions options;
  options.origin = MachineOrigin::Ground;
  const YardTruth yard = testing::noisy_yard();
  const SlewResult result = solve(yard, options);
  EXPECT_NEAR(result.calibration.mounting.reference_from_sensor.translation().z(), yard.ground_m, 0.01);
}

TEST(slew, errors_are_as_large_as_the_covariance_says) {
  for (const FirstPlane first : {FirstPlane::Ground, FirstPlane::Turn}) {
    SlewOptions options;
    options.first_plane = first;
    options.surface_sigma_deg = 0.0;  // ground and arm of the yard are plane
    options.plane_inlier_m = 0.1;
    YardTruth yard = testing::noisy_yard();
    yard.points = 600;
    double chi2 = 0.0;
    constexpr int kSeeds = 60;
    for (int seed = 0; seed < kSeeds; ++seed) {
      const SlewResult result = solve(yard, options, 100 + seed);
      ASSERT_EQ(result.calibration.status, Status::Ok) << english(result.calibration.message);
      const SixParameters found = six_from_rigid(result.calibration.mounting.reference_from_sensor),
                          exact = six_from_rigid(yard.machine_from_lidar);
      Vector6d error;
      error << found.x_m - exact.x_m, found.y_m - exact.y_m, found.z_m - exact.z_m, found.yaw_rad - exact.yaw_rad,
          found.pitch_rad - exact.pitch_rad, found.roll_rad - exact.roll_rad;
      chi2 += error.dot(inverse_by_lu(result.calibration.covariance) * error);
    }
    std::printf("  chi2 / n = %.2f\n", chi2 / (6.0 * kSeeds));
    // 360 degrees of freedom: the 1% limits are 0.82 and 1.20 of it.
    EXPECT_GT(chi2 / (6.0 * kSeeds), 0.75);
    EXPECT_LT(chi2 / (6.0 * kSeeds), 1.25);
  }
}

TEST(slew, errors_with_the_origin_on_the_ground_and_an_error_of_the_first_scan_in_all_poses_are_as_large_as_said) {
  for (const FirstPlane first : {FirstPlane::Ground, FirstPlane::Turn}) {
    SlewOptions options;
    options.first_plane = first;
    options.origin = MachineOrigin::Ground;
    options.surface_sigma_deg = 0.0;
    options.plane_inlier_m = 0.1;
    YardTruth yard = testing::noisy_yard();
    yard.points = 600;
    RigidTransform truth = yard.machine_from_lidar;
    truth.translation().z() = yard.ground_m;
    Vector6d chi2 = Vector6d::Zero();
    constexpr int kSeeds = 60;
    for (int seed = 0; seed < kSeeds; ++seed) {
      SlewData data = testing::slew_yard(yard, 300 + seed);
      std::mt19937_64 random(static_cast<std::uint64_t>(seed));
      const RigidTransform common =
          perturb(RigidTransform::Identity(), testing::random_step(random, yard.way_noise_m, yard.turn_noise_rad));
      for (RigidTransform& pose : data.first_from_lidar) pose = common * pose;
      // Only half of the ground is seen: its middle is far from the axis, and its tilt moves the origin.
      std::erase_if(data.ground_points,
                    [&](const Eigen::Vector3d& point) { return (yard.machine_from_lidar * point).x() < 0.0; });
      Progress progress;
      const SlewResult result = solve_slew(data, std::nullopt, options, SolveOptions{}, progress);
      ASSERT_EQ(result.calibration.status, Status::Ok) << english(result.calibration.message);
      const SixParameters found = six_from_rigid(result.calibration.mounting.reference_from_sensor),
                          exact = six_from_rigid(truth);
      Vector6d error;
      error << found.x_m - exact.x_m, found.y_m - exact.y_m, found.z_m - exact.z_m, found.yaw_rad - exact.yaw_rad,
          found.pitch_rad - exact.pitch_rad, found.roll_rad - exact.roll_rad;
      chi2 += error.cwiseAbs2().cwiseQuotient(result.calibration.covariance.diagonal()) / kSeeds;
    }
    for (int i = 0; i < 6; ++i) {
      std::printf("  %s: chi2 / n = %.2f\n", to_string(kParameters[i]).data(), chi2[i]);
      // 60 degrees of freedom: the 0.1% limits are 0.53 and 1.66.
      EXPECT_GT(chi2[i], 0.53) << i;
      EXPECT_LT(chi2[i], 1.66) << i;
    }
  }
}

TEST(slew, scans_of_the_same_rays_count_once) {
  Progress progress;
  YardTruth yard = testing::noisy_yard();
  yard.points = 600;
  SlewData data = testing::slew_yard(yard, 2);
  const SlewResult once = solve_slew(data, std::nullopt, {}, {}, progress);
  for (std::vector<Eigen::Vector3d>* points : {&data.ground_points, &data.arm_points}) {
    const std::vector<Eigen::Vector3d> scan = *points;
    for (int i = 1; i < 10; ++i) points->insert(points->end(), scan.begin(), scan.end());
  }
  const SlewResult often = solve_slew(data, std::nullopt, {}, {}, progress);
  for (const std::size_t i : {3u, 4u, 5u})
    EXPECT_NEAR(often.calibration.estimate(kParameters[i]).sigma.value() /
                    once.calibration.estimate(kParameters[i]).sigma.value(),
                1.0, 0.2)
        << i;
}

TEST(slew, how_surfaces_are_made_is_part_of_every_sigma) {
  for (const FirstPlane first : {FirstPlane::Ground, FirstPlane::Turn}) {
    SlewOptions options;
    options.first_plane = first;
    options.surface_sigma_deg = 0.3;
    SolveOptions wide;
    wide.max_rotation_sigma_deg = 2.0;
    Progress progress;
    const SlewResult judged =
        solve_slew(testing::slew_yard(testing::noisy_yard()), std::nullopt, options, wide, progress);
    for (const std::size_t i : {3u, 4u, 5u})
      EXPECT_GT(radians_to_degrees(judged.calibration.estimate(kParameters[i]).sigma.value_or(0.0)), 0.29) << i;
  }
}

TEST(slew, a_turn_too_noisy_to_check_the_ground_is_refused) {
  YardTruth yard = testing::noisy_yard();
  yard.way_noise_m = 0.08;
  yard.turn_noise_rad = 0.08;  // the angle is told by the attitudes
  yard.ground_tilt_rad = degrees_to_radians(1.0);
  expect_refused(solve(yard), Status::TooLittleData, "cannot be told");
}

TEST(slew, a_quarter_turn_is_refused) {
  YardTruth yard = testing::noisy_yard();
  yard.turn_rad = 0.5 * kPi;
  for (const FirstPlane first : {FirstPlane::Ground, FirstPlane::Turn}) {
    SlewOptions options;
    options.first_plane = first;
    expect_refused(solve(yard, options), Status::TooLittleData, "covers an arc of");
  }
}

TEST(slew, a_missing_arm_is_refused) {
  YardTruth yard = testing::noisy_yard();
  yard.arm = false;
  expect_refused(solve(yard), Status::TooLittleData, "plane of the arm is missing");
  Progress progress;
  SlewData data = testing::slew_yard(yard);
  std::mt19937_64 random(4);
  for (int i = 0; i < 2000; ++i) data.arm_points.push_back(testing::random_vector(random, 3.0));  // no plane in it
  const SlewResult scattered = solve_slew(data, std::nullopt, {}, {}, progress);
  EXPECT_NE(scattered.calibration.status, Status::Ok) << scattered.arm.inliers << " " << scattered.arm.rms_m;
}

TEST(slew, a_ground_that_is_tilted_against_the_slew_axis_is_refused) {
  YardTruth yard = testing::noisy_yard();
  yard.ground_tilt_rad = degrees_to_radians(2.0);
  expect_refused(solve(yard), Status::Inconsistent, "The ground is tilted by");
  SlewOptions options;
  options.first_plane = FirstPlane::Turn;  // needs no ground
  const SlewResult result = solve(yard, options);
  EXPECT_EQ(result.calibration.status, Status::Ok);
  EXPECT_LT(rotation_deg(result, yard), 0.05);
  EXPECT_NEAR(radians_to_degrees(result.ground_to_turn_rad), 2.0, 0.2);
}

TEST(slew, a_ground_that_leans_within_the_limit_is_part_of_sigma_where_it_is_the_first_plane) {
  Vector6d worst = Vector6d::Zero();
  for (const double tilt_deg : {0.0, 0.05, 0.1, 0.2, 0.3, 0.4})
    for (int seed = 700; seed < 706; ++seed) {
      YardTruth yard = testing::noisy_yard();
      yard.ground_tilt_rad = degrees_to_radians(tilt_deg);
      const SlewResult result = solve(yard, {}, seed);
      ASSERT_EQ(result.calibration.status, Status::Ok) << result.calibration.message;
      const SixParameters found = six_from_rigid(result.calibration.mounting.reference_from_sensor),
                          exact = six_from_rigid(yard.machine_from_lidar);
      Vector6d error;
      error << found.x_m - exact.x_m, found.y_m - exact.y_m, found.z_m - exact.z_m, found.yaw_rad - exact.yaw_rad,
          found.pitch_rad - exact.pitch_rad, found.roll_rad - exact.roll_rad;
      worst = worst.cwiseMax(error.cwiseAbs().cwiseQuotient(result.calibration.covariance.diagonal().cwiseSqrt()));
      if (tilt_deg > 0.15) {
        EXPECT_GT(result.ground_lean_variance_rad2.trace(), 0.0);
      }
      // It is not said of a lean that is not there.
      const double sigma_deg = radians_to_degrees(result.calibration.estimate(Parameter::Roll).sigma.value_or(kPi));
      EXPECT_LT(sigma_deg, tilt_deg > 0.0 ? tilt_deg + 0.05 : 0.03);
    }
  std::printf("  worst errors in sigma: x %.1f, y %.1f, z %.1f, yaw %.1f, pitch %.1f, roll %.1f\n", worst[0], worst[1],
              worst[2], worst[3], worst[4], worst[5]);
  EXPECT_LT(worst.maxCoeff(), 3.7);
  // The turn as first plane knows the lean: it is no error there.
  YardTruth yard = testing::noisy_yard();
  yard.ground_tilt_rad = degrees_to_radians(0.4);
  SlewOptions by_turn;
  by_turn.first_plane = FirstPlane::Turn;
  EXPECT_LT(radians_to_degrees(solve(yard, by_turn, 706).calibration.estimate(Parameter::Roll).sigma.value_or(kPi)),
            0.03);
}

TEST(slew, a_hole_of_scans_that_were_not_aligned_is_named_as_the_cause_of_a_short_arc) {
  SlewData data = testing::slew_yard(testing::noisy_yard(), 5);
  data.first_from_lidar.resize(data.first_from_lidar.size() * 3 / 5);
  data.turn_scans = 60;
  data.turn_scans_failed = 13;
  Progress progress;
  SlewResult result = solve_slew(data, std::nullopt, {}, {}, progress);
  expect_refused(result, Status::TooLittleData, "13 of 60 scans of the turn could not be aligned");
  EXPECT_NE(english(result.calibration.advice.front()).find("more slowly"), std::string::npos);
  data.turn_scans_failed = 1;
  expect_refused(solve_slew(data, std::nullopt, {}, {}, progress), Status::TooLittleData, "covers an arc of");
}

TEST(slew, missing_ground_is_refused_only_where_it_is_needed) {
  SlewData data = testing::slew_yard(testing::noisy_yard());
  data.ground_points.clear();
  Progress progress;
  expect_refused(solve_slew(data, std::nullopt, {}, {}, progress), Status::TooLittleData, "ground is missing");
  SlewOptions options;
  options.first_plane = FirstPlane::Turn;
  EXPECT_EQ(solve_slew(data, std::nullopt, options, {}, progress).calibration.status, Status::Ok);
}

TEST(slew, an_arm_that_is_not_square_to_the_ground_is_refused) {
  YardTruth yard = testing::noisy_yard();
  yard.arm_lean_rad = degrees_to_radians(6.0);
  expect_refused(solve(yard), Status::Inconsistent, "plane of the arm leans");
}

TEST(slew, a_lidar_on_the_slew_axis_is_refused) {
  YardTruth yard = testing::noisy_yard();
  yard.machine_from_lidar.translation() = Eigen::Vector3d(0.01, 0.01, 0.0);
  const SlewResult result = solve(yard);
  EXPECT_NE(result.calibration.status, Status::Ok);
  EXPECT_FALSE(result.calibration.known[Parameter::Yaw].observed);
}

TEST(slew, cancelled_claims_nothing) {
  std::stop_source stop;
  stop.request_stop();
  Progress progress(stop.get_token());
  const SlewResult result = solve_slew(testing::slew_yard(testing::noisy_yard()), std::nullopt, {}, {}, progress);
  EXPECT_EQ(result.calibration.status, Status::Cancelled);
  EXPECT_EQ(parameter_names(result.calibration.observed()), "");
}

TEST(slew, options_out_of_range_are_refused) {
  SlewOptions options;
  options.min_arc_deg = 500.0;
  EXPECT_THROW(solve({}, options), Error);
}

}  // namespace
}  // namespace remount::calibration
