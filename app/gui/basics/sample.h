// The session that comes with the program.
#pragma once

#include <QString>

namespace remount::gui {

/// Where the bundled sample session lies; empty where it is not installed.
QString sample_path();

}  // namespace remount::gui
