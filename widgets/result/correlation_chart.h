// The correlations between the six parameters, as coloured numbers.
#pragma once

#include <QWidget>

#include "algorithms/calibration/calibration_result.h"

namespace remount::widgets {

class CorrelationChart : public QWidget {
  Q_OBJECT
 public:
  explicit CorrelationChart(QWidget* parent = nullptr);
  void show_result(const calibration::CalibrationResult& result);

  QSize minimumSizeHint() const override { return {230, 170}; }
  QSize sizeHint() const override { return {270, 190}; }
  bool hasHeightForWidth() const override { return false; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool event(QEvent* event) override;

 private:
  QRect cell(int row, int column) const;
  calibration::PerParameter<calibration::PerParameter<double>> values_;
};

}  // namespace remount::widgets
