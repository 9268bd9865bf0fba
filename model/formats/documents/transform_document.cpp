#include "model/formats/documents/transform_document.h"

#include <cmath>

#include "messages/poses.h"

namespace remount::formats {
namespace {

constexpr std::string_view kTranslation = "translation_m", kQuaternion = "quaternion_xyzw",
                           kAngles = "yaw_pitch_roll_deg", kMatrix = "matrix";
constexpr double kTolerance = 1e-6;

/// Removes what printing left of non-orthonormality; an already orthonormal matrix is returned bit for bit.
Eigen::Matrix3d clean(const Eigen::Matrix3d& rotation) {
  const double error = (rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  return error < 1e-14 ? rotation : nearest_rotation(rotation);
}

Eigen::Vector3d vector_of(const DocumentView& view) {
  return Eigen::Map<const Eigen::Vector3d>(view.numbers(3).data());
}

Eigen::Matrix3d rotation_from_angles_deg(const DocumentView& view) {
  const Eigen::Vector3d deg = vector_of(view);
  return rotation_from_yaw_pitch_roll(
      {degrees_to_radians(deg[0]), degrees_to_radians(deg[1]), degrees_to_radians(deg[2])});
}

void check_agrees(const DocumentView& view, double difference, Message (*what)()) {
  if (difference > kTolerance) view.fail(say::transform_contradicts(what(), difference));
}

}  // namespace

Eigen::Quaterniond canonical_quaternion(const Eigen::Matrix3d& rotation) {
  Eigen::Quaterniond q(rotation);
  q.normalize();
  if (q.w() < 0.0) q.coeffs() = -q.coeffs();
  return q;
}

DocumentNode short_transform_document(const RigidTransform& a_from_b) {
  const Eigen::Vector3d t = a_from_b.translation();
  const Eigen::Quaterniond q = canonical_quaternion(a_from_b.linear());
  DocumentNode node = DocumentNode::map();
  node.add(std::string(kTranslation), DocumentNode::numbers({t.x(), t.y(), t.z()}));
  node.add(std::string(kQuaternion), DocumentNode::numbers({q.x(), q.y(), q.z(), q.w()}));
  return node;
}

DocumentNode transform_document(const RigidTransform& a_from_b) {
  const SixParameters six = six_from_rigid(a_from_b);
  DocumentNode node = short_transform_document(a_from_b);
  node.add(std::string(kAngles),
           DocumentNode::numbers(
               {radians_to_degrees(six.yaw_rad), radians_to_degrees(six.pitch_rad), radians_to_degrees(six.roll_rad)}));
  DocumentNode& matrix = node.add(std::string(kMatrix), DocumentNode::sequence());
  for (int row = 0; row < 4; ++row)
    matrix.add(DocumentNode::numbers({a_from_b(row, 0), a_from_b(row, 1), a_from_b(row, 2), a_from_b(row, 3)}));
  return node;
}

RigidTransform matrix_from_document(const DocumentView& view) {
  const std::vector<DocumentView> rows = view.items();
  if (rows.size() != 4) view.fail(say::transform_four_rows());
  Eigen::Matrix4d matrix;
  for (int row = 0; row < 4; ++row)
    matrix.row(row) = Eigen::Map<const Eigen::RowVector4d>(rows[static_cast<std::size_t>(row)].numbers(4).data());
  if ((matrix.row(3) - Eigen::RowVector4d(0, 0, 0, 1)).cwiseAbs().maxCoeff() > kTolerance)
    view.fail(say::transform_last_row());
  const Eigen::Matrix3d rotation = matrix.topLeftCorner<3, 3>();
  const double error = (rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (!(error <= kTolerance)) view.fail(say::transform_not_orthonormal(error));
  if (rotation.determinant() < 0.0) view.fail(say::transform_reflection());
  return make_rigid(clean(rotation), matrix.topRightCorner<3, 1>());
}

Eigen::Matrix3d rotation_from_quaternion_xyzw(const DocumentView& view) {
  const std::vector<double> q = view.numbers(4);
  const Eigen::Quaterniond quaternion(q[3], q[0], q[1], q[2]);
  if (!(std::abs(quaternion.norm() - 1.0) <= kTolerance))
    view.fail(say::transform_quaternion_length(quaternion.norm()));
  return quaternion.normalized().toRotationMatrix();
}

RigidTransform transform_from_document(const DocumentView& view) {
  if (!view.has(kMatrix)) {
    const Eigen::Vector3d t = vector_of(view.at(kTranslation));
    if (view.has(kQuaternion)) return make_rigid(rotation_from_quaternion_xyzw(view.at(kQuaternion)), t);
    return make_rigid(rotation_from_angles_deg(view.at(kAngles)), t);
  }
  const RigidTransform a_from_b = matrix_from_document(view.at(kMatrix));
  if (view.has(kTranslation))
    check_agrees(view.at(kTranslation), (vector_of(view.at(kTranslation)) - a_from_b.translation()).norm(),
                 say::transform_the_translation);
  if (view.has(kQuaternion))
    check_agrees(view.at(kQuaternion),
                 (rotation_from_quaternion_xyzw(view.at(kQuaternion)) - a_from_b.linear()).cwiseAbs().maxCoeff(),
                 say::transform_the_quaternion);
  if (view.has(kAngles))
    check_agrees(view.at(kAngles),
                 (rotation_from_angles_deg(view.at(kAngles)) - a_from_b.linear()).cwiseAbs().maxCoeff(),
                 say::transform_the_angles);
  return a_from_b;
}

}  // namespace remount::formats
