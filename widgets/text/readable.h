// What some palettes draw too faintly to be seen: placeholders and the edges of empty boxes.
#pragma once

#include <QColor>
#include <QPalette>

class QAbstractButton;
class QWidget;

namespace remount::widgets {

/// Contrast ratio of two opaque colours, 1 to 21 (WCAG 2.1, 1.4.3).
double contrast(const QColor& first, const QColor& second);

/// The faintest mixture of `ink` and `paper` that still has this contrast against `paper`; `ink` where none has.
QColor faint_but_readable(const QColor& ink, const QColor& paper, double least_contrast);

/// Keeps the placeholder of an editor readable on its own background, whatever palette follows.
void keep_placeholder_readable(QWidget& editor);
/// Likewise the edge of a check box or radio button that is not ticked.
void keep_box_visible(QAbstractButton& box);

}  // namespace remount::widgets
