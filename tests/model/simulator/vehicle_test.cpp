#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "algorithms/core/error.h"
#include "model/simulator/lidar_model.h"
#include "model/simulator/simulator.h"
#include "tests/model/simulator/written_drive.h"

namespace remount::simulator {
namespace {

SimulationOptions short_drive(ScenarioKind scenario = ScenarioKind::Street) {
  SimulationOptions options;
  options.scenario = scenario;
  options.duration_s = 1.0;
  options.beams = 16;
  options.azimuth_steps = 200;
  return options;
}

/// At the front a LiDAR that turns and errs; at the rear one that looks ahead, at another rate.
std::vector<LidarMount> front_and_rear(const SimulationOptions& options) {
  LidarMount front{"front", options}, rear{"rear-2", options};
  front.options.ins_from_lidar = rigid_from_six({2.0, 0.3, 0.4, 0.1, 0.0, 0.02});
  front.options.lidar_errors.ring_elevation_deg = 0.1;
  rear.options.ins_from_lidar = rigid_from_six({-1.5, 0.0, 0.6, kPi, 0.0, 0.0});
  rear.options.lidar.model = lidar_named("at128");
  rear.options.lidar.points_per_scan = 4000;
  rear.options.scan_rate_hz = 5.0;
  rear.options.scan_phase_s = 0.03;
  return {front, rear};
}

void expect_same_motion(const drive::Session& a, const drive::Session& b) {
  ASSERT_EQ(a.ins.size(), b.ins.size());
  for (std::size_t i = 0; i < a.ins.size(); ++i) {
    ASSERT_EQ(a.ins[i].stamp_ns, b.ins[i].stamp_ns);
    ASSERT_EQ(a.ins[i].latitude_rad, b.ins[i].latitude_rad);
    ASSERT_EQ(a.ins[i].height_m, b.ins[i].height_m);
    ASSERT_EQ(a.ins[i].enu_from_ins.coeffs(), b.ins[i].enu_from_ins.coeffs());
  }
  ASSERT_EQ(a.imu.size(), b.imu.size());
  for (std::size_t i = 0; i < a.imu.size(); ++i)
    ASSERT_EQ(a.imu[i].angular_rate_radps, b.imu[i].angular_rate_radps) << "of sample " << i;
  EXPECT_EQ(a.gnss.size(), b.gnss.size());
  EXPECT_EQ(a.wheels.size(), b.wheels.size());
}

void expect_same_scans(const drive::ScanSource& a, const drive::ScanSource& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a.stamp_ns(i), b.stamp_ns(i));
    const cloud::PointCloud expected = a.load(i), found = b.load(i);
    EXPECT_GT(expected.size(), 100u);
    ASSERT_EQ(expected.points, found.points) << "of scan " << i;
    ASSERT_EQ(expected.ring, found.ring);
  }
}

TEST(simulated_vehicle, all_lidars_have_the_ins_of_the_drive_with_one) {
  for (const ScenarioKind scenario :
       {ScenarioKind::Street, ScenarioKind::Flat, ScenarioKind::FigureEight, ScenarioKind::Hill}) {
    const SimulationOptions options = short_drive(scenario);
    const SimulatedVehicle vehicle = simulate_vehicle(options, front_and_rear(options));
    ASSERT_EQ(vehicle.lidars.size(), 2u);
    const SimulatedDrive alone = simulate_drive(options);
    for (const SimulatedDrive& drive : vehicle.lidars) {
      expect_same_motion(drive.session, alone.session);
      EXPECT_EQ(drive.session.name, alone.session.name);
    }
  }
}

TEST(simulated_vehicle, each_lidar_is_what_its_mount_says) {
  const SimulationOptions options = short_drive();
  const SimulatedVehicle vehicle = simulate_vehicle(options, front_and_rear(options));
  const SimulatedDrive &front = vehicle.lidars[0], &rear = vehicle.lidars[1];
  EXPECT_EQ(front.session.lidar_name, "front");
  EXPECT_EQ(rear.session.lidar_name, "rear-2");
  EXPECT_NEAR(rear.ins_from_lidar.translation().x(), -1.5, 1e-12);
  EXPECT_FALSE(front.sensors.lidar.perfect());
  EXPECT_TRUE(rear.sensors.lidar.perfect());
  EXPECT_EQ(front.session.lidar, cloud::LidarKind::Unknown);
  EXPECT_EQ(rear.session.lidar, cloud::LidarKind::Perfect);
  EXPECT_EQ(front.session.scans->size(), 10u);
  EXPECT_EQ(rear.session.scans->size(), 4u) << "0.97 s at 5 Hz";
  EXPECT_EQ(front.session.scans->stamp_ns(0), kDriveStart_ns + 50'000'000) << "spins: in the middle of the turn";
  EXPECT_EQ(rear.session.scans->stamp_ns(0), kDriveStart_ns + 30'000'000) << "with the first point";
  EXPECT_EQ(rear.session.scans->stamp_ns(1), kDriveStart_ns + 230'000'000);
  ASSERT_EQ(rear.enu_from_ins.size(), 4u);
  EXPECT_EQ(rear.enu_from_ins[1].stamp_ns, rear.session.scans->stamp_ns(1));
  EXPECT_LT(rear.session.scans->load(1).size(), 4500u);
}

TEST(simulated_vehicle, points_lie_where_the_world_is) {
  // The floor of a flat world, seen by both from their own places at their own times.
  SimulationOptions options = short_drive(ScenarioKind::Flat);
  options.range_noise_m = 0.0;
  std::vector<LidarMount> mounts = front_and_rear(options);
  mounts[0].options.lidar_errors = {};
  for (const SimulatedDrive& drive : simulate_vehicle(options, mounts).lidars) {
    const Scene& scene = *scene_of(drive.session.scans);
    const cloud::PointCloud cloud = drive.session.scans->load(2);
    const double stamp_s = 1e-9 * static_cast<double>(drive.session.scans->stamp_ns(2) - kDriveStart_ns);
    std::size_t on_floor = 0, below = 0;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      const double time_s = stamp_s + static_cast<double>(cloud.time_from_stamp_s[i]);
      const double z_m = (scene.road_from_ins(time_s) * drive.ins_from_lidar * cloud.points[i].cast<double>()).z();
      on_floor += std::abs(z_m) < 1e-3;
      below += z_m < -1e-3;
    }
    std::printf("%s: %zu of %zu points on the floor\n", drive.session.lidar_name.c_str(), on_floor, cloud.size());
    EXPECT_GT(on_floor, cloud.size() / 10);
    EXPECT_EQ(below, 0u);
  }
}

TEST(simulated_vehicle, no_lidar_changes_what_another_measures) {
  const SimulationOptions options = short_drive();
  std::vector<LidarMount> mounts = front_and_rear(options);
  const SimulatedVehicle both = simulate_vehicle(options, mounts);
  const SimulatedVehicle rear_alone = simulate_vehicle(options, {mounts[1]});
  expect_same_scans(*both.lidars[1].session.scans, *rear_alone.lidars[0].session.scans);
  std::swap(mounts[0], mounts[1]);
  mounts[0].options.dropout = 0.5;
  const SimulatedVehicle changed = simulate_vehicle(options, mounts);
  expect_same_scans(*both.lidars[0].session.scans, *changed.lidars[1].session.scans);
  EXPECT_EQ(both.lidars[0].sensors.lidar.ring_elevation_rad, changed.lidars[1].sensors.lidar.ring_elevation_rad);
}

TEST(simulated_vehicle, lidars_of_other_names_and_seeds_draw_other_errors) {
  const SimulationOptions options = short_drive();
  LidarMount left{"left", options}, right{"right", options};
  left.options.lidar_errors.ring_elevation_deg = right.options.lidar_errors.ring_elevation_deg = 0.1;
  const SimulatedVehicle vehicle = simulate_vehicle(options, {left, right});
  EXPECT_NE(vehicle.lidars[0].sensors.lidar.ring_elevation_rad, vehicle.lidars[1].sensors.lidar.ring_elevation_rad);
  EXPECT_NE(vehicle.lidars[0].session.scans->load(0).points, vehicle.lidars[1].session.scans->load(0).points);
  SimulationOptions other = options;
  other.seed = 2;
  EXPECT_NE(vehicle.lidars[0].sensors.lidar.ring_elevation_rad,
            simulate_vehicle(other, {left}).lidars[0].sensors.lidar.ring_elevation_rad);
}

TEST(simulated_vehicle, what_is_none_is_refused) {
  const SimulationOptions options = short_drive();
  const auto refusal = [&](const std::vector<LidarMount>& mounts) {
    return formats::error_of([&] { simulate_vehicle(options, mounts); });
  };
  LidarMount front{"front", options}, late{"late", options}, odd{"a/b", options}, wrong{"wrong", options};
  late.options.scan_phase_s = 1.0;
  wrong.options.beams = 0;
  EXPECT_TRUE(formats::contains(refusal({}), "one to 64 LiDARs")) << refusal({});
  EXPECT_TRUE(formats::contains(refusal({front, front}), "two LiDARs are called front"));
  EXPECT_TRUE(formats::contains(refusal({odd}), "'a/b' is no name of a LiDAR"));
  EXPECT_TRUE(formats::contains(refusal({front, late}), "mount late")) << refusal({front, late});
  EXPECT_TRUE(formats::contains(refusal({wrong}), "beams")) << refusal({wrong});
}

TEST(simulated_vehicle, comes_back_from_every_format_that_takes_one) {
  EXPECT_EQ(vehicle_formats(), (std::vector<std::string>{"native", "native-las", "native-text", "rosbag1", "rosbag2",
                                                         "mcap", "mcap-novatel", "apollo-record"}));
  const SimulationOptions options = short_drive();
  const SimulatedVehicle vehicle = simulate_vehicle(options, front_and_rear(options));
  for (const std::string& format : vehicle_formats()) {
    const formats::TemporaryFolder folder;
    Progress progress;
    write_vehicle(vehicle, drive_in(folder), format, 2, progress);
    const std::vector<drive::LidarOffer> offers = formats::offer_lidars(drive_in(folder), progress);
    ASSERT_EQ(offers.size(), 2u) << format;
    for (std::size_t l = 0; l < 2; ++l) {
      const SimulatedDrive& drive = vehicle.lidars[l];
      const drive::Session read = formats::open_session(drive_in(folder), offers[l].choice, progress);
      EXPECT_EQ(read.lidar_name, offers[l].name);
      EXPECT_TRUE(formats::contains(read.lidar_name, drive.session.lidar_name)) << read.lidar_name;
      EXPECT_EQ(read.ins.size() + read.world_from_ins.size(), drive.session.ins.size()) << format;
      ASSERT_EQ(read.scans->size(), drive.session.scans->size());
      EXPECT_EQ(offers[l].scans, read.scans->size());
      EXPECT_EQ(read.scan_timing, format == "native-las" ? drive.session.scan_timing : drive::ScanTiming::PerPoint);
      for (std::size_t i = 0; i < read.scans->size(); ++i) {
        const cloud::PointCloud expected = drive.session.scans->load(i), found = read.scans->load(i);
        // Apollo stamps scans with their last point.
        const double late_s = format == "apollo-record" ? std::ranges::max(expected.time_from_stamp_s) : 0.0;
        EXPECT_EQ(read.scans->stamp_ns(i), drive.session.scans->stamp_ns(i) + std::llround(1e9 * late_s)) << format;
        ASSERT_EQ(found.size(), expected.size()) << format;
        for (std::size_t k = 0; k < found.size(); k += 7)
          ASSERT_LT((found.points[k] - expected.points[k]).norm(), 2e-4f) << format;
      }
    }
  }
}

TEST(simulated_vehicle, the_truth_of_each_lidar_stands_beside_the_drive) {
  const SimulationOptions options = short_drive();
  const SimulatedVehicle vehicle = simulate_vehicle(options, front_and_rear(options));
  const formats::TemporaryFolder folder;
  Progress progress;
  write_vehicle(vehicle, drive_in(folder), "native", 1, progress);
  const formats::DocumentNode root = truth_in(folder);
  const formats::DocumentView view(root, "truth.yaml");
  for (const SimulatedDrive& drive : vehicle.lidars) {
    const formats::DocumentView lidar = view.at("lidars").at(drive.session.lidar_name);
    EXPECT_TRUE(formats::transform_from_document(lidar.at("ins_from_lidar")).isApprox(drive.ins_from_lidar, 1e-12));
    EXPECT_EQ(lidar.has("lidar_errors"), !drive.sensors.lidar.perfect());
  }
  EXPECT_EQ(view.at("lidars").at("rear-2").at("simulation").at("lidar").string(), "at128");
  EXPECT_NEAR(view.at("lidars").at("rear-2").at("simulation").at("scan_phase_s").number(), 0.03, 1e-12);
  EXPECT_FALSE(view.at("lidars").at("front").at("simulation").has("duration_s"));
  EXPECT_TRUE(view.at("simulation").has("duration_s"));
  EXPECT_FALSE(view.at("simulation").has("beams"));
  EXPECT_TRUE(view.has("vehicle_from_ins"));
}

TEST(simulated_vehicle, formats_with_room_for_one_lidar_refuse_several) {
  const SimulationOptions options = short_drive();
  const SimulatedVehicle vehicle = simulate_vehicle(options, front_and_rear(options));
  for (const std::string& format : drive_formats()) {
    const std::vector<std::string>& takers = vehicle_formats();
    if (std::find(takers.begin(), takers.end(), format) != takers.end()) continue;
    const formats::TemporaryFolder folder;
    Progress progress;
    const std::string refusal =
        formats::error_of([&] { write_vehicle(vehicle, drive_in(folder), format, 1, progress); });
    EXPECT_TRUE(formats::contains(refusal, "room for one LiDAR")) << format << ": " << refusal;
    EXPECT_FALSE(std::filesystem::exists(drive_in(folder)));
  }
}

TEST(simulated_vehicle, the_figure_of_eight_undulates) {
  SimulationOptions options = short_drive(ScenarioKind::FigureEight);
  const Scene scene(options);
  double least_m = 0.0, most_m = 0.0, steepest_rad = 0.0;
  for (double time_s = 0.0; time_s < 30.0; time_s += 0.1) {
    const RigidTransform road_from_vehicle = scene.road_from_vehicle(time_s);
    const double z_m = road_from_vehicle.translation().z();
    least_m = std::min(least_m, z_m), most_m = std::max(most_m, z_m);
    steepest_rad = std::max(steepest_rad, std::acos(std::min(1.0, road_from_vehicle.linear()(2, 2))));
  }
  std::printf("heights of %.3f m, tilts of up to %.2f deg\n", most_m - least_m, radians_to_degrees(steepest_rad));
  EXPECT_GT(most_m - least_m, 0.2);
  EXPECT_GT(steepest_rad, degrees_to_radians(1.0));
}

}  // namespace
}  // namespace remount::simulator
