#include "algorithms/odometry/fusion/fused_poses.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include "tests/algorithms/odometry/synthetic_drive.h"

namespace remount::odometry {
namespace {

/// Two degrees and three decimetres away.
RigidTransform wrong_mounting(const RigidTransform& vehicle_from_lidar) {
  return vehicle_from_lidar * make_rigid(so3_exp({0.01, -0.01, 0.035}), {0.2, -0.2, 0.1});
}

FusionOdometryResult solve_with(const synthetic::Drive& drive, const FusionMounting& mounting) {
  Progress progress;
  return solve_fusion_odometry(
      static_cast<std::size_t>(drive.scans), [&](std::size_t i) { return drive.scan(static_cast<int>(i)); }, mounting,
      drive.streams(), {}, 1, progress);
}

struct PathError {
  double across_m = 0.0, turn_deg = 0.0;
};

// Of the motion from the first scan to the last, in axes of the LiDAR; what lies along its travel does not count.
PathError path_error(const synthetic::Drive& drive, const std::vector<motion::StampedPose>& poses) {
  const auto lidar_at = [&](int scan) { return RigidTransform(drive.truth(scan) * drive.mounting.vehicle_from_lidar); };
  const RigidTransform truth = lidar_at(0).inverse() * lidar_at(drive.scans - 1);
  const RigidTransform found = poses.front().pose.inverse() * poses.back().pose;
  const Eigen::Vector3d along = truth.translation().normalized(), off = found.translation() - truth.translation();
  return {(off - along * along.dot(off)).norm(), radians_to_degrees(rotation_angle_between_rad(found, truth))};
}

// What shall judge a mounting must not follow from it: a wrong one bends the poses of all sensors together, and leaves
// those alone that rest on them only where scans say nothing.
TEST(fused_poses, a_wrong_mounting_does_not_enter_the_motion_that_is_to_judge_it) {
  synthetic::Drive street = synthetic::street_drive(), tunnel;
  street.yaw_rate_radps = 0.2;
  tunnel.world = synthetic::tunnel();
  for (const synthetic::Drive* drive : {&street, &tunnel}) {
    const RigidTransform wrong = wrong_mounting(drive->mounting.vehicle_from_lidar);
    FusionMounting mounting{wrong, drive->mounting.vehicle_from_imu, false};
    const PathError all = path_error(*drive, odometry_from_lidar(solve_with(*drive, mounting).scans, wrong));
    mounting.to_be_judged = true;
    const PathError judged =
        path_error(*drive, uncorrected_odometry_from_lidar(solve_with(*drive, mounting).scans, wrong));
    std::cout << "    with all sensors " << 1000.0 * all.across_m << " mm, " << all.turn_deg
              << " deg off; to be judged " << 1000.0 * judged.across_m << " mm, " << judged.turn_deg << " deg\n";
    EXPECT_LT(judged.across_m, 0.03);
    EXPECT_LT(judged.turn_deg, 0.1);  // a twentieth
  }
}

TEST(fused_poses, a_tunnel_leaves_untold_the_motion_along_it_and_a_street_nothing) {
  synthetic::Drive drive;
  drive.world = synthetic::tunnel();
  FusionMounting mounting = drive.mounting;
  mounting.to_be_judged = true;
  const RigidTransform& vehicle_from_lidar = mounting.vehicle_from_lidar;
  const std::vector<Matrix6d> motions = untold_motions(solve_with(drive, mounting).scans, vehicle_from_lidar);
  ASSERT_EQ(motions.size(), static_cast<std::size_t>(drive.scans));
  EXPECT_TRUE(motions.front().isZero(0.0));
  const Eigen::Vector3d along = vehicle_from_lidar.linear().transpose() * Eigen::Vector3d::UnitX();
  const double step_m = drive.speed_mps * drive.kPeriod_s;
  for (std::size_t i = 1; i < motions.size(); ++i) {
    const Vector6d by_travel = motions[i].col(0);  // as the vehicle's x errs
    EXPECT_NEAR(by_travel.head<3>().dot(along), step_m, 0.05 * step_m) << i;
    EXPECT_LT((by_travel.head<3>() - along * along.dot(by_travel.head<3>())).norm(), 0.1 * step_m) << i;
    EXPECT_LT(motions[i].rightCols<5>().norm(), 0.2 * step_m) << i;
  }
  for (const Matrix6d& motion :
       untold_motions(solve_with(synthetic::street_drive(), mounting).scans, vehicle_from_lidar))
    EXPECT_LT(motion.norm(), 1e-9);
}

TEST(fused_poses, uncorrected_poses_are_the_steps_one_after_the_other) {
  std::vector<FusedScan> scans(3);
  const RigidTransform step = make_rigid(so3_exp({0.0, 0.01, 0.1}), {1.0, 0.1, 0.0});
  for (std::size_t i = 0; i < scans.size(); ++i) {
    scans[i].stamp_ns = static_cast<std::int64_t>(i);
    if (i > 0) scans[i].before_from_vehicle = step;
    scans[i].odometry_from_vehicle.translation().z() = 5.0;  // where a barometer put it
  }
  const RigidTransform vehicle_from_lidar = make_rigid(so3_exp({0.0, 0.0, 0.3}), {1.0, 0.0, 2.0});
  const std::vector<motion::StampedPose> poses = uncorrected_odometry_from_lidar(scans, vehicle_from_lidar);
  ASSERT_EQ(poses.size(), 3u);
  EXPECT_LT(difference(poses[2].pose, step * step * vehicle_from_lidar).norm(), 1e-12);
  EXPECT_EQ(poses[2].stamp_ns, 2);
}

}  // namespace
}  // namespace remount::odometry
