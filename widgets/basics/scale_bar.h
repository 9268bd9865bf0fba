// How long a metre is on the screen, over a 3-D view.
#pragma once

#include <QWidget>

namespace remount::widgets {

/// Lets the mouse through to what it lies on.
class ScaleBar : public QWidget {
  Q_OBJECT
 public:
  explicit ScaleBar(QWidget* parent);
  /// @param metres_per_pixel of the screen @param everywhere false: only as far away as what is looked at
  void show_scale(double metres_per_pixel, bool everywhere);
  void name_axes(const QString& axes);  ///< whose axes the view has
  QString text() const;
  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  double length_m() const;
  double metres_per_pixel_ = 0.0;
  bool everywhere_ = true;
  QString axes_;
};

}  // namespace remount::widgets
