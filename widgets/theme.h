// Colours that carry meaning, for light and for dark palettes, always together with a word or a sign.
#pragma once

#include <QColor>
#include <QPalette>
#include <QString>

#include "algorithms/trajectory/pair.h"
#include "model/session.h"

class QWidget;

namespace remount {

bool is_dark(const QPalette& palette);
QColor state_color(PairState state, const QPalette& palette);
QString state_text(const Pair& pair);  ///< "✓ accepted", "✕ rejected by you"
QColor severity_color(Severity severity, const QPalette& palette);
QString severity_sign(Severity severity);
QColor good_color(const QPalette& palette);
QColor warning_color(const QPalette& palette);
QColor bad_color(const QPalette& palette);
/// A background that carries `color` softly under text of the palette.
QColor tinted(const QColor& color, const QPalette& palette);
/// Sets a style sheet where it is another: the same one, set once more, styles the widget and all in it anew.
void set_style(QWidget& widget, const QString& style_sheet);

}  // namespace remount
