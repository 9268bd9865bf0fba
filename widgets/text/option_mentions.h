// Options that sentences of the model mention by their keys, in the words of the options' pages.
#pragma once

#include <QString>

namespace remount::widgets {

/// "set solve.apply_time_offset to correct it" -> "set “Apply time offset” (Solution) to correct it". Keys that stand
/// for a place in a file ("settings.solve.threads", "solve.threads: is no number") stay.
QString with_option_labels(const QString& text);

}  // namespace remount::widgets
