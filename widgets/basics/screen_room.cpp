#include "widgets/basics/screen_room.h"

#include <QScreen>
#include <QStyle>
#include <QWidget>

namespace remount::widgets {

QSize within_screen(const QWidget& widget, const QSize& wanted) {
  // How high the frame is, nobody knows before the window is shown.
  const int title = widget.style()->pixelMetric(QStyle::PM_TitleBarHeight, nullptr, &widget);
  return wanted.boundedTo(widget.screen()->availableSize() - QSize(8, title + 12));
}

}  // namespace remount::widgets
