// Ranked candidates as a table.
#pragma once

#include <QAbstractTableModel>
#include <QPalette>
#include <memory>

#include "model/pipeline.h"

namespace remount {

class CandidateTableModel : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { Rank, Source, X, Y, Z, Yaw, Pitch, Roll, ErrorSum, InRange, ColumnCount };
  enum Role { SortRole = Qt::UserRole };

  using QAbstractTableModel::QAbstractTableModel;
  void show_output(std::shared_ptr<const PipelineOutput> output);
  void set_palette(const QPalette& palette);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  std::shared_ptr<const PipelineOutput> output_;
  QPalette palette_;
};

}  // namespace remount
