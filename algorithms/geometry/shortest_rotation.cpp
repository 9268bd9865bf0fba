#include "algorithms/geometry/shortest_rotation.h"

#include <Eigen/Geometry>
#include <cmath>

namespace remount {
namespace {

// Eigen's own finds the axis between opposite directions by a singular value decomposition, which takes the compiler
// half a minute in every file that calls it.
template <class Scalar>
Eigen::Matrix<Scalar, 3, 3> shortest(const Eigen::Matrix<Scalar, 3, 1>& from, const Eigen::Matrix<Scalar, 3, 1>& to) {
  // By the sum, and not by the cosine: that of nearly opposite directions is one of rounding.
  const Eigen::Matrix<Scalar, 3, 1> a = from.normalized(), b = to.normalized(), sum = a + b;
  const Scalar length = sum.norm();
  Eigen::Quaternion<Scalar> rotation;
  if (length < Scalar(4) * std::sqrt(Eigen::NumTraits<Scalar>::epsilon())) {
    rotation.w() = Scalar(0);
    rotation.vec() = a.unitOrthogonal();
  } else {
    rotation.w() = Scalar(0.5) * length;
    rotation.vec() = a.cross(b) / length;
    rotation.normalize();
  }
  return rotation.toRotationMatrix();
}

}  // namespace

Eigen::Matrix3d shortest_rotation(const Eigen::Vector3d& from, const Eigen::Vector3d& to) { return shortest(from, to); }
Eigen::Matrix3f shortest_rotation(const Eigen::Vector3f& from, const Eigen::Vector3f& to) { return shortest(from, to); }

}  // namespace remount
