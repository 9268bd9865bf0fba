// How large a window may be where it opens.
#pragma once

#include <QSize>

class QWidget;

namespace remount::widgets {

/// `wanted`, or as much of it as fits on the widget's screen beside the frame of a window.
QSize within_screen(const QWidget& widget, const QSize& wanted);

}  // namespace remount::widgets
