#include "model/conventions/inverted_poses.h"

#include <gtest/gtest.h>

#include <random>

#include "algorithms/messages/render.h"
#include "model/conventions/attitude_check.h"
#include "model/drive/session_frames.h"
#include "tests/support/motion_drive.h"

namespace remount::conventions {
namespace {

/// Poses of INS and LiDAR of a drive.
drive::Session pose_drive(simulator::ScenarioKind scenario) {
  const simulator::SimulatedDrive drive = simulator::simulate_drive(testing::motion_options(scenario, 30.0, 20.0));
  drive::Session session;
  session.name = "drive";
  session.ins_axes.reset();
  session.world_from_ins = drive::metric_poses(drive.session);
  session.odometry_from_lidar = session.world_from_ins;
  const RigidTransform start_from_world = (session.world_from_ins.front().pose * drive.ins_from_lidar).inverse();
  for (motion::StampedPose& pose : session.odometry_from_lidar)
    pose.pose = start_from_world * pose.pose * drive.ins_from_lidar;
  return session;
}

void invert(std::vector<motion::StampedPose>& poses) {
  for (motion::StampedPose& pose : poses) pose.pose = pose.pose.inverse();
}

TEST(inverted_poses, are_named_for_each_sensor_and_right_ones_pass) {
  for (const simulator::ScenarioKind scenario :
       {simulator::ScenarioKind::Street, simulator::ScenarioKind::FigureEight}) {
    const drive::Session right = pose_drive(scenario);
    EXPECT_TRUE(inverted_pose_findings(right).empty());
    drive::Session ins = right, lidar = right, both = right;
    invert(ins.world_from_ins), invert(lidar.odometry_from_lidar);
    invert(both.world_from_ins), invert(both.odometry_from_lidar);
    ASSERT_EQ(attitude_findings(ins).size(), 1U);
    EXPECT_EQ(attitude_findings(ins)[0].code, kPosesInverted);
    EXPECT_EQ(attitude_findings(ins)[0].severity, drive::Severity::Problem);
    EXPECT_TRUE(english(attitude_findings(ins)[0].explanation).starts_with("The poses of the INS seem"));
    ASSERT_EQ(inverted_pose_findings(lidar).size(), 1U);
    EXPECT_TRUE(english(inverted_pose_findings(lidar)[0].explanation).starts_with("The poses of the LiDAR seem"));
    EXPECT_EQ(inverted_pose_findings(both).size(), 2U);
  }
}

TEST(inverted_poses, nothing_is_said_of_what_moves_at_will_or_straight_on) {
  drive::Session hand, straight;
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
  drive::Session session = pose_drive(simulator::ScenarioKind::FigureEight);
  invert(session.world_from_ins), invert(session.odometry_from_lidar);
  calibration::CalibrationResult result;
  result.status = calibration::Status::Ok;
  blame_attitude(attitude_findings(session), result);
  EXPECT_EQ(result.status, calibration::Status::Inconsistent);
  ASSERT_FALSE(result.advice.empty());
  EXPECT_TRUE(english(result.advice[0]).starts_with("Before anything else invert the poses"));
}

}  // namespace
}  // namespace remount::conventions
