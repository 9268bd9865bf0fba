// The LiDAR odometry on a simulated street.
#include <gtest/gtest.h>

#include <cstdio>

#include "algorithms/calibration/linear_solutions.h"
#include "algorithms/core/error.h"
#include "algorithms/messages/render.h"
#include "algorithms/odometry/lidar/lidar_odometry.h"
#include "model/simulator/simulator.h"
#include "tests/support/kept_scans.h"

namespace remount::methods {

using odometry::OdometryPose;

namespace {

simulator::SimulatedDrive street_of(double duration_s) {
  simulator::SimulationOptions options;
  options.duration_s = duration_s;
  options.beams = 16;
  options.azimuth_steps = 600;
  return testing::simulate_drive(options);
}

// Few rings on open ground, whole turns from scan to scan.
simulator::SimulatedDrive flat_of(int seed, double duration_s) {
  simulator::SimulationOptions options;
  options.scenario = simulator::ScenarioKind::Flat;
  options.seed = seed;
  options.beams = 24;
  options.azimuth_steps = 512;
  options.scan_rate_hz = 5.0;
  options.duration_s = duration_s;
  return testing::simulate_drive(options);
}

void append(const std::vector<OdometryPose>& more, std::vector<OdometryPose>& poses) {
  poses.insert(poses.end(), more.begin(), more.end());
}

std::vector<OdometryPose> odometry_of(const simulator::SimulatedDrive& drive, bool compensated,
                                      const Progress& progress = {}) {
  odometry::LidarOdometry odometry({}, {});
  std::vector<OdometryPose> poses;
  for (std::size_t i = 0; i < drive.session.scans->size(); ++i) {
    const cloud::PointCloud cloud = drive.session.scans->load(i);
    append(odometry.push(cloud, compensated ? cloud.time_from_stamp_s : std::vector<float>{},
                         drive.session.scans->stamp_ns(i), progress),
           poses);
  }
  append(odometry.finish(progress), poses);
  return poses;
}

RigidTransform true_lidar(const simulator::SimulatedDrive& drive, std::size_t i) {
  return drive.enu_from_ins[i].pose * drive.ins_from_lidar;
}

double drift_percent(const simulator::SimulatedDrive& drive, const std::vector<OdometryPose>& poses) {
  double distance_m = 0.0;
  for (std::size_t i = 1; i < poses.size(); ++i)
    distance_m += (true_lidar(drive, i).translation() - true_lidar(drive, i - 1).translation()).norm();
  const RigidTransform moved = true_lidar(drive, 0).inverse() * true_lidar(drive, poses.size() - 1);
  const double error_m = (poses.back().odometry_from_lidar.translation() - moved.translation()).norm();
  std::printf("  %.3f m off after %.1f m: %.3f %%\n", error_m, distance_m, 100.0 * error_m / distance_m);
  return 100.0 * error_m / distance_m;
}

TEST(lidar_odometry_drive, drifts_by_less_than_a_percent_of_the_distance) {
  const simulator::SimulatedDrive drive = street_of(12.0);
  const std::vector<OdometryPose> poses = odometry_of(drive, true);
  ASSERT_EQ(poses.size(), drive.session.scans->size());
  EXPECT_LT(drift_percent(drive, poses), 1.0);
  std::size_t within = 0;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    EXPECT_TRUE(poses[i].aligned) << poses[i].problem;
    const RigidTransform step = true_lidar(drive, i - 1).inverse() * true_lidar(drive, i);
    const RigidTransform found = poses[i - 1].odometry_from_lidar.inverse() * poses[i].odometry_from_lidar;
    const Matrix6d covariance = poses[i - 1].covariance + poses[i].covariance;
    Vector6d error;
    error << found.translation() - step.translation(), so3_log(step.linear().transpose() * found.linear());
    within +=
        error.dot(calibration::symmetric_solution(covariance, error)) < 16.8 ? 1 : 0;  // 99 % of six degrees of freedom
  }
  std::printf("  %zu of %zu steps within 99 %% of their covariance\n", within, poses.size() - 1);
  EXPECT_GT(static_cast<double>(within), 0.85 * static_cast<double>(poses.size() - 1));
}

TEST(lidar_odometry_drive, motion_within_the_scans_is_compensated_by_its_own_motion) {
  const simulator::SimulatedDrive drive = street_of(5.0);
  const std::vector<OdometryPose> with = odometry_of(drive, true), without = odometry_of(drive, false);
  double residual = 0.0, residual_without = 0.0;
  for (std::size_t i = 1; i < with.size(); ++i) {
    residual += with[i].rmse_m;
    residual_without += without[i].rmse_m;
  }
  std::printf("  mean residual %.4f m, without compensation %.4f m\n", residual / static_cast<double>(with.size() - 1),
              residual_without / static_cast<double>(with.size() - 1));
  EXPECT_LT(residual, residual_without);
}

double largest_step_error_m(const simulator::SimulatedDrive& drive, const std::vector<OdometryPose>& poses,
                            std::size_t first) {
  double largest_m = 0.0;
  for (std::size_t i = first; i < poses.size(); ++i) {
    const RigidTransform step = true_lidar(drive, i - 1).inverse() * true_lidar(drive, i);
    const RigidTransform found = poses[i - 1].odometry_from_lidar.inverse() * poses[i].odometry_from_lidar;
    largest_m = std::max(largest_m, (found.translation() - step.translation()).norm());
  }
  return largest_m;
}

// Rings of the ground fit each other where the vehicle stands still as well.
TEST(lidar_odometry_drive, a_first_step_of_a_metre_and_eight_degrees_is_found) {
  for (const int seed : {2, 24}) {
    const simulator::SimulatedDrive drive = flat_of(seed, 2.0);
    const std::vector<OdometryPose> poses = odometry_of(drive, true);
    const double largest_m = largest_step_error_m(drive, poses, 1);
    std::printf("  seed %d: the largest error of a step %.3f m\n", seed, largest_m);
    for (const OdometryPose& pose : poses) EXPECT_TRUE(pose.aligned) << pose.problem;
    EXPECT_LT(largest_m, 0.03);
  }
}

TEST(lidar_odometry_drive, a_wrong_velocity_leads_no_later_scan_astray) {
  constexpr std::size_t kWrong = 5, kFound = 8;
  const simulator::SimulatedDrive drive = flat_of(3, 3.0);
  const auto& scans = *drive.session.scans;
  for (const RigidTransform& step : {rigid_from_six({-3.5, 3.0, 0, 0.5, 0, 0}), rigid_from_six({5.0, 0, 0, -0.6, 0, 0}),
                                     rigid_from_six({0, 0, 0, -0.7, 0, 0})}) {
    odometry::LidarOdometry odometry({}, {});
    std::vector<OdometryPose> poses;
    for (std::size_t i = 0; i < scans.size(); ++i) {
      const cloud::PointCloud cloud = scans.load(i);
      const std::optional<RigidTransform> told = i == kWrong ? std::optional(step) : std::nullopt;
      append(odometry.push(cloud, cloud.time_from_stamp_s, scans.stamp_ns(i), {}, told), poses);
    }
    append(odometry.finish({}), poses);
    const double largest_m = largest_step_error_m(drive, poses, kFound);
    std::printf("  the largest error of a step later on %.3f m\n", largest_m);
    EXPECT_LT(largest_m, 0.05);
  }
}

TEST(lidar_odometry_drive, the_same_scans_give_the_same_poses) {
  const simulator::SimulatedDrive drive = street_of(1.0);
  const std::vector<OdometryPose> first = odometry_of(drive, true), second = odometry_of(drive, true);
  for (std::size_t i = 0; i < first.size(); ++i)
    EXPECT_EQ(first[i].odometry_from_lidar.matrix(), second[i].odometry_from_lidar.matrix());
}

TEST(lidar_odometry_drive, empty_scans_keep_the_prediction_and_say_so) {
  const simulator::SimulatedDrive drive = street_of(1.0);
  odometry::LidarOdometry odometry({}, {});
  const cloud::PointCloud first = drive.session.scans->load(0), second = drive.session.scans->load(1);
  odometry.push(first, first.time_from_stamp_s, 100, {});
  const OdometryPose lost =
      odometry.push(cloud::PointCloud{}, {}, 100'000'100, {}, rigid_from_six({0.6, 0, 0, 0, 0, 0})).back();
  EXPECT_FALSE(lost.aligned);
  EXPECT_FALSE(lost.problem.empty());
  EXPECT_NEAR(lost.odometry_from_lidar.translation().x(), 0.6, 1e-9);
  EXPECT_GT(lost.covariance(0, 0), 0.5);
  EXPECT_THROW(odometry.push(second, {}, 5, {}), Error);
}

TEST(lidar_odometry_drive, point_times_that_make_it_worse_do_not_cost_the_alignment) {
  const simulator::SimulatedDrive drive = street_of(1.0);
  odometry::LidarOdometry odometry({}, {});
  const auto& scans = *drive.session.scans;
  const cloud::PointCloud first = scans.load(0), second = scans.load(1), third = scans.load(2);
  odometry.push(first, first.time_from_stamp_s, scans.stamp_ns(0), {});
  // Seconds away from each other: once the velocity is known, the scan is torn to pieces.
  std::vector<float> nonsense_s;
  for (std::size_t i = 0; i < second.size(); ++i)
    nonsense_s.push_back(static_cast<float>(i * 7919 % 1000) / 500.0f - 1.0f);
  EXPECT_EQ(odometry.push(second, nonsense_s, scans.stamp_ns(1), {}).size(), 1u);
  const OdometryPose pose = odometry.push(third, third.time_from_stamp_s, scans.stamp_ns(2), {}).back();
  EXPECT_TRUE(pose.aligned) << pose.problem;
  const auto off_m = [&](const OdometryPose& found, std::size_t scan) {
    const RigidTransform truth = true_lidar(drive, 0).inverse() * true_lidar(drive, scan);
    return (found.odometry_from_lidar.translation() - truth.translation()).norm();
  };
  EXPECT_LT(off_m(pose, 1), 0.3);  // neither scan is compensated
  const OdometryPose next = odometry.finish({}).back();
  EXPECT_TRUE(next.aligned) << next.problem;
  EXPECT_LT(off_m(next, 2), 0.3);
}

TEST(lidar_odometry_drive, a_map_that_begins_anew_has_a_number_of_its_own) {
  const simulator::SimulatedDrive drive = street_of(1.0);
  odometry::LidarOdometry odometry({}, {});
  const cloud::PointCloud first = drive.session.scans->load(0);
  EXPECT_EQ(odometry.push(first, {}, 0, {}).back().map, 0);
  EXPECT_EQ(odometry.push(cloud::PointCloud{}, {}, 100'000'000, {}).back().map, 0);
  EXPECT_EQ(odometry.push(cloud::PointCloud{}, {}, 200'000'000, {}).back().map, 0);
  const OdometryPose began = odometry.push(cloud::PointCloud{}, {}, 300'000'000, {}).back();
  EXPECT_EQ(began.map, 1);
  EXPECT_GT(began.covariance(0, 0), 0.5);
}

TEST(lidar_odometry_drive, cancelled_calls_return_the_prediction) {
  const simulator::SimulatedDrive drive = street_of(1.0);
  std::stop_source stop;
  const Progress progress(stop.get_token());
  odometry::LidarOdometry odometry({}, {});
  const cloud::PointCloud first = drive.session.scans->load(0);
  odometry.push(first, {}, 0, progress);
  stop.request_stop();
  EXPECT_FALSE(odometry.push(first, {}, 100'000'000, progress).back().aligned);
}

}  // namespace
}  // namespace remount::methods
