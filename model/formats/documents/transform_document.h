// A rigid transform as it stands in result, project and export files.
#pragma once

#include "algorithms/geometry/rigid_transform.h"
#include "model/formats/documents/document.h"

namespace remount::formats {

/// {translation_m: [3], quaternion_xyzw: [4], yaw_pitch_roll_deg: [3], matrix: [[4] x 4]}; the four agree, w >= 0.
DocumentNode transform_document(const RigidTransform& a_from_b);

/// {translation_m: [3], quaternion_xyzw: [4]}: what programs need.
DocumentNode short_transform_document(const RigidTransform& a_from_b);

/// Reads the matrix, or translation and quaternion (or angles) where there is none, and makes sure that everything
/// that is there says the same (1e-6). Throws Error(Format) otherwise: a file edited in one place only is refused.
RigidTransform transform_from_document(const DocumentView& view);

/// A 4x4 (list of four lists of four) rigid transform. Throws Error(Format) where the rotation is not orthonormal to
/// 1e-6, is a reflection, or the last row is not 0 0 0 1. The rotation returned is orthonormal to machine precision.
RigidTransform matrix_from_document(const DocumentView& view);

/// A unit quaternion (to 1e-6) in the order x, y, z, w, as a rotation.
Eigen::Matrix3d rotation_from_quaternion_xyzw(const DocumentView& view);

/// The quaternion of a rotation with w >= 0, so that equal rotations give equal texts.
Eigen::Quaterniond canonical_quaternion(const Eigen::Matrix3d& rotation);

}  // namespace remount::formats
