// Matrices of the interface. None asks for an alignment: they are the same however a program is compiled.
#pragma once

#include <Eigen/Core>

namespace remount::api {

/// A rigid transform [R t; 0 1], m, named a_from_b: point_in_a = a_from_b * point_in_b.
using Matrix4 = Eigen::Matrix<double, 4, 4, Eigen::DontAlign>;
using Matrix6 = Eigen::Matrix<double, 6, 6, Eigen::DontAlign>;
using Vector6 = Eigen::Matrix<double, 6, 1, Eigen::DontAlign>;
using Vector4 = Eigen::Matrix<double, 4, 1, Eigen::DontAlign>;

}  // namespace remount::api
