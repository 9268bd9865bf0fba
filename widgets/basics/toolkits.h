// What draws the window, for reports of faults. Names and numbers, in no language.
#pragma once

#include <QString>

namespace remount::widgets {

/// "Qt 6.4.2, VTK 9.1.0"; needs no display.
QString toolkit_versions();

/// "OpenGL 4.5, llvmpipe (LLVM 15.0.6)"; empty where this display has none. Needs QApplication.
QString opengl_name();

}  // namespace remount::widgets
