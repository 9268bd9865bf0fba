// lidar_b_from_lidar_a by scan registration. One function type, and the list of algorithms. docs/maths/registration.md
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "algorithms/core/progress.h"
#include "algorithms/motion/pair.h"
#include "algorithms/registration/prepared_cloud.h"
#include "algorithms/registration/undetermined.h"

namespace remount::registration {

struct RegistrationResult {
  RigidTransform target_from_source = RigidTransform::Identity();
  motion::RegistrationQuality quality;
};

/// Aligns `source` to `target` from a start value. A failure is part of the result (quality.failure), never an
/// exception.
using AlignFunction = RegistrationResult (*)(const PreparedCloud& source, const PreparedCloud& target,
                                             const RigidTransform& target_from_source_start,
                                             const RegistrationOptions& options, const Progress& progress);

struct RegistrationMethod {
  std::string_view id;  ///< as in RegistrationOptions' choice
  AlignFunction align;
};

/// In the order of RegistrationAlgorithm. Adding one: a file in this folder, its name in the enumeration and a line in
/// registration.cpp.
const std::vector<RegistrationMethod>& registration_methods();

/// Aligns with the chosen algorithm, judges the outcome (overlap, residual) and fills the quality.
RegistrationResult align_scans(const PreparedCloud& source, const PreparedCloud& target,
                               const RigidTransform& target_from_source_start, const RegistrationOptions& options,
                               const Progress& progress);

/// Normal equations of the residuals between two scans at a given transform, under `perturb` (translation first, axes
/// of the target): the cost near it is 1/2 d' H d + g' d, in units of variance. Used for the information of a
/// registration and for joint alignment. Empty where `progress` is cancelled.
struct AlignmentEquations {
  Matrix6d hessian = Matrix6d::Zero();
  Vector6d gradient = Vector6d::Zero();
  /// Inverse covariance of the minimum: H B^-1 H with the scatter B of the gradient's parts from separate surfaces, and
  /// nothing along what is undetermined.
  Matrix6d information = Matrix6d::Zero();
  /// How the minimum moves with the errors of the beams, where it was asked for; a direction that the surfaces do not
  /// show hardly moves. docs/maths/beams.md (B3)
  motion::BeamResponse beam_response = motion::BeamResponse(6, 0);
  double rmse_m = 0.0;   ///< of inlier residuals along the normals
  double overlap = 0.0;  ///< share of source points with an inlier neighbour
  /// The same share as the mean over three directions that surfaces face, so that a lot of ground does not hide that
  /// facades miss each other.
  double agreement = 0.0;
  UndeterminedDirections undetermined;
};
AlignmentEquations alignment_equations(const PreparedCloud& source, const PreparedCloud& target,
                                       const RigidTransform& target_from_source, double max_correspondence_m,
                                       const Progress& progress = {}, const cloud::BeamNodes& beam_nodes = {});
/// The same of scans of two LiDARs: the response has columns of the source's errors, then of the target's.
AlignmentEquations alignment_equations_across(const PreparedCloud& source, const PreparedCloud& target,
                                              const RigidTransform& target_from_source, double max_correspondence_m,
                                              const Progress& progress, const cloud::BeamNodes& source_nodes,
                                              const cloud::BeamNodes& target_nodes);

/// The step to the minimum of the equations, held by a spread of 0.1 m and 0.3 deg around zero: a direction that the
/// surfaces do not show stays where it is.
Vector6d damped_step(const AlignmentEquations& equations);

// The algorithms (one file each).
RegistrationResult align_plane_to_plane(const PreparedCloud&, const PreparedCloud&, const RigidTransform&,
                                        const RegistrationOptions&, const Progress&);
RegistrationResult align_pcl_icp(const PreparedCloud&, const PreparedCloud&, const RigidTransform&,
                                 const RegistrationOptions&, const Progress&);
RegistrationResult align_pcl_gicp(const PreparedCloud&, const PreparedCloud&, const RigidTransform&,
                                  const RegistrationOptions&, const Progress&);
RegistrationResult align_pcl_ndt(const PreparedCloud&, const PreparedCloud&, const RigidTransform&,
                                 const RegistrationOptions&, const Progress&);

}  // namespace remount::registration
