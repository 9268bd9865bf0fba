#include "model/formats/documents/pair_document.h"

#include "algorithms/cloud/beam_nodes.h"
#include "model/formats/documents/notations.h"

namespace remount::formats {
namespace {

/// The upper triangle of a symmetric matrix, row by row.
DocumentNode triangle_document(const Matrix6d& symmetric) {
  std::vector<double> entries;
  for (int row = 0; row < 6; ++row)
    for (int column = row; column < 6; ++column) entries.push_back(symmetric(row, column));
  return DocumentNode::numbers(entries);
}

Matrix6d triangle_from_document(const DocumentView& view) {
  const std::vector<double> entries = view.numbers(21);
  Matrix6d symmetric;
  std::size_t next = 0;
  for (int row = 0; row < 6; ++row)
    for (int column = row; column < 6; ++column) symmetric(row, column) = symmetric(column, row) = entries[next++];
  return symmetric;
}

/// The columns that are not zero, each by its number and its six rows.
struct Columns {
  DocumentNode write(const motion::BeamResponse& response) const {
    std::vector<double> numbers;
    for (Eigen::Index column = 0; column < response.cols(); ++column) {
      if (response.col(column).isZero(0.0f)) continue;
      numbers.push_back(static_cast<double>(column));
      for (const float value : response.col(column)) numbers.push_back(value);
    }
    return DocumentNode::numbers(numbers);
  }
  void read(const DocumentView& view, motion::BeamResponse& response) const {
    constexpr std::size_t kStep = 1 + motion::BeamResponse::RowsAtCompileTime;
    const std::vector<DocumentView> items = view.items();
    const std::vector<double> numbers = view.numbers((items.size() + kStep - 1) / kStep * kStep);
    std::int64_t columns = 0;
    for (std::size_t at = 0; at < numbers.size(); at += kStep)
      columns = std::max(columns, items[at].integer(0, cloud::kMostBeamErrors - 1) + 1);
    response.setZero(motion::BeamResponse::RowsAtCompileTime, static_cast<Eigen::Index>(columns));
    for (std::size_t at = 0; at < numbers.size(); at += kStep) {
      const auto column = static_cast<Eigen::Index>(items[at].integer(0, columns - 1));
      for (Eigen::Index row = 0; row < response.rows(); ++row)
        response(row, column) = static_cast<float>(numbers[at + 1 + static_cast<std::size_t>(row)]);
    }
  }
};

}  // namespace

void describe(RecordOf<motion::RegistrationQuality> auto& quality, auto& fields) {
  fields("attempted", quality.attempted);
  fields("converged", quality.converged);
  fields("iterations", quality.iterations);
  fields("rmse_m", quality.rmse_m);
  fields("overlap", quality.overlap);
  fields("information", quality.information, Through{triangle_document, triangle_from_document});
  fields.where(!quality.beam_response.isZero(0.0f), "beam_response", quality.beam_response, Columns());
  fields("failure", quality.failure);
  fields.where(!quality.undetermined.empty(), "undetermined", quality.undetermined);
}

void describe(RecordOf<motion::ScrewTest> auto& screw, auto& fields) {
  fields("rotation_difference_rad", screw.rotation_difference_rad);
  fields("translation_difference_m", screw.translation_difference_m);
  fields("score", screw.score);
  fields("passed", screw.passed);
}

namespace {

auto keyframe_fields(std::size_t session_count) {
  return MapOf{[session_count](auto& keyframe, auto& fields) {
    fields.on_one_line();
    fields("session", keyframe.session, below(session_count));
    fields("scan", keyframe.scan);
    fields("stamp_ns", keyframe.stamp_ns);
    fields("travelled_m", keyframe.travelled_m);
  }};
}

auto pair_fields(std::size_t keyframe_count) {
  return MapOf{[keyframe_count](auto& pair, auto& fields) {
    fields.on_one_line();
    fields("keyframe_a", pair.keyframe_a, below(keyframe_count));
    fields("keyframe_b", pair.keyframe_b, below(keyframe_count));
    fields("state", pair.state, Whole{0, 2});
    fields("decided_by", pair.decided_by, Whole{0, 2});
    fields("reason", pair.reason);
    fields("gap_s", pair.gap_s);
    fields("baseline_m", pair.baseline_m);
    fields("rotation_rad", pair.rotation_rad);
    fields("shared_objects", pair.shared_objects);
    fields("moving_objects", pair.moving_objects);
    fields("ins_b_from_ins_a", pair.ins_b_from_ins_a, kShortTransform);
    fields("lidar_b_from_lidar_a", pair.lidar_b_from_lidar_a, kShortTransform);
    fields("registration", pair.registration);
    fields("screw", pair.screw);
    fields("residual_rotation_rad", pair.residual_rotation_rad);
    fields("residual_translation_m", pair.residual_translation_m);
    fields("weight", pair.weight);
  }};
}

constexpr std::size_t kUnbounded = 0;  // bounds are of reading only

}  // namespace

DocumentNode keyframe_document(const motion::Keyframe& keyframe) { return keyframe_fields(kUnbounded).write(keyframe); }

DocumentNode pair_document(const motion::Pair& pair) { return pair_fields(kUnbounded).write(pair); }

motion::Keyframe keyframe_from_document(const DocumentView& view, std::size_t session_count) {
  motion::Keyframe keyframe;
  keyframe_fields(session_count).read(view, keyframe);
  return keyframe;
}

motion::Pair pair_from_document(const DocumentView& view, std::size_t keyframe_count) {
  motion::Pair pair;
  pair_fields(keyframe_count).read(view, pair);
  return pair;
}

}  // namespace remount::formats
