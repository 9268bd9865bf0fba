// What the method of the result tells beside X: its quantities and its plots.
#pragma once

#include <QWidget>
#include <vector>

#include "algorithms/calibration/method_details.h"

class QLabel;

namespace remount::widgets {

class FigureTable;
class PlotView;

class MethodView : public QWidget {
  Q_OBJECT
 public:
  explicit MethodView(QWidget* parent = nullptr);
  void show_message(const QString& text);
  void show_method(const QString& title, const std::vector<calibration::NamedQuantity>& quantities,
                   const std::vector<calibration::Plot>& plots);

 private:
  QLabel* title_;
  FigureTable* quantities_;
  PlotView* plots_;
};

}  // namespace remount::widgets
