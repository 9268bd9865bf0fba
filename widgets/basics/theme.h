// Colours that carry meaning, for light and for dark palettes, always together with a word or a sign.
#pragma once

#include <QColor>
#include <QPalette>
#include <QString>
#include <functional>

#include "algorithms/motion/pair.h"
#include "model/drive/session.h"

class QWidget;

namespace remount::widgets {

bool is_dark(const QPalette& palette);
QColor state_color(motion::PairState state, const QPalette& palette);
QString state_text(const motion::Pair& pair);  ///< "✓ accepted", "✕ rejected by you"
QColor severity_color(drive::Severity severity, const QPalette& palette);
QString severity_sign(drive::Severity severity);
QColor good_color(const QPalette& palette);
QColor warning_color(const QPalette& palette);
QColor bad_color(const QPalette& palette);
/// A background that carries `color` softly under text of the palette.
QColor tint(const QColor& color, const QPalette& palette);
/// Before the application is made: widgets in one that has a style sheet follow the palette as all others do.
void prepare_theme();
/// A style sheet of the colours of a palette. It is made anew whenever the application takes another palette.
using Style = std::function<QString(const QPalette&)>;
void set_style(QWidget& widget, const Style& style);
/// The style of a text in a colour of the palette.
Style text_in(QColor (*color)(const QPalette&));
/// The style of a box with a bar of a colour at its left, softly filled with it.
Style marked_box(QColor (*color)(const QPalette&), const QString& more);
/// What is not said any more: the colour of disabled text.
QColor faded_color(const QPalette& palette);

}  // namespace remount::widgets
