#include "widgets/residuals/residual_plot.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "widgets/basics/rows.h"
#include "widgets/basics/theme.h"
#include "widgets/text/pair_reasons.h"

namespace remount::widgets {

using motion::PairIndex;

namespace {

constexpr double kNear_px = 9.0;
constexpr double kRoom = 0.04;  // beside the outermost points

/// Even-odd, as QPolygonF::containsPoint, but without its copies: a lasso asks a hundred thousand times.
bool lies_within(const QPolygonF& line, const QPointF& point) {
  bool inside = false;
  for (qsizetype i = 0, before = line.size() - 1; i < line.size(); before = i++) {
    const QPointF &a = line[i], &b = line[before];
    if ((a.y() > point.y()) != (b.y() > point.y()) &&
        point.x() < (b.x() - a.x()) * (point.y() - a.y()) / (b.y() - a.y()) + a.x())
      inside = !inside;
  }
  return inside;
}

double quantile_of(std::vector<double>& values, double share) {
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

}  // namespace

ResidualPlot::ResidualPlot(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAccessibleName(tr("Residuals of the pairs"));
  setAccessibleDescription(tr(
      "Each pair is a point. Left and right arrow keys select the neighbouring pair, plus and minus zoom, Home shows "
      "the usual part, Space marks the selected pair, Escape takes the marks away."));
}

void ResidualPlot::show_output(std::shared_ptr<const pipeline::PipelineOutput> output) {
  const std::size_t before = output_ ? output_->pairs.size() : 0;
  const bool same_view = output && output->pairs.size() == before && before > 0;
  output_ = std::move(output);
  hovered_.reset();
  const PlotFrame seen = frame_;
  find_values();
  if (same_view) {
    view(seen.across, seen.up);  // what somebody zoomed to stays under another solution
  } else {
    marked_.clear();
    show_usual();
  }
  if (selected_ && *selected_ >= count()) selected_.reset();
}

void ResidualPlot::show_session_names(const QStringList& names) {
  session_names_ = names;
  change();
}

void ResidualPlot::show_selected(std::optional<PairIndex> pair) {
  selected_ = pair && *pair < count() ? pair : std::nullopt;
  update();
}

void ResidualPlot::set_axes(ResidualMeasure measure, PairCircumstance circumstance) {
  measure_ = measure;
  circumstance_ = circumstance;
  find_values();
  show_usual();
}

void ResidualPlot::show_state_of_pairs(motion::PairState state, bool shown) {
  shown_[index_of(state)] = shown;
  const bool usual = frame_.up == usual_up_ && frame_.across == whole_across_;
  const PlotFrame seen = frame_;
  find_values();
  usual ? show_usual() : view(seen.across, seen.up);
}

/// Once: each picture asks for the values of all pairs several times.
void ResidualPlot::find_values() {
  across_.clear();
  up_.clear();
  states_.clear();
  if (output_) {
    up_ = values_of(*output_, measure_);
    across_ = values_of(*output_, circumstance_);
    states_.reserve(up_.size());
    for (const motion::Pair& pair : output_->pairs) states_.push_back(pair.state);
  }
  drawn_ = 0;
  for (std::size_t i = 0; i < count(); ++i) drawn_ += is_drawn(i);
  whole_across_ = whole_across();
  usual_up_ = whole_up(false);
  whole_up_ = whole_up(true);
}

bool ResidualPlot::is_drawn(std::size_t pair) const {
  return shown_[index_of(states_[pair])] && std::isfinite(up_[pair]) && std::isfinite(across_[pair]);
}

AxisSpan ResidualPlot::whole_across() const {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (std::size_t i = 0; i < count(); ++i) {
    if (!is_drawn(i)) continue;
    low = std::min(low, across_[i]);
    high = std::max(high, across_[i]);
  }
  return span_with_room(low, high, kRoom);
}

/// A few wild pairs must not flatten all others: the usual part ends at twice what 95 of 100 kept pairs lie in.
AxisSpan ResidualPlot::whole_up(bool all) const {
  std::vector<double> every, kept;
  for (std::size_t i = 0; i < count(); ++i) {
    if (!is_drawn(i)) continue;
    every.push_back(up_[i]);
    if (states_[i] != motion::PairState::Rejected) kept.push_back(up_[i]);
  }
  if (every.empty()) return {};
  const auto [least, most] = std::ranges::minmax_element(every);
  double low = *least, high = *most;
  if (!all) {
    std::vector<double>& typical = kept.empty() ? every : kept;
    const double middle = quantile_of(typical, 0.5);
    const double below = middle - quantile_of(typical, 0.025), above = quantile_of(typical, 0.975) - middle;
    const double reach = 2.0 * std::max(above, below);
    if (reach > 0.0) low = std::max(low, middle - reach), high = std::min(high, middle + reach);
  }
  if (!has_sign(measure_) && low < 0.35 * high) low = 0.0;  // a norm is small or large beside nothing
  AxisSpan span = span_with_room(low, high, 0.06);
  if (!has_sign(measure_) && low == 0.0) span.low = std::max(span.low, -0.03 * span.high);
  return span;
}

void ResidualPlot::view(const AxisSpan& across, const AxisSpan& up) {
  frame_.across = across;
  frame_.up = up;
  change();
}

void ResidualPlot::show_usual() { view(whole_across_, usual_up_); }

void ResidualPlot::show_all() { view(whole_across_, whole_up_); }

void ResidualPlot::change() {
  picture_ = {};
  update();
  emit contents_changed();
}

/// Nothing where it lies outside of what is seen.
std::optional<QPointF> ResidualPlot::point_of(std::size_t pair) const {
  if (!is_drawn(pair) || !frame_.across.holds(across_[pair]) || !frame_.up.holds(up_[pair])) return std::nullopt;
  return frame_.place_of(across_[pair], up_[pair]);
}

std::optional<QPointF> ResidualPlot::place_of(PairIndex pair) const {
  return pair < count() ? point_of(pair) : std::nullopt;
}

std::optional<PairIndex> ResidualPlot::pair_at(const QPointF& position) const {
  std::optional<PairIndex> nearest;
  double shortest_px = kNear_px;
  for (PairIndex i; i < count(); ++i) {
    const std::optional<QPointF> place = point_of(i);
    if (!place || std::abs(place->x() - position.x()) > shortest_px) continue;
    const double distance_px = std::hypot(place->x() - position.x(), place->y() - position.y());
    if (distance_px >= shortest_px) continue;
    shortest_px = distance_px;
    nearest = i;
  }
  return nearest;
}

std::vector<PairIndex> ResidualPlot::pairs_within(const QPolygonF& line) const {
  std::vector<PairIndex> within;
  const QRectF box = line.boundingRect();
  for (PairIndex i; i < count(); ++i)
    if (const auto place = point_of(i); place && box.contains(*place) && lies_within(line, *place)) within.push_back(i);
  return within;
}

void ResidualPlot::mark(const std::vector<PairIndex>& pairs) {
  marked_.clear();
  for (const PairIndex pair : pairs)
    if (pair < count()) marked_.insert(pair);
  change();
}

std::vector<PairIndex> ResidualPlot::marked_and_kept() const {
  std::vector<PairIndex> kept;
  for (const PairIndex pair : marked_)
    if (states_[pair] != motion::PairState::Rejected) kept.push_back(pair);
  return kept;
}

ResidualSummary ResidualPlot::summary() const {
  ResidualSummary summary;
  summary.drawn = drawn_;
  std::vector<double> accepted;
  for (std::size_t i = 0; i < count(); ++i) {
    if (states_[i] == motion::PairState::Accepted && std::isfinite(up_[i])) accepted.push_back(up_[i]);
    if (!shown_[index_of(states_[i])]) continue;
    if (!is_drawn(i))
      ++summary.unknown;
    else
      summary.outside += !point_of(i);
  }
  summary.accepted = qt_count(accepted.size());
  if (accepted.empty()) return summary;
  summary.mean = std::accumulate(accepted.begin(), accepted.end(), 0.0) / summary.accepted;
  double squares = 0.0;
  for (const double value : accepted) squares += (value - summary.mean) * (value - summary.mean);
  summary.deviation = std::sqrt(squares / std::max(1, summary.accepted - 1));
  return summary;
}

QString ResidualPlot::number_on(double value, PairCircumstance circumstance) const {
  const int decimals = circumstance == PairCircumstance::Time ? 1 : 2;
  return QStringLiteral("%1 %2").arg(value, 0, 'f', decimals).arg(unit_of(circumstance));
}

QString ResidualPlot::words_of(PairIndex index) const {
  if (index >= count()) return {};
  const motion::Pair& pair = output_->pairs[index];
  const QString value = std::isfinite(up_[index])
                            ? QStringLiteral("%1 %2").arg(up_[index], 0, 'g', 3).arg(unit_of(measure_))
                            : tr("not aligned");
  const int session = qt_row(output_->keyframes[pair.keyframe_a].session);
  if (circumstance_ == PairCircumstance::Session)
    return tr("pair %1: %2, %3, %4")
        .arg(index)
        .arg(value, session_names_.value(session, QString::number(session + 1)), state_text(pair));
  if (!std::isfinite(across_[index])) return tr("pair %1: %2, %3").arg(index).arg(value, state_text(pair));
  return tr("pair %1: %2 at %3, %4").arg(index).arg(value, number_on(across_[index], circumstance_), state_text(pair));
}

}  // namespace remount::widgets
