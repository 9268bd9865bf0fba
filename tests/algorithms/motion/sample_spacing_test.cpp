// What lies between samples errs as the samples themselves say: on motions that the rule was not made from.
#include "algorithms/motion/sample_spacing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "algorithms/motion/motion_track.h"

namespace remount::motion {
namespace {

using Motion = std::function<RigidTransform(double time_s)>;

RigidTransform at_heading(double heading_rad, const Eigen::Vector3d& place_m) {
  return make_rigid(Eigen::AngleAxisd(heading_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix(), place_m);
}

RigidTransform round_a_circle(double time_s) {
  const double heading_rad = 0.35 * time_s;
  return at_heading(heading_rad, 17.0 * Eigen::Vector3d(std::sin(heading_rad), 1.0 - std::cos(heading_rad), 0.0));
}

/// Winds about a line, ever faster.
RigidTransform in_bends(double time_s) {
  const double phase_rad = 0.5 * time_s + 0.005 * time_s * time_s;
  return at_heading(0.4 * std::cos(phase_rad), {8.0 * time_s, 5.0 * std::sin(phase_rad), 0.2 * std::cos(0.3 * time_s)});
}

RigidTransform straight_on(double time_s) { return at_heading(0.7, {9.0 * time_s, -2.0 * time_s, 0.0}); }

std::vector<StampedPose> sampled(const Motion& motion, double step_s) {
  std::vector<StampedPose> samples;
  for (int i = 0; i * step_s <= 40.0; ++i) samples.push_back({std::llround(1e9 * i * step_s), motion(i * step_s)});
  return samples;
}

struct Spread {
  double error_rms = 0.0, stated_rms = 0.0;
};

/// Of the errors of interpolated poses, and of what is stated of them; [m] or [rad].
std::pair<Spread, Spread> spread_of(const Motion& motion, double step_s) {
  const MotionTrack track(sampled(motion, step_s));
  Spread position, attitude;
  double count = 0.0;
  for (double time_s = 3.5 * step_s; time_s < 36.0; time_s += 0.07) {
    const auto stamp_ns = static_cast<std::int64_t>(std::llround(1e9 * time_s));
    const RigidTransform truth = motion(time_s), found = *track.at(stamp_ns);
    const Matrix6d covariance = track.between_samples(stamp_ns)->covariance;
    position.error_rms += (found.translation() - truth.translation()).squaredNorm();
    position.stated_rms += covariance.topLeftCorner<3, 3>().trace();
    attitude.error_rms += std::pow(rotation_angle_between_rad(found, truth), 2);
    attitude.stated_rms += covariance.bottomRightCorner<3, 3>().trace();
    count += 1.0;
  }
  for (Spread* spread : {&position, &attitude}) {
    spread->error_rms = std::sqrt(spread->error_rms / count);
    spread->stated_rms = std::sqrt(spread->stated_rms / count);
  }
  return {position, attitude};
}

TEST(sample_spacing, states_what_an_interpolation_misses) {
  for (const auto& [name, motion] : {std::pair<const char*, Motion>("circle", round_a_circle), {"bends", in_bends}})
    for (const double step_s : {0.2, 0.5, 1.0}) {
      const auto [position, attitude] = spread_of(motion, step_s);
      std::printf("  %s, every %.1f s: %.4f m off, stated %.4f; %.5f rad off, stated %.5f\n", name, step_s,
                  position.error_rms, position.stated_rms, attitude.error_rms, attitude.stated_rms);
      EXPECT_LT(position.error_rms, 1.5 * position.stated_rms + 1e-9) << name << " " << step_s;
      EXPECT_GT(position.error_rms, 0.1 * position.stated_rms) << name << " " << step_s;
      EXPECT_LT(attitude.error_rms, 1.5 * attitude.stated_rms + 1e-9) << name << " " << step_s;
    }
}

TEST(sample_spacing, is_nothing_on_a_straight_line_at_samples_and_where_samples_are_close) {
  const auto [position, attitude] = spread_of(straight_on, 1.0);
  EXPECT_LT(position.stated_rms, 1e-6);
  EXPECT_LT(attitude.stated_rms, 1e-6);
  const MotionTrack slow(sampled(round_a_circle, 0.5));
  EXPECT_LT(slow.between_samples(5'000'000'000)->covariance.norm(), 1e-20);
  EXPECT_GT(slow.between_samples(5'250'000'000)->covariance.norm(), 1e-12);
  const MotionTrack quick(sampled(round_a_circle, 0.1));
  EXPECT_EQ(quick.between_samples(5'050'000'000)->covariance.norm(), 0.0);
}

}  // namespace
}  // namespace remount::motion
