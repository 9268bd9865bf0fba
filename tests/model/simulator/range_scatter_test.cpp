#include "model/simulator/range_scatter.h"

#include <gtest/gtest.h>

#include <cmath>

#include "model/simulator/lidar_model.h"

namespace remount::simulator {
namespace {

using Eigen::Vector3d;

SimulationOptions scatter_options(ScenarioKind scenario = ScenarioKind::Street) {
  SimulationOptions options;
  options.scenario = scenario;
  options.beams = 32;
  options.azimuth_steps = 500;
  options.duration_s = 1.0;
  options.range_noise_m = options.dropout = 0.0;
  options.motion_distortion = false;
  return options;
}

/// Goes through the firings of a scan with what they meet, at the time of its stamp.
template <class Body>
void for_firings(const SimulationOptions& options, std::size_t scan, Body&& body) {
  const Scene scene(options);
  const Surroundings around(scene, scan_time_s(options, scan));
  RangeScatter scatter(scene.options(), scan);
  for (const Firing& firing : make_scan_pattern(options)->firings(scan)) {
    const double flat = std::cos(firing.elevation_rad);
    const Vector3d direction(flat * std::cos(firing.azimuth_rad), flat * std::sin(firing.azimuth_rad),
                             std::sin(firing.elevation_rad));
    const RayHit hit = around.cast(direction);
    body(around, direction, hit, scatter.next(around, direction));
  }
}

TEST(range_scatter, noise_grows_with_the_footprint_that_falls_aslant) {
  SimulationOptions options = scatter_options(ScenarioKind::Flat);
  options.lidar_errors.divergence_mrad = 3.0;
  double chi2 = 0.0;
  int count = 0, right_incidence = 0;
  const Scene scene(options);
  const RigidTransform road_from_lidar = scene.road_from_ins(scan_time_s(options, 0)) * options.ins_from_lidar;
  for_firings(options, 0,
              [&](const Surroundings& around, const Vector3d& direction, const RayHit& hit,
                  const std::optional<RangeScatter::Return>& found) {
                const Vector3d in_road = road_from_lidar.linear() * direction;
                const double height_m = road_from_lidar.translation().z() + in_road.z() * hit.distance_m;
                const Footprint footprint = look_at_footprint(around, direction, hit, 3e-3);
                if (!found || std::abs(height_m) > 1e-6 || hit.distance_m > 12.0 || footprint.on_edge()) return;
                const double cosine = -in_road.z();
                const double tangent = std::min(std::sqrt(1.0 - cosine * cosine) / cosine, 5.67);
                right_incidence += std::abs(footprint.tan_incidence / tangent - 1.0) < 0.02;
                chi2 += std::pow(found->noise_m / (hit.distance_m * 3e-3 * tangent / 4.0), 2);
                ++count;
              });
  std::printf("  %d ranges, their noise %.3f of what is stated, incidence right of %d\n", count,
              std::sqrt(chi2 / count), right_incidence);
  ASSERT_GT(count, 2000);
  // All but where a wall stands on the ground.
  EXPECT_GT(right_incidence, count * 97 / 100);
  EXPECT_NEAR(chi2 / count, 1.0, 0.1);
}

TEST(range_scatter, noise_of_a_surface_is_that_of_the_options_where_none_is_added) {
  SimulationOptions options;
  options.range_noise_m = 0.02;
  EXPECT_EQ(range_sigma_m(options, 50.0, 0.05, 5.0), 0.02);
  options.lidar_errors.dark_noise_m = 0.04;
  EXPECT_NEAR(range_sigma_m(options, 50.0, 0.1, 0.0), std::hypot(0.02, 0.04), 1e-12);
  EXPECT_NEAR(range_sigma_m(options, 50.0, 0.4, 0.0), std::hypot(0.02, 0.02), 1e-12);
  EXPECT_GT(range_sigma_m(options, 50.0, 0.05, 0.0), range_sigma_m(options, 50.0, 0.2, 0.0));
  EXPECT_EQ(range_sigma_m(options, 50.0, 0.0, 0.0), range_sigma_m(options, 50.0, 0.02, 0.0)) << "bounded";
}

TEST(range_scatter, mixed_pixels_lie_between_the_surfaces_of_an_edge_and_are_as_many_as_stated) {
  SimulationOptions options = scatter_options();
  options.azimuth_steps = 2000;
  options.lidar_errors.divergence_mrad = 3.0;
  for (const double share : {0.0, 0.4, 1.0}) {
    options.lidar_errors.mixed_pixels = share;
    int edges = 0, mixed = 0, all = 0;
    for_firings(options, 0,
                [&](const Surroundings& around, const Vector3d& direction, const RayHit& hit,
                    const std::optional<RangeScatter::Return>& found) {
                  if (!found) return;
                  ++all;
                  const Footprint footprint = look_at_footprint(around, direction, hit, 3e-3);
                  if (!footprint.on_edge()) {
                    ASSERT_EQ(found->range_m, hit.distance_m);
                    return;
                  }
                  ++edges;
                  ASSERT_GE(found->range_m, footprint.near_m);
                  ASSERT_LE(found->range_m, footprint.far_m);
                  mixed += found->range_m > footprint.near_m + 1e-9 && found->range_m < footprint.far_m - 1e-9 &&
                           found->range_m != hit.distance_m;
                });
    std::printf("  %d of %d edges mixed, %d ranges\n", mixed, edges, all);
    ASSERT_GT(edges, 200);
    EXPECT_LT(edges, all / 5);
    EXPECT_NEAR(static_cast<double>(mixed) / edges, share, 4.0 * std::sqrt(0.25 / edges) * (share == 0.4));
  }
}

TEST(range_scatter, rain_takes_far_returns_and_gives_near_ones_as_stated) {
  double last_lost = 0.0;
  for (const double rate_mmph : {5.0, 50.0}) {
    SimulationOptions options = scatter_options();
    options.azimuth_steps = 2000;
    options.lidar_errors.rain_mmph = rate_mmph;
    double near_expected = 0.0, far_expected = 0.0, drops = 0.0;
    int near = 0, near_lost = 0, far = 0, far_lost = 0, from_drops = 0, beams = 0;
    for_firings(options, 0,
                [&](const Surroundings& around, const Vector3d&, const RayHit& hit,
                    const std::optional<RangeScatter::Return>& found) {
                  ++beams;
                  if (found && found->range_m < hit.distance_m) {
                    ++from_drops;
                    EXPECT_LT(found->range_m, 12.0);
                    EXPECT_LT(found->reflectance, 0.1f);
                    return;
                  }
                  if (hit.distance_m >= around.farthest_m()) return;
                  const double loss = rain_loss_share(rate_mmph, hit.distance_m);
                  if (hit.distance_m < 15.0) near_expected += loss, ++near, near_lost += !found;
                  if (hit.distance_m > 30.0) far_expected += loss, ++far, far_lost += !found;
                });
    drops = rain_drop_share(rate_mmph) * beams;
    std::printf("  %.0f mm/h: %d of %d near ones lost (%.0f), %d of %d far ones (%.0f), %d drops (at most %.0f)\n",
                rate_mmph, near_lost, near, near_expected, far_lost, far, far_expected, from_drops, drops);
    EXPECT_NEAR(near_lost, near_expected, 4.0 * std::sqrt(near_expected));
    EXPECT_NEAR(far_lost, far_expected, 4.0 * std::sqrt(far_expected));
    EXPECT_GT(far_lost * near, near_lost * far) << "grows with the range";
    EXPECT_GT(far_lost, last_lost);
    EXPECT_LT(from_drops, drops + 4.0 * std::sqrt(drops));
    EXPECT_GT(from_drops, 0.6 * drops);
    last_lost = far_lost;
  }
  EXPECT_EQ(rain_loss_share(0.0, 80.0), 0.0);
  EXPECT_EQ(rain_drop_share(0.0), 0.0);
}

}  // namespace
}  // namespace remount::simulator
