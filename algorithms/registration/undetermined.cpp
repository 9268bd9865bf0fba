#include "algorithms/registration/undetermined.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "algorithms/core/decompositions.h"
#include "algorithms/core/symmetric_eigen.h"

namespace remount {
namespace {

constexpr double kFacing = 0.26;         // sine of 15 deg
constexpr double kLeastShare = 0.002;    // of all surfaces, as squared cosines
constexpr double kLeastElements = 12.0;  // a pole's worth: below, a few bad normals would do
constexpr double kAligned = 0.9;         // cosine to an axis that is named after it

// Whether the squared cosines between normals and the motion of their points, where the surface faces the motion, add
// up to `needed`. Mostly a small part of the surfaces is enough to say so. docs/maths/registration.md (R9)
bool resisted(const Vector6d& direction, double lever_m, const std::vector<SurfaceElement>& elements, double needed) {
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

std::string join(std::string list, const std::string& word) { return list + (list.empty() ? "" : ", ") + word; }

// Names of the axes that a subspace of R^3 (as a projector) holds, or its directions where they lie between axes.
std::string axes_of(const Eigen::Matrix3d& projector, const std::array<const char*, 3>& names, const char* between) {
  std::string list;
  int named = 0;
  for (int axis = 0; axis < 3; ++axis)
    if (projector(axis, axis) > kAligned * kAligned) {
      list = join(list, names[static_cast<std::size_t>(axis)]);
      ++named;
    }
  const auto eigen = symmetric_eigen(projector);
  const auto dimensions = static_cast<int>((eigen.eigenvalues().array() > 0.5).count());
  if (named == dimensions) return list;
  list.clear();
  for (int i = 3 - dimensions; i < 3; ++i) {
    Eigen::Vector3d v = eigen.eigenvectors().col(i);
    Eigen::Index largest = 0;
    v.cwiseAbs().maxCoeff(&largest);
    if (v[largest] < 0.0) v = -v;
    char text[80];
    std::snprintf(text, sizeof text, "%s [%.2f, %.2f, %.2f]", between, v.x(), v.y(), v.z());
    list = join(list, text);
  }
  return list;
}

}  // namespace

std::string UndeterminedDirections::words() const {
  if (empty()) return {};
  const Matrix6d projector = basis * basis.transpose();
  const std::string shifts = axes_of(projector.topLeftCorner<3, 3>(), {"x", "y", "z"}, "the shift along"),
                    turns = axes_of(projector.bottomRightCorner<3, 3>(), {"roll", "pitch", "yaw"}, "the turn about");
  const std::string both = shifts.empty() ? turns : turns.empty() ? shifts : shifts + ", " + turns;
  // A turn about an axis beside the sensor is half shift and half turn.
  return (both.empty() ? "a turn about an axis beside the sensor" : both) + " (axes of the lidar)";
}

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
    if (resisted(direction, out.lever_m, elements, needed)) continue;
    out.basis.conservativeResize(6, out.basis.cols() + 1);
    out.basis.col(out.basis.cols() - 1) = direction;
  }
  return out;
}

}  // namespace remount
