// Directions that the surfaces two scans have in common do not determine: a corridor's length, an open field's plane.
#pragma once

#include <vector>

#include "algorithms/geometry/rigid_transform.h"
#include "algorithms/messages/message.h"

namespace remount::registration {

/// What one matched surface element says about a motion under `perturb`, in the axes of the target.
struct SurfaceElement {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  Eigen::Vector3d arm = Eigen::Vector3d::Zero();  ///< from the source's origin, m
  double weight = 1.0;
};

struct UndeterminedDirections {
  /// Orthonormal columns [translation m; rotation rad * lever_m], one a direction; none where all are determined.
  Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, 6> basis{6, 0};
  double lever_m = 10.0;  ///< what makes a rotation comparable to a translation: how far away surfaces are

  bool empty() const { return basis.cols() == 0; }
  bool all() const { return basis.cols() == 6; }
  /// A message each, in axes of the target: "x", "yaw", or "the shift along [0.71, 0.70, 0.02]" between axes.
  std::vector<Message> directions() const;
  /// "x, y, yaw (axes of the lidar)"; empty for none. For elements in the axes of a target's lidar.
  Message words() const;
  /// What the information says of the other directions where nothing is known of these; exactly zero for all().
  Matrix6d removed_from(const Matrix6d& information) const;
};

/// The eigenvectors of the elements' 6x6 information, with rotations scaled by the surfaces' distance, along which
/// hardly any surface resists. A surface resists where it faces the motion of its point by more than the noise of a
/// normal (15 deg; Tuna et al. 2022, X-ICP, take 10 to 45): normals of a corridor's walls lean this way and that, which
/// adds up to an eigenvalue that noise alone makes. What is left, as a share of all surfaces, decides.
UndeterminedDirections undetermined_directions(const std::vector<SurfaceElement>& elements);

}  // namespace remount::registration
