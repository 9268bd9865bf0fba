#include "algorithms/trajectory/motion_track.h"

#include <gtest/gtest.h>

#include <cmath>

namespace remount {
namespace {

constexpr double kSpeed = 10.0, kTurn = 0.5;  // m/s, rad/s

std::int64_t nanoseconds(double time_s) { return std::llround(time_s * 1e9); }

RigidTransform on_circle(double time_s) {
  const double radius_m = kSpeed / kTurn, angle = kTurn * time_s;
  return make_rigid(rotation_from_yaw_pitch_roll({angle, 0.0, 0.0}),
                    {radius_m * std::sin(angle), radius_m * (1.0 - std::cos(angle)), 0.0});
}

std::vector<StampedPose> circle(double rate_hz, int count) {
  std::vector<StampedPose> samples;
  for (int i = 0; i < count; ++i) samples.push_back({nanoseconds(i / rate_hz), on_circle(i / rate_hz)});
  return samples;
}

TEST(MotionTrack, FollowsACurveBetterThanAMillimetreAtTenHertz) {
  const MotionTrack track(circle(10.0, 60));
  double worst_m = 0.0, worst_rad = 0.0;
  for (double t = 0.1; t < 5.8; t += 0.0137) {
    const auto pose = track.at(nanoseconds(t));
    ASSERT_TRUE(pose) << t;
    worst_m = std::max(worst_m, (pose->translation() - on_circle(t).translation()).norm());
    worst_rad = std::max(worst_rad, rotation_angle_between_rad(*pose, on_circle(t)));
  }
  EXPECT_LT(worst_m, 1e-3);
  EXPECT_LT(worst_rad, 1e-8);
  // The first and the last step have a neighbour on one side only.
  EXPECT_LT((track.at(nanoseconds(0.05))->translation() - on_circle(0.05).translation()).norm(), 0.005);
}

TEST(MotionTrack, CurvesStayAccurateWhereSamplesAreUneven) {
  std::vector<StampedPose> samples;
  for (int i = 0; i < 60; ++i) {
    const double t = 0.1 * i + (i % 3 == 0 ? 0.03 : 0.0);
    samples.push_back({nanoseconds(t), on_circle(t)});
  }
  const MotionTrack track(samples);
  double worst_m = 0.0;
  for (double t = 0.3; t < 5.5; t += 0.0137)
    worst_m = std::max(worst_m, (track.at(nanoseconds(t))->translation() - on_circle(t).translation()).norm());
  EXPECT_LT(worst_m, 1e-3);
}

TEST(MotionTrack, ReturnsItsSamplesExactly) {
  const std::vector<StampedPose> samples = circle(10.0, 10);
  const MotionTrack track(samples);
  for (const StampedPose& sample : samples)
    EXPECT_TRUE(track.at(sample.stamp_ns)->matrix() == sample.pose.matrix()) << sample.stamp_ns;
}

TEST(MotionTrack, KnowsNothingOutsideItsData) {
  const MotionTrack track(circle(10.0, 10));
  EXPECT_FALSE(track.at(-1));
  EXPECT_FALSE(track.at(nanoseconds(0.9) + 1));
  EXPECT_FALSE(MotionTrack().at(0));
  EXPECT_FALSE(MotionTrack(std::vector<StampedPose>{}).at(0));
  EXPECT_FALSE(MotionTrack(circle(10.0, 1)).at(5));
}

TEST(MotionTrack, KnowsNothingInAGapAndDoesNotReachAcrossIt) {
  std::vector<StampedPose> samples = circle(10.0, 60);
  samples.erase(samples.begin() + 20, samples.begin() + 30);  // 1.9 s to 3.0 s
  const MotionTrack track(samples);
  EXPECT_FALSE(track.at(nanoseconds(2.5)));
  EXPECT_TRUE(track.at(nanoseconds(1.9)));
  EXPECT_TRUE(track.at(nanoseconds(3.0)));
  EXPECT_LT((track.at(nanoseconds(3.05))->translation() - on_circle(3.05).translation()).norm(), 0.005);
  // The solution restarts fifty metres aside: the steps next to the gap do not know of it.
  const Eigen::Vector3d aside(0, 50, 0);
  for (std::size_t i = 20; i < samples.size(); ++i) samples[i].pose.translation() += aside;
  const MotionTrack restarted(samples);
  EXPECT_LT((restarted.at(nanoseconds(1.85))->translation() - on_circle(1.85).translation()).norm(), 0.01);
  EXPECT_LT((restarted.at(nanoseconds(3.05))->translation() - on_circle(3.05).translation() - aside).norm(), 0.01);
  EXPECT_FALSE(MotionTrack(circle(10.0, 60), 0.05).at(nanoseconds(1.05)));  // a limit of one's own
  EXPECT_TRUE(MotionTrack(samples, 2.0).at(nanoseconds(2.5)));
}

TEST(MotionTrack, LeavesOutStampsThatRepeatOrStepBack) {
  const std::vector<StampedPose> clean = circle(10.0, 20);
  std::vector<StampedPose> samples = clean;
  samples.insert(samples.begin() + 5, {samples[4].stamp_ns, on_circle(7.0)});
  samples.insert(samples.begin() + 12, {samples[3].stamp_ns, on_circle(8.0)});
  const MotionTrack track(samples), reference(clean);
  ASSERT_EQ(track.samples().size(), clean.size());
  for (double t = 0.0; t < 1.9; t += 0.013)
    EXPECT_TRUE(track.at(nanoseconds(t))->matrix() == reference.at(nanoseconds(t))->matrix()) << t;
}

TEST(MotionTrack, VelocityIsInBodyAxesAlsoAtTheEnds) {
  const MotionTrack track(circle(100.0, 500));
  Vector6d truth;
  truth << kSpeed, 0.0, 0.0, 0.0, 0.0, kTurn;
  for (const double t : {1.0, 2.345, 4.0}) {
    const auto velocity = track.body_velocity(nanoseconds(t));
    ASSERT_TRUE(velocity);
    EXPECT_LT((*velocity - truth).norm(), 1e-3) << velocity->transpose();
  }
  for (const double t : {0.0, 4.99}) {
    const auto velocity = track.body_velocity(nanoseconds(t));
    ASSERT_TRUE(velocity) << t;
    EXPECT_LT((*velocity - truth).norm(), 0.2) << velocity->transpose();
  }
  EXPECT_FALSE(track.body_velocity(nanoseconds(6.0)));
}

}  // namespace
}  // namespace remount
