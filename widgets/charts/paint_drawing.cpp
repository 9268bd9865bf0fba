#include "widgets/charts/paint_drawing.h"

#include <QPainter>
#include <QPolygonF>

namespace remount::widgets {
namespace {

QPointF point(const Eigen::Vector2d& at) { return {at.x(), at.y()}; }
QColor color(const std::string& name) { return QColor(QString::fromStdString(name)); }

struct ShapePainter {
  QPainter& painter;

  void operator()(const report::DrawnLine& line) const {
    QPolygonF polygon;
    for (const Eigen::Vector2d& at : line.points) polygon << point(at);
    painter.setPen(QPen(color(line.color), line.width));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(polygon);
  }
  void operator()(const report::DrawnBox& box) const {
    painter.fillRect(QRectF(point(box.corner), QSizeF(box.size.x(), box.size.y())), color(box.color));
  }
  void operator()(const report::DrawnDot& dot) const {
    painter.setPen(Qt::NoPen);
    painter.setBrush(color(dot.color));
    painter.drawEllipse(point(dot.middle), dot.radius, dot.radius);
  }
  void operator()(const report::DrawnText& text) const {
    QFont font = painter.font();
    font.setPixelSize(static_cast<int>(text.size));
    painter.setFont(font);
    painter.setPen(color(text.color));
    const QString words = QString::fromStdString(text.text);
    const double width = QFontMetricsF(font).horizontalAdvance(words);
    const double shift = text.anchor == report::TextAnchor::Start    ? 0.0
                         : text.anchor == report::TextAnchor::Middle ? 0.5
                                                                     : 1.0;
    painter.drawText(point(text.base) - QPointF(shift * width, 0.0), words);
  }
};

}  // namespace

void paint_drawing(const report::Drawing& drawing, QPainter& painter) {
  painter.setRenderHint(QPainter::Antialiasing);
  for (const auto& shape : drawing.shapes) std::visit(ShapePainter{painter}, shape);
}

QImage image_of(const report::Drawing& drawing, double scale) {
  QImage image(static_cast<int>(drawing.width * scale), static_cast<int>(drawing.height * scale), QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  painter.scale(scale, scale);
  paint_drawing(drawing, painter);
  return image;
}

}  // namespace remount::widgets
