// The table of pairs with its filter, and the bar chart beside it.
#pragma once

#include <QWidget>

#include "widgets/itemmodels/pair_table_model.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableView;

namespace remount {

class ErrorBarChart;

class PairsPanel : public QWidget {
  Q_OBJECT
 public:
  explicit PairsPanel(PairTableModel& model, QWidget* parent = nullptr);
  void show_output(std::shared_ptr<const PipelineOutput> output);
  void show_selected(int pair);
  /// Pairs marked in the table (several with Ctrl or Shift), ascending; at least the current one.
  std::vector<int> marked_pairs() const;
  /// The pair that follows (step 1) or precedes (step -1) in the order shown; -1 where there is none. With
  /// `undecided` only pairs that the user has not decided count.
  int neighbour(int step, bool undecided) const;
  QTableView* table() const { return table_; }
  ErrorBarChart* chart() const { return chart_; }

 signals:
  void pair_selected(int pair);
  void accept_clicked();
  void reject_clicked();

 private:
  QWidget* make_filter_row();
  QWidget* make_chart_side();
  void update_count();

  PairTableModel& model_;
  PairFilter* filter_;
  QTableView* table_;
  ErrorBarChart* chart_;
  QComboBox* state_;
  QLineEdit* text_;
  QLabel* count_ = nullptr;
  QPushButton *accept_ = nullptr, *reject_ = nullptr;
};

}  // namespace remount
