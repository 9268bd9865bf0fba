// Two settings compared, in the words of the options' pages.
#pragma once

#include <QStringList>

#include "model/settings/settings.h"

namespace remount::widgets {

/// "Max gap (Pairing): 2.5 s, now 1.25 s", one for each option that differs and matters for a result. Angles in
/// degrees.
QStringList setting_changes(const settings::Settings& then, const settings::Settings& now);

}  // namespace remount::widgets
