#include "widgets/basics/axes_picture.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QLineF>
#include <QPainter>
#include <QToolTip>

namespace remount::widgets {
namespace {

struct AxesText {
  Q_DECLARE_TR_FUNCTIONS(remount::widgets::axes_picture)
};

void draw_arrow(QPainter& painter, QPointF from, QPointF to, const QString& name, const QColor& color) {
  painter.setPen(QPen(color, 2.5));
  painter.drawLine(from, to);
  const QLineF line(to, from);
  for (const double turn : {25.0, -25.0}) {
    QLineF wing = line;
    wing.setLength(9.0);
    wing.setAngle(line.angle() + turn);
    painter.drawLine(wing);
  }
  painter.drawText(to + QPointF(5.0, -4.0), name);
}

}  // namespace

QImage axes_picture(const QPalette& palette, int width) {
  constexpr double kWidth = 360.0, kHeight = 150.0;
  QImage image(width, static_cast<int>(width * kHeight / kWidth), QImage::Format_ARGB32_Premultiplied);
  image.fill(Qt::transparent);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.scale(width / kWidth, width / kWidth);
  const QColor ink = palette.color(QPalette::Text);
  painter.setPen(QPen(ink, 1.2));
  painter.drawRoundedRect(QRectF(20, 55, 120, 56), 12, 12);  // seen from above, front to the right
  painter.drawLine(QPointF(108, 60), QPointF(108, 106));     // windscreen
  painter.drawPolyline(QPolygonF(
      {{200, 110}, {200, 86}, {226, 80}, {244, 62}, {292, 62}, {312, 84}, {330, 88}, {330, 110}, {200, 110}}));
  painter.drawEllipse(QPointF(228, 112), 11, 11);
  painter.drawEllipse(QPointF(304, 112), 11, 11);
  const QColor x(200, 60, 50), y(40, 140, 60), z(50, 100, 200);
  draw_arrow(painter, {70, 83}, {150, 83}, "x", x);
  draw_arrow(painter, {70, 83}, {70, 22}, "y", y);
  draw_arrow(painter, {262, 92}, {345, 92}, "x", x);
  draw_arrow(painter, {262, 92}, {262, 24}, "z", z);
  painter.setPen(ink);
  painter.drawText(QPointF(20, 140), AxesText::tr("seen from above"));
  painter.drawText(QPointF(200, 140), AxesText::tr("seen from the right"));
  return image;
}

QString tooltip_with_axes(const QString& text) {
  constexpr int kWidth = 300;
  QPalette palette = QToolTip::palette();
  palette.setColor(QPalette::Text, palette.color(QPalette::ToolTipText));
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  axes_picture(palette, kWidth).save(&buffer, "PNG");
  return QStringLiteral("<p>%1</p><p><img src=\"data:image/png;base64,%2\"></p>")
      .arg(text.toHtmlEscaped(), QString::fromLatin1(bytes.toBase64()));
}

}  // namespace remount::widgets
