// Pairs and the user's decisions about them.
#pragma once

#include "app/gui/shell/feature.h"
#include "model/pipeline/pipeline.h"

class QAction;
class QDockWidget;
class QItemSelectionModel;
class QMenu;
class QTimer;

namespace remount::widgets {
class ErrorChartPanel;
class PairFilter;
class PairTableModel;
class PairsPanel;
}  // namespace remount::widgets

namespace remount::gui {

enum class MenuPlace;

class PairsFeature : public Feature {
  Q_OBJECT
 public:
  explicit PairsFeature(MainWindow& window);
  void show_output() override;
  std::vector<TurnQueue::Piece> show_output_later() override;
  void show_state() override;
  void show_palette(const QPalette& palette) override;
  void take_over(Kept* kept) override;
  /// Enabled while there are pairs to review. `id`: by which its key is remembered.
  QAction* add_review(MenuPlace place, const QString& id, const QString& text, const QKeySequence& key,
                      const std::function<void()>& act);
  /// In which keys are for the pair that is looked at.
  QList<QWidget*> key_widgets() const;
  widgets::PairFilter& filter() const;  ///< the pairs of the table, in its order
  QItemSelectionModel& marked() const;  ///< in the table

 private:
  void make_docks();
  void make_menu();
  void make_reason_menu();
  void connect_panels();
  void review_pairs();
  std::vector<motion::PairIndex> pairs_to_decide() const;
  void decide(motion::PairState state, const Message& reason = {});
  void ask_reason();
  void ask_comment();
  void make_notes_menu();
  void make_player();
  void reject_above(const std::vector<motion::PairIndex>& pairs, const QString& reason);
  void go(int step, bool undecided);
  void prepare_neighbours();
  void show_errors();
  void show_marks();

  widgets::PairTableModel* model_;
  widgets::PairsPanel* pairs_;
  widgets::ErrorChartPanel* errors_;
  QDockWidget* dock_ = nullptr;
  std::vector<QAction*> review_actions_;  // that need a calibration
  QAction* goes_on_ = nullptr;            // to the next pair after a decision
  QAction* plays_ = nullptr;
  QTimer* player_ = nullptr;
  bool was_busy_ = false;
};

}  // namespace remount::gui
