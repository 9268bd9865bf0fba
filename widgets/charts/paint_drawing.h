// Paints what a report draws, where SVG cannot be shown.
#pragma once

#include <QImage>

#include "model/report/drawing.h"

class QPainter;

namespace remount {

void paint_drawing(const Drawing& drawing, QPainter& painter);
/// On white, `scale` pixels a point.
QImage image_of(const Drawing& drawing, double scale);

}  // namespace remount
