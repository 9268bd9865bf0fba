// Whether the multi-sensor odometry knows how far off it is: errors of many drives against the covariance that it
// states, of the end and of motions over one, ten and a hundred scans.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <map>

#include "tests/algorithms/odometry/synthetic_drive.h"
#include "tests/algorithms/support/size_of_error.h"

namespace remount::odometry {
namespace {

using synthetic::Drive;
using synthetic::Noise;

/// Sums over drives; means are per degree of freedom.
struct Normalised {
  double sum = 0.0;
  int count = 0;
  Vector6d each = Vector6d::Zero();
  Vector6d sigma = Vector6d::Zero();
  void add(const Vector6d& error, const Matrix6d& covariance) {
    sum += testing::squared_over_sigma(error, covariance);
    each += error.cwiseAbs2().cwiseQuotient(covariance.diagonal());
    sigma += covariance.diagonal();
    ++count;
  }
  double mean() const { return sum / (6.0 * count); }
};

/// By numbers of scans; 0: the end.
using Judgement = std::map<int, Normalised>;

/// Error of the motion since a scan, in axes of the odometry.
Vector6d motion_error(const RigidTransform& from, const RigidTransform& to, const RigidTransform& true_from,
                      const RigidTransform& true_to) {
  const RigidTransform found = from.inverse() * to, truth = true_from.inverse() * true_to;
  Vector6d error;
  error << from.linear() * (found.translation() - truth.translation()),
      from.linear() * so3_log(found.linear() * truth.linear().transpose());
  return error;
}

void judge(const Drive& drive, const FusionOptions& options, bool scans, Judgement& judgement) {
  constexpr std::array<int, 3> kSteps{1, 10, 100};
  FusionOdometry odometry(drive.mounting, drive.streams(), options, 1);
  std::array<RigidTransform, kSteps.size()> from;
  FusedScan last;
  for (int i = 0; i < drive.scans; ++i) {
    OdometryScan scan;
    if (scans)
      scan = drive.scan(i);
    else
      scan.stamp_ns = Drive::stamp_ns(drive.time_s(i));
    last = odometry.add(scan);
    for (std::size_t k = 0; k < kSteps.size(); ++k) {
      if (i % kSteps[k] != 0) continue;
      if (i > 0)
        judgement[kSteps[k]].add(
            motion_error(from[k], last.odometry_from_vehicle, drive.truth(i - kSteps[k]), drive.truth(i)),
            odometry.covariance_since(k));
      from[k] = last.odometry_from_vehicle;
      odometry.mark(k);
    }
  }
  judgement[0].add(-difference(last.odometry_from_vehicle, drive.truth(drive.scans - 1)), last.covariance);
}

void print(const char* name, const Judgement& judgement) {
  for (const auto& [scans, all] : judgement) {
    std::printf("    %s, %3d scans: %.2f per degree of freedom (%d motions); each", name, scans, all.mean(), all.count);
    for (int i = 0; i < 6; ++i) std::printf(" %.2f", all.each[i] / all.count);
    std::printf("; sigma");
    for (int i = 0; i < 6; ++i)
      std::printf(" %.2g", (i < 3 ? 1e3 : radians_to_degrees(1.0)) * std::sqrt(all.sigma[i] / all.count));
    std::printf(" (mm, deg)\n");
  }
}

Noise all_noise() {
  Noise noise{0.015, 0.02, 0.02, 0.02, 0.02, 0.1};
  noise.gyro_walk_dps = 0.001;
  noise.force_bias_mps2 = 0.02;
  noise.wheel_scale = 0.005;
  noise.barometer_bias_m = 0.2;
  return noise;
}

/// What these sensors are.
FusionOptions matching(const Noise& noise, double speed_mps) {
  FusionOptions options;
  options.gyro_sigma_dps = noise.gyro_dps / std::sqrt(10.0);
  options.gyro_bias_sigma_dps = noise.gyro_bias_dps;
  options.gyro_bias_walk_dps = noise.gyro_walk_dps;
  options.wheel_sigma = noise.wheel_share / std::sqrt(5.0);
  options.sideslip_sigma_mps = 0.001;
  options.wheel_scale_sigma = noise.wheel_scale;
  // Of its noise and, which is more, of the acceleration that half a second of the wheels' speeds tells.
  const double acceleration_mps2 = std::sqrt(12.0 / 25.0) / 0.5 * noise.wheel_share * speed_mps;
  options.accelerometer_sigma_deg =
      radians_to_degrees(std::hypot(noise.force_mps2 / std::sqrt(50.0), acceleration_mps2) / 9.81);
  options.accelerometer_discount_deg = 0.05;
  options.accelerometer_bias_deg = radians_to_degrees(noise.force_bias_mps2 / 9.81);
  options.barometer_sigma_m = noise.barometer_m / std::sqrt(5.0);
  options.barometer_drift_m = noise.barometer_bias_m;
  options.range_noise_m = noise.range_m;
  return options;
}

/// REMOUNT_COVARIANCE_DRIVES asks for more.
int drives(int otherwise) {
  const char* text = std::getenv("REMOUNT_COVARIANCE_DRIVES");
  return text ? std::atoi(text) : otherwise;
}

Judgement judgement_of(const Drive& drive, int count, bool scans, const char* name) {
  Judgement judgement;
  for (int seed = 1; seed <= count; ++seed) {
    Drive one = drive;
    one.noise = all_noise();
    one.seed = static_cast<std::uint64_t>(seed);
    FusionOptions options = matching(one.noise, one.speed_mps);
    options.lines = options.planes = scans;
    judge(one, options, scans, judgement);
  }
  print(name, judgement);
  return judgement;
}

// Six degrees of freedom and many motions: the mean lies near one where the covariance is what the errors are. Of a
// single step it is rather too wide: noise of a scan's features is said to be what it is at most.
void expect_honest(const Judgement& judgement) {
  for (const auto& [scans, all] : judgement) {
    EXPECT_LT(all.mean(), 2.0) << scans << " scans";
    EXPECT_GT(all.mean(), scans == 1 ? 0.2 : 0.3) << scans << " scans";
  }
}

TEST(fusion_covariance, dead_reckoning_knows_how_far_off_it_is) {
  Drive drive;
  drive.world = synthetic::tunnel();
  drive.speed_mps = 15.0;
  drive.scans = 301;
  const Judgement judgement = judgement_of(drive, drives(12), false, "without features");
  expect_honest(judgement);
  EXPECT_GT(judgement.at(0).mean(), 0.5);
}

TEST(fusion_covariance, a_drive_through_a_tunnel_knows_how_far_off_it_is) {
  Drive drive;
  drive.world = synthetic::tunnel();
  drive.speed_mps = 15.0;
  drive.scans = 121;
  drive.beams = 16;
  drive.azimuths = 360;
  expect_honest(judgement_of(drive, drives(4), true, "tunnel"));
}

TEST(fusion_covariance, a_drive_along_a_street_knows_how_far_off_it_is) {
  Drive drive;
  drive.world = synthetic::street();
  drive.scans = 81;
  drive.beams = 12;
  drive.azimuths = 300;
  expect_honest(judgement_of(drive, drives(4), true, "street"));
}

/// Sigma of x after one hundred and two hundred scans by wheels alone, m.
std::pair<double, double> sigma_of_way(const FusionOptions& options) {
  Drive drive;
  drive.scans = 201;
  drive.speed_mps = 15.0;
  FusionOdometry odometry(drive.mounting, drive.streams(), options, 1);
  std::pair<double, double> sigma;
  for (int i = 0; i < drive.scans; ++i) {
    const FusedScan scan = odometry.add({Drive::stamp_ns(drive.time_s(i)), {}, {}});
    (i <= 100 ? sigma.first : sigma.second) = std::sqrt(scan.covariance(0, 0));
  }
  return sigma;
}

// The scale of the wheels errs alike on all of the way, their noise anew in each step; both as the options say.
TEST(fusion_covariance, errors_of_the_wheels_scale_grow_with_the_way_and_noise_with_its_root) {
  FusionOptions scale;
  scale.lines = scale.planes = scale.accelerometer = scale.barometer = false;
  scale.wheel_sigma = scale.wheel_sigma_mps = 1e-4;
  scale.wheel_scale_sigma = 0.004;
  const auto by_scale = sigma_of_way(scale);
  EXPECT_NEAR(by_scale.first, 0.004 * 150.0, 0.01);
  EXPECT_NEAR(by_scale.second, 0.004 * 300.0, 0.02);
  FusionOptions noise = scale;
  noise.wheel_scale_sigma = 0.0;
  noise.wheel_sigma = 0.02;
  const auto by_noise = sigma_of_way(noise);
  EXPECT_NEAR(by_noise.first, 0.02 * 1.5 * 10.0, 0.01);
  EXPECT_NEAR(by_noise.second, 0.02 * 1.5 * std::sqrt(200.0), 0.015);
}

}  // namespace
}  // namespace remount::odometry
