// What the colours of distances mean, and where the scale ends.
#pragma once

#include <QWidget>

class QDoubleSpinBox;
class QLabel;

namespace remount::widgets {

class DistanceLegend : public QWidget {
  Q_OBJECT
 public:
  explicit DistanceLegend(QWidget* parent = nullptr);
  double limit_m() const;
  void set_limit(double limit_m);
  void show_sides(bool on);  ///< the scale runs from behind a surface to before it
  /// Medians of the pictures, m, from left to right; NaN: nothing near; empty: not known yet.
  void show_medians(const std::vector<float>& medians_m);

 signals:
  void limit_edited(double limit_m);

 private:
  QDoubleSpinBox* limit_;
  QLabel *medians_, *from_;
  QWidget *without_sides_, *with_sides_;
};

}  // namespace remount::widgets
