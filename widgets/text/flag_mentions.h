// Flags of the command line that sentences of the model mention, as places of the window.
#pragma once

#include <QString>

namespace remount::widgets {

/// "Mend the file, or give the mounting with --nominal." -> "… in “Nominal mounting”."; "--topic imu=none" ->
/// "“Topics…: IMU – none”"; "--method slew" -> "the method “…”", by its title.
QString with_window_places(const QString& text);

}  // namespace remount::widgets
