#include "model/simulator/lidar_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "algorithms/core/parallel.h"
#include "model/simulator/patterns/spinning_pattern.h"
#include "model/simulator/random_stream.h"
#include "model/simulator/simulator.h"
#include "tests/model/simulator/written_drive.h"

namespace remount::simulator {
namespace {

using Eigen::Vector3d;

SimulationOptions of_lidar(std::string_view id) {
  SimulationOptions options;
  options.lidar.model = lidar_named(id);
  options.lidar.points_per_scan = 3000;
  options.duration_s = 1.0;
  options.beams = 16;
  return options;
}

/// What the simulator had before its LiDARs had errors: every byte of a drive that sets none must stay.
cloud::PointCloud plain_scan(const Scene& scene, std::size_t scan) {
  const SimulationOptions& options = scene.options();
  const double period_s = 1.0 / options.scan_rate_hz,
               stamp_s = (static_cast<double>(scan) + 0.5) / options.scan_rate_hz;
  RandomStream random(static_cast<std::uint64_t>(options.seed), 100 + scan);
  cloud::PointCloud cloud;
  for (int step = 0; step < options.azimuth_steps; ++step) {
    const double turn = (step + 0.5) / options.azimuth_steps - 0.5;
    const double azimuth_rad = (options.clockwise ? -2.0 : 2.0) * kPi * turn;
    const double time_s = options.motion_distortion ? stamp_s + turn * period_s : stamp_s;
    const RigidTransform road_from_lidar = scene.road_from_ins(time_s) * options.ins_from_lidar;
    std::vector<BoxCaster> cars;
    for (const Box& box :
         scene.traffic().boxes_at(time_s, road_from_lidar.translation().head<2>(), options.max_range_m))
      cars.emplace_back(box);
    const std::vector<TiltedBox> arm = scene.arm(time_s);
    std::uint16_t ring = 0;
    for (const double elevation_rad : beam_elevations_rad(options.beams)) {
      const double flat = std::cos(elevation_rad);
      const Vector3d direction(flat * std::cos(azimuth_rad), flat * std::sin(azimuth_rad), std::sin(elevation_rad));
      const Ray ray{road_from_lidar.translation(), road_from_lidar.linear() * direction};
      RayHit hit = scene.world().cast(ray, options.max_range_m);
      if (!hit.found()) hit.distance_m = options.max_range_m;
      for (const BoxCaster& car : cars) car.cast(ray, 1.0 / ray.direction.z(), hit);
      for (const TiltedBox& box : arm) cast_tilted_box(box, ray, hit);
      const double noise_m = options.range_noise_m * random.normal();
      const bool lost = random.uniform() < options.dropout;
      const std::uint16_t own_ring = ring++;
      if (lost || hit.distance_m >= options.max_range_m || hit.distance_m < 0.5) continue;
      cloud.points.push_back(((hit.distance_m + noise_m) * direction).cast<float>());
      cloud.intensity.push_back(hit.albedo / (1.0f + 0.02f * static_cast<float>(hit.distance_m)));
      cloud.ring.push_back(own_ring);
      if (options.motion_distortion) cloud.time_from_stamp_s.push_back(static_cast<float>(turn * period_s));
    }
  }
  return cloud;
}

TEST(lidar_model, a_drive_that_sets_no_errors_has_the_bytes_of_one_without_them) {
  for (const ScenarioKind scenario : {ScenarioKind::Street, ScenarioKind::SlewYard}) {
    for (const bool other : {false, true}) {
      SimulationOptions options;
      options.scenario = scenario;
      options.beams = other ? 32 : 64;
      options.azimuth_steps = 300;
      options.clockwise = other;
      options.motion_distortion = !other;
      options.duration_s = 2.0;
      for (options.seed = 1; options.seed <= 3; ++options.seed) {
        const auto scene = std::make_shared<const Scene>(options);
        const cloud::PointCloud expected = plain_scan(*scene, 13), found = SimulatedScanSource(scene).load(13);
        ASSERT_GT(expected.size(), 1000u);
        EXPECT_EQ(found.points, expected.points);
        EXPECT_EQ(found.intensity, expected.intensity);
        EXPECT_EQ(found.ring, expected.ring);
        EXPECT_EQ(found.time_from_stamp_s, expected.time_from_stamp_s);
      }
    }
  }
}

TEST(lidar_model, one_error_more_or_less_changes_no_other) {
  SimulationOptions options = of_lidar("spinning");
  options.lidar_errors.ring_range_m = 0.03;
  const cloud::PointCloud plain = simulate_drive(options).session.scans->load(2);
  options.lidar_errors.range_offset_m = 0.5;
  const cloud::PointCloud farther = simulate_drive(options).session.scans->load(2);
  ASSERT_EQ(farther.size(), plain.size());
  for (std::size_t i = 0; i < plain.size(); ++i)
    ASSERT_NEAR(farther.points[i].norm() - plain.points[i].norm(), 0.5, 1e-4);
  options.lidar_errors.range_offset_m = 0.0;
  options.lidar_errors.rain_mmph = 20.0;
  const cloud::PointCloud wet = simulate_drive(options).session.scans->load(2);
  std::size_t same = 0, next = 0;
  for (const Eigen::Vector3f& point : wet.points) {
    const auto at = std::find(plain.points.begin() + static_cast<std::ptrdiff_t>(next), plain.points.end(), point);
    if (at == plain.points.end()) continue;
    ++same;
    next = static_cast<std::size_t>(at - plain.points.begin()) + 1;
  }
  EXPECT_GT(same, wet.size() * 9 / 10) << "what rain leaves is what it was";
  EXPECT_LT(same, plain.size());
}

TEST(lidar_model, scans_are_the_same_in_any_order_and_on_any_thread) {
  for (const LidarModel& model : lidar_models()) {
    SimulationOptions options = of_lidar(model.id);
    options.lidar_errors = {0.05, 0.01, 0.03, 0.005, 0.02, 0.01, 0.001, 0.01, 2.0, 0.5, 10.0};
    const SimulatedDrive drive = simulate_drive(options), again = simulate_drive(options);
    std::vector<cloud::PointCloud> together(drive.session.scans->size());
    parallel_for(together.size(), 4, [&](std::size_t scan) { together[scan] = drive.session.scans->load(scan); });
    for (std::size_t scan = together.size(); scan-- > 0;) {
      const cloud::PointCloud alone = again.session.scans->load(scan);
      ASSERT_GT(alone.size(), 300u) << model.id;
      ASSERT_EQ(alone.points, together[scan].points) << model.id;
      ASSERT_EQ(alone.time_from_stamp_s, together[scan].time_from_stamp_s) << model.id;
    }
  }
}

/// Distance of points, carried to the road by their times, from where the same beams meet the world then.
double worst_off_m(const SimulatedDrive& drive, std::size_t scan) {
  const auto& source = dynamic_cast<const SimulatedScanSource&>(*drive.session.scans);
  const cloud::PointCloud cloud = source.load(scan);
  double worst_m = 0.0;
  for (std::size_t i = 0; i < cloud.size(); i += 7) {
    const double time_s = 1e-9 * static_cast<double>(source.stamp_ns(scan) - kDriveStart_ns) +
                          static_cast<double>(cloud.time_from_stamp_s[i]);
    const RigidTransform road_from_lidar = source.scene().road_from_ins(time_s) * drive.ins_from_lidar;
    const Vector3d point = cloud.points[i].cast<double>();
    const RayHit hit = source.scene().world().cast(
        {road_from_lidar.translation(), road_from_lidar.linear() * point.normalized()}, 500.0);
    worst_m = std::max(worst_m, std::abs(hit.distance_m - point.norm()));
  }
  return worst_m;
}

TEST(lidar_model, points_of_every_lidar_lie_on_the_world_at_their_times) {
  for (const LidarModel& model : lidar_models()) {
    SimulationOptions options = of_lidar(model.id);
    options.moving_objects = 0;
    options.range_noise_m = options.dropout = 0.0;
    options.scenario = ScenarioKind::Flat;
    options.speed_mps = 20.0;
    const SimulatedDrive drive = simulate_drive(options);
    const cloud::PointCloud cloud = drive.session.scans->load(5);
    std::size_t first = 0, last = 0;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      if (cloud.time_from_stamp_s[i] < cloud.time_from_stamp_s[first]) first = i;
      if (cloud.time_from_stamp_s[i] > cloud.time_from_stamp_s[last]) last = i;
    }
    const double from_s = cloud.time_from_stamp_s[first], to_s = cloud.time_from_stamp_s[last];
    std::printf("  %-10s %5zu points, %6.1f to %5.1f ms, %.4f m off at most\n", model.id.data(), cloud.size(),
                1e3 * from_s, 1e3 * to_s, worst_off_m(drive, 5));
    // Rays that graze an edge may miss it by the rounding of a float.
    EXPECT_LT(worst_off_m(drive, 5), 0.05) << model.id;
    EXPECT_EQ(cloud.ring.empty(), !model.has_rings) << model.id;
    EXPECT_GE(from_s, model.spins ? -0.05 : 0.0) << model.id;
    EXPECT_LT(to_s, model.spins ? 0.05 : 0.1) << model.id;
    EXPECT_GT(to_s - from_s, 0.05) << model.id;
    EXPECT_EQ(drive.session.scans->stamp_ns(5), drive.enu_from_ins[5].stamp_ns);
    EXPECT_EQ(drive.session.scans->stamp_ns(5) - kDriveStart_ns, model.spins ? 550'000'000 : 500'000'000);
  }
}

TEST(lidar_model, a_session_says_that_its_lidar_does_not_spin) {
  for (const LidarModel& model : lidar_models()) {
    SimulationOptions options = of_lidar(model.id);
    EXPECT_EQ(simulate_drive(options).session.scan_timing, drive::ScanTiming::PerPoint);
    options.per_point_time = false;
    const drive::Session without = simulate_drive(options).session;
    EXPECT_EQ(without.scan_timing, model.spins ? drive::ScanTiming::SweepAzimuth : drive::ScanTiming::Unknown);
    EXPECT_EQ(without.sweep.by_order, !model.spins);
    EXPECT_EQ(without.sweep.certain, model.spins);
    options.motion_distortion = false;
    EXPECT_EQ(simulate_drive(options).session.scan_timing, drive::ScanTiming::Instant);
  }
}

TEST(lidar_model, every_format_carries_its_scans_or_refuses_them) {
  // Of a LiDAR of its own: see velodyne_drive_test.cpp, bag_drive_test.cpp and others. Captures are found below.
  std::set<std::string> captures{"rosbag1-velodyne", "mcap-ouster", "rosbag2-hesai", "mcap-robosense"};
  for (const LidarModel& model : lidar_models()) {
    SimulationOptions options = of_lidar(model.id);
    options.clockwise = false;
    options.duration_s = 0.5;
    const SimulatedDrive drive = simulate_drive(options);
    for (const std::string& format : drive_formats()) {
      if (captures.contains(format)) continue;
      const formats::TemporaryFolder folder;
      if (format == "kitti-raw" && !model.spins) {
        EXPECT_ERROR(read_back(drive, format, folder), "spin");
        EXPECT_FALSE(std::filesystem::exists(drive_in(folder)));
        continue;
      }
      if (has_compensated_scans(format)) {
        EXPECT_ERROR(read_back(drive, format, folder), "compensated");
        EXPECT_FALSE(std::filesystem::exists(drive_in(folder)));
        continue;
      }
      Progress progress;
      write_drive(drive, drive_in(folder), format, 1, progress);
      if (format == "smartloc" || format == "gpx" || format == "kitti-raw") continue;
      const drive::Session read = formats::open_session(drive_in(folder), progress);
      if (read.format == "lidar-capture") {
        captures.insert(format);
        continue;
      }
      if (!read.scans) {
        EXPECT_EQ(read.odometry_from_lidar.size(), drive.session.scans->size()) << format;
        continue;
      }
      EXPECT_EQ(read.scan_timing, drive::ScanTiming::PerPoint) << model.id << ' ' << format;
      EXPECT_EQ(read.times_count, drive::TimesCount::Forwards) << model.id << ' ' << format;
      ASSERT_EQ(read.scans->size(), drive.session.scans->size()) << model.id << ' ' << format;
      const cloud::PointCloud written = drive.session.scans->load(3), found = read.scans->load(3);
      const bool of_apollo = format == "apollo-record";  // stamped by its last point
      const double later_s = seconds(read.scans->stamp_ns(3) - drive.session.scans->stamp_ns(3));
      EXPECT_NEAR(later_s, of_apollo ? *std::ranges::max_element(written.time_from_stamp_s) : 0.0,
                  of_apollo ? 1e-6 : 0.0)
          << model.id << ' ' << format;
      ASSERT_EQ(found.size(), written.size()) << model.id << ' ' << format;
      EXPECT_TRUE(format == "native-las" || of_apollo || found.ring == written.ring) << model.id << ' ' << format;
      for (std::size_t i = 0; i < found.size(); i += 5) {
        ASSERT_LT((found.points[i] - written.points[i]).norm(), 2e-4f) << model.id << ' ' << format;
        ASSERT_NEAR(found.time_from_stamp_s[i] + later_s, written.time_from_stamp_s[i], 1e-6)
            << model.id << ' ' << format;
      }
    }
  }
}

TEST(lidar_model, without_times_a_lidar_that_does_not_spin_is_read_as_one_of_unknown_times) {
  SimulationOptions options = of_lidar("avia");
  options.per_point_time = false;
  options.duration_s = 0.5;
  const SimulatedDrive drive = simulate_drive(options);
  for (const char* format : {"native", "native-las", "mcap", "opencalib"}) {
    const formats::TemporaryFolder folder;
    EXPECT_EQ(read_back(drive, format, folder).scan_timing, drive::ScanTiming::Unknown) << format;
  }
}

TEST(lidar_model, sees_no_farther_than_its_data_sheet) {
  SimulationOptions options = of_lidar("mid-360");
  options.max_range_m = 200.0;
  options.dropout = 0.0;
  options.duration_s = 0.5;
  options.lidar.points_per_scan = 0;
  float farthest_m = 0.0f;
  const cloud::PointCloud cloud = simulate_drive(options).session.scans->load(1);
  for (const Eigen::Vector3f& point : cloud.points) farthest_m = std::max(farthest_m, point.norm());
  EXPECT_LT(farthest_m, 70.1f);
  EXPECT_GT(farthest_m, 60.0f);
  EXPECT_LT(cloud.size(), 20'000u);
}

}  // namespace
}  // namespace remount::simulator
