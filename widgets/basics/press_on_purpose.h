// Buttons that take something away.
#pragma once

#include <QPushButton>

namespace remount::widgets {

/// Only a click or its own key presses the button: never an Enter that was meant for a field of its dialog, which
/// presses the first button that may be the default where nobody named one.
inline void press_on_purpose(QPushButton& button) {
  button.setDefault(false);
  button.setAutoDefault(false);
}

}  // namespace remount::widgets
