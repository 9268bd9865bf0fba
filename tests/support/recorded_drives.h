// Recorded drives beside the checkout, and what is known of their mounting. Tests are skipped where they are absent.
#pragma once

#include <filesystem>

#include "algorithms/geometry/rigid_transform.h"

namespace remount::testing {

inline const std::filesystem::path kData = std::filesystem::path(REMOUNT_SOURCE_DIR) / ".." / "shared" / "data";

/// The stated angles "yaw -90.443 pitch 0.619 roll 0.134" reproduce the drives' own motion pairs as Rx(roll) Ry(pitch)
/// Rz(yaw) (0.28 deg rms) and not as Rz Ry Rx (0.81 deg rms).
inline RigidTransform zxl19_reference() {
  const Eigen::Matrix3d rotation = (Eigen::AngleAxisd(degrees_to_radians(0.134), Eigen::Vector3d::UnitX()) *
                                    Eigen::AngleAxisd(degrees_to_radians(0.619), Eigen::Vector3d::UnitY()) *
                                    Eigen::AngleAxisd(degrees_to_radians(-90.443), Eigen::Vector3d::UnitZ()))
                                       .toRotationMatrix();
  return make_rigid(rotation, {-0.004, 0.379, 0.13});
}

}  // namespace remount::testing
