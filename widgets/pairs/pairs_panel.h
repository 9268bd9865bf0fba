// The table of pairs with its filter and what can be done with the marked ones.
#pragma once

#include <QWidget>
#include <optional>

#include "widgets/pairs/pair_filter.h"

class QComboBox;
class QHBoxLayout;
class QLabel;
class QLineEdit;
class QMenu;
class QPushButton;
class QTableView;
class QToolButton;

namespace remount::widgets {

class PairsPanel : public QWidget {
  Q_OBJECT
 public:
  explicit PairsPanel(PairTableModel& model, QWidget* parent = nullptr);
  void show_output(std::shared_ptr<const pipeline::PipelineOutput> output);
  void show_selected(std::optional<motion::PairIndex> pair);
  void show_marks(PairMarksPtr marks, int seen);
  void add_tool(QWidget* tool);           ///< before the buttons that decide
  void set_measure(PairMeasure measure);  ///< of the worst
  /// Reasons for rejecting, beside the button.
  void set_reason_menu(QMenu* menu);
  /// Pairs marked in the table (several with Ctrl or Shift), ascending, where the one that is looked at is among them:
  /// a decision never meets pairs of which none is shown. Else that one alone; empty: none is looked at.
  std::vector<motion::PairIndex> marked_pairs() const;
  /// The pair that follows (step 1) or precedes (step -1) in the order shown; nothing where there is none. With
  /// `undecided` only pairs that the user has not decided count. Where the present pair is filtered away, its former
  /// place counts.
  std::optional<motion::PairIndex> neighbour(int step, bool undecided) const;
  /// The pairs so many rows from the present one, where there are any.
  std::vector<motion::PairIndex> neighbours(std::initializer_list<int> steps) const;
  QTableView* table() const { return table_; }
  PairFilter* filter() const { return filter_; }

 signals:
  void pair_selected(motion::PairIndex pair);
  void shown_changed();  ///< other pairs in the table, or in another order
  void accept_clicked();
  void reject_clicked();

 private:
  void make_table();
  void make_filters(QHBoxLayout& row);
  void make_buttons(QHBoxLayout& row);
  void apply_criteria();
  void update_count();
  void update_decisions();
  void extend_marks(int steps);
  bool eventFilter(QObject* watched, QEvent* event) override;

  PairTableModel& model_;
  PairFilter* filter_;
  QTableView* table_;
  QComboBox* state_;
  QComboBox* group_;
  QLineEdit* text_;
  QLabel* count_;
  QLabel* seen_;
  QToolButton* sort_again_;
  QHBoxLayout* tools_ = nullptr;
  QPushButton* accept_;
  QToolButton* reject_;
  std::optional<motion::PairIndex> selected_;
  int last_row_ = -1;
  int anchor_row_ = 0;  // from which Shift marks: of the row that was marked alone last
  bool sized_ = false;  // columns follow their contents once; afterwards they are the user's
};

}  // namespace remount::widgets
