// Ranked candidates as a table.
#pragma once

#include <QAbstractTableModel>
#include <QPalette>
#include <memory>
#include <optional>

#include "model/pipeline/pipeline.h"

namespace remount::widgets {

/// Place of the candidate that became the result in its list; nothing where nothing was solved, or it is not listed.
std::optional<calibration::CandidateIndex> place_of_result(const calibration::CalibrationResult& result);

class CandidateTableModel : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { Rank, Source, X, Y, Z, Yaw, Pitch, Roll, ErrorSum, InRange, ColumnCount };
  enum Role { SortRole = Qt::UserRole };

  using QAbstractTableModel::QAbstractTableModel;
  void show_output(std::shared_ptr<const pipeline::PipelineOutput> output);
  /// Row of the candidate that became the result; -1 where there is no result, or it is not listed.
  int result_row() const { return result_row_; }
  void set_palette(const QPalette& palette);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  std::shared_ptr<const pipeline::PipelineOutput> output_;
  int result_row_ = -1;
  QPalette palette_;
};

}  // namespace remount::widgets
