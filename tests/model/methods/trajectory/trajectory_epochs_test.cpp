// From a session to what trajectory alignment takes: how much of it is independent.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "model/methods/trajectory/trajectory_feed.h"
#include "model/simulator/simulator.h"

namespace remount::methods {
namespace {

std::int64_t stamp_ns(double time_s) { return static_cast<std::int64_t>(std::llround(time_s * 1e9)); }

RigidTransform on_the_road(double time_s) {
  return rigid_from_six({5.0 * time_s, std::sin(time_s), 0.0, 0.2 * std::cos(time_s), 0.0, 0.0});
}

drive::Session with_ins(double rate_hz, double duration_s) {
  drive::Session session;
  for (int i = 0; i <= static_cast<int>(rate_hz * duration_s); ++i)
    session.world_from_ins.push_back({stamp_ns(i / rate_hz), on_the_road(i / rate_hz)});
  return session;
}

SessionOdometry ten_a_second(double duration_s) {
  SessionOdometry odometry;
  for (int i = 0; i <= static_cast<int>(10 * duration_s); ++i) {
    odometry::OdometryPose pose;
    pose.stamp_ns = stamp_ns(0.1 * i);
    pose.odometry_from_lidar = on_the_road(0.1 * i);
    pose.covariance = 1e-6 * Matrix6d::Identity();
    odometry.poses.push_back(pose);
  }
  return odometry;
}

std::size_t with_pose_of_ins(const calibration::TrajectorySession& session) {
  return static_cast<std::size_t>(
      std::count_if(session.epochs.begin(), session.epochs.end(),
                    [](const calibration::TrajectoryEpoch& epoch) { return epoch.ins.has_value(); }));
}

TEST(trajectory_epochs, a_step_across_a_new_map_knows_no_more_than_where_the_map_began) {
  SessionOdometry odometry = ten_a_second(20.0);
  for (std::size_t i = 47; i < odometry.poses.size(); ++i) odometry.poses[i].map = 1;
  odometry.poses[47].covariance = Matrix6d::Identity();
  odometry.poses[123].undetermined = Message::verbatim("along the road");
  odometry.poses[123].covariance = Matrix6d::Identity();
  const calibration::TrajectorySession session = trajectory_session(with_ins(100.0, 20.0), odometry, {}, {});
  std::vector<double> uncertain_at_s;
  for (const calibration::TrajectoryEpoch& epoch : session.epochs)
    if (epoch.step_translation_m2(0, 0) > 0.9) uncertain_at_s.push_back(epoch.time_s);
  ASSERT_EQ(uncertain_at_s.size(), 2u);
  EXPECT_NEAR(uncertain_at_s[0], 5.0, 1e-6);
  EXPECT_NEAR(uncertain_at_s[1], 12.5, 1e-6);
}

TEST(trajectory_epochs, poses_of_a_slow_ins_are_used_once) {
  settings::Settings settings;
  settings.trajectory.state_interval_s = 0.2;
  const calibration::TrajectorySession slow = trajectory_session(with_ins(1.0, 20.0), ten_a_second(20.0), settings, {});
  const calibration::TrajectorySession fast =
      trajectory_session(with_ins(100.0, 20.0), ten_a_second(20.0), settings, {});
  EXPECT_GE(with_pose_of_ins(slow), 18u);
  EXPECT_LE(with_pose_of_ins(slow), 21u);
  EXPECT_GE(with_pose_of_ins(fast), 95u);
}

TEST(trajectory_epochs, frequent_fixes_do_not_multiply_the_ins) {
  simulator::SimulationOptions options;
  options.duration_s = 10.0;
  options.ins_position_noise_m = 0.02;
  options.gnss.rate_hz = 20.0;
  const simulator::SimulatedDrive drive = simulator::simulate_drive(options);
  SessionOdometry odometry;
  for (const motion::StampedPose& pose : drive.enu_from_ins) {
    odometry::OdometryPose one;
    one.stamp_ns = pose.stamp_ns;
    one.odometry_from_lidar = pose.pose * drive.ins_from_lidar;
    odometry.poses.push_back(one);
  }
  const settings::Settings settings;
  const calibration::TrajectorySession session = trajectory_session(drive.session, odometry, settings, {});
  EXPECT_GT(session.epochs.size(), 150u);
  double last_s = -1e9;
  for (const calibration::TrajectoryEpoch& epoch : session.epochs) {
    if (!epoch.ins) continue;
    EXPECT_GT(epoch.time_s - last_s, settings.trajectory.state_interval_s - 2e-3);
    last_s = epoch.time_s;
  }
  EXPECT_GT(with_pose_of_ins(session), 15u);
}

TEST(trajectory_epochs, however_frequent_the_fixes_the_odometry_is_as_uncertain) {
  const auto summed = [](double rate_hz) {
    simulator::SimulationOptions options;
    options.duration_s = 6.0;
    options.gnss.rate_hz = rate_hz;
    drive::Session session = simulator::simulate_drive(options).session;
    session.ins.clear();
    SessionOdometry odometry = ten_a_second(6.0);
    for (odometry::OdometryPose& pose : odometry.poses) pose.stamp_ns += session.scans->stamp_ns(0);
    std::pair<double, double> sum;
    for (const calibration::TrajectoryEpoch& epoch : trajectory_session(session, odometry, {}, {}).epochs) {
      if (epoch.time_s < 1.0 || epoch.time_s > 5.0) continue;
      sum.first += epoch.step_translation_m2(0, 0);
      sum.second += epoch.step_rotation_rad2(2, 2);
    }
    return sum;
  };
  const auto [slow_m2, slow_rad2] = summed(10.0);
  const auto [fast_m2, fast_rad2] = summed(100.0);
  ASSERT_GT(slow_m2, 0.0);
  EXPECT_NEAR(fast_m2 / slow_m2, 1.0, 0.1);
  EXPECT_NEAR(fast_rad2 / slow_rad2, 1.0, 0.1);
}

TEST(trajectory_epochs, without_an_ins_no_walk_of_an_ins_is_in_the_steps) {
  simulator::SimulationOptions options;
  options.duration_s = 6.0;
  options.gnss.rate_hz = 5.0;
  drive::Session session = simulator::simulate_drive(options).session;
  session.ins.clear();
  SessionOdometry odometry = ten_a_second(6.0);
  for (odometry::OdometryPose& pose : odometry.poses) pose.stamp_ns += session.scans->stamp_ns(0);
  settings::Settings settings;
  settings.trajectory.odometry_drift_percent = settings.trajectory.odometry_drift_deg = 0.0;
  session.ins_position_drift = 1.0;
  session.ins_attitude_drift = 1.0;
  const calibration::TrajectorySession made = trajectory_session(session, odometry, settings, {});
  ASSERT_GT(made.epochs.size(), 10u);
  EXPECT_LT(made.epochs[5].step_translation_m2(0, 0), 1e-5);
  EXPECT_LT(made.epochs[5].step_rotation_rad2(0, 0), 1e-5);
}

TEST(trajectory_epochs, a_later_range_gives_the_epochs_that_the_whole_gives_there) {
  const drive::Session session = with_ins(100.0, 120.0);
  const SessionOdometry odometry = ten_a_second(120.0);
  const calibration::TrajectorySession whole = trajectory_session(session, odometry, {}, {});
  EpochRange range;
  range.since_ns = stamp_ns(80.0);
  range.until_ns = stamp_ns(100.0);
  const calibration::TrajectorySession part = trajectory_session(session, odometry, {}, {}, range);
  ASSERT_EQ(part.epochs.size(), 41u);
  for (std::size_t i = 0; i < part.epochs.size(); ++i) {
    const calibration::TrajectoryEpoch &here = part.epochs[i], &there = whole.epochs[160 + i];
    ASSERT_EQ(here.time_s, there.time_s);
    ASSERT_EQ(here.odometry_from_lidar.matrix(), there.odometry_from_lidar.matrix());
    ASSERT_TRUE(here.ins && there.ins);
    ASSERT_LT(difference(here.ins->enu_from_ins, there.ins->enu_from_ins).norm(), 1e-9);
    if (i > 0) {
      ASSERT_EQ(here.step_translation_m2, there.step_translation_m2);
      ASSERT_EQ(here.step_rotation_rad2, there.step_rotation_rad2);
    }
  }
}

TEST(trajectory_epochs, a_silent_stream_holds_back_for_seconds_and_an_unused_one_never) {
  drive::Session session = with_ins(100.0, 40.0);
  const SessionOdometry odometry = ten_a_second(40.0);
  motion::GnssFix fix;
  for (int i = 0; i < 4; ++i) {
    fix.stamp_ns = stamp_ns(i);
    session.gnss.push_back(fix);
  }
  EXPECT_GT(trajectory_reach_ns(session, odometry.poses), stamp_ns(39.0)) << "fixes are not used here";
  for (const motion::StampedPose& pose : session.world_from_ins) {
    motion::InsSample sample;
    sample.stamp_ns = pose.stamp_ns;
    session.ins.push_back(sample);
  }
  session.world_from_ins.clear();
  EXPECT_EQ(trajectory_reach_ns(session, odometry.poses), stamp_ns(35.0));
  session.gnss.clear();
  EXPECT_GT(trajectory_reach_ns(session, odometry.poses), stamp_ns(39.0));
  EXPECT_LT(trajectory_reach_ns(session, odometry.poses), stamp_ns(40.0));
}

}  // namespace
}  // namespace remount::methods
