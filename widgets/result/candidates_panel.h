// Ranked candidates: a table, and two plots of the same points.
#pragma once

#include <QWidget>
#include <memory>
#include <optional>

#include "widgets/result/candidate_plot.h"

class QLabel;
class QSortFilterProxyModel;
class QTableView;

namespace remount::widgets {

class CandidateTableModel;

/// What is pointed at in one plot is selected in the other and in the table.
class CandidatesPanel : public QWidget {
  Q_OBJECT
 public:
  explicit CandidatesPanel(CandidateTableModel& model, QWidget* parent = nullptr);
  void show_output(std::shared_ptr<const pipeline::PipelineOutput> output);
  void show_range(const calibration::SearchRange& range);
  void show_nominal(const std::optional<RigidTransform>& nominal_ins_from_lidar);
  void select(calibration::CandidateIndex candidate);
  std::optional<calibration::CandidateIndex> selected() const { return position_->selected(); }
  QTableView* table() const { return table_; }
  CandidatePlot* position() const { return position_; }
  CandidatePlot* attitude() const { return attitude_; }

 signals:
  void candidate_selected(calibration::CandidateIndex candidate);

 private:
  void make_table();
  QWidget* make_left();
  CandidateTableModel& model_;
  QSortFilterProxyModel* sorted_;
  QTableView* table_;
  CandidatePlot *position_, *attitude_;
  QLabel *note_, *legend_;  // note: why the result is not the first
  bool sized_ = false;
};

}  // namespace remount::widgets
