#include "algorithms/geometry/plane_fit.h"

#include <gtest/gtest.h>

#include <stop_token>

#include "algorithms/messages/render.h"
#include "tests/algorithms/support/random_motion.h"

namespace remount {
namespace {

std::vector<Eigen::Vector3d> plate(const Eigen::Matrix3d& axes, const Eigen::Vector3d& centre, double noise_m, int seed,
                                   int count = 600) {
  std::mt19937_64 random(static_cast<std::uint64_t>(seed));
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d u = testing::random_vector(random, 1.0);
    points.push_back(centre + axes * Eigen::Vector3d(3.0 * u.x(), 1.0 * u.y(), noise_m * u.z()));
  }
  return points;
}

TEST(plane_fit, exact_points_give_the_plane_and_its_extent) {
  std::mt19937_64 random(1);
  const Eigen::Matrix3d axes = testing::random_rotation(random);
  const PlaneFit fit = fit_plane(plate(axes, {4, -2, 1}, 0.0, 2), {});
  ASSERT_TRUE(fit.found) << fit.why;
  EXPECT_LT(fit.normal.cross(axes.col(2)).norm(), 1e-9);
  EXPECT_GT(fit.height_of(Eigen::Vector3d::Zero()), 0.0);  // the normal looks at the origin
  EXPECT_NEAR(fit.long_extent_m, 3.0, 0.3);
  EXPECT_NEAR(fit.short_extent_m, 1.0, 0.1);
  EXPECT_LT(fit.rms_m, 1e-9);
}

TEST(plane_fit, errors_are_as_large_as_the_covariance_says) {
  double chi2 = 0.0;
  constexpr int kSeeds = 150;
  for (int seed = 0; seed < kSeeds; ++seed) {
    const Eigen::Matrix3d axes = rotation_from_yaw_pitch_roll({0.3, 0.2, 0.1});
    PlaneFitOptions options;
    options.inlier_m = 0.08;
    const PlaneFit fit = fit_plane(plate(axes, {4, -2, -3}, 0.015, seed), options);
    ASSERT_TRUE(fit.found);
    const Eigen::Vector3d truth = axes.col(2).dot(fit.normal) > 0 ? axes.col(2) : Eigen::Vector3d(-axes.col(2));
    const Eigen::Vector3d error = fit.normal.cross(truth);
    for (int k = 0; k < 2; ++k)
      chi2 += std::pow(error.dot(axes.col(k)), 2) / axes.col(k).dot(fit.normal_covariance_rad2 * axes.col(k));
  }
  // 300 degrees of freedom: the 1% limits are 0.81 and 1.22 of it.
  EXPECT_GT(chi2 / (2.0 * kSeeds), 0.80);
  EXPECT_LT(chi2 / (2.0 * kSeeds), 1.25);
}

TEST(plane_fit, errors_within_a_spot_count_for_as_much_as_they_are_alike) {
  for (const double alike : {0.0, 0.7, 1.0}) {  // share of the error that a spot has in common
    double chi2 = 0.0, offset = 0.0;
    constexpr int kSeeds = 120;
    for (int seed = 0; seed < kSeeds; ++seed) {
      std::mt19937_64 random(static_cast<std::uint64_t>(seed));
      std::normal_distribution<double> normal(0.0, 0.015);
      std::vector<Eigen::Vector3d> points;
      std::vector<std::size_t> spots;
      for (std::size_t spot = 0; spot < 120; ++spot) {
        const Eigen::Vector3d at = testing::random_vector(random, 1.0);
        const double common = normal(random);
        for (int i = 0; i < 12; ++i) {
          points.emplace_back(3.0 * at.x(), at.y(),
                              -2.0 + alike * common + std::sqrt(1.0 - alike * alike) * normal(random));
          spots.push_back(spot);
        }
      }
      PlaneFitOptions options;
      options.inlier_m = 0.08;
      const PlaneFit fit = fit_plane(points, options, spots);
      ASSERT_TRUE(fit.found);
      for (int k = 0; k < 2; ++k)
        chi2 += std::pow(fit.normal.cross(Eigen::Vector3d::UnitZ())[k], 2) / fit.normal_covariance_rad2(k, k);
      offset += std::pow((fit.height_of({0.0, 0.0, -2.0})) / fit.offset_sigma_m, 2);
    }
    std::printf("  %.1f alike: tilt %.2f, offset %.2f\n", alike, chi2 / (2.0 * kSeeds), offset / kSeeds);
    // 240 degrees of freedom: the 0.1% limits are 0.74 and 1.31; the offset is taken at the middle, not at the centre.
    EXPECT_GT(chi2 / (2.0 * kSeeds), 0.72) << alike;
    EXPECT_LT(chi2 / (2.0 * kSeeds), 1.36) << alike;
    EXPECT_GT(offset / kSeeds, 0.6) << alike;
    EXPECT_LT(offset / kSeeds, 1.6) << alike;
  }
}

TEST(plane_fit, points_that_do_not_belong_are_left_out) {
  const Eigen::Matrix3d axes = rotation_from_yaw_pitch_roll({0.3, 0.2, 0.1});
  std::vector<Eigen::Vector3d> points = plate(axes, {4, -2, -3}, 0.01, 3);
  std::mt19937_64 random(4);
  for (int i = 0; i < 500; ++i) points.push_back(Eigen::Vector3d(4, -2, -3) + testing::random_vector(random, 3.0));
  const PlaneFit fit = fit_plane(points, {});
  EXPECT_LT(fit.normal.cross(axes.col(2)).norm(), 0.003);
}

TEST(plane_fit, only_planes_of_the_expected_direction_count) {
  std::vector<Eigen::Vector3d> points = plate(Eigen::Matrix3d::Identity(), {0, 0, -2}, 0.01, 5, 900);
  const Eigen::Matrix3d upright = rotation_from_yaw_pitch_roll({0.0, 0.0, 0.5 * kPi});
  for (const Eigen::Vector3d& point : plate(upright, {5, 2, 0}, 0.01, 6, 300)) points.push_back(point);
  PlaneFitOptions options;
  options.square_to = Eigen::Vector3d::UnitZ();
  EXPECT_LT(fit_plane(points, options).normal.cross(upright.col(2)).norm(), 0.01);
  options.square_to.reset();
  options.near_normal = Eigen::Vector3d::UnitZ();
  EXPECT_LT(fit_plane(points, options).normal.cross(Eigen::Vector3d::UnitZ()).norm(), 0.01);
  options.near_normal = Eigen::Vector3d::UnitX();
  const PlaneFit none = fit_plane(plate(Eigen::Matrix3d::Identity(), {0, 0, -2}, 0.001, 5), options);
  EXPECT_FALSE(none.found);
  EXPECT_FALSE(none.why.empty());
}

TEST(plane_fit, too_few_points_and_a_line_are_no_plane_to_trust) {
  EXPECT_FALSE(fit_plane({}, {}).found);
  std::vector<Eigen::Vector3d> line;
  for (int i = 0; i < 100; ++i) line.emplace_back(0.1 * i, 2.0, 0.0);
  const PlaneFit fit = fit_plane(line, {});
  EXPECT_TRUE(!fit.found || fit.short_extent_m < 1e-6);
}

TEST(plane_fit, cancelled_finds_nothing) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(
      fit_plane(plate(Eigen::Matrix3d::Identity(), {0, 0, 1}, 0.01, 1), {}, {}, Progress(stop.get_token())).found);
}

}  // namespace
}  // namespace remount
