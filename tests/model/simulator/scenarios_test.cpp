// What the scenarios promise: slopes of a hill, a tunnel without features, an excavator that turns and sweeps its arm.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "model/simulator/lidar_model.h"
#include "model/simulator/patterns/spinning_pattern.h"
#include "model/simulator/scenario_world.h"
#include "model/simulator/slew_yard.h"

namespace remount::simulator {
namespace {

using Eigen::Vector3d;

SimulationOptions exact_scenario(ScenarioKind scenario) {
  SimulationOptions options;
  options.scenario = scenario;
  options.beams = 16;
  options.azimuth_steps = 360;
  options.range_noise_m = options.dropout = 0.0;
  options.moving_objects = 0;
  options.motion_distortion = false;
  return options;
}

TEST(scenarios, hill_has_slopes_of_five_degrees_up_and_down_over_two_kilometres) {
  for (int seed = 1; seed <= 5; ++seed) {
    SimulationOptions options = exact_scenario(ScenarioKind::Hill);
    options.seed = seed;
    const Road road(options.scenario, options.speed_mps);
    const Ground ground = scenario_ground(options.scenario, seed);
    double up_deg = 0.0, down_deg = 0.0, climbed_m = 0.0;
    for (double s = 0.0; s < 2000.0; s += 1.0) {
      const RigidTransform here = road_from_vehicle(road, ground, s), next = road_from_vehicle(road, ground, s + 1.0);
      const double slope_deg = radians_to_degrees(std::asin(here.linear()(2, 0)));
      up_deg = std::max(up_deg, slope_deg);
      down_deg = std::min(down_deg, slope_deg);
      climbed_m += std::max(0.0, next.translation().z() - here.translation().z());
    }
    EXPECT_GT(up_deg, 4.5);
    EXPECT_LT(up_deg, 6.5);
    EXPECT_LT(down_deg, -4.5);
    EXPECT_GT(down_deg, -6.5);
    EXPECT_GT(climbed_m, 20.0);
  }
}

TEST(scenarios, highway_is_straight_and_has_something_to_see_all_along) {
  SimulationOptions options = exact_scenario(ScenarioKind::Highway);
  options.speed_mps = 30.0;
  options.duration_s = 60.0;
  const SimulatedScanSource source(std::make_shared<const Scene>(options));
  EXPECT_EQ(Road(options.scenario, 30.0).yaw_rad(777.0), 0.0);
  for (std::size_t scan = 0; scan < source.size(); scan += 50) {
    const cloud::PointCloud cloud = source.load(scan);
    const auto high =
        std::count_if(cloud.points.begin(), cloud.points.end(), [](const auto& p) { return p.z() > -1.0f; });
    EXPECT_GT(high, 30) << "points above the road in scan " << scan;
  }
}

/// Share of the firings that measure another range in the other scan, by more than a centimetre, within 10 m.
double differing_share(const SimulatedScanSource& source, std::size_t a, std::size_t b) {
  const auto by_firing = [&](std::size_t scan) {
    std::map<std::pair<int, long>, double> ranges_m;
    const cloud::PointCloud cloud = source.load(scan);
    for (std::size_t i = 0; i < cloud.size(); ++i)
      if (cloud.points[i].norm() < 10.0f)
        ranges_m[{cloud.ring[i], std::lround(radians_to_degrees(std::atan2(cloud.points[i].y(), cloud.points[i].x())) *
                                             10.0)}] = static_cast<double>(cloud.points[i].norm());
    return ranges_m;
  };
  const auto first = by_firing(a), second = by_firing(b);
  double differing = 0.0;
  for (const auto& [firing, range_m] : first) {
    const auto other = second.find(firing);
    differing += other == second.end() || std::abs(other->second - range_m) > 0.01;
  }
  return differing / static_cast<double>(first.size());
}

TEST(scenarios, tunnel_looks_the_same_everywhere_but_near_its_portals) {
  SimulationOptions options = exact_scenario(ScenarioKind::Tunnel);
  options.speed_mps = 15.0;
  options.duration_s = 80.0;
  options.max_range_m = 40.0;
  const SimulatedScanSource source(std::make_shared<const Scene>(options));
  const TunnelReach reach = tunnel_reach(options);
  EXPECT_EQ(reach.from_m, 60.0);
  EXPECT_EQ(reach.to_m, 1140.0);
  const auto at = [&](double along_m) { return static_cast<std::size_t>(along_m / 1.5); };
  const cloud::PointCloud inside = source.load(at(500.0));
  EXPECT_GT(inside.size(), 16u * 360u * 95u / 100u) << "walls all around";
  // Farther away it shows that the bend changes.
  EXPECT_LT(differing_share(source, at(496.5), at(504.0)), 0.01);
  EXPECT_LT(differing_share(source, at(750.0), at(757.5)), 0.01);
  EXPECT_GT(differing_share(source, at(80.0), at(87.5)), 0.02) << "cabinets near the portal";
  EXPECT_GT(differing_share(source, at(20.0), at(27.5)), 0.2) << "outside";
}

TEST(scenarios, vehicle_touches_nothing_on_hill_highway_and_in_the_tunnel) {
  for (const ScenarioKind kind : {ScenarioKind::Hill, ScenarioKind::Highway, ScenarioKind::Tunnel})
    for (int seed = 1; seed <= 3; ++seed) {
      SimulationOptions options;
      options.scenario = kind;
      options.seed = seed;
      options.speed_mps = 15.0;
      options.duration_s = 40.0;
      const Scene scene(options);
      for (double t = 0.0; t < options.duration_s; t += 0.05) {
        const Vector3d place = scene.road_from_ins(t).translation();
        for (double bearing = 0.0; bearing < 2.0 * kPi; bearing += kPi / 8.0) {
          const Ray ray{place, {std::cos(bearing), std::sin(bearing), 0.0}};
          RayHit hit = scene.world().cast(ray, 5.0);
          for (const Box& box : scene.traffic().boxes_at(t, place.head<2>(), 50.0)) BoxCaster(box).cast(ray, 1e12, hit);
          ASSERT_GT(hit.distance_m, 1.0) << "scenario " << static_cast<int>(kind) << " seed " << seed << " at " << t;
        }
      }
    }
}

TEST(scenarios, excavator_turns_by_its_arc_about_its_axis) {
  for (const double arc_deg : {360.0, 90.0, -180.0}) {
    SimulationOptions options = exact_scenario(ScenarioKind::SlewYard);
    options.slew_yard.arc_deg = arc_deg;
    const Scene scene(options);
    const RigidTransform body_from_lidar = scene.vehicle_from_ins() * options.ins_from_lidar;
    double turned_deg = 0.0;
    for (double t = 0.0; t < options.duration_s; t += 0.05) {
      const RigidTransform a = scene.road_from_vehicle(t), b = scene.road_from_vehicle(t + 0.05);
      turned_deg += radians_to_degrees(so3_log(a.linear().transpose() * b.linear()).z());
      const Vector3d lidar = (a * body_from_lidar).translation();
      ASSERT_NEAR(lidar.head<2>().norm(), body_from_lidar.translation().head<2>().norm(), 1e-12);
      ASSERT_NEAR(lidar.z(), body_from_lidar.translation().z(), 1e-12);
    }
    EXPECT_NEAR(turned_deg, arc_deg, 1e-9);
    EXPECT_GT(body_from_lidar.translation().head<2>().norm(), 1.0) << "the LiDAR is off the axis";
  }
}

TEST(scenarios, excavator_stands_still_in_the_other_recordings) {
  for (const SlewRecording recording : {SlewRecording::Ground, SlewRecording::ArmSweep}) {
    SimulationOptions options = exact_scenario(ScenarioKind::SlewYard);
    options.slew_yard.recording = recording;
    const Scene scene(options);
    EXPECT_TRUE(scene.road_from_vehicle(3.0).isApprox(RigidTransform::Identity(), 1e-15));
    const double moved_m =
        (scene.arm(0.0)[0].world_from_box.translation() - scene.arm(3.0)[0].world_from_box.translation()).norm();
    EXPECT_EQ(moved_m > 1.0, recording == SlewRecording::ArmSweep) << moved_m;
  }
}

TEST(scenarios, arm_sweeps_in_its_plane_and_the_lidar_sees_it) {
  SimulationOptions options = exact_scenario(ScenarioKind::SlewYard);
  options.slew_yard.recording = SlewRecording::ArmSweep;
  options.beams = 64;
  const SimulatedScanSource source(std::make_shared<const Scene>(options));
  const RigidTransform body_from_lidar = source.scene().vehicle_from_ins() * options.ins_from_lidar;
  std::size_t on_side = 0;
  for (std::size_t scan = 0; scan < source.size(); scan += 10) {
    for (const auto& point : source.load(scan).points) {
      const Vector3d p = body_from_lidar * point.cast<double>();
      if (p.z() < 0.5 || p.x() < 0.5 || p.head<2>().norm() > 9.5) continue;
      ASSERT_LT(std::abs(p.y()), 0.23) << "nothing else is within reach: " << p.transpose();
      on_side += p.y() < -0.17;
    }
  }
  EXPECT_GT(on_side, 2000u) << "points on the side of the arm";
  options.slew_yard.arm = false;
  EXPECT_TRUE(Scene(options).arm(1.0).empty());
}

TEST(scenarios, yard_slopes_with_the_machine_or_without_it) {
  SimulationOptions options = exact_scenario(ScenarioKind::SlewYard);
  options.slew_yard.slope_deg = 2.0;
  const Scene sloped(options);
  const auto axis_from_up_deg = [](const RigidTransform& frame) {
    return radians_to_degrees(std::acos(frame.linear()(2, 2)));
  };
  EXPECT_NEAR(axis_from_up_deg(sloped.enu_from_road() * sloped.road_from_vehicle(2.0)), 2.0, 1e-9);
  EXPECT_NEAR(axis_from_up_deg(sloped.road_from_vehicle(2.0)), 0.0, 1e-6) << "square on its ground";
  options.slew_yard = {};
  options.slew_yard.uneven_deg = 3.0;
  const Scene uneven(options);
  EXPECT_NEAR(axis_from_up_deg(uneven.enu_from_road()), 0.0, 1e-9);
  EXPECT_NEAR(axis_from_up_deg(uneven.road_from_vehicle(2.0)), 3.0, 1e-9);
}

TEST(scenarios, tilted_boxes_are_hit_where_upright_ones_are) {
  const Box upright{{4.0, 1.0}, 0.3, {1.0, 0.5}, 0.2, 1.4, 0.5f};
  const TiltedBox same{
      make_rigid(rotation_from_yaw_pitch_roll({0.3, 0.0, 0.0}), {4.0, 1.0, 0.8}), {1.0, 0.5, 0.6}, 0.5f};
  int hits = 0;
  for (double bearing = -1.0; bearing < 1.0; bearing += 0.013)
    for (double rise = -0.3; rise < 0.3; rise += 0.017) {
      const Ray ray{{0.0, 0.0, 1.0}, Vector3d(std::cos(bearing), std::sin(bearing), rise).normalized()};
      RayHit a, b;
      BoxCaster(upright).cast(ray, 1.0 / ray.direction.z(), a);
      cast_tilted_box(same, ray, b);
      ASSERT_EQ(a.found(), b.found());
      if (!a.found()) continue;
      ASSERT_NEAR(a.distance_m, b.distance_m, 1e-9);
      ++hits;
    }
  EXPECT_GT(hits, 100);
}

TEST(scenarios, lidar_models_have_their_beams_evenly_within_their_field_of_view) {
  const std::vector<std::array<double, 3>> models{{16, -15, 15}, {32, -30, 10}, {64, -24.8, 2}, {128, -25, 15}};
  for (const auto& [beams, low_deg, high_deg] : models) {
    const std::vector<double> elevations = beam_elevations_rad(static_cast<int>(beams));
    ASSERT_EQ(elevations.size(), static_cast<std::size_t>(beams));
    EXPECT_NEAR(radians_to_degrees(elevations.front()), low_deg, 1e-9);
    EXPECT_NEAR(radians_to_degrees(elevations.back()), high_deg, 1e-9);
    for (std::size_t i = 1; i < elevations.size(); ++i)
      EXPECT_NEAR(elevations[i] - elevations[i - 1], elevations[1] - elevations[0], 1e-12);
    SimulationOptions options = exact_scenario(ScenarioKind::Street);
    options.beams = static_cast<int>(beams);
    const cloud::PointCloud cloud = SimulatedScanSource(std::make_shared<const Scene>(options)).load(0);
    for (std::size_t i = 0; i < cloud.size(); ++i)
      ASSERT_NEAR(std::asin(cloud.points[i].z() / cloud.points[i].norm()), elevations[cloud.ring[i]], 1e-5);
  }
}

}  // namespace
}  // namespace remount::simulator
