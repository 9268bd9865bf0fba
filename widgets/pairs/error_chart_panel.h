// The bar chart of errors with what it shows and what its line would reject.
#pragma once

#include <QWidget>

#include "widgets/pairs/error_bar_chart.h"

class QComboBox;
class QLabel;

namespace remount::widgets {

class ErrorChartPanel : public QWidget {
  Q_OBJECT
 public:
  explicit ErrorChartPanel(QWidget* parent = nullptr);
  ErrorBarChart* chart() const { return chart_; }

 signals:
  void measure_changed(widgets::PairMeasure measure);
  /// `reason`: of every pair above the line, "residual translation above 4.2 cm".
  void reject_requested(const std::vector<motion::PairIndex>& pairs, const QString& reason);
  void take_back_requested(const std::vector<motion::PairIndex>& pairs);

 private:
  void show_count(int rejected, int of);
  ErrorBarChart* chart_;
  QComboBox* measure_;
  QLabel* count_;
};

}  // namespace remount::widgets
