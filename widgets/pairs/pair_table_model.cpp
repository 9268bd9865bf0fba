#include "widgets/pairs/pair_table_model.h"

#include <QBrush>
#include <QCoreApplication>
#include <QFont>
#include <algorithm>
#include <cmath>

#include "algorithms/core/stamps.h"
#include "algorithms/motion/pair.h"
#include "widgets/basics/rows.h"
#include "widgets/basics/theme.h"
#include "widgets/pairs/pair_measure.h"
#include "widgets/text/model_text.h"
#include "widgets/text/pair_reasons.h"

namespace remount::widgets {
namespace {

struct Heading {
  QString title, help;
};

struct TableText {
  Q_DECLARE_TR_FUNCTIONS(remount::widgets::PairTableModel)
};

/// What judges a pair comes first, what names it last: the table is wider than the window.
Heading heading(int column) {
  switch (column) {
    case PairTableModel::State:
      return {TableText::tr("State"), TableText::tr("What was decided about the pair, and by whom")};
    case PairTableModel::Note:
      return {TableText::tr("Note"), TableText::tr("Your flag and your comment")};
    case PairTableModel::ResidualTranslation:
      return {TableText::tr("Δpos [cm]"), TableText::tr("Translation residual of P X = X Q under the present result")};
    case PairTableModel::ResidualRotation:
      return {TableText::tr("Δrot [°]"), TableText::tr("Rotation residual of P X = X Q under the present result")};
    case PairTableModel::Rmse:
      return {TableText::tr("RMSE [cm]"), TableText::tr("Of the inlier residuals of the alignment")};
    case PairTableModel::Overlap:
      return {TableText::tr("Overlap"),
              TableText::tr("Share of points of scan a with a neighbour in scan b after alignment")};
    case PairTableModel::Screw:
      return {
          TableText::tr("INS–LiDAR [σ]"),
          TableText::tr("How much INS and LiDAR motion differ in turn and advance, whatever the mounting (screw test); "
                        "in sigma")};
    case PairTableModel::Weight:
      return {TableText::tr("Weight"), TableText::tr("Robust weight of the pair in the solution, 0 to 1")};
    case PairTableModel::Shared:
      return {TableText::tr("Objects"),
              TableText::tr("Static objects that both scans contain; moving ones after the plus sign")};
    case PairTableModel::Baseline:
      return {TableText::tr("Base [m]"), TableText::tr("Distance between the two INS positions")};
    case PairTableModel::Rotation:
      return {TableText::tr("Turn [°]"), TableText::tr("Angle between the two INS attitudes")};
    case PairTableModel::Gap:
      return {TableText::tr("Gap [s]"), TableText::tr("Time between the two scans")};
    case PairTableModel::TimeA:
      return {TableText::tr("a [s]"), TableText::tr("Time of scan a since the session's first keyframe")};
    case PairTableModel::TimeB:
      return {TableText::tr("b [s]"), TableText::tr("Time of scan b since the session's first keyframe")};
    case PairTableModel::SessionName:
      return {TableText::tr("Session"), TableText::tr("Drive the pair is from")};
    case PairTableModel::Reason:
      return {TableText::tr("Reason"), TableText::tr("Why the pair was rejected or accepted")};
    default:
      return {QStringLiteral("#"), TableText::tr("Number of the pair")};
  }
}

bool same_pairs(const pipeline::PipelineOutput& first, const pipeline::PipelineOutput& second) {
  return first.keyframes.size() == second.keyframes.size() &&
         std::equal(first.pairs.begin(), first.pairs.end(), second.pairs.begin(), second.pairs.end(),
                    [](const motion::Pair& a, const motion::Pair& b) {
                      return a.keyframe_a == b.keyframe_a && a.keyframe_b == b.keyframe_b;
                    });
}

std::vector<std::int64_t> session_starts_ns(const pipeline::PipelineOutput& output) {
  std::vector<std::int64_t> starts;
  for (const motion::Keyframe& keyframe : output.keyframes) {
    const motion::SessionIndex session = keyframe.session;
    if (starts.size() <= session) starts.resize(session + 1, std::numeric_limits<std::int64_t>::max());
    starts[session] = std::min(starts[session], keyframe.stamp_ns);
  }
  return starts;
}

}  // namespace

void PairTableModel::show_output(std::shared_ptr<const pipeline::PipelineOutput> output,
                                 const QStringList& session_names) {
  const bool keep = output && output_ && same_pairs(*output, *output_);
  if (!keep) beginResetModel();
  output_ = std::move(output);
  reason_texts_ = output_ ? std::make_unique<ReasonTexts>(output_, window_language()) : nullptr;
  session_names_ = session_names;
  session_start_ns_ = output_ ? session_starts_ns(*output_) : std::vector<std::int64_t>{};
  if (!keep) {
    endResetModel();
  } else if (rowCount() > 0) {
    emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
  }
}

void PairTableModel::show_marks(PairMarksPtr marks) {
  marks_ = std::move(marks);
  if (rowCount() > 0) emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1), {Qt::FontRole});
}

const PairMark& PairTableModel::mark_of(motion::PairIndex pair) const {
  static const PairMark none;
  return marks_ && pair < marks_->size() ? (*marks_)[pair] : none;
}

void PairTableModel::set_palette(const QPalette& palette) {
  palette_ = palette;
  if (rowCount() > 0) emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1), {Qt::ForegroundRole});
}

const motion::Pair* PairTableModel::pair(motion::PairIndex index) const {
  return output_ && index < output_->pairs.size() ? &output_->pairs[index] : nullptr;
}

int PairTableModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() || !output_ ? 0 : qt_count(output_->pairs.size());
}

int PairTableModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : ColumnCount; }

double PairTableModel::time_in_session_s(motion::KeyframeIndex keyframe) const {
  const motion::Keyframe& chosen = output_->keyframes.at(keyframe);
  return seconds(chosen.stamp_ns - session_start_ns_.at(chosen.session));
}

motion::SessionIndex PairTableModel::session_of(const motion::Pair& pair) const {
  return output_->keyframes.at(pair.keyframe_a).session;
}

QString PairTableModel::session_name(const motion::Pair& pair) const {
  const motion::SessionIndex session = session_of(pair);
  return session_names_.value(qt_row(session), QString::number(session));
}

double PairTableModel::sort_number(motion::PairIndex index, int column) const {
  const motion::Pair& pair = output_->pairs.at(index);
  const auto value = [&](PairMeasure measure) { return measured(pair, measure).value_or(std::nan("")); };
  switch (column) {
    case SessionName:
      return qt_row(session_of(pair));
    case TimeA:
      return time_in_session_s(pair.keyframe_a);
    case TimeB:
      return time_in_session_s(pair.keyframe_b);
    case Gap:
      return pair.gap_s;
    case Baseline:
      return pair.baseline_m;
    case Rotation:
      return radians_to_degrees(pair.rotation_rad);
    case Shared:
      return is_from_poses(pair) ? std::nan("") : pair.shared_objects;
    case Overlap:
      if (is_from_poses(pair)) return std::nan("");
      return is_aligned(pair) || pair.registration.overlap > 0.0 ? 100.0 * pair.registration.overlap : std::nan("");
    case Rmse:
      return value(PairMeasure::Rmse);
    case Screw:
      return value(PairMeasure::Screw);
    case ResidualRotation:
      return value(PairMeasure::ResidualRotation);
    case ResidualTranslation:
      return value(PairMeasure::ResidualTranslation);
    case Weight:
      return pair.state == motion::PairState::Accepted ? pair.weight : std::nan("");
    case State:
      return 3 * static_cast<int>(pair.state) + static_cast<int>(pair.decided_by);
    case Note:
      return mark_of(index).flagged ? 0.0 : mark_of(index).comment.isEmpty() ? std::nan("") : 1.0;
    default:
      return qt_row(index);
  }
}

QString PairTableModel::display(motion::PairIndex index, int column) const {
  const motion::Pair& pair = output_->pairs.at(index);
  switch (column) {
    case Number:
      return QString::number(index);
    case SessionName:
      return session_name(pair);
    case State:
      return state_text(pair);
    case Reason:
      return reason_words(pair.reason);
    case Note:
      return (mark_of(index).flagged ? QStringLiteral("⚑ ") : QString()) + mark_of(index).comment;
    case Shared:
      if (is_from_poses(pair)) return QStringLiteral("–");
      return pair.moving_objects > 0 ? tr("%1 + %2 moving").arg(pair.shared_objects).arg(pair.moving_objects)
                                     : QString::number(pair.shared_objects);
    default:
      break;
  }
  const double value = sort_number(index, column);
  if (!std::isfinite(value)) return QStringLiteral("–");
  if (column == Overlap) return tr("%1 %").arg(value, 0, 'f', 0);
  const bool coarse = column == Screw || column == Rmse || column == ResidualTranslation;
  return QString::number(value, 'f', coarse ? 1 : column == ResidualRotation ? 3 : 2);
}

QVariant PairTableModel::tool_tip(const motion::Pair& pair, int column) const {
  if (column == Reason || column == State) return reason_words(pair.reason);
  const bool of_alignment = column == Overlap || column == Rmse || column == Screw || column == ResidualTranslation ||
                            column == ResidualRotation;
  if (!of_alignment || is_aligned(pair)) return {};
  return tr("The two scans were not aligned: %1").arg(model_text(motion::unusable_reason(pair)));
}

QVariant PairTableModel::data(const QModelIndex& index, int role) const {
  const std::optional<motion::PairIndex> place = at_row<motion::PairIndex>(index.row());
  const motion::Pair* chosen = place ? pair(*place) : nullptr;
  if (!chosen) return {};
  const int column = index.column();
  switch (role) {
    case Qt::DisplayRole:
      return display(*place, column);
    case Qt::TextAlignmentRole: {
      const bool words = column == SessionName || column == State || column == Reason || column == Note;
      return QVariant::fromValue(Qt::Alignment(Qt::AlignVCenter | (words ? Qt::AlignLeft : Qt::AlignRight)));
    }
    case Qt::ForegroundRole:
      if (chosen->state == motion::PairState::Rejected || column == State)
        return QBrush(state_color(chosen->state, palette_));
      if (column == Screw && !chosen->screw.passed) return QBrush(bad_color(palette_));
      return {};
    case Qt::ToolTipRole:
      return column == Note ? QVariant(mark_of(*place).comment) : tool_tip(*chosen, column);
    case Qt::FontRole: {
      // As mail that was not read.
      QFont font;
      font.setBold(!mark_of(*place).seen);
      return column == Number ? QVariant(font) : QVariant();
    }
    default:
      return {};
  }
}

QVariant PairTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || section < 0 || section >= ColumnCount) return {};
  if (role == Qt::DisplayRole) return heading(section).title;
  if (role == Qt::ToolTipRole) return heading(section).help;
  return {};
}

}  // namespace remount::widgets
