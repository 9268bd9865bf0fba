#include "widgets/basics/scale_bar.h"

#include <QPainter>
#include <cmath>

namespace remount::widgets {
namespace {
constexpr double kLongest_px = 140.0;
}  // namespace

ScaleBar::ScaleBar(QWidget* parent) : QWidget(parent) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAccessibleName(tr("Scale"));
}

void ScaleBar::show_scale(double metres_per_pixel, bool everywhere) {
  if (metres_per_pixel == metres_per_pixel_ && everywhere == everywhere_) return;
  metres_per_pixel_ = metres_per_pixel;
  everywhere_ = everywhere;
  setAccessibleDescription(text());
  update();
}

void ScaleBar::name_axes(const QString& axes) {
  axes_ = axes;
  update();
}

/// 1, 2 or 5 times a power of ten.
double ScaleBar::length_m() const {
  const double most = kLongest_px * metres_per_pixel_;
  if (!(most > 0.0)) return 0.0;
  const double power = std::pow(10.0, std::floor(std::log10(most)));
  return power * (most >= 5.0 * power ? 5.0 : most >= 2.0 * power ? 2.0 : 1.0);
}

QString ScaleBar::text() const {
  const double length = length_m();
  const QString words = length < 1.0 ? tr("%1 cm").arg(100.0 * length) : tr("%1 m").arg(length);
  return everywhere_ ? words : tr("%1 in the middle").arg(words);
}

QSize ScaleBar::sizeHint() const { return {static_cast<int>(kLongest_px) + 100, 2 * fontMetrics().height() + 8}; }

void ScaleBar::paintEvent(QPaintEvent*) {
  if (length_m() <= 0.0) return;
  QPainter painter(this);
  const double line = fontMetrics().height(), right = width() - 2.0, y = height() - 4.0;
  const double left = right - length_m() / metres_per_pixel_;
  painter.setPen(QPen(palette().color(QPalette::Text), 2.0));
  painter.drawPolyline(QPolygonF({{left, y - 5.0}, {left, y}, {right, y}, {right, y - 5.0}}));
  const auto write = [&](double bottom, const QString& words) {
    painter.drawText(QRectF(0.0, bottom - line, right, line), Qt::AlignRight | Qt::AlignBottom, words);
  };
  write(y - 6.0, text());
  write(y - 6.0 - line, axes_);
}

}  // namespace remount::widgets
