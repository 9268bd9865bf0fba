// What the acceptance tests of whole calibrations share.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <memory>

#include "model/pipeline/pipeline.h"

namespace remount::testing {

/// Rotation error in degrees, translation errors in metres against the truth; printed by every test that uses it.
struct CalibrationError {
  double rotation_deg = 0.0, x_m = 0.0, y_m = 0.0, z_m = 0.0;
};

inline CalibrationError error_of(const calibration::CalibrationResult& result,
                                 const RigidTransform& truth_ins_from_lidar) {
  CalibrationError error;
  error.rotation_deg =
      radians_to_degrees(rotation_angle_between_rad(result.mounting.reference_from_sensor, truth_ins_from_lidar));
  const Eigen::Vector3d t = result.mounting.reference_from_sensor.translation() - truth_ins_from_lidar.translation();
  error.x_m = t.x();
  error.y_m = t.y();
  error.z_m = t.z();
  std::printf("  %s: rotation %.4f deg, x %.4f, y %.4f, z %.4f m; pairs %d accepted, %d rejected\n",
              std::string(to_string(result.status)).c_str(), error.rotation_deg, error.x_m, error.y_m, error.z_m,
              result.pairs_accepted, result.pairs_rejected);
  return error;
}

/// Errors of the observed parameters over their stated sigma, order of kParameters; NaN where not observed.
inline std::array<double, 6> normalised_errors(const calibration::CalibrationResult& result,
                                               const RigidTransform& truth) {
  const SixParameters found = six_from_rigid(result.mounting.reference_from_sensor), exact = six_from_rigid(truth);
  const std::array<double, 6> error{found.x_m - exact.x_m,
                                    found.y_m - exact.y_m,
                                    found.z_m - exact.z_m,
                                    wrap_angle_rad(found.yaw_rad - exact.yaw_rad),
                                    found.pitch_rad - exact.pitch_rad,
                                    wrap_angle_rad(found.roll_rad - exact.roll_rad)};
  std::array<double, 6> normalised{};
  for (std::size_t i = 0; i < 6; ++i)
    normalised[i] = result.estimate(calibration::kParameters[i]).sigma
                        ? error[i] / *result.estimate(calibration::kParameters[i]).sigma
                        : std::numeric_limits<double>::quiet_NaN();
  return normalised;
}

inline void expect_within_sigma(const calibration::CalibrationResult& result, const RigidTransform& truth,
                                double limit) {
  const std::array<double, 6> normalised = normalised_errors(result, truth);
  for (std::size_t i = 0; i < 6; ++i)
    if (std::isfinite(normalised[i])) {
      EXPECT_LT(std::abs(normalised[i]), limit)
          << to_string(calibration::kParameters[i]) << " is off by " << normalised[i] << " sigma of "
          << *result.estimate(calibration::kParameters[i]).sigma;
    }
}

}  // namespace remount::testing
