#include "widgets/pairs/error_bar_chart.h"

#include <QAccessible>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "widgets/basics/theme.h"
#include "widgets/charts/chart_axis.h"
#include "widgets/text/pair_reasons.h"

namespace remount::widgets {

using motion::PairIndex;

namespace {
constexpr int kHandle_px = ErrorBarChart::kHandleWidth;
constexpr int kLineReach_px = 5;  // how near to the line counts as on it
}  // namespace

ErrorBarChart::ErrorBarChart(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAccessibleName(tr("Error of each pair"));
  setAccessibleDescription(
      tr("One bar per pair. Left and right arrow keys select the neighbouring pair; up and down move the line above "
         "which Return rejects, Escape puts it back."));
}

void ErrorBarChart::show_output(std::shared_ptr<const pipeline::PipelineOutput> output) {
  output_ = std::move(output);
  if (!output_) threshold_.reset();
  find_values();
  show_pairs(pairs_);
}

void ErrorBarChart::show_pairs(const std::vector<PairIndex>& pairs) {
  const std::size_t all = output_ ? output_->pairs.size() : 0;
  std::vector<PairIndex> known;
  std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(known), [all](PairIndex pair) { return pair < all; });
  pairs_ = std::move(known);
  find_top();
  set_threshold(threshold_);
}

void ErrorBarChart::show_selected(std::optional<PairIndex> pair) {
  selected_ = pair;
  update();
}

void ErrorBarChart::set_measure(PairMeasure measure) {
  measure_ = measure;
  find_values();
  find_top();
  set_threshold(std::nullopt);  // a height of the other axis
}

/// Once: each picture asks for the values of all pairs several times.
void ErrorBarChart::find_values() {
  values_.clear();
  rejected_.clear();
  if (!output_) return;
  values_.reserve(output_->pairs.size());
  rejected_.reserve(output_->pairs.size());
  for (const motion::Pair& pair : output_->pairs) {
    values_.push_back(measured(pair, measure_));
    rejected_.push_back(pair.state == motion::PairState::Rejected);
  }
}

std::optional<double> ErrorBarChart::value_of(PairIndex index) const { return values_[index]; }

bool ErrorBarChart::is_rejected(PairIndex index) const { return rejected_[index]; }

QRect ErrorBarChart::plot_area() const {
  const QFontMetrics metrics = fontMetrics();
  return rect().adjusted(metrics.horizontalAdvance(QStringLiteral("000.00")) + 10, metrics.height() + 8,
                         -kHandle_px - 4, -metrics.height() - 6);
}

int ErrorBarChart::place_of(std::optional<PairIndex> pair) const {
  const auto found = std::find(pairs_.begin(), pairs_.end(), pair);
  return found == pairs_.end() ? -1 : static_cast<int>(found - pairs_.begin());
}

void ErrorBarChart::find_top() {
  // A few wild pairs must not flatten all others: the axis ends at 1.5 times the 95th percentile of the pairs that
  // are not rejected; bars beyond it are cut and marked.
  std::vector<double> values, kept;
  for (const PairIndex index : pairs_) {
    const std::optional<double> value = value_of(index);
    if (!value) continue;
    values.push_back(*value);
    if (!is_rejected(index)) kept.push_back(*value);
  }
  if (!kept.empty()) values = std::move(kept);
  top_ = 1.0;
  if (values.empty()) return;
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(0.95 * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  const double high = *place, largest = *std::max_element(values.begin(), values.end());
  const double top = high > 0.0 ? std::min(largest, 1.5 * high) : largest;
  if (top > 0.0) top_ = 1.05 * top;
}

int ErrorBarChart::y_of(double value) const {
  const QRect area = plot_area();
  return area.bottom() - static_cast<int>(std::lround(std::min(1.0, value / top_) * area.height()));
}

double ErrorBarChart::value_at(int y) const {
  const QRect area = plot_area();
  return top_ * std::max(0, area.bottom() - y) / std::max(1, area.height());
}

std::optional<PairIndex> ErrorBarChart::pair_at(const QPoint& position) const {
  const QRect area = plot_area();
  if (pairs_.empty() || area.width() <= 0 || position.x() < area.left() || position.x() > area.right())
    return std::nullopt;
  const double share = static_cast<double>(position.x() - area.left()) / area.width();
  return pairs_[index_at(std::clamp(static_cast<int>(share * count()), 0, count() - 1))];
}

QPoint ErrorBarChart::handle() const {
  const QRect area = plot_area();
  return {area.right() + 2 + kHandle_px / 2, threshold_ ? y_of(*threshold_) : area.top() - 3};
}

bool ErrorBarChart::at_line(const QPoint& position) const {
  if (pairs_.empty() || std::abs(position.y() - handle().y()) > kLineReach_px + 2) return false;
  const bool on_handle = position.x() > plot_area().right();
  return on_handle || (threshold_ && std::abs(position.y() - handle().y()) <= kLineReach_px);
}

std::vector<PairIndex> ErrorBarChart::above_threshold() const {
  std::vector<PairIndex> above;
  if (!threshold_) return above;
  for (const PairIndex index : pairs_)
    if (!is_rejected(index) && value_of(index).value_or(0.0) > *threshold_) above.push_back(index);
  std::sort(above.begin(), above.end());
  return above;
}

int ErrorBarChart::kept_count() const {
  return static_cast<int>(
      std::count_if(pairs_.begin(), pairs_.end(), [&](PairIndex index) { return !is_rejected(index); }));
}

void ErrorBarChart::set_threshold(std::optional<double> threshold) {
  threshold_ = threshold;
  update();
  if (threshold_)
    emit threshold_moved(qt_count(above_threshold().size()), kept_count());
  else
    emit threshold_moved(-1, -1);
}

void ErrorBarChart::reject_above() {
  const std::vector<PairIndex> above = above_threshold();
  if (above.empty()) return;
  emit reject_requested(above, *threshold_);
  set_threshold(std::nullopt);  // it has done its work: what is undone later is not rejected by it again
}

void ErrorBarChart::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  if (at_line(event->pos())) {
    dragging_ = true;
    threshold_before_drag_ = threshold_;
    return;
  }
  if (const std::optional<PairIndex> pair = pair_at(event->pos())) emit pair_clicked(*pair);
}

void ErrorBarChart::mouseMoveEvent(QMouseEvent* event) {
  if (!dragging_) {
    setCursor(at_line(event->pos()) ? Qt::SizeVerCursor : Qt::ArrowCursor);
    return;
  }
  if (event->pos().y() <= plot_area().top() - 3)
    set_threshold(std::nullopt);
  else
    set_threshold(value_at(event->pos().y()));
}

void ErrorBarChart::mouseReleaseEvent(QMouseEvent*) {
  if (!dragging_) return;
  dragging_ = false;
  if (threshold_ && threshold_ != threshold_before_drag_) reject_above();
}

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
      return reject_above();
    case Qt::Key_Escape:
      if (!threshold_ && !dragging_) break;
      dragging_ = false;
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
    QToolTip::showText(help->globalPos(),
                       tr("Drag: what is above the line is rejected when you let go.\nIn the chart: "
                          "Up and Down move it, Return rejects, Escape puts it back."),
                       this);
  } else if (!index) {
    QToolTip::hideText();
  } else {
    const std::optional<double> value = value_of(*index);
    QString text =
        tr("pair %1: %2, %3")
            .arg(*index)
            .arg(value ? QStringLiteral("%1 %2").arg(*value, 0, 'g', 3).arg(measure_unit(measure_)) : tr("not aligned"),
                 state_text(pair(*index)));
    if (!pair(*index).reason.empty()) text += '\n' + reason_words(pair(*index).reason);
    QToolTip::showText(help->globalPos(), text, this);
  }
  return true;
}

}  // namespace remount::widgets
