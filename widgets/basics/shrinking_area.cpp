#include "widgets/basics/shrinking_area.h"

namespace remount::widgets {

ShrinkingArea::ShrinkingArea(QWidget* content, QSize least, QWidget* parent) : QScrollArea(parent), least_(least) {
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  setFocusPolicy(Qt::NoFocus);
  setFocusProxy(content);
  setWidget(content);
}

QSize ShrinkingArea::minimumSizeHint() const {
  return least_.boundedTo(widget()->minimumSizeHint().expandedTo(widget()->minimumSize()));
}

QSize ShrinkingArea::sizeHint() const { return widget()->sizeHint().expandedTo(minimumSizeHint()); }

}  // namespace remount::widgets
