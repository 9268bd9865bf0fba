#include "widgets/vehicle/cross_pair_table_model.h"

#include <QBrush>
#include <array>
#include <cmath>

#include "widgets/basics/rows.h"
#include "widgets/basics/theme.h"
#include "widgets/pairs/pair_measure.h"
#include "widgets/text/pair_reasons.h"

namespace remount::widgets {

void CrossPairTableModel::show_pairs(std::vector<calibration::CrossPair> pairs, const QStringList& names) {
  beginResetModel();
  pairs_ = std::move(pairs);
  names_ = names;
  endResetModel();
}

void CrossPairTableModel::set_palette(const QPalette& palette) {
  palette_ = palette;
  if (!pairs_.empty()) emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1), {Qt::ForegroundRole});
}

QString CrossPairTableModel::name(motion::LidarIndex lidar) const { return names_.value(qt_row(lidar)); }

int CrossPairTableModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : qt_count(pairs_.size());
}

int CrossPairTableModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : ColumnCount; }

double CrossPairTableModel::number(const calibration::CrossPair& cross, int column) const {
  const motion::Pair& pair = cross.pair;
  const auto value = [&](PairMeasure measure) { return measured(pair, measure).value_or(std::nan("")); };
  switch (column) {
    case LidarA:
      return qt_row(cross.lidar_a);
    case LidarB:
      return qt_row(cross.lidar_b);
    case State:
      return static_cast<int>(pair.state);
    case ResidualTranslation:
      return value(PairMeasure::ResidualTranslation);
    case ResidualRotation:
      return value(PairMeasure::ResidualRotation);
    case Rmse:
      return value(PairMeasure::Rmse);
    case Overlap:
      return pair.registration.attempted ? 100.0 * pair.registration.overlap : std::nan("");
    case Gap:
      return pair.gap_s;
    default:
      return 0.0;
  }
}

QString CrossPairTableModel::display(const calibration::CrossPair& cross, int column) const {
  if (column == LidarA) return name(cross.lidar_a);
  if (column == LidarB) return name(cross.lidar_b);
  if (column == State) return state_text(cross.pair);
  if (column == Reason) return reason_words(cross.pair.reason);
  const double value = number(cross, column);
  if (!std::isfinite(value)) return QStringLiteral("–");
  if (column == Overlap) return tr("%1 %").arg(value, 0, 'f', 0);
  return QString::number(value, 'f', column == ResidualRotation ? 3 : column == Gap ? 2 : 1);
}

QVariant CrossPairTableModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const calibration::CrossPair& cross = pairs_[index_at(index.row())];
  const int column = index.column();
  const bool words = column == LidarA || column == LidarB || column == State || column == Reason;
  switch (role) {
    case Qt::DisplayRole:
      return display(cross, column);
    case SortRole:
      return column == Reason ? QVariant(display(cross, column)) : QVariant(number(cross, column));
    case Qt::ToolTipRole:
      return reason_words(cross.pair.reason);
    case Qt::ForegroundRole:
      return column == State ? QVariant(QBrush(state_color(cross.pair.state, palette_))) : QVariant();
    case Qt::TextAlignmentRole:
      return QVariant::fromValue(Qt::Alignment(Qt::AlignVCenter | (words ? Qt::AlignLeft : Qt::AlignRight)));
    default:
      return {};
  }
}

QVariant CrossPairTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || section < 0 || section >= ColumnCount || role != Qt::DisplayRole) return {};
  const std::array<QString, ColumnCount> titles{tr("LiDAR a"),   tr("LiDAR b"),  tr("State"),
                                                tr("Δpos [cm]"), tr("Δrot [°]"), tr("RMSE [cm]"),
                                                tr("Overlap"),   tr("Gap [s]"),  tr("Reason")};
  return titles[index_at(section)];
}

}  // namespace remount::widgets
