// A colour of the 3-D view with what it stands for, in rich text.
#pragma once

#include <QColor>
#include <QString>

#include "widgets/scene/distance_scale.h"

namespace remount::widgets {

inline QColor to_qt(const scene::SceneColor& color) { return {color[0], color[1], color[2]}; }

/// @param sign what is drawn in the colour
inline QString swatch(const scene::SceneColor& color, const QString& text, const QString& sign = QStringLiteral("■")) {
  return QStringLiteral("<span style='color:%1'>%2</span>&nbsp;%3")
      .arg(to_qt(color).name(), sign, QString(text).replace(' ', QChar::Nbsp));
}

}  // namespace remount::widgets
