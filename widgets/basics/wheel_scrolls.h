// Editors that stand in what is scrolled.
#pragma once

#include <QWidget>

namespace remount::widgets {

/// The wheel over a list or a number goes to what it stands in: nobody changes a value by scrolling past it.
void let_wheel_scroll(QWidget& editor);

}  // namespace remount::widgets
