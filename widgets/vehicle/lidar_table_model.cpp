#include "widgets/vehicle/lidar_table_model.h"

#include <QBrush>
#include <QFont>
#include <array>

#include "model/results/display_units.h"
#include "model/results/result_words.h"
#include "widgets/basics/rows.h"
#include "widgets/basics/swatch.h"
#include "widgets/basics/theme.h"
#include "widgets/result/result_panel.h"
#include "widgets/scene/lidar_colors.h"
#include "widgets/text/model_text.h"
#include "widgets/text/parameter_text.h"
#include "widgets/text/sentences.h"

namespace remount::widgets {
namespace {

calibration::Parameter parameter_of(int column) {
  return calibration::kParameters.at(index_at(column - LidarTableModel::X));
}

}  // namespace

void LidarTableModel::show_lidars(std::vector<LidarEntry> lidars) {
  const bool same_rows = lidars.size() == lidars_.size();
  if (!same_rows) beginResetModel();
  lidars_ = std::move(lidars);
  if (!same_rows)
    endResetModel();
  else if (!lidars_.empty())
    emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
}

void LidarTableModel::show_relative(std::optional<Relatives> relatives) {
  relatives_ = std::move(relatives);
  if (!lidars_.empty()) emit dataChanged(index(0, X), index(rowCount() - 1, ColumnCount - 1));
}

void LidarTableModel::set_palette(const QPalette& palette) {
  palette_ = palette;
  if (!lidars_.empty()) emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1), {Qt::ForegroundRole});
}

int LidarTableModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : qt_count(lidars_.size());
}

int LidarTableModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : ColumnCount; }

QString LidarTableModel::state_words(const LidarEntry& lidar) const {
  if (!lidar.output) return tr("not calibrated");
  const QString title = status_title(lidar.output->result);
  switch (lidar.standing) {
    case LidarEntry::Standing::Together:
      if (!lidar.problem.isEmpty()) return tr("✕ contradicts: %1").arg(title);
      return tr("%1, with the others").arg(title);
    case LidarEntry::Standing::LeftOut:
      return tr("✕ left out: %1").arg(title);
    case LidarEntry::Standing::ChangedSince:
      return tr("▲ changed since: %1").arg(title);
    default:
      return tr("%1, alone").arg(title);
  }
}

QColor LidarTableModel::state_color(const LidarEntry& lidar) const {
  if (!lidar.output) return faded_color(palette_);
  if (!calibration::is_usable(lidar.output->result) || lidar.standing == LidarEntry::Standing::LeftOut ||
      !lidar.problem.isEmpty())
    return bad_color(palette_);
  const bool ok = lidar.output->result.status == calibration::Status::Ok;
  // Nothing is wrong with one that was not yet solved together with others.
  if (ok && lidar.standing == LidarEntry::Standing::Alone) return palette_.color(QPalette::Text);
  return ok && lidar.standing == LidarEntry::Standing::Together ? good_color(palette_) : warning_color(palette_);
}

QString LidarTableModel::state_reason(const LidarEntry& lidar) const {
  if (!lidar.problem.isEmpty()) return lidar.problem;
  QStringList reason{model_text(lidar.output->result.message)};
  if (lidar.standing == LidarEntry::Standing::Alone)
    reason << tr("By itself: it has not been solved together with the others yet.");
  if (lidar.standing == LidarEntry::Standing::ChangedSince)
    reason << tr("Decisions, options or the nominal are others than when it was solved with the others.");
  return one_text(reason);
}

std::optional<LidarTableModel::Numbers> LidarTableModel::numbers(const LidarEntry& lidar) const {
  if (relatives_) {
    const auto relative = relatives_->find(lidar.name);
    return relative == relatives_->end() ? std::nullopt : std::optional(relative->second);
  }
  if (!lidar.output || !results::has_mounting(lidar.output->result) ||
      !lidar.output->result.mounting.is_of({calibration::BodyFrame::Ins, calibration::BodyFrame::Lidar}))
    return std::nullopt;
  Numbers numbers{lidar.output->result.mounting.reference_from_sensor, {}};
  for (const calibration::Parameter parameter : calibration::kParameters)
    numbers.sigma[parameter] = lidar.output->result.estimate(parameter).sigma;
  return numbers;
}

QString LidarTableModel::number(const LidarEntry& lidar, calibration::Parameter parameter) const {
  const std::optional<Numbers> shown = numbers(lidar);
  if (!shown) return QStringLiteral("–");
  if (!shown->sigma[parameter]) return tr("–\nnot observed");
  const double value = results::six_on_screen(shown->mounting)[parameter];
  const double sigma = results::on_screen(parameter, *shown->sigma[parameter]);
  const int decimals = std::clamp(results::justified_decimals(sigma), 3, 4);
  return QStringLiteral("%1\n%2").arg(rounded_text(value, decimals), spread_text(sigma, decimals));
}

QVariant LidarTableModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const LidarEntry& lidar = lidars_[index_at(index.row())];
  const int column = index.column();
  if (role == Qt::TextAlignmentRole)
    return QVariant::fromValue(Qt::Alignment(Qt::AlignVCenter | (column < X ? Qt::AlignLeft : Qt::AlignRight)));
  if (role == Qt::FontRole && lidar.shown) {
    QFont bold;
    bold.setBold(true);
    return bold;
  }
  if (column == Name) {
    if (role == Qt::CheckStateRole) return lidar.ticked ? Qt::Checked : Qt::Unchecked;
    if (role == Qt::DecorationRole) return to_qt(scene::lidar_color(index_at<motion::LidarIndex>(index.row())));
    if (role == Qt::DisplayRole) return lidar.shown ? tr("▶ %1").arg(lidar.name) : lidar.name;
    if (role == Qt::ToolTipRole)
      return lidar.shown ? tr("The other panels are about this LiDAR")
                         : tr("Double click: the other panels are about this LiDAR then");
    return {};
  }
  if (column == State) {
    if (role == Qt::DisplayRole) return state_words(lidar);
    if (role == Qt::ForegroundRole) return QBrush(state_color(lidar));
    if (role == Qt::ToolTipRole && lidar.output) return state_reason(lidar);
    return {};
  }
  if (role == Qt::DisplayRole) return number(lidar, parameter_of(column));
  return {};
}

bool LidarTableModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (!index.isValid() || index.column() != Name || role != Qt::CheckStateRole) return false;
  emit ticked(index_at<motion::LidarIndex>(index.row()), value.toInt() == Qt::Checked);
  return true;
}

Qt::ItemFlags LidarTableModel::flags(const QModelIndex& index) const {
  Qt::ItemFlags flags = QAbstractTableModel::flags(index);
  if (index.column() == Name) flags |= Qt::ItemIsUserCheckable;
  return flags;
}

QVariant LidarTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || section < 0 || section >= ColumnCount) return {};
  const std::array<QString, ColumnCount> titles{tr("LiDAR"), tr("State"),   tr("x [m]"),     tr("y [m]"),
                                                tr("z [m]"), tr("yaw [°]"), tr("pitch [°]"), tr("roll [°]")};
  if (role == Qt::DisplayRole) return titles[index_at(section)];
  if (role == Qt::ToolTipRole && section >= X) return tr("Value ± one sigma");
  return {};
}

}  // namespace remount::widgets
