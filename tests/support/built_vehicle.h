// Results of a vehicle with several LiDARs that sit where a test says.
#pragma once

#include <map>
#include <string>

#include "algorithms/calibration/rig/relative_mounting.h"
#include "model/report/vehicle_comparison.h"

namespace remount::testing {

/// ins_from_lidar by the names of LiDARs.
using Mountings = std::map<std::string, RigidTransform>;

/// Each LiDAR known to 3 mm and 0.02 degrees, each two of them to 1 mm and 0.01 degrees against each other.
inline report::NamedVehicle vehicle_with(const std::string& name, const Mountings& ins_from_lidars) {
  report::NamedVehicle vehicle{name, {}};
  for (const auto& [lidar, ins_from_lidar] : ins_from_lidars) {
    results::LidarResult one{lidar, true, {}};
    one.file.result.status = calibration::Status::Ok;
    one.file.result.set_observed(calibration::ParameterSet::all(), {});
    const double sigma_m = 3e-3, sigma_rad = degrees_to_radians(0.02);
    const Eigen::Vector3d places = Eigen::Vector3d::Constant(sigma_m * sigma_m),
                          turns = Eigen::Vector3d::Constant(sigma_rad * sigma_rad);
    one.file.result.covariance.setZero();
    one.file.result.covariance.diagonal() << places, turns;
    one.file.result.mounting.reference_from_sensor = ins_from_lidar;
    vehicle.file.lidars.push_back(one);
    for (const auto& [other, ins_from_other] : ins_from_lidars) {
      if (other <= lidar) continue;
      results::RelativeRecord two;
      two.lidar_a = lidar, two.lidar_b = other;
      two.lidar_a_from_lidar_b = calibration::relative_mounting(ins_from_lidar, ins_from_other);
      for (const calibration::Parameter parameter : calibration::kParameters)
        two.sigma[parameter] = calibration::is_angle(parameter) ? degrees_to_radians(0.01) : 1e-3;
      vehicle.file.relatives.push_back(two);
    }
  }
  return vehicle;
}

/// Where the LiDARs were mounted.
inline Mountings as_built() {
  return {{"front", rigid_from_six({1.2, 0, 1.6, 0.01, 0, -0.04})},
          {"rear", rigid_from_six({-1.5, 0.1, 0.9, 3.1, 0.02, 0})},
          {"roof", rigid_from_six({0, 0, 2.1, 1.5, -0.1, 0.2})}};
}

}  // namespace remount::testing
