// Pairs as a table.
#pragma once

#include <QAbstractTableModel>
#include <QPalette>
#include <QStringList>
#include <memory>

#include "model/pipeline/pipeline.h"
#include "widgets/pairs/pair_mark.h"
#include "widgets/pairs/reason_texts.h"

namespace remount::widgets {

class PairTableModel : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column {
    Number,
    State,
    Note,
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

  using QAbstractTableModel::QAbstractTableModel;

  /// A snapshot of the calibration, or null. Where it holds the same pairs as before, selection and order stay.
  void show_output(std::shared_ptr<const pipeline::PipelineOutput> output, const QStringList& session_names);
  /// Of each pair of the output, changed where they are.
  void show_marks(PairMarksPtr marks);
  const PairMark& mark_of(motion::PairIndex pair) const;
  void set_palette(const QPalette& palette);
  /// Null where the output that is shown has no such pair.
  const motion::Pair* pair(motion::PairIndex index) const;
  /// The number of a cell, in the unit of the screen; NaN where it is not known, as where scans were never aligned.
  double sort_number(motion::PairIndex index, int column) const;
  /// Of an output that is shown.
  const ReasonTexts& reason_texts() const { return *reason_texts_; }
  motion::SessionIndex session_of(const motion::Pair& pair) const;
  QString session_name(const motion::Pair& pair) const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  QString display(motion::PairIndex index, int column) const;
  QVariant tool_tip(const motion::Pair& pair, int column) const;
  double time_in_session_s(motion::KeyframeIndex keyframe) const;

  std::shared_ptr<const pipeline::PipelineOutput> output_;
  std::unique_ptr<ReasonTexts> reason_texts_;
  std::vector<std::int64_t> session_start_ns_;
  QStringList session_names_;
  PairMarksPtr marks_;
  QPalette palette_;
};

}  // namespace remount::widgets
