// Pairs as a table, and the filter above it.
#pragma once

#include <QAbstractTableModel>
#include <QPalette>
#include <QSortFilterProxyModel>
#include <QStringList>
#include <memory>
#include <optional>

#include "model/pipeline.h"

namespace remount {

class PairTableModel : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column {
    Number,
    State,
    ResidualTranslation,
    ResidualRotation,
    Rmse,
    Overlap,
    Screw,
    Weight,
    Shared,
    Baseline,
    Rotation,
    Gap,
    TimeA,
    TimeB,
    SessionName,
    Reason,
    ColumnCount
  };
  enum Role { SortRole = Qt::UserRole };  ///< numbers for sorting; every cell has one

  using QAbstractTableModel::QAbstractTableModel;

  /// A snapshot of the calibration, or null. Where it holds the same pairs as before, selection and order stay.
  void show_output(std::shared_ptr<const PipelineOutput> output, const QStringList& session_names);
  void set_palette(const QPalette& palette);
  const Pair* pair(int row) const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  QVariant number(const Pair& pair, int row, int column) const;
  QString display(const Pair& pair, int row, int column) const;
  double time_in_session_s(int keyframe) const;

  std::shared_ptr<const PipelineOutput> output_;
  std::vector<std::int64_t> session_start_ns_;
  QStringList session_names_;
  QPalette palette_;
};

/// Sorts by number and filters by state and by text in any column.
class PairFilter : public QSortFilterProxyModel {
  Q_OBJECT
 public:
  explicit PairFilter(QObject* parent = nullptr);
  void set_state(std::optional<PairState> state);
  void set_text(const QString& text);

 protected:
  bool filterAcceptsRow(int source_row, const QModelIndex& source_parent) const override;

 private:
  std::optional<PairState> state_;
  QString text_;
};

}  // namespace remount
