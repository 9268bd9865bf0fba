#include "model/formats/documents/pair_document.h"

#include <limits>

#include "model/formats/documents/message_document.h"
#include "model/formats/documents/transform_document.h"

namespace remount {
namespace {

constexpr std::int64_t kLongest = std::numeric_limits<std::int64_t>::max();
constexpr int kMaxCount = std::numeric_limits<int>::max();

/// On one line: translation and quaternion, without the notations that only people need.
DocumentNode short_transform(const RigidTransform& a_from_b) {
  DocumentNode node = DocumentNode::map();
  const Eigen::Vector3d t = a_from_b.translation();
  const Eigen::Quaterniond q = canonical_quaternion(a_from_b.linear());
  node.add("translation_m", DocumentNode::numbers({t.x(), t.y(), t.z()}));
  node.add("quaternion_xyzw", DocumentNode::numbers({q.x(), q.y(), q.z(), q.w()}));
  return node;
}

/// The upper triangle of a symmetric matrix, row by row.
DocumentNode triangle(const Matrix6d& symmetric) {
  std::vector<double> entries;
  for (int row = 0; row < 6; ++row)
    for (int column = row; column < 6; ++column) entries.push_back(symmetric(row, column));
  return DocumentNode::numbers(entries);
}

Matrix6d from_triangle(const DocumentView& view) {
  const std::vector<double> entries = view.numbers(21);
  Matrix6d symmetric;
  std::size_t next = 0;
  for (int row = 0; row < 6; ++row)
    for (int column = row; column < 6; ++column) symmetric(row, column) = symmetric(column, row) = entries[next++];
  return symmetric;
}

DocumentNode registration_document(const RegistrationQuality& quality) {
  DocumentNode node = DocumentNode::map();
  node.add("attempted", DocumentNode::boolean(quality.attempted));
  node.add("converged", DocumentNode::boolean(quality.converged));
  node.add("iterations", DocumentNode::integer(quality.iterations));
  node.add("rmse_m", DocumentNode::number(quality.rmse_m));
  node.add("overlap", DocumentNode::number(quality.overlap));
  node.add("information", triangle(quality.information));
  node.add("failure", message_document(quality.failure));
  if (!quality.undetermined.empty()) node.add("undetermined", message_document(quality.undetermined));
  return node;
}

RegistrationQuality registration_from(const DocumentView& view) {
  RegistrationQuality quality;
  quality.attempted = view.at("attempted").boolean();
  quality.converged = view.at("converged").boolean();
  quality.iterations = static_cast<int>(view.at("iterations").integer(0, kMaxCount));
  quality.rmse_m = view.at("rmse_m").number_or_nan();
  quality.overlap = view.at("overlap").number_or_nan();
  quality.information = from_triangle(view.at("information"));
  quality.failure = message_from_document(view.at("failure"));
  if (view.has("undetermined")) quality.undetermined = message_from_document(view.at("undetermined"));
  return quality;
}

}  // namespace

DocumentNode keyframe_document(const Keyframe& keyframe) {
  DocumentNode node = DocumentNode::map();
  node.on_one_line = true;
  node.add("session", DocumentNode::integer(keyframe.session));
  node.add("scan", DocumentNode::integer(keyframe.scan));
  node.add("stamp_ns", DocumentNode::integer(keyframe.stamp_ns));
  node.add("travelled_m", DocumentNode::number(keyframe.travelled_m));
  return node;
}

Keyframe keyframe_from_document(const DocumentView& view, std::size_t session_count) {
  Keyframe keyframe;
  keyframe.session = index_at<SessionIndex>(view.at("session").integer(0, number_of(session_count) - 1));
  keyframe.scan = index_at<ScanIndex>(view.at("scan").integer(0, kMaxCount));
  keyframe.stamp_ns = view.at("stamp_ns").integer(-kLongest, kLongest);
  keyframe.travelled_m = view.at("travelled_m").number_or_nan();
  return keyframe;
}

DocumentNode pair_document(const Pair& pair) {
  DocumentNode node = DocumentNode::map();
  node.on_one_line = true;
  node.add("keyframe_a", DocumentNode::integer(pair.keyframe_a));
  node.add("keyframe_b", DocumentNode::integer(pair.keyframe_b));
  node.add("state", DocumentNode::integer(static_cast<int>(pair.state)));
  node.add("decided_by", DocumentNode::integer(static_cast<int>(pair.decided_by)));
  node.add("reason", message_document(pair.reason));
  node.add("gap_s", DocumentNode::number(pair.gap_s));
  node.add("baseline_m", DocumentNode::number(pair.baseline_m));
  node.add("rotation_rad", DocumentNode::number(pair.rotation_rad));
  node.add("shared_objects", DocumentNode::integer(pair.shared_objects));
  node.add("moving_objects", DocumentNode::integer(pair.moving_objects));
  node.add("ins_b_from_ins_a", short_transform(pair.ins_b_from_ins_a));
  node.add("lidar_b_from_lidar_a", short_transform(pair.lidar_b_from_lidar_a));
  node.add("registration", registration_document(pair.registration));
  DocumentNode& screw = node.add("screw", DocumentNode::map());
  screw.add("rotation_difference_rad", DocumentNode::number(pair.screw.rotation_difference_rad));
  screw.add("translation_difference_m", DocumentNode::number(pair.screw.translation_difference_m));
  screw.add("score", DocumentNode::number(pair.screw.score));
  screw.add("passed", DocumentNode::boolean(pair.screw.passed));
  node.add("residual_rotation_rad", DocumentNode::number(pair.residual_rotation_rad));
  node.add("residual_translation_m", DocumentNode::number(pair.residual_translation_m));
  node.add("weight", DocumentNode::number(pair.weight));
  return node;
}

Pair pair_from_document(const DocumentView& view, std::size_t keyframe_count) {
  const std::int64_t last = number_of(keyframe_count) - 1;
  Pair pair;
  pair.keyframe_a = index_at<KeyframeIndex>(view.at("keyframe_a").integer(0, last));
  pair.keyframe_b = index_at<KeyframeIndex>(view.at("keyframe_b").integer(0, last));
  pair.state = static_cast<PairState>(view.at("state").integer(0, 2));
  pair.decided_by = static_cast<DecidedBy>(view.at("decided_by").integer(0, 2));
  pair.reason = message_from_document(view.at("reason"));
  pair.gap_s = view.at("gap_s").number_or_nan();
  pair.baseline_m = view.at("baseline_m").number_or_nan();
  pair.rotation_rad = view.at("rotation_rad").number_or_nan();
  pair.shared_objects = static_cast<int>(view.at("shared_objects").integer(0, kMaxCount));
  pair.moving_objects = static_cast<int>(view.at("moving_objects").integer(0, kMaxCount));
  pair.ins_b_from_ins_a = transform_from_document(view.at("ins_b_from_ins_a"));
  pair.lidar_b_from_lidar_a = transform_from_document(view.at("lidar_b_from_lidar_a"));
  pair.registration = registration_from(view.at("registration"));
  const DocumentView screw = view.at("screw");
  pair.screw.rotation_difference_rad = screw.at("rotation_difference_rad").number_or_nan();
  pair.screw.translation_difference_m = screw.at("translation_difference_m").number_or_nan();
  pair.screw.score = screw.at("score").number_or_nan();
  pair.screw.passed = screw.at("passed").boolean();
  pair.residual_rotation_rad = view.at("residual_rotation_rad").number_or_nan();
  pair.residual_translation_m = view.at("residual_translation_m").number_or_nan();
  pair.weight = view.at("weight").number_or_nan();
  return pair;
}

}  // namespace remount
