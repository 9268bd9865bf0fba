#include "model/simulator/lidar_truth.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "algorithms/calibration/linear_solutions.h"
#include "algorithms/core/error.h"
#include "model/simulator/lidar_model.h"
#include "model/simulator/patterns/spinning_pattern.h"
#include "model/simulator/simulator.h"
#include "tests/model/simulator/written_drive.h"

namespace remount::simulator {
namespace {

using Eigen::Vector3d;

/// Without chance and motion, so that what is left are the errors of the sensor.
SimulationOptions still_options() {
  SimulationOptions options;
  options.beams = 16;
  options.azimuth_steps = 600;
  options.duration_s = 1.0;
  options.moving_objects = 0;
  options.range_noise_m = options.dropout = 0.0;
  options.motion_distortion = false;
  return options;
}

SimulatedLidarErrors all_errors() {
  SimulatedLidarErrors errors;
  errors.ring_elevation_deg = 0.1;
  errors.ring_range_m = 0.02;
  errors.elevation_offset_deg = 0.15;
  errors.range_offset_m = 0.05;
  errors.range_scale = 0.004;
  return errors;
}

/// Elevation error, range error and scale of one ring.
struct RingFit {
  Vector3d error = Vector3d::Zero();
  int points = 0;
};

/// Least squares of the measured ranges against those of the world in the directions that the ring claims, with an
/// unknown elevation error. Knows nothing of how the errors were made.
RingFit fit_ring(const SimulatedScanSource& source, const cloud::PointCloud& cloud, std::uint16_t ring) {
  const SimulationOptions& options = source.scene().options();
  const RigidTransform road_from_lidar = source.scene().road_from_ins(scan_time_s(options, 0)) * options.ins_from_lidar;
  const double nominal_rad = beam_elevations_rad(options.beams)[ring];
  const auto world_range_m = [&](double azimuth_rad, double elevation_rad) {
    const Vector3d direction(std::cos(elevation_rad) * std::cos(azimuth_rad),
                             std::cos(elevation_rad) * std::sin(azimuth_rad), std::sin(elevation_rad));
    return source.scene()
        .world()
        .cast({road_from_lidar.translation(), road_from_lidar.linear() * direction}, 200.0)
        .distance_m;
  };
  constexpr double kStep_rad = 1e-6;
  RingFit fit;
  for (const double limit_m : {2.0, 1.0, 0.5, 0.1, 0.02, 0.005, 0.005}) {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Vector3d right = Vector3d::Zero();
    fit.points = 0;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      if (cloud.ring[i] != ring || cloud.points[i].norm() > 30.0f) continue;
      const Vector3d point = cloud.points[i].cast<double>();
      const double azimuth_rad = std::atan2(point.y(), point.x()), elevation_rad = nominal_rad + fit.error[0];
      const double range_m = world_range_m(azimuth_rad, elevation_rad);
      const double slope = (world_range_m(azimuth_rad, elevation_rad + kStep_rad) - range_m) / kStep_rad;
      const double residual_m = point.norm() - (range_m * (1.0 + fit.error[2]) + fit.error[1]);
      if (!(std::abs(residual_m) < limit_m) || !(std::abs(slope) < 1e4)) continue;
      const Vector3d row(slope * (1.0 + fit.error[2]), 1.0, range_m);
      normal += row * row.transpose();
      right += row * residual_m;
      ++fit.points;
    }
    fit.error += calibration::symmetric_solution(Eigen::MatrixXd(normal), right);
  }
  return fit;
}

TEST(lidar_truth, elevations_ranges_and_scale_are_found_in_the_points_as_the_truth_has_them) {
  SimulationOptions options = still_options();
  options.lidar_errors = all_errors();
  for (options.seed = 1; options.seed <= 3; ++options.seed) {
    const SimulatedDrive drive = simulate_drive(options);
    const auto& source = dynamic_cast<const SimulatedScanSource&>(*drive.session.scans);
    const LidarTruth& truth = drive.sensors.lidar;
    const cloud::PointCloud cloud = source.load(0);
    double worst_deg = 0.0, worst_m = 0.0, worst_scale = 0.0;
    // The others see too little of the ground to tell elevations.
    for (std::uint16_t ring = 0; ring < 6; ++ring) {
      const RingFit fit = fit_ring(source, cloud, ring);
      ASSERT_GT(fit.points, 150) << ring;
      worst_deg = std::max(worst_deg, std::abs(radians_to_degrees(fit.error[0] - truth.elevation_error_rad(ring))));
      worst_m = std::max(worst_m, std::abs(fit.error[1] - truth.measured_range_m(ring, 0.0)));
      worst_scale = std::max(worst_scale, std::abs(fit.error[2] - 0.004));
    }
    std::printf("  seed %d: elevations to %.1e deg, ranges to %.1e mm, scale to %.1e\n", options.seed, worst_deg,
                1e3 * worst_m, worst_scale);
    EXPECT_LT(worst_deg, 0.002);
    EXPECT_LT(worst_m, 1e-3);
    EXPECT_LT(worst_scale, 1e-4);
  }
}

TEST(lidar_truth, rings_follow_from_the_seed_whatever_else_is_set) {
  SimulationOptions options;
  options.lidar_errors.ring_elevation_deg = 0.1;
  const LidarTruth plain = draw_lidar_truth(options, 64);
  options.lidar_errors = all_errors();
  options.range_noise_m = 0.1;
  options.scenario = ScenarioKind::Tunnel;
  options.lidar.model = lidar_named("at128");
  const LidarTruth other = draw_lidar_truth(options, 128);
  for (std::size_t ring = 0; ring < 64; ++ring)
    ASSERT_EQ(plain.ring_elevation_rad[ring], other.ring_elevation_rad[ring]);
  options.seed = 2;
  EXPECT_NE(draw_lidar_truth(options, 128).ring_elevation_rad, other.ring_elevation_rad);
  EXPECT_FALSE(plain.perfect());
  EXPECT_TRUE(draw_lidar_truth({}, 64).perfect());
}

TEST(lidar_truth, fields_have_the_stated_spread_change_smoothly_and_turn_nothing) {
  std::vector<Vector3d> directions;
  for (double azimuth = -1.0; azimuth < 1.0; azimuth += 0.1)
    for (double elevation = -0.2; elevation < 0.25; elevation += 0.1)
      directions.push_back(Vector3d(std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                                    std::sin(elevation)));
  constexpr int kSeeds = 200;
  double range2 = 0.0, near = 0.0, far = 0.0;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    SimulationOptions options;
    options.seed = seed;
    options.lidar_errors.field_angle_deg = 0.05;
    options.lidar_errors.field_range_m = 0.01;
    LidarTruth truth = draw_lidar_truth(options, 4);
    EXPECT_FALSE(truth.perfect());
    const auto range = [&](double azimuth) {
      return truth.range_field_m.at({std::cos(azimuth), std::sin(azimuth), 0.0}) / 0.01;
    };
    range2 += range(0.0) * range(0.0) / kSeeds;
    near += range(0.0) * range(0.05) / kSeeds;
    far += range(0.0) * range(1.0) / kSeeds;
    truth.pointing.take_out_turn(directions);
    Vector3d turn = Vector3d::Zero();
    double across2 = 0.0, along = 0.0;
    for (const Vector3d& direction : directions) {
      const Vector3d aside = truth.pointing.aside(direction);
      turn += direction.cross(aside);
      across2 += aside.squaredNorm() / static_cast<double>(directions.size());
      along = std::max(along, std::abs(aside.dot(direction)));
    }
    EXPECT_LT(turn.norm(), 1e-9);
    EXPECT_LT(along, 1e-12);
    EXPECT_LT(std::sqrt(across2), 3.0 * degrees_to_radians(0.05));
  }
  std::printf("  variance %.2f, near %.2f, far %.2f\n", range2, near, far);
  EXPECT_NEAR(range2, 1.0, 0.4);
  EXPECT_GT(near, 0.9 * range2);
  EXPECT_NEAR(far, 0.0, 0.3);
  EXPECT_TRUE(SmoothField(3, 4, 0.0).zero());
}

TEST(lidar_truth, rings_have_the_stated_spread_and_nothing_in_common) {
  SimulationOptions options;
  options.lidar_errors.ring_elevation_deg = 0.1;
  options.lidar_errors.ring_range_m = 0.02;
  double elevation2 = 0.0, range2 = 0.0, product = 0.0;
  constexpr int kSeeds = 40, kRings = 64;
  for (options.seed = 1; options.seed <= kSeeds; ++options.seed) {
    const LidarTruth truth = draw_lidar_truth(options, kRings);
    for (std::size_t ring = 0; ring < kRings; ++ring) {
      const double elevation = radians_to_degrees(truth.ring_elevation_rad[ring]) / 0.1;
      const double range = truth.ring_range_m[ring] / 0.02;
      elevation2 += elevation * elevation / (kSeeds * kRings);
      range2 += range * range / (kSeeds * kRings);
      product += elevation * range / (kSeeds * kRings);
    }
  }
  // 2560 of each: four sigma of the estimates.
  EXPECT_NEAR(elevation2, 1.0, 0.11);
  EXPECT_NEAR(range2, 1.0, 0.11);
  EXPECT_NEAR(product, 0.0, 0.08);
}

TEST(lidar_truth, stands_in_truth_yaml_and_only_where_there_is_any) {
  SimulationOptions options = still_options();
  for (const bool wrong : {false, true}) {
    if (wrong) options.lidar_errors = all_errors();
    const SimulatedDrive drive = simulate_drive(options);
    const formats::TemporaryFolder folder;
    read_back(drive, "mcap", folder);
    const formats::DocumentNode root = truth_in(folder);
    const formats::DocumentNode* errors = root.find("lidar_errors");
    ASSERT_EQ(errors != nullptr, wrong);
    if (!wrong) continue;
    const formats::DocumentView view(*errors, "truth.yaml");
    EXPECT_NEAR(view.at("elevation_offset_deg").number(), 0.15, 1e-12);
    EXPECT_NEAR(view.at("range_offset_m").number(), 0.05, 1e-12);
    EXPECT_NEAR(view.at("range_scale").number(), 0.004, 1e-12);
    const std::vector<double> elevations_deg = view.at("ring_elevation_deg").numbers(16);
    const std::vector<double> ranges_m = view.at("ring_range_m").numbers(16);
    for (std::size_t ring = 0; ring < 16; ++ring) {
      EXPECT_NEAR(degrees_to_radians(elevations_deg[ring]), drive.sensors.lidar.ring_elevation_rad[ring], 1e-12);
      EXPECT_NEAR(ranges_m[ring], drive.sensors.lidar.ring_range_m[ring], 1e-12);
    }
  }
}

TEST(lidar_truth, options_out_of_range_and_mixed_pixels_of_thin_beams_are_refused) {
  const auto refused = [](auto&& change) {
    SimulationOptions options;
    options.duration_s = 0.5;
    change(options);
    return formats::error_of([&] { simulate_drive(options); });
  };
  EXPECT_EQ(refused([](SimulationOptions&) {}), "");
  EXPECT_TRUE(formats::contains(refused([](SimulationOptions& o) { o.lidar_errors.ring_elevation_deg = -0.1; }),
                                "lidar_ring_elevation_deg"));
  EXPECT_TRUE(
      formats::contains(refused([](SimulationOptions& o) { o.lidar_errors.range_scale = 0.2; }), "lidar_range_scale"));
  EXPECT_TRUE(
      formats::contains(refused([](SimulationOptions& o) { o.lidar_errors.rain_mmph = -1.0; }), "lidar_rain_mmph"));
  EXPECT_TRUE(
      formats::contains(refused([](SimulationOptions& o) { o.lidar.points_per_scan = -5; }), "lidar_points_per_scan"));
  EXPECT_TRUE(
      formats::contains(refused([](SimulationOptions& o) { o.lidar.model = static_cast<LidarChoice>(99); }), "lidar"));
  EXPECT_TRUE(formats::contains(refused([](SimulationOptions& o) { o.lidar_errors.mixed_pixels = 0.5; }),
                                "lidar_divergence_mrad"));
}

}  // namespace
}  // namespace remount::simulator
