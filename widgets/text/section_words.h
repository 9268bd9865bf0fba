// Sections of the settings as the options' pages are called.
#pragma once

#include <QString>

namespace remount::widgets {

/// "pairing" -> "Pairing"; the section itself where it has no page of its own.
QString section_title(const QString& section);

}  // namespace remount::widgets
