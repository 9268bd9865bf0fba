// How the bar chart of errors answers the hand.
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "widgets/pairs/error_bar_chart.h"
#include "widgets/text/pair_reasons.h"

namespace remount::widgets {

using motion::PairIndex;

void ErrorBarChart::mousePressEvent(QMouseEvent* event) {
  if (pairs_.empty() || dragging_ || panned_from_) return;
  if (event->button() == Qt::RightButton || event->button() == Qt::MiddleButton) {
    panned_from_ = event->pos();
    setCursor(Qt::ClosedHandCursor);
    return;
  }
  if (event->button() != Qt::LeftButton) return;
  if (at_line(event->pos())) {
    dragging_ = true;
    threshold_before_drag_ = threshold_;
    return;
  }
  if (const std::optional<PairIndex> pair = pair_at(event->pos())) emit pair_clicked(*pair);
}

void ErrorBarChart::mouseMoveEvent(QMouseEvent* event) {
  if (panned_from_) {
    const double bars = (panned_from_->x() - event->pos().x()) / bar_width();
    panned_from_ = event->pos();
    return look_at(seen_.low + bars);
  }
  if (!dragging_) {
    setCursor(at_line(event->pos()) ? Qt::SizeVerCursor : Qt::ArrowCursor);
    return hover(pair_at(event->pos()));
  }
  if (event->pos().y() <= plot_area().top() - 3)
    set_threshold(std::nullopt);
  else
    set_threshold(value_at(event->pos().y()));
}

void ErrorBarChart::mouseReleaseEvent(QMouseEvent*) {
  setCursor(Qt::ArrowCursor);
  panned_from_.reset();
  if (!dragging_) return;
  dragging_ = false;
  if (threshold_ == threshold_before_drag_) return;
  apply_line();
  set_threshold(threshold_);  // it stands now: other words
}

void ErrorBarChart::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return mousePressEvent(event);  // panning twice in a row
  if (at_line(event->pos())) return;
  show_whole();
}

void ErrorBarChart::wheelEvent(QWheelEvent* event) {
  event->accept();
  if (pairs_.empty() || event->angleDelta().y() == 0) return;
  const double factor = wheel_factor(event->angleDelta().y());
  if (event->position().x() < plot_area().left())
    stretch(factor);
  else
    zoom(event->position().x(), factor);
}

void ErrorBarChart::hover(std::optional<PairIndex> pair) {
  if (pair == hovered_) return;
  hovered_ = pair;
  update();
}

void ErrorBarChart::leaveEvent(QEvent*) { hover({}); }

void ErrorBarChart::step_selection(int step) {
  const int place = place_of(selected_);
  const int next = place < 0 ? (step > 0 ? 0 : count() - 1) : std::clamp(place + step, 0, count() - 1);
  emit pair_clicked(pairs_[index_at(next)]);
}

void ErrorBarChart::step_threshold(double share) {
  const double moved = threshold_.value_or(top_) + share * top_;
  if (moved > top_ * (1.0 + 1e-9))
    set_threshold(std::nullopt);
  else
    set_threshold(std::max(0.0, moved));
}

void ErrorBarChart::keyPressEvent(QKeyEvent* event) {
  if (pairs_.empty()) return QWidget::keyPressEvent(event);
  switch (event->key()) {
    case Qt::Key_Left:
    case Qt::Key_Right:
      return step_selection(event->key() == Qt::Key_Left ? -1 : 1);
    case Qt::Key_Home:
      return emit pair_clicked(pairs_.front());
    case Qt::Key_End:
      return emit pair_clicked(pairs_.back());
    case Qt::Key_Up:
    case Qt::Key_Down:
      return step_threshold(event->key() == Qt::Key_Up ? 0.02 : -0.02);
    case Qt::Key_PageUp:
    case Qt::Key_PageDown:
      return step_threshold(event->key() == Qt::Key_PageUp ? 0.1 : -0.1);
    case Qt::Key_Return:
    case Qt::Key_Enter:
      return apply_line();
    case Qt::Key_Plus:
    case Qt::Key_Minus:
      return zoom(plot_area().center().x(), wheel_factor(event->key() == Qt::Key_Plus ? 120 : -120));
    case Qt::Key_Escape:
      if (!threshold_ && !dragging_) break;
      dragging_ = false;
      by_line_.clear();  // what it rejected stays so
      return set_threshold(std::nullopt);
    default:
      break;
  }
  QWidget::keyPressEvent(event);
}

bool ErrorBarChart::event(QEvent* event) {
  // Escape also cancels a calibration; with the line in hand it lets go of the line.
  if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape &&
      (dragging_ || threshold_)) {
    event->accept();
    return true;
  }
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  auto* help = static_cast<QHelpEvent*>(event);
  const std::optional<PairIndex> index = pair_at(help->pos());
  if (at_line(help->pos())) {
    QToolTip::showText(
        help->globalPos(),
        tr("Drag: what is above the line is rejected when you let go. The line stays: pulled back, it gives "
           "back what it rejected.\nIn the chart: Up and Down move it, Return applies it, Escape puts "
           "it away."),
        this);
  } else if (!index) {
    QToolTip::hideText();
  } else {
    QString text = words_of(*index);
    if (!pair(*index).reason.empty()) text += '\n' + reason_words(pair(*index).reason);
    QToolTip::showText(help->globalPos(), text, this);
  }
  return true;
}

}  // namespace remount::widgets
