// Pairs across LiDARs as a table.
#pragma once

#include <QAbstractTableModel>
#include <QPalette>
#include <QStringList>
#include <vector>

#include "algorithms/calibration/rig/rig.h"

namespace remount::widgets {

using CrossPairIndex = Index<calibration::CrossPair>;  ///< among the pairs across LiDARs

class CrossPairTableModel : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { LidarA, LidarB, State, ResidualTranslation, ResidualRotation, Rmse, Overlap, Gap, Reason, ColumnCount };
  enum Role { SortRole = Qt::UserRole };

  using QAbstractTableModel::QAbstractTableModel;
  /// @param names of the LiDARs that the pairs name by their places
  void show_pairs(std::vector<calibration::CrossPair> pairs, const QStringList& names);
  void set_palette(const QPalette& palette);
  const std::vector<calibration::CrossPair>& pairs() const { return pairs_; }
  QString name(motion::LidarIndex lidar) const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  double number(const calibration::CrossPair& cross, int column) const;
  QString display(const calibration::CrossPair& cross, int column) const;

  std::vector<calibration::CrossPair> pairs_;
  QStringList names_;
  QPalette palette_;
};

}  // namespace remount::widgets
