// Poses of national grids, and of an INS that is turned in its vehicle: within their sigma.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>

#include "algorithms/messages/render.h"
#include "model/conventions/pose_north.h"
#include "tests/model/conventions/north_drives.h"
#include "tests/support/calibration_checks.h"
#include "tests/support/sanitized.h"

namespace remount::conventions {
namespace {

using namespace north;

constexpr NationalGrid kSwiss{"LV03", 7.4396, 46.9524, 1.0, 6e5, 2e5},
    kBritish{"OSGB", -2.0, 49.0, 0.9996013, 4e5, -1e5}, kDutch{"RD", 5.3876, 52.1562, 0.9999079, 155e3, 463e3},
    kFrench{"Lambert 93", 3.0, 46.5, 0.99905, 7e5, 6.6e6}, kPolish{"PL-1992", 19.0, 52.0, 0.9993, 5e5, 461e3},
    // Numbers below zero, as those of Krovak's grid are, which is no transverse Mercator.
    kCzech{"negative", 19.0, 49.5, 0.9999, -4e5, -1.1e6};

struct PlaceOnGrid {
  const NationalGrid& grid;
  Site place;
};
const PlaceOnGrid kPlacesOnGrids[] = {
    {kSwiss, {"Bern", 46.95, 7.45}},      {kSwiss, {"Zurich", 47.4, 8.55}},    {kSwiss, {"Chur", 46.85, 9.53}},
    {kSwiss, {"Geneva", 46.2, 6.15}},     {kBritish, {"London", 51.5, -0.1}},  {kBritish, {"Truro", 50.3, -5.05}},
    {kBritish, {"Glasgow", 55.9, -4.25}}, {kDutch, {"Groningen", 53.2, 6.57}}, {kFrench, {"Lyon", 45.75, 4.85}},
    {kFrench, {"Nice", 43.7, 7.27}},      {kPolish, {"Rzeszow", 50.0, 22.0}},  {kCzech, {"Prague", 50.09, 14.42}},
    {kCzech, {"Kosice", 48.72, 21.26}}};

/// The yaw by which attitudes are off, against the same poses with attitudes to the grid.
double off_deg(const drive::Session& session, const Poses& exact) {
  const std::size_t at = exact.world_from_ins.size() / 2;
  const Eigen::Matrix3d off =
      session.world_from_ins[at].pose.linear() * exact.world_from_ins[at].pose.linear().transpose();
  return radians_to_degrees(yaw_pitch_roll_from_rotation(off).yaw_rad);
}

double driven_m(const std::vector<motion::StampedPose>& poses) {
  return (poses[poses.size() / 3].pose.translation() - poses.front().pose.translation()).norm();
}

TEST(pose_north_grids, of_a_nation_are_left_as_they_are_and_within_sigma) {
  double worst = 0.0;
  for (const auto& [grid, place] : kPlacesOnGrids) {
    const simulator::SimulatedDrive drive = drive_at(place, 31);
    for (const AttitudesTo north : {AttitudesTo::True, AttitudesTo::Grid})
      for (const bool fixes : {false, true}) {
        SCOPED_TRACE(std::string(place.name) + (north == AttitudesTo::True ? ", true" : ", grid") +
                     (fixes ? ", fixes" : ""));
        const Poses poses = grid_poses(grid, drive, north, Origin::Utm),
                    exact = grid_poses(grid, drive, AttitudesTo::Grid, Origin::Utm);
        drive::Session session = session_of(drive, poses, fixes);
        settle_north(session);
        const double off = off_deg(session, exact), sigma_deg = radians_to_degrees(session.ins_north_sigma_rad);
        std::printf("%s, %s: convergence %+.2f, attitudes to %s, %s: off by %+.3f deg, sigma %.3f\n", grid.name,
                    place.name, radians_to_degrees(poses.convergence_rad),
                    north == AttitudesTo::True ? "true north" : "the grid", fixes ? "fixes" : "no fixes", off,
                    sigma_deg);
        EXPECT_LT(std::abs(off), 0.05 + 3.5 * sigma_deg);
        EXPECT_FALSE(tells(session, "utm-grid-north"));
        EXPECT_LT(std::abs(driven_m(session.world_from_ins) / driven_m(poses.world_from_ins) - 1.0), 1e-9);
        EXPECT_TRUE(std::abs(off) < 0.1 || tells(session, "north-unknown"));
        if (sigma_deg > 0.0) worst = std::max(worst, std::abs(off) / sigma_deg);
      }
  }
  std::printf("worst %.2f sigma\n", worst);
}

TEST(pose_north_grids, of_utm_with_a_turned_ins_are_within_sigma) {
  double worst = 0.0;
  for (const Site& place : {Site{"Munich", 48.1, 11.6}, Site{"Oslo", 59.9, 10.7}, Site{"Sydney", -33.9, 151.2},
                            Site{"Tokyo", 35.7, 139.7}, Site{"Santiago", -33.4, -70.6}, Site{"Dubai", 25.2, 55.3}}) {
    const simulator::SimulatedDrive drive = drive_at(place, 17);
    const double convergence_rad = utm_poses(drive, AttitudesTo::Grid, Origin::Utm).convergence_rad;
    for (const double share : {1.0, 0.9, -1.0, 0.4})
      for (const AttitudesTo north : {AttitudesTo::True, AttitudesTo::Grid})
        for (const bool fixes : {false, true})
          for (const Origin origin : {Origin::Utm, Origin::Start}) {
            if (origin == Origin::Start && !fixes) continue;  // the place is not known
            const double turned_rad = -share * convergence_rad;
            drive::Session session = session_of(drive, utm_poses(drive, north, origin, turned_rad), fixes);
            settle_north(session);
            const double off = off_deg(session, utm_poses(drive, AttitudesTo::Grid, origin, turned_rad)),
                         sigma_deg = radians_to_degrees(session.ins_north_sigma_rad);
            EXPECT_LT(std::abs(off), 0.02 + 3.5 * sigma_deg)
                << place.name << ": convergence " << radians_to_degrees(convergence_rad) << ", turned by "
                << radians_to_degrees(turned_rad) << (north == AttitudesTo::True ? ", true" : ", grid")
                << (fixes ? ", fixes" : "") << ", sigma " << sigma_deg;
            EXPECT_LT(sigma_deg, 0.4 + std::abs(radians_to_degrees(convergence_rad)));
            if (sigma_deg > 0.02) worst = std::max(worst, std::abs(off) / sigma_deg);
          }
  }
  std::printf("worst %.2f sigma\n", worst);
}

/// Places, setups and seeds at random: most INS in line with their vehicle to some tenths of a degree, one in ten not.
TEST(pose_north_grids, of_any_place_are_within_sigma_with_any_setup) {
  const NationalGrid grids[] = {kSwiss, kBritish, kDutch, kFrench, kPolish};
  std::mt19937 random(7);
  const auto between = [&](double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(random);
  };
  std::normal_distribution<double> normal;
  for (const bool utm : {true, false})
    for (const bool fixes : {false, true}) {
      constexpr int kDrives = testing::kSanitized ? 3 : 30;
      double worst = 0.0, square = 0.0, sum_deg = 0.0;
      for (int i = 0; i < kDrives; ++i) {
        const NationalGrid& grid = grids[i % 5];
        const double origin_deg = grid.origin_deg + (grid.northing_m < 0.0 ? 2.5 : 0.0);  // no northing is negative
        const Site place = utm ? Site{"", between(-60.0, 65.0), between(-170.0, 170.0)}
                               : Site{"", origin_deg + between(0.0, 1.0), grid.middle_deg + between(-2.0, 2.0)};
        const simulator::SimulatedDrive drive =
            drive_at(place, 1000 + i, i % 2 ? simulator::ScenarioKind::Hill : simulator::ScenarioKind::FigureEight);
        const double turned_rad = degrees_to_radians((between(0.0, 1.0) < 0.1 ? 1.5 : 0.4) * normal(random));
        const AttitudesTo north = between(0.0, 1.0) < 0.5 ? AttitudesTo::True : AttitudesTo::Grid;
        const auto poses_to = [&](AttitudesTo to) {
          return utm ? utm_poses(drive, to, Origin::Utm, turned_rad)
                     : grid_poses(grid, drive, to, Origin::Utm, turned_rad);
        };
        drive::Session session = session_of(drive, poses_to(north), fixes);
        settle_north(session);
        const double off = std::abs(off_deg(session, poses_to(AttitudesTo::Grid))),
                     sigma_deg = std::hypot(radians_to_degrees(session.ins_north_sigma_rad), 0.02);
        EXPECT_LT(off, 3.5 * sigma_deg) << place.latitude_deg << ", " << place.longitude_deg << ", turned by "
                                        << radians_to_degrees(turned_rad);
        worst = std::max(worst, off / sigma_deg);
        square += std::pow(off / sigma_deg, 2);
        sum_deg += sigma_deg;
      }
      std::printf("%s, %s: %d drives, root mean square %.2f sigma, worst %.2f, sigma %.2f deg in the mean\n",
                  utm ? "UTM" : "national grids", fixes ? "fixes" : "no fixes", kDrives, std::sqrt(square / kDrives),
                  worst, sum_deg / kDrives);
      EXPECT_LT(std::sqrt(square / kDrives), 1.4);
    }
}

/// Other seeds, places and roads than anywhere else, to the end of a calibration.
TEST(pose_north_grids, give_x_whose_yaw_is_within_its_sigma) {
  struct Drive {
    Site place;
    const NationalGrid* grid;  ///< none: UTM
    AttitudesTo north;
    double turned_deg;
    bool fixes;
  };
  const Drive drives[] = {{{"Zurich", 47.38, 8.5}, &kSwiss, AttitudesTo::True, 0.0, false},
                          {{"Lugano", 46.0, 8.95}, &kSwiss, AttitudesTo::True, 0.0, true},
                          {{"Basel", 47.55, 7.6}, &kSwiss, AttitudesTo::Grid, 0.4, false},
                          {{"Leeds", 53.8, -1.55}, &kBritish, AttitudesTo::True, 0.0, false},
                          {{"Exeter", 50.7, -3.5}, &kBritish, AttitudesTo::Grid, 0.0, false},
                          {{"Norwich", 52.6, 1.3}, &kBritish, AttitudesTo::True, 0.3, true},
                          {{"Arnhem", 52.0, 5.9}, &kDutch, AttitudesTo::True, -0.3, false},
                          {{"Grenoble", 45.2, 5.7}, &kFrench, AttitudesTo::True, 0.0, false},
                          {{"Lublin", 51.25, 22.6}, &kPolish, AttitudesTo::True, 0.0, false},
                          {{"Vienna", 48.2, 16.4}, nullptr, AttitudesTo::Grid, -1.05, false},
                          {{"Berlin", 52.5, 13.4}, nullptr, AttitudesTo::Grid, 1.2, true},
                          {{"Perth", -31.95, 115.9}, nullptr, AttitudesTo::True, 0.0, false},
                          {{"Denver", 39.7, -104.9}, nullptr, AttitudesTo::True, 0.5, true},
                          {{"Quito", -0.2, -78.5}, nullptr, AttitudesTo::True, 0.2, false}};
  int seed = 101, observed = 0;
  double worst = 0.0, square = 0.0;
  for (const Drive& one : drives) {
    if (testing::kSanitized && seed > 102) break;
    const simulator::SimulatedDrive drive =
        drive_at(one.place, seed, seed % 2 == 0 ? simulator::ScenarioKind::Hill : simulator::ScenarioKind::FigureEight);
    ++seed;
    const double turned_rad = degrees_to_radians(one.turned_deg);
    drive::Session session = session_of(drive,
                                        one.grid ? grid_poses(*one.grid, drive, one.north, Origin::Utm, turned_rad)
                                                 : utm_poses(drive, one.north, Origin::Utm, turned_rad),
                                        one.fixes);
    settle_north(session);
    const double north_sigma_rad = session.ins_north_sigma_rad;
    const RigidTransform turned_from_lidar =
        make_rigid(rotation_from_yaw_pitch_roll({-turned_rad, 0.0, 0.0}), Eigen::Vector3d::Zero()) *
        drive.ins_from_lidar;
    const calibration::CalibrationResult result = solved(session);
    const double error_deg = yaw_error_deg(result, turned_from_lidar), sigma_deg = yaw_sigma_deg(result);
    std::printf("%s, %s: yaw off by %+.3f deg, sigma %.3f\n", one.grid ? one.grid->name : "UTM", one.place.name,
                error_deg, sigma_deg);
    EXPECT_TRUE(calibration::is_usable(result)) << one.place.name << english(result.message);
    // What is uncertain by more than a degree counts as not observed.
    if (!result.known[calibration::kParameters[kYawOf]].observed) {
      EXPECT_LT(std::abs(error_deg), 3.5 * radians_to_degrees(north_sigma_rad)) << one.place.name;
      continue;
    }
    ++observed;
    EXPECT_LT(std::abs(error_deg), 3.5 * sigma_deg) << one.place.name;
    worst = std::max(worst, std::abs(error_deg) / sigma_deg);
    square += std::pow(error_deg / sigma_deg, 2);
  }
  std::printf("%d drives, yaw of %d observed: worst %.2f sigma, root mean square %.2f\n", seed - 101, observed, worst,
              std::sqrt(square / observed));
  EXPECT_GE(observed, testing::kSanitized ? 1 : 10);
}

}  // namespace
}  // namespace remount::conventions
