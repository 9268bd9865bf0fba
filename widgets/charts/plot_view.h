// Plots of a method, one below the other, as wide as their panel.
#pragma once

#include <QWidget>
#include <vector>

#include "algorithms/calibration/method_details.h"
#include "model/report/drawing.h"

namespace remount::widgets {

/// Each plot is a picture on white, as in the report, in the size that the width allows; read aloud by its title.
class PlotView : public QWidget {
  Q_OBJECT
 public:
  explicit PlotView(QWidget* parent = nullptr);
  void show_plots(const std::vector<calibration::Plot>& plots);
  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override;
  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  static constexpr int kGap = 8;
  double scale_of(int width) const;
  std::vector<report::Drawing> drawings_;
};

}  // namespace remount::widgets
