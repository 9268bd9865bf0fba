// A strip of colours, for legends.
#pragma once

#include <QWidget>
#include <functional>

namespace remount::widgets {

class ColorBar : public QWidget {
  Q_OBJECT
 public:
  /// @param color_at of a share from 0 (left) to 1 (right)
  explicit ColorBar(std::function<QColor(double)> color_at, QWidget* parent = nullptr);
  QSize sizeHint() const override { return {120, fontMetrics().height()}; }
  QSize minimumSizeHint() const override { return {40, fontMetrics().height()}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::function<QColor(double)> color_at_;
};

}  // namespace remount::widgets
