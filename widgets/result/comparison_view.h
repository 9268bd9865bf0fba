// Results of several methods or drives on one vehicle, side by side.
#pragma once

#include <QWidget>
#include <vector>

#include "model/report/comparison.h"

class QPushButton;

namespace remount::widgets {

class FigureTable;
class VerdictLabel;

class ComparisonView : public QWidget {
  Q_OBJECT
 public:
  explicit ComparisonView(QWidget* parent = nullptr);
  void show_results(const std::vector<report::NamedResult>& results);

 signals:
  void add_requested();    ///< result files are to be added
  void clear_requested();  ///< the files are to be left out again

 private:
  VerdictLabel* verdict_;
  FigureTable* table_;
  FigureTable* pairs_;
  QPushButton* clear_;
};

}  // namespace remount::widgets
