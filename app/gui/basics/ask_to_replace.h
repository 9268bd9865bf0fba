// A question before files are replaced.
#pragma once

#include <QStringList>

class QWidget;

namespace remount::gui {

/// Asks, once for all of them, where one of the files exists. False where the user does not want it.
bool ask_to_replace(QStringList files, QWidget& window);

}  // namespace remount::gui
