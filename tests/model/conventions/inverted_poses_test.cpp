#include "model/conventions/inverted_poses.h"

#include <gtest/gtest.h>

#include <random>

#include "algorithms/messages/render.h"
#include "model/conventions/attitude_check.h"
#include "model/drive/session_frames.h"
#include "tests/support/motion_drive.h"

namespace remount {
namespace {

/// Poses of INS and LiDAR of a drive.
Session pose_drive(ScenarioKind scenario) {
  const SimulatedDrive drive = simulate_drive(motion_options(scenario, 30.0, 20.0));
  Session session;
  session.name = "drive";
  session.ins_axes.reset();
  session.world_from_ins = metric_poses(drive.session);
  session.odometry_from_lidar = session.world_from_ins;
  const RigidTransform start_from_world = (session.world_from_ins.front().pose * drive.ins_from_lidar).inverse();
  for (StampedPose& pose : session.odometry_from_lidar) pose.pose = start_from_world * pose.pose * drive.ins_from_lidar;
  return session;
}

void invert(std::vector<StampedPose>& poses) {
  for (StampedPose& pose : poses) pose.pose = pose.pose.inverse();
}

TEST(inverted_poses, are_named_for_each_sensor_and_right_ones_pass) {
  for (const ScenarioKind scenario : {ScenarioKind::Street, ScenarioKind::FigureEight}) {
    const Session right = pose_drive(scenario);
    EXPECT_TRUE(inverted_pose_findings(right).empty());
    Session ins = right, lidar = right, both = right;
    invert(ins.world_from_ins), invert(lidar.odometry_from_lidar);
    invert(both.world_from_ins), invert(both.odometry_from_lidar);
    ASSERT_EQ(attitude_findings(ins).size(), 1U);
    EXPECT_EQ(attitude_findings(ins)[0].code, kPosesInverted);
    EXPECT_EQ(attitude_findings(ins)[0].severity, Severity::Problem);
    EXPECT_TRUE(english(attitude_findings(ins)[0].explanation).starts_with("The poses of the INS seem"));
    ASSERT_EQ(inverted_pose_findings(lidar).size(), 1U);
    EXPECT_TRUE(english(inverted_pose_findings(lidar)[0].explanation).starts_with("The poses of the LiDAR seem"));
    EXPECT_EQ(inverted_pose_findings(both).size(), 2U);
  }
}

TEST(inverted_poses, nothing_is_said_of_what_moves_at_will_or_straight_on) {
  Session hand, straight;
  std::mt19937 random(3);
  std::normal_distribution<double> step;
  RigidTransform at = RigidTransform::Identity(), ahead = RigidTransform::Identity();
  Eigen::Vector3d pace = Eigen::Vector3d::Zero();
  for (int i = 0; i < 2000; ++i) {
    pace = 0.98 * pace + 0.04 * Eigen::Vector3d(step(random), step(random), step(random));
    at.translation() += pace;
    at.linear() = at.linear() * Eigen::AngleAxisd(0.02 * step(random), Eigen::Vector3d::UnitZ()).toRotationMatrix();
    ahead.translation() += Eigen::Vector3d(0.3, 1e-3 * step(random), 0.0);
    for (const bool of_hand : {true, false})
      (of_hand ? hand : straight).world_from_ins.push_back({i * 50'000'000LL, of_hand ? at : ahead});
  }
  EXPECT_TRUE(inverted_pose_findings(hand).empty());
  EXPECT_TRUE(inverted_pose_findings(straight).empty());
  invert(hand.world_from_ins), invert(straight.world_from_ins);
  EXPECT_TRUE(inverted_pose_findings(hand).empty());
  EXPECT_TRUE(inverted_pose_findings(straight).empty());
}

TEST(inverted_poses, make_a_result_inconsistent) {
  Session session = pose_drive(ScenarioKind::FigureEight);
  invert(session.world_from_ins), invert(session.odometry_from_lidar);
  CalibrationResult result;
  result.status = Status::Ok;
  blame_attitude(attitude_findings(session), result);
  EXPECT_EQ(result.status, Status::Inconsistent);
  ASSERT_FALSE(result.advice.empty());
  EXPECT_TRUE(english(result.advice[0]).starts_with("Before anything else invert the poses"));
}

}  // namespace
}  // namespace remount
