// What two LiDARs have in common of the INS's noise, by what the motion itself averages.
#include <gtest/gtest.h>

#include <random>

#include "algorithms/calibration/rig/rig_problem.h"
#include "algorithms/geometry/rotation.h"
#include "algorithms/motion/motion_track.h"
#include "model/rig/swept_time.h"

namespace remount::rig {
namespace {

constexpr double kNoise_m = 0.01, kSpeed_mps = 5.0;

motion::MotionTrack noisy_straight_drive(double sweep_s) {
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0.0, 1.0);
  std::vector<motion::StampedPose> samples;
  for (int i = 0; i < 20000; ++i) {
    const auto draw = [&](double sigma) -> Eigen::Vector3d {
      return sigma * Eigen::Vector3d(noise(random), noise(random), noise(random));
    };
    samples.push_back(
        {i * std::int64_t{10'000'000},
         make_rigid(so3_exp(draw(3e-4)), Eigen::Vector3d(0.01 * kSpeed_mps * i, 0.0, 0.0) + draw(kNoise_m))});
  }
  return motion::MotionTrack(samples, 0.0, {}, sweep_s);
}

// Errors of where the INS is seen to be during a sweep, as the mean over its points.
Eigen::Vector3d error_of(const motion::MotionTrack& track, std::int64_t stamp_ns, const motion::Sweep& swept) {
  const motion::Passage passage = *track.around(stamp_ns, swept.middle_s());
  constexpr int kPoints = 21;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int i = 0; i < kPoints; ++i) {
    const double time_s = swept.from_s + swept.length_s() * i / (kPoints - 1);
    const double moved_m = kSpeed_mps * (1e-9 * static_cast<double>(stamp_ns) + time_s);
    sum += passage.at(time_s)->translation() - Eigen::Vector3d(moved_m, 0.0, 0.0);
  }
  return sum / kPoints;
}

double correlation_of_errors(const motion::MotionTrack& track, const motion::Sweep& a, const motion::Sweep& b,
                             double b_after_a_s) {
  double of_a = 0.0, of_b = 0.0, of_both = 0.0;
  for (std::int64_t stamp_ns = 2'000'000'000; stamp_ns < 195'000'000'000; stamp_ns += 253'700'000) {
    const Eigen::Vector3d error_a = error_of(track, stamp_ns, a);
    const Eigen::Vector3d error_b = error_of(track, stamp_ns + std::llround(1e9 * b_after_a_s), b);
    of_a += error_a.squaredNorm(), of_b += error_b.squaredNorm(), of_both += error_a.dot(error_b);
  }
  return of_both / std::sqrt(of_a * of_b);
}

TEST(averaged_noise, is_in_common_as_far_as_the_times_that_are_averaged_overlap) {
  struct Case {
    const char* name;
    motion::Sweep a, b;
    double b_after_a_s;
  };
  const motion::Sweep slow{0.0, 0.2}, usual{0.0, 0.1}, fast{0.0, 0.05}, at_once;
  for (const Case& two :
       {Case{"10 Hz, half a sweep apart", usual, usual, 0.05}, Case{"10 Hz, end to end", usual, usual, 0.1},
        Case{"20 Hz, end to end", fast, fast, 0.05}, Case{"a flash at the stamp of a sweep", at_once, usual, 0.0},
        Case{"two flashes", at_once, at_once, 0.03}, Case{"5 Hz, half a sweep apart", slow, slow, 0.1}}) {
    const motion::MotionTrack track = noisy_straight_drive(std::max(two.a.length_s(), two.b.length_s()));
    ASSERT_GT(track.averaged_s(), 0.0) << two.name;
    const double measured = correlation_of_errors(track, two.a, two.b, two.b_after_a_s);
    const double stated = calibration::common_share(averaged_time(two.a, track.averaged_s()),
                                                    averaged_time(two.b, track.averaged_s()), two.b_after_a_s);
    std::printf("  %s: correlation %.2f, stated %.2f\n", two.name, measured, stated);
    EXPECT_NEAR(measured, stated, 0.1) << two.name;
  }
}

}  // namespace
}  // namespace remount::rig
