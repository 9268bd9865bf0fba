#include "widgets/itemmodels/pair_table_model.h"

#include <QBrush>
#include <QCoreApplication>
#include <algorithm>

#include "widgets/theme.h"

namespace remount {
namespace {

struct Heading {
  QString title, help;
};

QString words(const char* text) { return QCoreApplication::translate("remount::PairTableModel", text); }

/// What judges a pair comes first, what names it last: the table is wider than the window.
Heading heading(int column) {
  switch (column) {
    case PairTableModel::State:
      return {words("State"), words("A accepts, R rejects the marked pairs")};
    case PairTableModel::ResidualTranslation:
      return {words("Δt [cm]"), words("Translation residual of P X = X Q under the present result")};
    case PairTableModel::ResidualRotation:
      return {words("Δrot [°]"), words("Rotation residual of P X = X Q under the present result")};
    case PairTableModel::Rmse:
      return {words("RMSE [cm]"), words("Of the inlier residuals of the alignment")};
    case PairTableModel::Overlap:
      return {words("Overlap"), words("Share of points of scan a with a neighbour in scan b after alignment")};
    case PairTableModel::Screw:
      return {words("Screw [σ]"),
              words("How much INS and LiDAR motion differ in turn and advance, whatever the mounting; in sigma")};
    case PairTableModel::Weight:
      return {words("Weight"), words("Robust weight of the pair in the solution, 0 to 1")};
    case PairTableModel::Shared:
      return {words("Objects"), words("Static objects that both scans contain; moving ones after the plus sign")};
    case PairTableModel::Baseline:
      return {words("Base [m]"), words("Distance between the two INS positions")};
    case PairTableModel::Rotation:
      return {words("Turn [°]"), words("Angle between the two INS attitudes")};
    case PairTableModel::Gap:
      return {words("Gap [s]"), words("Time between the two scans")};
    case PairTableModel::TimeA:
      return {words("a [s]"), words("Time of scan a since the session's first keyframe")};
    case PairTableModel::TimeB:
      return {words("b [s]"), words("Time of scan b since the session's first keyframe")};
    case PairTableModel::SessionName:
      return {words("Session"), words("Drive the pair is from")};
    case PairTableModel::Reason:
      return {words("Reason"), words("Why the pair was rejected or accepted")};
    default:
      return {QStringLiteral("#"), words("Number of the pair")};
  }
}

bool same_pairs(const PipelineOutput& first, const PipelineOutput& second) {
  return first.keyframes.size() == second.keyframes.size() &&
         std::equal(
             first.pairs.begin(), first.pairs.end(), second.pairs.begin(), second.pairs.end(),
             [](const Pair& a, const Pair& b) { return a.keyframe_a == b.keyframe_a && a.keyframe_b == b.keyframe_b; });
}

std::vector<std::int64_t> session_starts_ns(const PipelineOutput& output) {
  std::vector<std::int64_t> starts;
  for (const Keyframe& keyframe : output.keyframes) {
    const auto session = static_cast<std::size_t>(std::max(0, keyframe.session));
    if (starts.size() <= session) starts.resize(session + 1, std::numeric_limits<std::int64_t>::max());
    starts[session] = std::min(starts[session], keyframe.stamp_ns);
  }
  return starts;
}

}  // namespace

void PairTableModel::show_output(std::shared_ptr<const PipelineOutput> output, const QStringList& session_names) {
  const bool keep = output && output_ && same_pairs(*output, *output_);
  if (!keep) beginResetModel();
  output_ = std::move(output);
  session_names_ = session_names;
  session_start_ns_ = output_ ? session_starts_ns(*output_) : std::vector<std::int64_t>{};
  if (!keep) {
    endResetModel();
  } else if (rowCount() > 0) {
    emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
  }
}

void PairTableModel::set_palette(const QPalette& palette) {
  palette_ = palette;
  if (rowCount() > 0) emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1), {Qt::ForegroundRole});
}

const Pair* PairTableModel::pair(int row) const {
  if (!output_ || row < 0 || static_cast<std::size_t>(row) >= output_->pairs.size()) return nullptr;
  return &output_->pairs[static_cast<std::size_t>(row)];
}

int PairTableModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() || !output_ ? 0 : static_cast<int>(output_->pairs.size());
}

int PairTableModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : ColumnCount; }

double PairTableModel::time_in_session_s(int keyframe) const {
  const Keyframe& chosen = output_->keyframes.at(static_cast<std::size_t>(keyframe));
  return 1e-9 * static_cast<double>(chosen.stamp_ns - session_start_ns_.at(static_cast<std::size_t>(chosen.session)));
}

QVariant PairTableModel::number(const Pair& pair, int row, int column) const {
  switch (column) {
    case SessionName:
      return output_->keyframes.at(static_cast<std::size_t>(pair.keyframe_a)).session;
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
      return pair.shared_objects;
    case Overlap:
      return pair.registration.attempted ? pair.registration.overlap : -1.0;
    case Rmse:
      return pair.registration.attempted ? 100.0 * pair.registration.rmse_m : 1e9;
    case Screw:
      return pair.screw.score;
    case ResidualRotation:
      return radians_to_degrees(pair.residual_rotation_rad);
    case ResidualTranslation:
      return 100.0 * pair.residual_translation_m;
    case Weight:
      return pair.state == PairState::Accepted ? pair.weight : 0.0;
    case State:
      return static_cast<int>(pair.state);
    case Reason:
      return QString::fromStdString(pair.reason);
    default:
      return row;
  }
}

QString PairTableModel::display(const Pair& pair, int row, int column) const {
  const auto fixed = [](double value, int decimals) { return QString::number(value, 'f', decimals); };
  const QString none = QStringLiteral("–");
  const double value = number(pair, row, column).toDouble();
  switch (column) {
    case SessionName:
      return session_names_.value(static_cast<int>(value), QString::number(static_cast<int>(value)));
    case TimeA:
    case TimeB:
    case Gap:
    case Baseline:
      return fixed(value, 2);
    case Weight:
      return pair.state == PairState::Accepted ? fixed(value, 2) : none;
    case Rotation:
    case Screw:
      return fixed(value, column == Screw ? 1 : 2);
    case ResidualRotation:
      return fixed(value, 3);
    case ResidualTranslation:
      return fixed(value, 1);
    case Shared:
      return pair.moving_objects > 0 ? tr("%1 + %2 moving").arg(pair.shared_objects).arg(pair.moving_objects)
                                     : QString::number(pair.shared_objects);
    case Overlap:
      return pair.registration.attempted ? tr("%1 %").arg(fixed(100.0 * value, 0)) : none;
    case Rmse:
      return pair.registration.attempted ? fixed(value, 1) : none;
    case State:
      return state_text(pair);
    case Reason:
      return QString::fromStdString(pair.reason);
    default:
      return QString::number(row);
  }
}

QVariant PairTableModel::data(const QModelIndex& index, int role) const {
  const Pair* chosen = index.isValid() ? pair(index.row()) : nullptr;
  if (!chosen) return {};
  const int column = index.column();
  switch (role) {
    case Qt::DisplayRole:
      return display(*chosen, index.row(), column);
    case SortRole:
      return number(*chosen, index.row(), column);
    case Qt::TextAlignmentRole: {
      const bool words = column == SessionName || column == State || column == Reason;
      return QVariant::fromValue(Qt::Alignment(Qt::AlignVCenter | (words ? Qt::AlignLeft : Qt::AlignRight)));
    }
    case Qt::ForegroundRole:
      if (chosen->state == PairState::Rejected || column == State) return QBrush(state_color(chosen->state, palette_));
      if (column == Screw && !chosen->screw.passed) return QBrush(bad_color(palette_));
      return {};
    case Qt::ToolTipRole: {
      const QString failure = QString::fromStdString(chosen->registration.failure);
      if ((column == Overlap || column == Rmse) && !failure.isEmpty()) return failure;
      return column == Reason || column == State ? QVariant(QString::fromStdString(chosen->reason)) : QVariant();
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

PairFilter::PairFilter(QObject* parent) : QSortFilterProxyModel(parent) {
  setSortRole(PairTableModel::SortRole);
  setSortLocaleAware(true);
}

void PairFilter::set_state(std::optional<PairState> state) {
  state_ = state;
  invalidateFilter();
}

void PairFilter::set_text(const QString& text) {
  text_ = text.trimmed();
  invalidateFilter();
}

bool PairFilter::filterAcceptsRow(int source_row, const QModelIndex& source_parent) const {
  const auto* model = static_cast<const PairTableModel*>(sourceModel());
  const Pair* pair = model->pair(source_row);
  if (!pair || (state_ && pair->state != *state_)) return false;
  if (text_.isEmpty()) return true;
  for (int column = 0; column < PairTableModel::ColumnCount; ++column) {
    const QModelIndex cell = model->index(source_row, column, source_parent);
    if (model->data(cell, Qt::DisplayRole).toString().contains(text_, Qt::CaseInsensitive)) return true;
  }
  return false;
}

}  // namespace remount
