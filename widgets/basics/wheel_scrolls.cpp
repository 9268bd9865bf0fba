#include "widgets/basics/wheel_scrolls.h"

#include <QEvent>

namespace remount::widgets {
namespace {

/// What is ignored goes on to the parent.
class WheelPasser : public QObject {
 public:
  using QObject::QObject;
  bool eventFilter(QObject*, QEvent* event) override {
    if (event->type() != QEvent::Wheel) return false;
    event->ignore();
    return true;
  }
};

}  // namespace

void let_wheel_scroll(QWidget& editor) {
  if (editor.focusPolicy() == Qt::WheelFocus) editor.setFocusPolicy(Qt::StrongFocus);
  editor.installEventFilter(new WheelPasser(&editor));
}

}  // namespace remount::widgets
