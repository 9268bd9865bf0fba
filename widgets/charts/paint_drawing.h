// Paints what a report draws, where SVG cannot be shown.
#pragma once

#include <QImage>

#include "model/report/drawing.h"

class QPainter;

namespace remount::widgets {

void paint_drawing(const report::Drawing& drawing, QPainter& painter);
/// On white, `scale` pixels a point.
QImage image_of(const report::Drawing& drawing, double scale);

}  // namespace remount::widgets
