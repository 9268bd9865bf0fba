// The residuals plot with what it shows, and what becomes of the pairs that are marked in it.
#pragma once

#include <QWidget>

#include "widgets/residuals/residual_plot.h"

class QComboBox;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace remount::widgets {

/// What is chosen stands at the left of the plot: the panel is low and wide.
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

 private:
  void add_choices(QVBoxLayout* column);
  void add_states(QVBoxLayout* column);
  void show_summary();
  void reject_marked();
  ResidualPlot* plot_;
  QComboBox *measure_, *circumstance_;
  QPushButton* reject_;
  QLabel* summary_;
};

}  // namespace remount::widgets
