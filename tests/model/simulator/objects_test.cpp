// Objects on simulated streets, where it is known what everything is. They lie here because the simulator is of this
// layer.
#include "algorithms/cloud/objects.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "algorithms/cloud/deskew.h"
#include "model/simulator/lidar_model.h"
#include "model/simulator/random_stream.h"
#include "model/simulator/simulator.h"

namespace remount::simulator {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

/// A drive with its scene, and scans compensated by the true motion.
class objects_on_a_street : public ::testing::Test {
 protected:
  void start(const SimulationOptions& options) {
    drive = simulate_drive(options);
    source = dynamic_cast<const SimulatedScanSource*>(drive.session.scans.get());
  }
  const Scene& scene() const { return source->scene(); }
  RigidTransform road_from_lidar(double time_s) const { return scene().road_from_ins(time_s) * drive.ins_from_lidar; }
  double time_s(std::size_t scan) const { return scan_time_s(scene().options(), scan); }
  cloud::PointCloud compensated(std::size_t scan) const {
    const cloud::PointCloud cloud = source->load(scan);
    const RigidTransform lidar_from_road = road_from_lidar(time_s(scan)).inverse();
    return cloud::deskew(cloud, cloud.time_from_stamp_s,
                         [&](double t) { return lidar_from_road * road_from_lidar(time_s(scan) + t); });
  }
  Vector3f up(std::size_t scan) const {
    return (road_from_lidar(time_s(scan)).linear().transpose() * Vector3d::UnitZ()).cast<float>();
  }
  Vector3d in_road(std::size_t scan, const Vector3f& p) const {
    return road_from_lidar(time_s(scan)) * p.cast<double>();
  }
  RigidTransform b_from_a(std::size_t a, std::size_t b) const {
    return road_from_lidar(time_s(b)).inverse() * road_from_lidar(time_s(a));
  }
  /// The moving car that an object is part of.
  bool on_moving_car(std::size_t scan, const cloud::SceneObject& object) const {
    const Vector3d p = in_road(scan, object.centroid_in_lidar);
    for (const Eigen::Vector2d& car : scene().traffic().centres_at(time_s(scan)))
      if ((car - p.head<2>()).norm() < 2.3) return true;
    return false;
  }
  /// The upright cylinder that an object is, or -1.
  int cylinder(std::size_t scan, const cloud::SceneObject& object) const {
    const Vector3d p = in_road(scan, object.centroid_in_lidar);
    const auto& all = scene().world().cylinders();
    for (std::size_t i = 0; i < all.size(); ++i)
      if ((all[i].centre - p.head<2>()).norm() < 0.4) return static_cast<int>(i);
    return -1;
  }

  SimulatedDrive drive;
  const SimulatedScanSource* source = nullptr;
  cloud::ObjectOptions objects;
};

TEST_F(objects_on_a_street, ground_is_told_from_objects_on_slopes) {
  for (const ScenarioKind kind : {ScenarioKind::Street, ScenarioKind::ParkingRamp}) {
    SimulationOptions options;
    options.scenario = kind;
    start(options);
    int ground = 0, ground_found = 0, upright = 0, upright_found = 0;
    for (std::size_t scan = 0; scan < source->size(); scan += 17) {
      const cloud::PointCloud cloud = compensated(scan);
      const std::vector<bool> mask = cloud::ground_mask(cloud, up(scan), objects);
      for (std::size_t i = 0; i < cloud.size(); ++i) {
        if (cloud.points[i].norm() > 40.0f) continue;
        const Vector3d p = in_road(scan, cloud.points[i]);
        const double height_m = p.z() - scene().world().ground().surface_height_m(p.x(), p.y());
        ground += height_m < 0.1;
        ground_found += height_m < 0.1 && mask[i];
        upright += height_m > 0.6;
        upright_found += height_m > 0.6 && !mask[i];
      }
    }
    EXPECT_GT(ground_found, 0.97 * ground) << "scenario " << static_cast<int>(kind) << ": ground taken for objects";
    EXPECT_GT(upright_found, 0.97 * upright) << "scenario " << static_cast<int>(kind) << ": objects taken for ground";
  }
}

TEST_F(objects_on_a_street, moving_cars_are_flagged_and_standing_objects_are_not) {
  int cars = 0, cars_flagged = 0, standing = 0, standing_flagged = 0;
  for (int seed = 1; seed <= 3; ++seed) {
    SimulationOptions options;
    options.seed = seed;
    options.moving_objects = 6;
    start(options);
    for (std::size_t a = 5; a + 3 < source->size(); a += 8) {
      const std::size_t b = a + 3;
      const auto objects_a = cloud::find_objects(compensated(a), up(a), objects),
                 objects_b = cloud::find_objects(compensated(b), up(b), objects);
      for (const cloud::ObjectMatch& match : cloud::match_objects(objects_a, objects_b, b_from_a(a, b), objects)) {
        const cloud::SceneObject& from = objects_a[match.object_a];
        const cloud::SceneObject& to = objects_b[match.object_b];
        if (on_moving_car(a, from) != on_moving_car(b, to)) continue;
        const bool car = on_moving_car(a, from) && from.shape == cloud::ObjectShape::VehicleSized;
        // A car that happens to stand still against the road for a moment counts for neither.
        const double truly_m = (in_road(b, to.centroid_in_lidar) - in_road(a, from.centroid_in_lidar)).norm();
        if (on_moving_car(a, from) && (!car || truly_m < 1.0)) continue;
        (car ? cars : standing) += 1;
        (car ? cars_flagged : standing_flagged) += match.moving;
      }
    }
  }
  RecordProperty("moving", std::to_string(cars_flagged) + " of " + std::to_string(cars));
  RecordProperty("standing", std::to_string(standing_flagged) + " of " + std::to_string(standing));
  EXPECT_GE(cars, 20);
  EXPECT_GE(cars_flagged, 0.8 * cars) << cars_flagged << " of " << cars << " moving cars flagged";
  EXPECT_GE(standing, 500);
  EXPECT_LE(standing_flagged, 0.02 * standing) << standing_flagged << " of " << standing << " standing objects flagged";
}

TEST_F(objects_on_a_street, poles_are_found_again_in_the_other_scan) {
  start({});
  int seen = 0, matched = 0, wrong = 0;
  for (std::size_t a = 0; a + 5 < source->size(); a += 10) {
    const std::size_t b = a + 5;
    const auto objects_a = cloud::find_objects(compensated(a), up(a), objects),
               objects_b = cloud::find_objects(compensated(b), up(b), objects);
    const auto matches = cloud::match_objects(objects_a, objects_b, b_from_a(a, b), objects);
    for (std::size_t i = 0; i < objects_a.size(); ++i) {
      const int pole = cylinder(a, objects_a[i]);
      if (pole < 0 || objects_a[i].shape != cloud::ObjectShape::Pole) continue;
      const bool in_b = std::any_of(objects_b.begin(), objects_b.end(),
                                    [&](const cloud::SceneObject& o) { return cylinder(b, o) == pole; });
      if (!in_b) continue;
      ++seen;
      for (const cloud::ObjectMatch& match : matches) {
        if (match.object_a != i) continue;
        const bool same = cylinder(b, objects_b[match.object_b]) == pole;
        (same ? matched : wrong) += 1;
      }
    }
  }
  RecordProperty("poles", std::to_string(matched) + " of " + std::to_string(seen) + ", wrong " + std::to_string(wrong));
  EXPECT_GE(seen, 50);
  EXPECT_GE(matched, 0.8 * seen) << matched << " of " << seen << " poles";
  EXPECT_LE(wrong, 0.02 * seen);
}

TEST_F(objects_on_a_street, common_error_of_the_prediction_does_not_make_objects_move) {
  SimulationOptions options;
  options.moving_objects = 0;
  start(options);
  const std::size_t a = 40, b = 44;
  const auto objects_a = cloud::find_objects(compensated(a), up(a), objects),
             objects_b = cloud::find_objects(compensated(b), up(b), objects);
  RigidTransform off = b_from_a(a, b);
  off.translation() += Vector3d(0.7, -0.5, 0.0);
  const auto matches = cloud::match_objects(objects_a, objects_b, off, objects);
  EXPECT_GE(matches.size(), 10u);
  const auto moving =
      std::count_if(matches.begin(), matches.end(), [](const cloud::ObjectMatch& m) { return m.moving; });
  EXPECT_LE(static_cast<double>(moving), 0.05 * static_cast<double>(matches.size()))
      << moving << " of " << matches.size();
}

TEST_F(objects_on_a_street, up_is_found_for_a_sensor_mounted_in_any_orientation) {
  RandomStream random(1, 0);
  double worst_deg = 0.0;
  for (int trial = 0; trial < 12; ++trial) {
    SimulationOptions options;
    options.scenario = static_cast<ScenarioKind>(trial % 5);
    options.beams = trial % 2 == 0 ? 64 : 32;
    options.seed = trial;
    start(options);
    const std::size_t scan = static_cast<std::size_t>(7 * trial);
    cloud::PointCloud cloud = compensated(scan);
    const Eigen::Matrix3f turn =
        Eigen::Quaternionf(Eigen::Quaterniond(so3_exp(2.0 * random.normal3())).cast<float>()).toRotationMatrix();
    for (Vector3f& p : cloud.points) p = turn * p;
    const Vector3f found = cloud::estimate_up(cloud, Vector3f::Zero());
    // Of the vehicle: the ground near it is as level as it stands.
    const Vector3f expected = turn * (drive.ins_from_lidar.linear().transpose() * Vector3d::UnitZ()).cast<float>();
    const double off_deg = radians_to_degrees(std::acos(std::min(1.0f, found.dot(expected))));
    EXPECT_LT(off_deg, 6.0) << "scenario " << trial % 5 << ", " << options.beams << " beams";
    worst_deg = std::max(worst_deg, off_deg);
  }
  RecordProperty("worst, deg", std::to_string(worst_deg));
}

TEST(objects, up_falls_back_to_the_hint_where_there_is_no_ground) {
  const Vector3f hint = Vector3f(0.0f, 1.0f, 1.0f).normalized();
  EXPECT_EQ(cloud::estimate_up({}, hint), hint);
  EXPECT_EQ(cloud::estimate_up({}, Vector3f::Zero()), Vector3f(0.0f, 0.0f, 1.0f));
}

TEST(objects, an_empty_scan_has_none) {
  EXPECT_TRUE(cloud::find_objects({}, Vector3f::UnitZ(), {}).empty());
  EXPECT_TRUE(cloud::match_objects({}, {}, RigidTransform::Identity(), {}).empty());
}

TEST(objects, too_large_clusters_are_cut_and_keep_all_points) {
  cloud::PointCloud wall;
  for (int x = 0; x < 300; ++x)
    for (int z = 0; z < 20; ++z)
      wall.points.push_back({0.1f * static_cast<float>(x) - 15.0f, 8.0f, 0.1f * static_cast<float>(z)});
  for (int x = -40; x < 40; ++x)
    for (int y = -40; y < 40; ++y)
      wall.points.push_back({0.5f * static_cast<float>(x), 0.5f * static_cast<float>(y), -1.5f});
  cloud::ObjectOptions options;
  ASSERT_EQ(cloud::find_objects(wall, Vector3f::UnitZ(), options).size(), 1u);
  EXPECT_EQ(cloud::find_objects(wall, Vector3f::UnitZ(), options)[0].shape, cloud::ObjectShape::Facade);
  options.max_points = 2000;
  const auto pieces = cloud::find_objects(wall, Vector3f::UnitZ(), options);
  EXPECT_GE(pieces.size(), 5u);
  std::size_t points = 0;
  for (const cloud::SceneObject& piece : pieces) {
    points += piece.points.size();
    EXPECT_TRUE(std::is_sorted(piece.points.begin(), piece.points.end()));
  }
  EXPECT_EQ(points, 6000u);
}

}  // namespace
}  // namespace remount::simulator
