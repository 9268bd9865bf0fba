#include "widgets/result/candidate_plot.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "algorithms/core/index.h"
#include "model/results/result_file.h"
#include "widgets/basics/theme.h"
#include "widgets/charts/chart_axis.h"
#include "widgets/text/parameter_text.h"

namespace remount::widgets {
namespace {
constexpr double kReach_px = 9.0;

/// A single number on an axis tells no scale.
std::vector<double> several_ticks(double low, double high, int steps) {
  std::vector<double> ticks;
  for (int finer = std::max(3, steps); ticks.size() < 2 && finer < 20; ++finer) ticks = nice_ticks(low, high, finer);
  return ticks;
}
}  // namespace

CandidatePlot::CandidatePlot(Kind kind, QWidget* parent) : QWidget(parent), kind_(kind) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(kind == Kind::Position ? tr("Candidates: x, y, z") : tr("Candidates: yaw, pitch, roll"));
  setAccessibleDescription(tr("Left and right arrow keys select the candidate before or after in rank."));
  show_range({});
}

void CandidatePlot::show_output(std::shared_ptr<const pipeline::PipelineOutput> output) {
  output_ = std::move(output);
  shown_.clear();
  result_.reset();
  for (calibration::CandidateIndex i; i < count(); ++i)
    shown_.push_back(results::six_on_screen(output_->result.candidates[i].ins_from_lidar));
  if (output_ && calibration::is_usable(output_->result))
    result_ = results::six_on_screen(output_->result.mounting.reference_from_sensor);
  if (selected_ && *selected_ >= count()) selected_.reset();
  find_limits();
}

void CandidatePlot::show_range(const calibration::SearchRange& range) {
  range_[calibration::Parameter::X] = {range.x_min_m, range.x_max_m};
  range_[calibration::Parameter::Y] = {range.y_min_m, range.y_max_m};
  range_[calibration::Parameter::Z] = {range.z_min_m, range.z_max_m};
  range_[calibration::Parameter::Yaw] = {radians_to_degrees(range.yaw_min_rad), radians_to_degrees(range.yaw_max_rad)};
  range_[calibration::Parameter::Pitch] = {radians_to_degrees(range.pitch_min_rad),
                                           radians_to_degrees(range.pitch_max_rad)};
  range_[calibration::Parameter::Roll] = {radians_to_degrees(range.roll_min_rad),
                                          radians_to_degrees(range.roll_max_rad)};
  update();
}

void CandidatePlot::show_nominal(const std::optional<RigidTransform>& nominal) {
  nominal_ = nominal ? std::optional(results::six_on_screen(*nominal)) : std::nullopt;
  find_limits();
}

void CandidatePlot::show_selected(std::optional<calibration::CandidateIndex> candidate) {
  selected_ = candidate && *candidate < count() ? candidate : std::nullopt;
  update();
}

void CandidatePlot::find_limits() {
  // Those out of range may be anywhere; where there are others, they do not squeeze these together.
  const bool any_in_range = std::any_of(shown_.begin(), shown_.end(), [&](const auto& six) {
    return output_->result.candidates[static_cast<std::size_t>(&six - shown_.data())].in_range;
  });
  for (int axis = 0; axis < 3; ++axis) {
    Limits limits{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    const auto take = [&](const calibration::PerParameter<double>& six) {
      limits.low = std::min(limits.low, six[parameter(axis)]);
      limits.high = std::max(limits.high, six[parameter(axis)]);
    };
    for (std::size_t i = 0; i < shown_.size(); ++i)
      if (output_->result.candidates[i].in_range || !any_in_range) take(shown_[i]);
    if (nominal_) take(*nominal_);
    if (result_) take(*result_);
    if (!(limits.high >= limits.low)) limits = {-1.0, 1.0};
    const double least = kind_ == Kind::Position ? 0.02 : 0.2, pad = std::max(least, 0.12 * (limits.high - limits.low));
    limits_[index_at(axis)] = {limits.low - pad, limits.high + pad};
  }
  update();
}

QRectF CandidatePlot::view_area(int view) const {
  const double left = fontMetrics().horizontalAdvance(QStringLiteral("-000.0")) + 6.0, half = 0.5 * width();
  // The title, and half of the topmost number below it.
  const double line = fontMetrics().height(), top = 1.5 * line + 4.0;
  return {view * half + left, top, half - left - 8.0, height() - top - line - 4.0};
}

QPointF CandidatePlot::to_screen(int view, double horizontal, double vertical) const {
  const QRectF area = view_area(view);
  const Limits &h = limits_[0], &v = limits_[index_at(view + 1)];
  const double right = std::clamp((horizontal - h.low) / (h.high - h.low), 0.0, 1.0);
  const double up = std::clamp((vertical - v.low) / (v.high - v.low), 0.0, 1.0);
  return {area.left() + right * area.width(), area.bottom() - up * area.height()};
}

QPointF CandidatePlot::place_of(calibration::CandidateIndex candidate, int view) const {
  const calibration::PerParameter<double>& six = shown_.at(candidate);
  return to_screen(view, six[parameter(0)], six[parameter(view + 1)]);
}

std::optional<calibration::CandidateIndex> CandidatePlot::candidate_at(const QPointF& position) const {
  std::optional<calibration::CandidateIndex> nearest;
  double shortest = kReach_px;
  for (calibration::CandidateIndex i; i < count(); ++i)
    for (int view = 0; view < 2; ++view) {
      const QPointF off = place_of(i, view) - position;
      const double distance = std::hypot(off.x(), off.y());
      if (distance >= shortest) continue;
      shortest = distance;
      nearest = i;
    }
  return nearest;
}

void CandidatePlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().color(QPalette::Base));
  if (count() == 0) {
    painter.setPen(palette().color(QPalette::Disabled, QPalette::Text));
    painter.drawText(rect().adjusted(8, 8, -8, -8), Qt::AlignCenter | Qt::TextWordWrap,
                     kind_ == Kind::Position ? tr("Candidates appear here: x, y, z.")
                                             : tr("Candidates appear here: yaw, pitch, roll."));
    return;
  }
  for (int view = 0; view < 2; ++view) paint_view(painter, view);
  if (!hasFocus()) return;
  painter.setPen(QPen(palette().color(QPalette::Highlight), 1));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

void CandidatePlot::paint_view(QPainter& painter, int view) const {
  const QRectF area = view_area(view);
  paint_range(painter, view);
  const Limits &h = limits_[0], &v = limits_[index_at(view + 1)];
  const double line = fontMetrics().height();
  for (const double tick : several_ticks(h.low, h.high, static_cast<int>(area.width() / 45.0))) {
    const QPointF foot = to_screen(view, tick, v.low);
    painter.setPen(grid_color(palette()));
    painter.drawLine(foot, QPointF(foot.x(), area.top()));
    painter.setPen(faint_text_color(palette()));
    const QString number = QString::number(tick, 'g', 4);
    const double wide = fontMetrics().horizontalAdvance(number);
    // The last one stays whole at the edge.
    const double from = std::min(foot.x() - 0.5 * wide, 0.5 * (view + 1) * width() - wide - 2.0);
    painter.drawText(QRectF(from, area.bottom() + 1, wide + 1.0, line), Qt::AlignLeft, number);
  }
  for (const double tick : several_ticks(v.low, v.high, static_cast<int>(area.height() / 24.0))) {
    const QPointF left = to_screen(view, h.low, tick);
    painter.setPen(grid_color(palette()));
    painter.drawLine(left, QPointF(area.right(), left.y()));
    painter.setPen(faint_text_color(palette()));
    painter.drawText(QRectF(left.x() - 90, left.y() - line / 2, 86, line), Qt::AlignRight | Qt::AlignVCenter,
                     QString::number(tick, 'g', 4));
  }
  painter.setPen(palette().color(QPalette::Text));
  // Both axes in one title: side by side, two would run into each other.
  const double left = 0.5 * view * width() + 4.0;
  painter.drawText(QRectF(left, 2, area.right() - left, line), Qt::AlignLeft | Qt::TextDontClip, title(view));
  painter.setRenderHint(QPainter::Antialiasing, true);
  paint_points(painter, view);
  painter.setRenderHint(QPainter::Antialiasing, false);
}

QString CandidatePlot::title(int view) const {
  //: axes of a plot: the vertical one over the horizontal one, and their unit
  return tr("%1 over %2 [%3]")
      .arg(parameter_name(parameter(view + 1)), parameter_name(parameter(0)), unit_suffix(parameter(0)).trimmed());
}

void CandidatePlot::paint_range(QPainter& painter, int view) const {
  const Limits &h = range_[parameter(0)], &v = range_[parameter(view + 1)];
  const QRectF inside(to_screen(view, h.low, v.high), to_screen(view, h.high, v.low));
  painter.fillRect(inside, tint(state_color(motion::PairState::Proposed, palette()), palette()));
  painter.setPen(QPen(state_color(motion::PairState::Proposed, palette()), 1, Qt::DashLine));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(inside);
}

void CandidatePlot::paint_points(QPainter& painter, int view) const {
  const QColor inside = good_color(palette()), outside = state_color(motion::PairState::Rejected, palette());
  // The best last, above all others.
  for (std::size_t worse = count(); worse > 0; --worse) {
    const calibration::CandidateIndex i(worse - 1);
    const bool in_range = output_->result.candidates[i].in_range;
    painter.setPen(in_range ? QPen(palette().color(QPalette::Base), 0.8) : QPen(outside, 1.0));
    painter.setBrush(in_range ? QBrush(inside) : QBrush(Qt::NoBrush));
    painter.drawEllipse(place_of(i, view), 3.2, 3.2);
  }
  painter.setBrush(Qt::NoBrush);
  if (nominal_) {
    const QPointF at = to_screen(view, (*nominal_)[parameter(0)], (*nominal_)[parameter(view + 1)]);
    painter.setPen(QPen(warning_color(palette()), 2.0));
    painter.drawLine(at - QPointF(6, 0), at + QPointF(6, 0));
    painter.drawLine(at - QPointF(0, 6), at + QPointF(0, 6));
  }
  if (result_) {
    painter.setPen(QPen(palette().color(QPalette::Text), 1.6));
    painter.drawEllipse(to_screen(view, (*result_)[parameter(0)], (*result_)[parameter(view + 1)]), 6.5, 6.5);
  }
  if (!selected_) return;
  painter.setPen(QPen(palette().color(QPalette::Highlight), 2.5));
  painter.drawEllipse(place_of(*selected_, view), 9.0, 9.0);
}

void CandidatePlot::mousePressEvent(QMouseEvent* event) {
  if (const auto candidate = candidate_at(event->position())) emit candidate_pointed(*candidate);
}

void CandidatePlot::mouseMoveEvent(QMouseEvent* event) {
  const std::optional<calibration::CandidateIndex> candidate = candidate_at(event->position());
  setCursor(candidate ? Qt::PointingHandCursor : Qt::ArrowCursor);
  if (candidate && candidate != selected_) emit candidate_pointed(*candidate);
}

void CandidatePlot::keyPressEvent(QKeyEvent* event) {
  const int step = event->key() == Qt::Key_Left ? -1 : event->key() == Qt::Key_Right ? 1 : 0;
  if (step == 0 || count() == 0) return QWidget::keyPressEvent(event);
  emit candidate_pointed(
      index_at<calibration::CandidateIndex>(std::clamp(qt_row(selected_) + step, 0, qt_count(count()) - 1)));
}

}  // namespace remount::widgets
