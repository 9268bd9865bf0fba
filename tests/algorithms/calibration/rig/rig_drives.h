// Vehicles with three LiDARs, and how well their sigmas hold.
#pragma once

#include <gtest/gtest.h>

#include <iostream>
#include <vector>

#include "algorithms/calibration/rig/rig.h"
#include "tests/algorithms/support/simulated_rig.h"
#include "tests/support/chi_square.h"

namespace remount::calibration {

inline std::vector<RigidTransform> three_mountings() {
  return {make_rigid(rotation_from_yaw_pitch_roll({1.2, 0.2, -0.1}), {1.1, -0.4, 1.6}),
          make_rigid(rotation_from_yaw_pitch_roll({-2.9, 0.05, 0.3}), {-1.4, 0.3, 1.2}),
          make_rigid(rotation_from_yaw_pitch_roll({0.1, -0.4, 0.02}), {2.2, 0.7, 0.5})};
}

inline testing::RigOptions small_rig() {
  testing::RigOptions options;
  options.ins_from_lidars = three_mountings();
  options.phases_s = {0.0, 0.13, 0.31};
  options.drive.keyframes = 30;
  options.drive.attitude_bias_sigma_rad = 8e-4;
  options.drive.noise.ins_position_drift = 4e-3;
  options.drive.noise.ins_attitude_drift = 1e-4;
  return options;
}

/// Squared errors over variances, component by component.
struct Tally {
  Vector6d sum = Vector6d::Zero();
  int count = 0;

  void add(const Vector6d& error, const Vector6d& variance) {
    sum += error.cwiseAbs2().cwiseQuotient(variance);
    ++count;
  }
  /// @param independent of those counted: LiDARs of a drive have its INS in common
  void expect_within_one_percent(const char* what, double independent) const {
    const double lower = testing::chi_square_quantile(independent, -testing::kOnePercentOutside) / independent,
                 upper = testing::chi_square_quantile(independent, testing::kOnePercentOutside) / independent;
    for (int i = 0; i < 6; ++i) {
      EXPECT_LT(sum[i] / count, upper) << what << " component " << i << " of " << count;
      EXPECT_GT(sum[i] / count, lower) << what << " component " << i << " of " << count;
    }
    std::cout << what << ": mean squares of error over sigma " << (sum / count).transpose() << ", " << count
              << " each\n";
  }
};

}  // namespace remount::calibration
