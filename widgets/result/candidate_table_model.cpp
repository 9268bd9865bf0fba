#include "widgets/result/candidate_table_model.h"

#include <QBrush>
#include <QFont>
#include <array>

#include "algorithms/core/index.h"
#include "model/results/display_units.h"
#include "widgets/basics/rows.h"
#include "widgets/basics/theme.h"
#include "widgets/text/model_text.h"
#include "widgets/text/parameter_text.h"

namespace remount::widgets {
namespace {

double shown_number(const calibration::Candidate& candidate, int column) {
  if (column < CandidateTableModel::X || column > CandidateTableModel::Roll) return candidate.frobenius_sum;
  return results::six_on_screen(
      candidate.ins_from_lidar)[calibration::kParameters.at(index_at(column - CandidateTableModel::X))];
}

}  // namespace

std::optional<calibration::CandidateIndex> place_of_result(const calibration::CalibrationResult& result) {
  if (!calibration::is_solved(result.status) && result.status != calibration::Status::Inconsistent) return std::nullopt;
  constexpr double kSame = 1e-9;  // what a file holds is rounded
  for (calibration::CandidateIndex i; i < result.candidates.size(); ++i)
    if (difference(result.candidates[i].ins_from_lidar, result.mounting.reference_from_sensor).norm() < kSame) return i;
  return std::nullopt;
}

void CandidateTableModel::show_output(std::shared_ptr<const pipeline::PipelineOutput> output) {
  beginResetModel();
  output_ = std::move(output);
  result_row_ = output_ ? qt_row(place_of_result(output_->result)) : -1;
  endResetModel();
}

void CandidateTableModel::set_palette(const QPalette& palette) {
  palette_ = palette;
  if (rowCount() > 0) emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1), {Qt::ForegroundRole});
}

int CandidateTableModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() || !output_ ? 0 : qt_count(output_->result.candidates.size());
}

int CandidateTableModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : ColumnCount; }

QVariant CandidateTableModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const calibration::Candidate& candidate = output_->result.candidates[index_at(index.row())];
  const int column = index.column();
  const bool words = column == Source || column == InRange;
  if (role == Qt::TextAlignmentRole)
    return QVariant::fromValue(Qt::Alignment(Qt::AlignVCenter | (words ? Qt::AlignLeft : Qt::AlignRight)));
  const bool is_result = index.row() == result_row_;
  if (role == Qt::FontRole && is_result) {
    QFont bold;
    bold.setBold(true);
    return bold;
  }
  if (role == Qt::BackgroundRole && is_result) return QBrush(tint(good_color(palette_), palette_));
  if (role == Qt::ToolTipRole && is_result)
    return tr(
        "This is the result. It weighs every pair by its noise; another candidate may have a smaller error sum, which "
        "counts all pairs alike.");
  if (role == Qt::ForegroundRole && !candidate.in_range)
    return QBrush(palette_.color(QPalette::Disabled, QPalette::Text));
  if (role == Qt::ToolTipRole && !candidate.in_range) return model_text(candidate.out_of_range);
  if (role != Qt::DisplayRole && role != SortRole) return {};
  switch (column) {
    case Rank:
      if (role == SortRole) return index.row();
      return candidate.in_range ? QString::number(index.row() + 1) : QStringLiteral("–");
    case Source:
      return is_result && role == Qt::DisplayRole
                 ? tr("✓ %1 (the result)").arg(model_text(calibration::in_words(candidate.source)))
                 : model_text(calibration::in_words(candidate.source));
    case InRange:
      if (role == SortRole) return candidate.in_range ? 0 : 1;
      return candidate.in_range ? tr("in range") : tr("out of range: %1").arg(model_text(candidate.out_of_range));
    default:
      break;
  }
  const double value = shown_number(candidate, column);
  return role == SortRole ? QVariant(value) : QVariant(rounded_text(value, column == ErrorSum ? 4 : 3));
}

QVariant CandidateTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || section < 0 || section >= ColumnCount) return {};
  const std::array<QString, ColumnCount> titles{tr("Rank"),      tr("Source"),      tr("x [m]"),     tr("y [m]"),
                                                tr("z [m]"),     tr("yaw [°]"),     tr("pitch [°]"), tr("roll [°]"),
                                                tr("Error sum"), tr("Search range")};
  if (role == Qt::DisplayRole) return titles[index_at(section)];
  if (role == Qt::ToolTipRole && section == ErrorSum)
    return tr(
        "How far the accepted pairs are from this mounting X, all together. E(X): sum of ‖P X − X Q‖ (Frobenius norm, "
        "translation over the characteristic length)");
  return {};
}

}  // namespace remount::widgets
