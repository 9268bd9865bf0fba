// The residuals plot with what it shows, and what becomes of the pairs that are marked in it.
#pragma once

#include <QWidget>

#include "widgets/residuals/residual_plot.h"

class QBoxLayout;
class QComboBox;
class QLabel;
class QPushButton;

namespace remount::widgets {

/// What is chosen stands at the left of the plot where the panel is wide, above it where it is narrow.
class ResidualsPanel : public QWidget {
  Q_OBJECT
 public:
  explicit ResidualsPanel(QWidget* parent = nullptr);
  ResidualPlot* plot() const { return plot_; }
  void choose(ResidualMeasure measure, PairCircumstance circumstance);
  QPushButton* reject_button() const { return reject_; }

 signals:
  /// `reason`: of every pair that is marked and not rejected yet, "marked in the plot: residual x over speed".
  void reject_requested(const std::vector<motion::PairIndex>& pairs, const QString& reason);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void add_choices();
  void add_states();
  void lay_out(bool narrow);
  void show_summary();
  void reject_marked();
  ResidualPlot* plot_;
  QComboBox *measure_, *circumstance_;
  QPushButton* reject_;
  QLabel* summary_;
  QWidget* side_;                         ///< what is chosen
  QBoxLayout *row_, *choices_, *states_;  ///< turn where the panel becomes narrow
};

}  // namespace remount::widgets
