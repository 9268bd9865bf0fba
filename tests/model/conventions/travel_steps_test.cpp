#include "model/conventions/travel_steps.h"

#include <gtest/gtest.h>

#include <random>

namespace remount::conventions {
namespace {

/// A minute eastwards at `mps`, with white noise in every position.
std::vector<motion::StampedPose> eastwards(double mps, double rate_hz, double noise_m) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  std::vector<motion::StampedPose> poses;
  for (int i = 0; i < static_cast<int>(60.0 * rate_hz); ++i) {
    const double t = i / rate_hz;
    const Eigen::Vector3d noise = noise_m * Eigen::Vector3d(normal(random), normal(random), normal(random));
    poses.push_back(
        {std::llround(t * 1e9), make_rigid(Eigen::Matrix3d::Identity(), Eigen::Vector3d(mps * t, 0.0, 0.0) + noise)});
  }
  return poses;
}

TEST(travel_steps, lead_the_way_of_the_vehicle_fast_and_slow) {
  for (const auto& [mps, count] : {std::pair(10.0, 119U), std::pair(2.5, 119U), std::pair(1.5, 59U)}) {
    const std::vector<TravelStep> steps = travel_steps(eastwards(mps, 50.0, 0.02));
    EXPECT_EQ(steps.size(), count) << mps;
    for (const TravelStep& step : steps) {
      EXPECT_GT(step.direction.x(), 0.99);
      EXPECT_NEAR(step.speed_mps, mps, 0.05);
    }
  }
}

TEST(travel_steps, a_vehicle_that_stands_takes_none) {
  EXPECT_TRUE(travel_steps({}).empty());
  EXPECT_TRUE(travel_steps(eastwards(0.0, 50.0, 0.3)).empty());
  EXPECT_TRUE(travel_steps(eastwards(0.0, 1.0, 0.3)).empty());
  EXPECT_LT(travel_steps(eastwards(0.0, 1.0, 0.5)).size(), 10U) << "a minute of a poor receiver";
  EXPECT_TRUE(travel_steps(eastwards(0.5, 50.0, 0.01)).empty());
}

}  // namespace
}  // namespace remount::conventions
