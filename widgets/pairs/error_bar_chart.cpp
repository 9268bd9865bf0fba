#include "widgets/pairs/error_bar_chart.h"

#include <algorithm>
#include <cmath>

namespace remount::widgets {

using motion::PairIndex;

namespace {
constexpr int kHandle_px = ErrorBarChart::kHandleWidth;
constexpr int kLineReach_px = 5;        // how near to the line counts as on it
constexpr double kLeastNear_px = 40.0;  // a bar is no wider, however near one looks
}  // namespace

ErrorBarChart::ErrorBarChart(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAccessibleName(tr("Error of each pair"));
  setAccessibleDescription(
      tr("One bar per pair. Left and right arrow keys select the neighbouring pair; up and down move the line above "
         "which Return rejects, Escape puts it back; plus and minus zoom."));
}

void ErrorBarChart::show_output(std::shared_ptr<const pipeline::PipelineOutput> output) {
  if (!output || !output_ || output->pairs.size() != output_->pairs.size()) by_line_.clear();
  output_ = std::move(output);
  hovered_.reset();
  if (!output_) threshold_.reset();
  find_values();
  show_pairs(pairs_);
}

void ErrorBarChart::show_pairs(const std::vector<PairIndex>& pairs) {
  const std::size_t all = output_ ? output_->pairs.size() : 0;
  std::vector<PairIndex> known;
  std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(known), [all](PairIndex pair) { return pair < all; });
  const bool as_many = known.size() == pairs_.size();
  pairs_ = std::move(known);
  if (!as_many) seen_ = whole();
  hovered_.reset();
  find_top();
  set_threshold(threshold_);
}

void ErrorBarChart::show_selected(std::optional<PairIndex> pair) {
  selected_ = pair;
  const int place = place_of(pair);
  if (place >= 0 && !(seen_.holds(place) && seen_.holds(place + 1))) look_at(place + 0.5 - 0.5 * seen_.length());
  update();
}

void ErrorBarChart::set_measure(PairMeasure measure) {
  measure_ = measure;
  stretch_ = 1.0;
  by_line_.clear();
  threshold_.reset();  // a height of the other axis
  find_values();
  find_top();
  set_threshold(std::nullopt);
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
  if (!pair) return -1;
  const auto found = std::find(pairs_.begin(), pairs_.end(), pair);
  return found == pairs_.end() ? -1 : static_cast<int>(found - pairs_.begin());
}

void ErrorBarChart::find_top() {
  // The line would jump, and with it what is above the hand, where its own work made the axis another.
  if (threshold_) return;
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
  top_ = stretch_;
  if (values.empty()) return;
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(0.95 * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  const double high = *place, largest = *std::max_element(values.begin(), values.end());
  const double top = high > 0.0 ? std::min(largest, 1.5 * high) : largest;
  if (top > 0.0) top_ = 1.05 * top * stretch_;
}

int ErrorBarChart::y_of(double value) const {
  const QRect area = plot_area();
  return area.bottom() - static_cast<int>(std::lround(std::min(1.0, value / top_) * area.height()));
}

double ErrorBarChart::value_at(int y) const {
  const QRect area = plot_area();
  return top_ * std::max(0, area.bottom() - y) / std::max(1, area.height());
}

double ErrorBarChart::bar_width() const { return plot_area().width() / seen_.length(); }

double ErrorBarChart::x_of(double place) const { return plot_area().left() + (place - seen_.low) * bar_width(); }

/// Bars stay within what there is, and as many are seen as before.
void ErrorBarChart::look_at(double first) {
  const double length = std::min(seen_.length(), whole().length());
  const double low = std::clamp(first, 0.0, whole().high - length);
  seen_ = {low, low + length};
  update();
}

void ErrorBarChart::zoom(double about_px, double factor) {
  const double area = std::max(1, plot_area().width());
  const double nearest = std::min(whole().length(), area / kLeastNear_px);
  const double place = seen_.low + (about_px - plot_area().left()) / bar_width();
  const double length = std::clamp(factor * seen_.length(), nearest, whole().length());
  const double first = place - (place - seen_.low) / seen_.length() * length;
  seen_ = {0.0, length};
  look_at(first);
}

void ErrorBarChart::stretch(double factor) {
  constexpr double kMost = 1e3;  // either way, from the usual
  const double before = stretch_;
  stretch_ = std::clamp(factor * stretch_, 1.0 / kMost, kMost);
  top_ *= stretch_ / before;
  update();
}

void ErrorBarChart::show_whole() {
  seen_ = whole();
  top_ /= stretch_;
  stretch_ = 1.0;
  find_top();
  update();
}

std::vector<ErrorBarChart::Bar> ErrorBarChart::bars() const {
  const double wide = bar_width();
  const bool alone = wide >= kLeastBar_px;
  const int first = std::max(0, static_cast<int>(seen_.low)),
            last = std::min(count(), static_cast<int>(std::ceil(seen_.high)));
  std::vector<Bar> bars(index_at(alone ? std::max(0, last - first) : plot_area().width() / kLeastBar_px + 1));
  for (int place = first; place < last; ++place) {
    const int column = alone ? place - first : static_cast<int>((place + 0.5 - seen_.low) * wide / kLeastBar_px);
    if (column < 0 || column >= std::ssize(bars)) continue;
    Bar& bar = bars[index_at(column)];
    const double value = value_of(pairs_[index_at(place)]).value_or(-1.0);
    if (bar.place < 0 || value > bar.value) bar = {value, place, column};
  }
  std::erase_if(bars, [](const Bar& bar) { return bar.place < 0; });
  return bars;
}

QRectF ErrorBarChart::span_of(const Bar& bar) const {
  const QRectF area = plot_area();
  const double wide = bar_width();
  if (wide < kLeastBar_px) return {area.left() + bar.column * kLeastBar_px, area.top(), kLeastBar_px, area.height()};
  return {x_of(bar.place), area.top(), std::max<double>(kLeastBar_px, wide - (wide > 4.0 ? 1.0 : 0.0)), area.height()};
}

std::optional<PairIndex> ErrorBarChart::pair_at(const QPoint& position) const {
  const QRect area = plot_area();
  if (pairs_.empty() || area.width() <= 0 || position.x() < area.left() || position.x() > area.right())
    return std::nullopt;
  const double right = position.x() - area.left(), wide = bar_width();
  if (wide >= kLeastBar_px)
    return pairs_[index_at(std::clamp(static_cast<int>(seen_.low + right / wide), 0, count() - 1))];
  const int column = static_cast<int>(right / kLeastBar_px);
  for (const Bar& bar : bars())
    if (bar.column == column) return pairs_[index_at(bar.place)];
  return std::nullopt;
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

/// The line stays where it was dropped: pulled back it gives back what it rejected.
void ErrorBarChart::apply_line() {
  std::vector<PairIndex> back;
  for (const PairIndex pair : by_line_)
    if (is_rejected(pair) && output_->pairs[pair].decided_by == motion::DecidedBy::User &&
        value_of(pair).value_or(0.0) <= threshold_.value_or(std::numeric_limits<double>::infinity()))
      back.push_back(pair);
  const std::vector<PairIndex> above = above_threshold();
  std::set<PairIndex> by_line = by_line_;  // what is emitted below may show another output
  for (const PairIndex pair : back) by_line.erase(pair);
  by_line.insert(above.begin(), above.end());
  by_line_ = std::move(by_line);
  if (!back.empty()) emit take_back_requested(back);
  if (!above.empty()) emit reject_requested(above, *threshold_);
}

}  // namespace remount::widgets
