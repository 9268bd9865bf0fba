// Whether this display can show 3-D.
#pragma once

#include <QString>

namespace remount::widgets {

/// Before QApplication: one surface format for every view and shared contexts, without which views go blank when a
/// dock is floated.
void prepare_gl();

/// Empty where a 3-D view can be made; else why not, in words. A view made in spite of it would end the program.
QString missing_gl_reason();

}  // namespace remount::widgets
