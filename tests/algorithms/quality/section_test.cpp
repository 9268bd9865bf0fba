#include "algorithms/quality/section.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace remount::quality {
namespace {

constexpr double kWallNoise_m = 0.01, kWall_m = 6.0, kGround_m = -1.8;

/// A street in level axes: two walls along x, the ground between them, and a pole; seen from its middle.
std::vector<Eigen::Vector3f> street(unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0.0, kWallNoise_m);
  std::uniform_real_distribution<double> along(-20.0, 20.0), up(kGround_m, 3.0), side(-kWall_m, kWall_m),
      turn(0, 6.283);
  std::vector<Eigen::Vector3f> points;
  const auto add = [&](double x, double y, double z) { points.push_back(Eigen::Vector3d(x, y, z).cast<float>()); };
  for (int i = 0; i < 20000; ++i) {
    add(along(random), kWall_m + noise(random), up(random));
    add(along(random), -kWall_m + noise(random), up(random));
    add(along(random), side(random), kGround_m + noise(random));
  }
  for (int i = 0; i < 600; ++i) {
    const double angle = turn(random);
    add(5.0 + 0.06 * std::cos(angle), 2.0 + 0.06 * std::sin(angle), up(random));
  }
  return points;
}

class sections : public ::testing::Test {
 protected:
  /// Scan a lies so far off: a metres along the axes of the street.
  SectionScans scans(const Eigen::Vector3d& off_m) const {
    RigidTransform moved = RigidTransform::Identity();
    moved.translation() = off_m;
    return {a_, b_, moved};
  }
  Section best(SectionKind kind, const Eigen::Vector3d& off_m) const {
    const std::vector<Section> found = find_sections(scans(off_m), kind, Eigen::Vector3d::UnitZ(), 5);
    EXPECT_FALSE(found.empty());
    return found.empty() ? Section{} : found.front();
  }
  std::vector<Eigen::Vector3f> a_ = street(1), b_ = street(2);
};

TEST_F(sections, walls_are_as_thick_as_the_noise_and_as_far_apart_as_the_scans) {
  const Section wall = best(SectionKind::Wall, {0.0, 0.05, 0.0});
  EXPECT_NEAR(std::abs(wall.centre_in_lidar_b.y()), kWall_m, 0.02);
  EXPECT_NEAR(std::abs(wall.normal().y()), 1.0, 1e-3);
  EXPECT_NEAR(std::abs(wall.along().x()), 1.0, 1e-3);
  EXPECT_LT(wall.normal().dot(wall.centre_in_lidar_b), 0.0) << "the normal looks to the sensor";
  const SectionCut cut = cut_section(scans({0.0, 0.05, 0.0}), wall);
  ASSERT_TRUE(cut.measured);
  EXPECT_NEAR(cut.thickness_a_m, kWallNoise_m, 0.001);
  EXPECT_NEAR(cut.thickness_b_m, kWallNoise_m, 0.001);
  // To the left is away from the sensor at the left wall, and towards it at the right one.
  EXPECT_NEAR(cut.offset_m, wall.centre_in_lidar_b.y() > 0.0 ? -0.05 : 0.05, 0.002);
  EXPECT_GT(cut.thickness_together_m, 2.0 * kWallNoise_m);
  const SectionCut aligned = cut_section(scans(Eigen::Vector3d::Zero()), wall);
  EXPECT_NEAR(aligned.offset_m, 0.0, 0.001);
  EXPECT_NEAR(aligned.thickness_together_m, kWallNoise_m, 0.001);
}

TEST_F(sections, ground_and_poles_are_found) {
  const Section ground = best(SectionKind::Ground, {0.0, 0.0, 0.03});
  EXPECT_NEAR(ground.centre_in_lidar_b.z(), kGround_m, 0.02);
  EXPECT_NEAR(cut_section(scans({0.0, 0.0, 0.03}), ground).offset_m, 0.03, 0.002);
  const Section pole = best(SectionKind::Pole, {0.04, 0.0, 0.0});
  EXPECT_NEAR(pole.centre_in_lidar_b.x(), 5.0, 0.05);
  EXPECT_NEAR(pole.centre_in_lidar_b.y(), 2.0, 0.05);
  EXPECT_NEAR(cut_section(scans({0.04, 0.0, 0.0}), pole).offset_m, 0.04, 0.01);
}

TEST_F(sections, are_found_where_the_sensor_is_turned_over) {
  RigidTransform turned = RigidTransform::Identity();
  turned.linear() =
      (Eigen::AngleAxisd(1.2, Eigen::Vector3d::UnitX()) * Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitY()))
          .toRotationMatrix();
  std::vector<Eigen::Vector3f> a, b;
  for (const Eigen::Vector3f& point : a_) a.push_back((turned * point.cast<double>()).cast<float>());
  for (const Eigen::Vector3f& point : b_) b.push_back((turned * point.cast<double>()).cast<float>());
  const Eigen::Vector3d up = turned.linear().col(2);
  const SectionScans scans{a, b, RigidTransform::Identity()};
  const std::vector<Section> walls = find_sections(scans, SectionKind::Wall, up, 5);
  ASSERT_FALSE(walls.empty());
  EXPECT_NEAR(std::abs(walls.front().normal().dot(turned.linear().col(1))), 1.0, 1e-3);
  EXPECT_NEAR(cut_section(scans, walls.front()).thickness_together_m, kWallNoise_m, 0.001);
}

TEST_F(sections, a_chosen_point_gives_the_surface_there) {
  const Section wall = section_at(scans(Eigen::Vector3d::Zero()), SectionKind::Wall, {3.0, kWall_m + 0.1, 0.5},
                                  Eigen::Vector3d::UnitZ());
  EXPECT_NEAR(std::abs(wall.normal().y()), 1.0, 1e-2);
  EXPECT_NEAR(wall.centre_in_lidar_b.y(), kWall_m, 0.02) << "it lies in the surface, not where was clicked";
  const Section nothing =
      section_at(scans(Eigen::Vector3d::Zero()), SectionKind::Wall, {0.0, 0.0, 2.0}, Eigen::Vector3d::UnitZ());
  EXPECT_TRUE(nothing.centre_in_lidar_b.isApprox(Eigen::Vector3d(0.0, 0.0, 2.0)));
  EXPECT_FALSE(cut_section(scans(Eigen::Vector3d::Zero()), nothing).measured) << "the air has no thickness";
}

TEST(no_sections, of_scans_that_hold_nothing) {
  const std::vector<Eigen::Vector3f> none, bad(100, Eigen::Vector3f::Constant(std::nanf("")));
  for (const auto* points : {&none, &bad})
    for (const SectionKind kind : {SectionKind::Wall, SectionKind::Ground, SectionKind::Pole}) {
      const SectionScans scans{*points, *points, RigidTransform::Identity()};
      EXPECT_TRUE(find_sections(scans, kind, Eigen::Vector3d::UnitZ(), 5).empty());
      EXPECT_FALSE(cut_section(scans, Section{}).measured);
    }
}

}  // namespace
}  // namespace remount::quality
