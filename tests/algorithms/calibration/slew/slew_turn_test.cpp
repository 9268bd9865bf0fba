#include "algorithms/calibration/slew/slew_turn.h"

#include <gtest/gtest.h>

#include "algorithms/core/error.h"
#include "algorithms/geometry/circle_fit.h"
#include "algorithms/messages/render.h"
#include "tests/algorithms/support/random_motion.h"
#include "tests/algorithms/support/room.h"

namespace remount::calibration {
namespace {

const RigidTransform kSlewMounting = make_rigid(rotation_from_yaw_pitch_roll({0.2, 0.1, -0.05}), {1.0, -0.6, 0.3});

RigidTransform turned(double angle_rad) {
  return make_rigid(so3_exp(angle_rad * Eigen::Vector3d::UnitZ()), Eigen::Vector3d::Zero()) * kSlewMounting;
}

struct Recording {
  std::vector<std::int64_t> stamps_ns;
  std::vector<RigidTransform> first_from_lidar;
  LoadScan load;
};

Recording turn(int scans, double step_rad) {
  Recording recording;
  for (int i = 0; i < scans; ++i) {
    recording.stamps_ns.push_back(1'000'000'000 + i * 100'000'000LL);
    recording.first_from_lidar.push_back(turned(0.0).inverse() * turned(i * step_rad));
  }
  recording.load = [step_rad](std::size_t scan) {
    return testing::scan_of(testing::room(), turned(static_cast<double>(scan) * step_rad), 0.01,
                            static_cast<int>(scan) + 1, 6000);
  };
  return recording;
}

TEST(slew_turn, a_full_turn_is_followed_without_drift) {
  const Recording recording = turn(36, 2.0 * kPi / 36.0);
  Progress progress;
  const TurnTrajectory found = turn_trajectory(recording.stamps_ns, recording.load, {}, {}, progress);
  EXPECT_EQ(found.failed, 0u) << found.first_failure;
  ASSERT_EQ(found.first_from_lidar.size(), 36u);
  double worst_m = 0.0;
  std::vector<Eigen::Vector3d> positions;
  for (std::size_t i = 0; i < 36; ++i) {
    const RigidTransform& pose = found.first_from_lidar[i].pose;
    worst_m = std::max(worst_m, (pose.translation() - recording.first_from_lidar[i].translation()).norm());
    positions.push_back(pose.translation());
  }
  std::printf("  worst position %.4f m\n", worst_m);
  EXPECT_LT(worst_m, 0.02);
  const CircleFit circle = fit_circle(positions);
  EXPECT_LT((circle.centre_m - kSlewMounting.inverse().translation() -
             kSlewMounting.linear().transpose() * Eigen::Vector3d(0, 0, kSlewMounting.translation().z()))
                .norm(),
            0.01);
}

TEST(slew_turn, a_scan_that_cannot_be_read_is_left_out) {
  Recording recording = turn(6, 0.1);
  const LoadScan load = recording.load;
  recording.load = [load](std::size_t scan) {
    if (scan == 3) throw Error(ErrorCode::Io, "scan 3", Message::verbatim("is not there"));
    return load(scan);
  };
  Progress progress;
  const TurnTrajectory found = turn_trajectory(recording.stamps_ns, recording.load, {}, {}, progress);
  EXPECT_EQ(found.failed, 1u);
  EXPECT_NE(english(found.first_failure).find("scan 3"), std::string::npos);
  EXPECT_EQ(found.scans, (std::vector<std::size_t>{0, 1, 2, 4, 5}));
}

TEST(slew_turn, cancelled_stops_at_once) {
  std::stop_source stop;
  stop.request_stop();
  Progress progress(stop.get_token());
  const Recording recording = turn(6, 0.1);
  EXPECT_TRUE(turn_trajectory(recording.stamps_ns, recording.load, {}, {}, progress).first_from_lidar.empty());
}

TEST(moving_points, what_stands_is_left_out_and_what_sweeps_is_kept) {
  std::vector<cloud::PointCloud> scans;
  std::size_t arm_points = 0;
  for (int s = 0; s < 12; ++s) {
    cloud::PointCloud cloud;
    for (int beam = -30; beam <= 10; ++beam)
      for (int step = 0; step < 360; ++step) {
        const double azimuth = degrees_to_radians(step) - kPi, elevation = degrees_to_radians(beam);
        const Eigen::Vector3d ray(std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                                  std::sin(elevation));
        double range = 30.0;
        if (ray.z() < -0.05) range = std::min(range, -2.0 / ray.z());
        // A boom of 3 deg width ahead whose height sweeps.
        const bool boom = std::abs(azimuth) < 0.05 && std::abs(beam - (-25 + 3 * s)) <= 2;
        if (boom) range = 3.0, ++arm_points;
        cloud.points.push_back((range * ray).cast<float>());
      }
    scans.push_back(cloud);
  }
  const std::vector<Eigen::Vector3d> moving = moving_points(scans, 12.0);
  EXPECT_GT(moving.size(), arm_points * 8 / 10);
  for (const Eigen::Vector3d& point : moving) EXPECT_NEAR(point.norm(), 3.0, 0.01);
  EXPECT_TRUE(moving_points({}, 10.0).empty());
  EXPECT_TRUE(moving_points(std::vector<cloud::PointCloud>(5, scans[0]), 10.0).empty());
}

}  // namespace
}  // namespace remount::calibration
