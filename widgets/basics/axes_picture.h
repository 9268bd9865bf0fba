// The axes of the INS frame on a vehicle, for help and tooltips.
#pragma once

#include <QImage>
#include <QPalette>
#include <QString>

namespace remount::widgets {

/// Seen from above and from the right, in the palette's colours of text.
QImage axes_picture(const QPalette& palette, int width);

/// A tooltip with the picture below the text.
QString tooltip_with_axes(const QString& text);

}  // namespace remount::widgets
