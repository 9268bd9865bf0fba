#include "widgets/basics/color_bar.h"

#include <QPainter>

namespace remount::widgets {

ColorBar::ColorBar(std::function<QColor(double)> color_at, QWidget* parent)
    : QWidget(parent), color_at_(std::move(color_at)) {
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

void ColorBar::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const QRect frame = rect().adjusted(0, 2, -1, -3);
  for (int x = frame.left(); x <= frame.right(); ++x)
    painter.fillRect(x, frame.top(), 1, frame.height(),
                     color_at_(static_cast<double>(x - frame.left()) / std::max(1, frame.width() - 1)));
  painter.setPen(palette().color(QPalette::Mid));
  painter.drawRect(frame);
}

}  // namespace remount::widgets
