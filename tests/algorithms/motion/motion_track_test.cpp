#include "algorithms/motion/motion_track.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "algorithms/core/stamps.h"

namespace remount::motion {
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

TEST(motion_track, follows_a_curve_better_than_a_millimetre_at_ten_hertz) {
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

TEST(motion_track, curves_stay_accurate_where_samples_are_uneven) {
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

TEST(motion_track, returns_its_samples_exactly) {
  const std::vector<StampedPose> samples = circle(10.0, 10);
  const MotionTrack track(samples);
  for (const StampedPose& sample : samples)
    EXPECT_TRUE(track.at(sample.stamp_ns)->matrix() == sample.pose.matrix()) << sample.stamp_ns;
}

TEST(motion_track, knows_nothing_outside_its_data) {
  const MotionTrack track(circle(10.0, 10));
  EXPECT_FALSE(track.at(-1));
  EXPECT_FALSE(track.at(nanoseconds(0.9) + 1));
  EXPECT_FALSE(MotionTrack().at(0));
  EXPECT_FALSE(MotionTrack(std::vector<StampedPose>{}).at(0));
  EXPECT_FALSE(MotionTrack(circle(10.0, 1)).at(5));
}

TEST(motion_track, knows_nothing_in_a_gap_and_does_not_reach_across_it) {
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

TEST(motion_track, leaves_out_stamps_that_repeat_or_step_back) {
  const std::vector<StampedPose> clean = circle(10.0, 20);
  std::vector<StampedPose> samples = clean;
  samples.insert(samples.begin() + 5, {samples[4].stamp_ns, on_circle(7.0)});
  samples.insert(samples.begin() + 12, {samples[3].stamp_ns, on_circle(8.0)});
  const MotionTrack track(samples), reference(clean);
  ASSERT_EQ(track.samples().size(), clean.size());
  for (double t = 0.0; t < 1.9; t += 0.013)
    EXPECT_TRUE(track.at(nanoseconds(t))->matrix() == reference.at(nanoseconds(t))->matrix()) << t;
}

TEST(motion_track, velocity_is_in_body_axes_also_at_the_ends) {
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

std::vector<StampedPose> noisy_circle(double rate_hz, int count, double position_sigma_m, double attitude_sigma_rad,
                                      unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  const auto vector = [&](double sigma) -> Eigen::Vector3d {
    return sigma * Eigen::Vector3d(normal(random), normal(random), normal(random));
  };
  std::vector<StampedPose> samples = circle(rate_hz, count);
  for (StampedPose& sample : samples) {
    sample.pose.translation() += vector(position_sigma_m);
    sample.pose.linear() *= so3_exp(vector(attitude_sigma_rad));
  }
  return samples;
}

TEST(motion_around_a_time, averages_the_noise_of_samples_as_far_as_it_says) {
  constexpr double kPosition_m = 0.005, kAttitude_rad = 3.5e-4;
  const MotionTrack track(noisy_circle(100.0, 2000, kPosition_m, kAttitude_rad, 1));
  EXPECT_LT(track.position_noise_factor(), 0.5);
  EXPECT_LT(track.attitude_noise_factor(), 0.5);
  double position2 = 0.0, attitude2 = 0.0;
  int count = 0;
  for (double t = 0.5; t < 19.5; t += 0.0937, ++count) {
    const RigidTransform pose = track.around(nanoseconds(t))->pose();
    position2 += (pose.translation() - on_circle(t).translation()).squaredNorm() / 3.0;
    attitude2 += so3_log(on_circle(t).linear().transpose() * pose.linear()).squaredNorm() / 3.0;
  }
  EXPECT_NEAR(std::sqrt(position2 / count) / (track.position_noise_factor() * kPosition_m), 1.0, 0.15);
  EXPECT_NEAR(std::sqrt(attitude2 / count) / (track.attitude_noise_factor() * kAttitude_rad), 1.0, 0.15);
}

// Noise of the pose at the stamp must not enter the motion over the sweep: compensation would hand it to the lidar.
TEST(motion_around_a_time, keeps_the_noise_of_the_middle_out_of_the_motion_over_a_sweep) {
  constexpr double kAttitude_rad = 3.5e-4;
  const MotionTrack track(noisy_circle(100.0, 2000, 0.005, kAttitude_rad, 2));
  double middle2 = 0.0, product = 0.0, worst_rad = 0.0;
  for (double t = 0.5; t < 19.5; t += 0.1037) {
    const Passage passage = *track.around(nanoseconds(t));
    const Eigen::Vector3d middle = so3_log(on_circle(t).linear().transpose() * passage.pose().linear());
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (int k = -5; k <= 5; ++k) {
      const Eigen::Matrix3d moved = passage.pose().linear().transpose() * passage.at(0.01 * k)->linear();
      const Eigen::Matrix3d truth = on_circle(t).linear().transpose() * on_circle(t + 0.01 * k).linear();
      mean += so3_log(truth.transpose() * moved) / 11.0;
      worst_rad = std::max(worst_rad, so3_log(truth.transpose() * moved).norm());
    }
    middle2 += middle.squaredNorm();
    product += middle.dot(mean);
  }
  // Interpolated samples would carry all of it: a share of -1.
  EXPECT_LT(std::abs(product / middle2), 0.25);
  EXPECT_LT(worst_rad, 1.5 * kAttitude_rad);
}

// Sweeps begin at their stamps: about these their far ends would be bent twice as much.
TEST(motion_around_a_time, knows_best_what_lies_about_the_middle_that_is_asked_for) {
  const MotionTrack track(noisy_circle(100.0, 2000, 0.005, 3.5e-4, 3));
  const auto bend_rad = [&](double middle_s) {
    double sum = 0.0, count = 0.0;
    for (double t = 0.5; t < 19.5; t += 0.1037, ++count) {
      const Passage passage = *track.around(nanoseconds(t), middle_s);
      const Eigen::Matrix3d moved = passage.pose().linear().transpose() * passage.at(0.1)->linear();
      const Eigen::Matrix3d truth = on_circle(t).linear().transpose() * on_circle(t + 0.1).linear();
      sum += so3_log(truth.transpose() * moved).squaredNorm();
    }
    return std::sqrt(sum / count);
  };
  const double about_stamp_rad = bend_rad(0.0), about_middle_rad = bend_rad(0.05);
  EXPECT_LT(about_middle_rad, 0.65 * about_stamp_rad) << about_stamp_rad;
}

// A LiDAR that turns five times a second: with a window as short as the sweep its ends are bent most.
TEST(motion_around_a_time, averages_over_twice_as_long_as_a_slow_sweep_takes) {
  constexpr double kAttitude_rad = 3.5e-4;
  const auto samples = noisy_circle(100.0, 2000, 0.005, kAttitude_rad, 4);
  const MotionTrack slow(samples, 0.0, {}, 0.2), usual(samples);
  const auto end_rad = [](const MotionTrack& track) {
    double sum = 0.0, count = 0.0;
    for (double t = 0.5; t < 19.5; t += 0.1037, ++count)
      sum += so3_log(on_circle(t + 0.2).linear().transpose() * track.around(nanoseconds(t), 0.1)->at(0.2)->linear())
                 .squaredNorm();
    return std::sqrt(sum / count);
  };
  EXPECT_LT(slow.attitude_noise_factor(), 0.8 * usual.attitude_noise_factor());
  EXPECT_LT(end_rad(slow), 0.6 * end_rad(usual)) << end_rad(usual);
}

// A motion that is no parabola for that long is not smoothed for that long.
TEST(motion_around_a_time, takes_the_short_window_where_the_long_one_would_lose_motion) {
  std::vector<StampedPose> samples = noisy_circle(100.0, 2000, 0.005, 3.5e-4, 5);
  for (StampedPose& sample : samples)
    sample.pose.translation().z() += 0.04 * std::sin(14.0 * seconds(sample.stamp_ns - samples.front().stamp_ns));
  const MotionTrack slow(samples, 0.0, {}, 0.25), usual(samples);
  ASSERT_LT(usual.position_noise_factor(), 0.5);
  EXPECT_EQ(slow.position_noise_factor(), usual.position_noise_factor());
}

TEST(motion_around_a_time, leaves_motion_without_noise_as_it_is) {
  // A vehicle that shakes at 9 Hz: a parabola over 0.2 s would flatten it.
  std::vector<StampedPose> shaking = circle(100.0, 1000);
  for (std::size_t i = 0; i < shaking.size(); ++i) {
    const double phase = 2.0 * kPi * 9.0 * 0.01 * static_cast<double>(i);
    shaking[i].pose.translation().z() += 0.004 * std::sin(phase);
    shaking[i].pose.linear() *= so3_exp({0.0, 0.001 * std::sin(phase + 1.0), 0.0});
  }
  for (const MotionTrack& track : {MotionTrack(circle(10.0, 200)), MotionTrack(shaking)}) {
    EXPECT_EQ(track.position_noise_factor(), 1.0);
    EXPECT_EQ(track.attitude_noise_factor(), 1.0);
    for (double t = 0.31; t < 9.0; t += 0.137)
      EXPECT_TRUE(track.around(nanoseconds(t))->pose().matrix() == track.at(nanoseconds(t))->matrix()) << t;
  }
}

TEST(motion_around_a_time, is_not_misled_by_rest_or_by_uneven_stamps) {
  // Three fifths at rest, then shaking: what the rest does not show must not be smoothed.
  std::vector<StampedPose> resting;
  for (int i = 0; i < 2000; ++i) {
    const double t = 0.01 * i, driven = std::max(0.0, t - 12.0);
    RigidTransform pose = on_circle(driven);
    if (driven > 0.0) pose.translation().z() += 0.004 * std::sin(2.0 * kPi * 9.0 * driven);
    resting.push_back({nanoseconds(t), pose});
  }
  EXPECT_EQ(MotionTrack(resting).position_noise_factor(), 1.0);
  EXPECT_EQ(MotionTrack(resting).attitude_noise_factor(), 1.0);
  // Stamps ten microseconds off the beat are as true as any.
  std::mt19937 random(5);
  std::uniform_real_distribution<double> jitter(-1e-5, 1e-5);
  std::vector<StampedPose> uneven;
  for (int i = 0; i < 2000; ++i) {
    const std::int64_t stamp_ns = nanoseconds(0.01 * i + jitter(random));
    uneven.push_back({stamp_ns, on_circle(1e-9 * static_cast<double>(stamp_ns))});
  }
  EXPECT_EQ(MotionTrack(uneven).position_noise_factor(), 1.0);
  EXPECT_EQ(MotionTrack(uneven).attitude_noise_factor(), 1.0);
}

TEST(motion_around_a_time, does_not_run_away_beyond_its_window) {
  const MotionTrack track(noisy_circle(100.0, 1000, 0.005, 3.5e-4, 4));
  const Passage passage = *track.around(nanoseconds(5.0));
  for (const double time_s : {-3.0, -0.5, -0.2, 0.2, 0.5, 3.0}) {
    const RigidTransform pose = *passage.at(time_s), truth = on_circle(5.0 + time_s);
    EXPECT_LT((pose.translation() - truth.translation()).norm(), 0.06) << time_s;
    EXPECT_LT(rotation_angle_between_rad(pose, truth), 3e-3) << time_s;
  }
  EXPECT_LT((passage.at(0.1)->translation() - passage.at(0.1001)->translation()).norm(), 0.005);
  EXPECT_FALSE(passage.at(7.0));
}

TEST(motion_around_a_time, knows_the_ends_and_stops_at_gaps) {
  std::vector<StampedPose> samples = noisy_circle(100.0, 1000, 0.005, 3.5e-4, 3);
  samples.erase(samples.begin() + 400, samples.begin() + 480);
  for (std::size_t i = 400; i < samples.size(); ++i) samples[i].pose.translation() += Eigen::Vector3d(0, 50, 0);
  const MotionTrack track(samples);
  EXPECT_LT(track.position_noise_factor(), 0.5);
  EXPECT_FALSE(track.around(nanoseconds(4.4)));
  EXPECT_FALSE(track.around(nanoseconds(-0.001)));
  EXPECT_LT((track.around(0)->pose().translation() - on_circle(0.0).translation()).norm(), 0.02);
  EXPECT_LT((track.around(nanoseconds(3.98))->pose().translation() - on_circle(3.98).translation()).norm(), 0.02);
  EXPECT_TRUE(track.around(nanoseconds(3.98))->at(0.05)) << "beyond the end of the data the parabola goes on";
}

}  // namespace
}  // namespace remount::motion
