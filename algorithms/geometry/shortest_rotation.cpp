#include "algorithms/geometry/shortest_rotation.h"

#include <Eigen/Geometry>
#include <cmath>

namespace remount {
namespace {

// Eigen's own finds the axis between opposite directions by a singular value decomposition, which takes the compiler
// half a minute in every file that calls it.
template <class Scalar>
Eigen::Matrix<Scalar, 3, 3> shortest(const Eigen::Matrix<Scalar, 3, 1>& from, const Eigen::Matrix<Scalar, 3, 1>& to) {
  using Quaternion = Eigen::Quaternion<Scalar>;
  const Eigen::Matrix<Scalar, 3, 1> a = from.normalized(), b = to.normalized();
  const Scalar cosine = a.dot(b);
  Quaternion rotation;
  if (cosine < Eigen::NumTraits<Scalar>::dummy_precision() - Scalar(1)) {
    rotation.w() = Scalar(0);
    rotation.vec() = a.unitOrthogonal();
  } else {
    const Scalar twice_w = std::sqrt((Scalar(1) + cosine) * Scalar(2));
    rotation.w() = Scalar(0.5) * twice_w;
    rotation.vec() = a.cross(b) / twice_w;
  }
  return rotation.toRotationMatrix();
}

}  // namespace

Eigen::Matrix3d shortest_rotation(const Eigen::Vector3d& from, const Eigen::Vector3d& to) { return shortest(from, to); }
Eigen::Matrix3f shortest_rotation(const Eigen::Vector3f& from, const Eigen::Vector3f& to) { return shortest(from, to); }

}  // namespace remount
