// What the charts' axes have in common.
#pragma once

#include <QPainter>
#include <QWidget>

namespace remount::widgets {

/// 1, 2 or 5 times a power of ten, not below span / steps.
double nice_step(double span, int steps);

/// Faint, in the text's colour: lines that carry no value.
QColor grid_color(const QPalette& palette);
QColor faint_text_color(const QPalette& palette);

/// Ticks of [low, high] at nice steps, at most `steps` or so.
std::vector<double> nice_ticks(double low, double high, int steps);

}  // namespace remount::widgets
