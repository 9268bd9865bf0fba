// How the residuals plot answers the hand.
#include <QApplication>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QToolTip>
#include <algorithm>

#include "widgets/basics/rows.h"
#include "widgets/residuals/residual_plot.h"
#include "widgets/text/pair_reasons.h"

namespace remount::widgets {

using motion::PairIndex;

void ResidualPlot::zoom(const QPointF& about, double factor) {
  if (count() == 0) return;
  AxisSpan across = frame_.across, up = frame_.up;
  // Over an axis along that one alone.
  if (about.x() >= frame_.area.left()) across = zoomed(across, frame_.x_at(about.x()), factor, whole_across_);
  if (about.y() <= frame_.area.bottom()) up = zoomed(up, frame_.y_at(about.y()), factor, whole_up_);
  view(across, up);
}

void ResidualPlot::wheelEvent(QWheelEvent* event) {
  if (event->angleDelta().y() != 0) zoom(event->position(), wheel_factor(event->angleDelta().y()));
  event->accept();
}

void ResidualPlot::mousePressEvent(QMouseEvent* event) {
  if (count() == 0 || hand_ != Hand::Free) return;
  pressed_ = last_ = event->position();
  if (event->button() == Qt::LeftButton) {
    hand_ = Hand::Pressed;
  } else if (event->button() == Qt::RightButton || event->button() == Qt::MiddleButton) {
    hand_ = Hand::Pan;
    setCursor(Qt::ClosedHandCursor);
  }
}

void ResidualPlot::mouseMoveEvent(QMouseEvent* event) {
  const QPointF here = event->position();
  if (hand_ == Hand::Free) return hover(pair_at(here));
  if (hand_ == Hand::Pan) {
    frame_.pan(here - last_);
    last_ = here;
    return change();
  }
  if (hand_ == Hand::Pressed) {
    if ((here - pressed_).manhattanLength() < QApplication::startDragDistance()) return;
    hand_ = Hand::Lasso;
    hover({});
    lasso_ = QPolygonF{pressed_};
  }
  lasso_ << here;
  update();
}

void ResidualPlot::mouseReleaseEvent(QMouseEvent* event) {
  const Hand before = hand_;
  hand_ = Hand::Free;
  setCursor(Qt::ArrowCursor);
  if (before == Hand::Lasso) return close_lasso(event->modifiers() & (Qt::ShiftModifier | Qt::ControlModifier));
  if (before != Hand::Pressed) return;
  if (const std::optional<PairIndex> pair = pair_at(event->position())) emit pair_clicked(*pair);
}

void ResidualPlot::close_lasso(bool beside) {
  const std::vector<PairIndex> within = pairs_within(lasso_);
  lasso_.clear();
  if (!beside) marked_.clear();
  marked_.insert(within.begin(), within.end());
  change();
}

void ResidualPlot::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return mousePressEvent(event);  // panning twice in a row
  hand_ = Hand::Free;
  const bool usual = frame_.up == usual_up_ && frame_.across == whole_across_;
  usual ? show_all() : show_usual();
}

void ResidualPlot::hover(std::optional<PairIndex> pair) {
  setCursor(pair ? Qt::PointingHandCursor : Qt::ArrowCursor);
  if (pair == hovered_) return;
  hovered_ = pair;
  update();
}

void ResidualPlot::leaveEvent(QEvent*) { hover({}); }

void ResidualPlot::step_selection(int step) {
  std::vector<PairIndex> seen;
  for (PairIndex i; i < count(); ++i)
    if (point_of(i)) seen.push_back(i);
  if (seen.empty()) return;
  const auto key = [this](PairIndex pair) { return std::pair(across_[pair], pair); };
  std::ranges::sort(seen, {}, key);
  const auto found = std::ranges::find(seen, selected_);
  const std::ptrdiff_t last = std::ssize(seen) - 1;
  const std::ptrdiff_t next =
      found == seen.end() ? (step > 0 ? 0 : last) : std::clamp<std::ptrdiff_t>(found - seen.begin() + step, 0, last);
  emit pair_clicked(seen[index_at(next)]);
}

void ResidualPlot::keyPressEvent(QKeyEvent* event) {
  if (count() == 0) return QWidget::keyPressEvent(event);
  switch (event->key()) {
    case Qt::Key_Left:
    case Qt::Key_Right:
      return step_selection(event->key() == Qt::Key_Left ? -1 : 1);
    case Qt::Key_Plus:
    case Qt::Key_Minus:
      return zoom(frame_.area.center(), wheel_factor(event->key() == Qt::Key_Plus ? 120 : -120));
    case Qt::Key_Home:
      return show_usual();
    case Qt::Key_End:
      return show_all();
    case Qt::Key_Space:
      if (!selected_) break;
      if (marked_.erase(*selected_) == 0) marked_.insert(*selected_);
      return change();
    case Qt::Key_Escape:
      if (marked_.empty() && hand_ != Hand::Lasso) break;
      hand_ = Hand::Free;
      lasso_.clear();
      return mark({});
    default:
      break;
  }
  QWidget::keyPressEvent(event);
}

bool ResidualPlot::event(QEvent* event) {
  // Escape also cancels a calibration; with marks it takes these away.
  if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape &&
      (hand_ == Hand::Lasso || !marked_.empty())) {
    event->accept();
    return true;
  }
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  auto* help = static_cast<QHelpEvent*>(event);
  const std::optional<PairIndex> pair = pair_at(help->pos());
  QString text = pair ? words_of(*pair) : QString();
  if (pair && !output_->pairs[*pair].reason.empty()) text += '\n' + reason_words(output_->pairs[*pair].reason);
  if (text.isEmpty())
    QToolTip::hideText();
  else
    QToolTip::showText(help->globalPos(), text, this);
  return true;
}

}  // namespace remount::widgets
