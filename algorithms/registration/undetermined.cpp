#include "algorithms/registration/undetermined.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "algorithms/core/decompositions.h"
#include "algorithms/core/index.h"
#include "algorithms/core/symmetric_eigen.h"
#include "messages/pairs.h"

namespace remount::registration {
namespace {

constexpr double kFacing = 0.26;         // sine of 15 deg
constexpr double kLeastShare = 0.002;    // of all surfaces, as squared cosines
constexpr double kLeastElements = 12.0;  // a pole's worth: below, a few bad normals would do
constexpr double kAligned = 0.9;         // cosine to an axis that is named after it

// Whether the squared cosines between normals and the motion of their points, where the surface faces the motion, add
// up to `needed`. Mostly a small part of the surfaces is enough to say so. docs/maths/registration.md (R9)
bool is_resisted(const Vector6d& direction, double lever_m, const std::vector<SurfaceElement>& elements,
                 double needed) {
  const Eigen::Vector3d shift = direction.head<3>(), turn = direction.tail<3>() / lever_m;
  double sum = 0.0;
  for (const SurfaceElement& element : elements) {
    if (sum >= needed) return true;
    const Eigen::Vector3d motion = shift + turn.cross(element.arm);
    const double along = motion.dot(element.normal), length2 = motion.squaredNorm();
    // Points that hardly move, near the axis of a rotation, say little: their share is that of their motion.
    if (along * along > kFacing * kFacing * length2) sum += element.weight * along * along / std::max(1.0, length2);
  }
  return sum >= needed;
}

Matrix6d scaled_information(const std::vector<SurfaceElement>& elements, double lever_m) {
  Matrix6d sum = Matrix6d::Zero();
  for (const SurfaceElement& element : elements) {
    Vector6d row;
    row << element.normal, element.arm.cross(element.normal) / lever_m;
    for (int i = 0; i < 6; ++i) sum.col(i).head(i + 1) += element.weight * row[i] * row.head(i + 1);
  }
  return sum.selfadjointView<Eigen::Upper>();
}

// What is known along the columns of `rest` where nothing is known along those of `open`: the inverse of the
// covariance's block. The block of the information itself would take the open directions for known exactly.
// docs/maths/registration.md (R10)
Eigen::MatrixXd marginal(const Matrix6d& information, const Eigen::MatrixXd& open, const Eigen::MatrixXd& rest) {
  constexpr double kNothing = 1e-13;  // of the largest: what is smaller is rounding, and so is its coupling
  const auto eigen = symmetric_eigen(Eigen::MatrixXd(open.transpose() * information * open));
  const double least = kNothing * information.trace();
  const Eigen::VectorXd inverse =
      eigen.eigenvalues().unaryExpr([least](double value) { return value > least ? 1.0 / value : 0.0; });
  const Eigen::MatrixXd coupling = rest.transpose() * information * open * eigen.eigenvectors();
  return rest.transpose() * information * rest - coupling * inverse.asDiagonal() * coupling.transpose();
}

// Names of the axes that a subspace of R^3 (as a projector) holds, or its directions where they lie between axes.
std::vector<Message> axes_of(const Eigen::Matrix3d& projector, const std::array<Message (*)(), 3>& names,
                             Message (*between)(double, double, double)) {
  std::vector<Message> list;
  for (int axis = 0; axis < 3; ++axis)
    if (projector(axis, axis) > kAligned * kAligned) list.push_back(names[index_at(axis)]());
  const auto eigen = symmetric_eigen(projector);
  const auto dimensions = static_cast<int>((eigen.eigenvalues().array() > 0.5).count());
  if (std::ssize(list) == dimensions) return list;
  list.clear();
  for (int i = 3 - dimensions; i < 3; ++i) {
    Eigen::Vector3d v = eigen.eigenvectors().col(i);
    Eigen::Index largest = 0;
    v.cwiseAbs().maxCoeff(&largest);
    if (v[largest] < 0.0) v = -v;
    list.push_back(between(v.x(), v.y(), v.z()));
  }
  return list;
}

}  // namespace

std::vector<Message> UndeterminedDirections::directions() const {
  if (empty()) return {};
  const Matrix6d projector = basis * basis.transpose();
  std::vector<Message> list = axes_of(projector.topLeftCorner<3, 3>(),
                                      {say::open_shift_x, say::open_shift_y, say::open_shift_z}, say::open_shift_along);
  for (Message& turn : axes_of(projector.bottomRightCorner<3, 3>(),
                               {say::open_turn_x, say::open_turn_y, say::open_turn_z}, say::open_turn_about))
    list.push_back(std::move(turn));
  // A turn about an axis beside the sensor is half shift and half turn.
  if (list.empty()) list.push_back(say::open_turn_beside());
  return list;
}

Message UndeterminedDirections::words() const { return empty() ? Message() : say::open_of_lidar(directions()); }

Matrix6d UndeterminedDirections::removed_from(const Matrix6d& information) const {
  if (empty()) return information;
  if (all()) return Matrix6d::Zero();  // exactly: projections leave rounding errors, which pass for knowledge
  Vector6d scale = Vector6d::Ones();
  scale.tail<3>().setConstant(lever_m);
  const Matrix6d scaled = scale.cwiseInverse().asDiagonal() * information * scale.cwiseInverse().asDiagonal();
  const Matrix6d axes = orthogonal_factor(basis);
  const Eigen::MatrixXd rest = axes.rightCols(6 - basis.cols());
  const Matrix6d kept = rest * marginal(scaled, basis, rest) * rest.transpose();
  return scale.asDiagonal() * (0.5 * (kept + kept.transpose())) * scale.asDiagonal();
}

UndeterminedDirections undetermined_directions(const std::vector<SurfaceElement>& elements) {
  UndeterminedDirections out;
  double weights = 0.0, squares = 0.0;
  for (const SurfaceElement& element : elements) {
    weights += element.weight;
    squares += element.weight * element.arm.squaredNorm();
  }
  if (weights > 0.0) out.lever_m = std::clamp(std::sqrt(squares / weights), 1.0, 100.0);
  const double needed = std::max(kLeastElements, kLeastShare * weights);
  const auto eigen = symmetric_eigen(Matrix6d(scaled_information(elements, out.lever_m)));
  for (int i = 0; i < 6; ++i) {
    const Vector6d direction = eigen.eigenvectors().col(i);
    if (is_resisted(direction, out.lever_m, elements, needed)) continue;
    out.basis.conservativeResize(6, out.basis.cols() + 1);
    out.basis.col(out.basis.cols() - 1) = direction;
  }
  return out;
}

}  // namespace remount::registration
