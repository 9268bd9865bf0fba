#include "widgets/sessions/drive_timeline.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QTextDocument>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "algorithms/core/index.h"
#include "widgets/basics/theme.h"
#include "widgets/charts/chart_axis.h"

namespace remount::widgets {
namespace {
QString quality_text(motion::InsQuality quality) {
  switch (quality) {
    case motion::InsQuality::Good:
      return DriveTimeline::tr("good");
    case motion::InsQuality::Degraded:
      return DriveTimeline::tr("degraded");
    case motion::InsQuality::Invalid:
      return DriveTimeline::tr("not valid");
    case motion::InsQuality::Unknown:
      break;
  }
  return DriveTimeline::tr("not stated");
}
}  // namespace

DriveTimeline::DriveTimeline(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Streams and INS quality over time"));
  setAccessibleDescription(tr("Left and right arrow keys select the pair that was recorded before or after."));
}

void DriveTimeline::show_drive(std::shared_ptr<const overview::DriveOverview> drive) {
  drive_ = std::move(drive);
  update();
}

void DriveTimeline::show_times(std::optional<std::pair<double, double>> times_s) {
  times_s_ = times_s;
  update();
}

bool DriveTimeline::shows_sigma() const {
  return drive_ &&
         std::any_of(drive_->stretches.begin(), drive_->stretches.end(),
                     [](const overview::InsStretch& stretch) { return std::isfinite(stretch.position_sigma_m); });
}

double DriveTimeline::curve_value(const overview::InsStretch& stretch) const {
  return shows_sigma() ? stretch.position_sigma_m : stretch.speed_m_s;
}

std::array<QString, DriveTimeline::kRows> DriveTimeline::row_names() const {
  return {tr("LiDAR"), tr("INS"), tr("fix"), QString()};
}

QRect DriveTimeline::curve_area() const {
  return plot_area().adjusted(0, kRows * row_height() + fontMetrics().height() + 8, 0, -row_height());
}

QRect DriveTimeline::plot_area() const {
  int widest = fontMetrics().horizontalAdvance(QStringLiteral("0.000"));  // of the curve's ticks
  for (const QString& name : row_names()) widest = std::max(widest, fontMetrics().horizontalAdvance(name));
  return rect().adjusted(widest + 10, 2, -8, -2);
}

double DriveTimeline::time_at(int x) const {
  const QRect area = plot_area();
  return drive_ ? drive_->duration_s * std::clamp(x - area.left(), 0, area.width()) / std::max(1, area.width()) : 0.0;
}

int DriveTimeline::x_of(double time_s) const {
  const QRect area = plot_area();
  if (!drive_ || !(drive_->duration_s > 0.0)) return area.left();
  return area.left() + static_cast<int>(std::lround(time_s / drive_->duration_s * area.width()));
}

QColor DriveTimeline::quality_color(motion::InsQuality quality) const {
  switch (quality) {
    case motion::InsQuality::Good:
      return good_color(palette());
    case motion::InsQuality::Degraded:
      return warning_color(palette());
    case motion::InsQuality::Invalid:
      return bad_color(palette());
    case motion::InsQuality::Unknown:
      break;
  }
  return palette().color(QPalette::Mid);
}

void DriveTimeline::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().color(QPalette::Base));
  if (!drive_ || !(drive_->duration_s > 0.0)) return;
  paint_rows(painter);
  paint_curve(painter);
  if (times_s_) {
    painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
    for (const double time_s : {times_s_->first, times_s_->second})  // not through the words in between
      for (const auto& [top, bottom] :
           {std::pair{2, 3 * row_height()}, std::pair{curve_area().top() - 4, curve_area().bottom()}})
        painter.drawLine(x_of(time_s), top, x_of(time_s), bottom);
  }
  if (!hasFocus()) return;
  painter.setPen(QPen(palette().color(QPalette::Highlight), 1));
  painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

void DriveTimeline::paint_rows(QPainter& painter) const {
  const QRect area = plot_area();
  const auto names = row_names();
  for (int i = 0; i < kRows; ++i) {
    const QRect row(area.left(), area.top() + i * row_height(), area.width(), row_height() - 4);
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(QRect(4, row.top() - 2, area.left() - 6, row_height()), Qt::AlignLeft | Qt::AlignVCenter,
                     names[index_at(i)]);
    if (i >= 2) {
      i == 2 ? paint_quality(painter, row) : paint_quality_legend(painter, row);
      continue;
    }
    const overview::StreamReport& stream = i == 0 ? drive_->lidar : drive_->ins;
    if (stream.count == 0) continue;
    const int first = x_of(drive_->time_s(stream.first_ns)), last = x_of(drive_->time_s(stream.last_ns));
    painter.fillRect(QRect(first, row.top(), std::max(1, last - first), row.height()),
                     state_color(motion::PairState::Proposed, palette()));
    for (const overview::TimeGap& gap : i == 0 ? drive_->lidar_gaps : drive_->ins_gaps)
      painter.fillRect(QRect(x_of(gap.from_s), row.top(), std::max(2, x_of(gap.to_s) - x_of(gap.from_s)), row.height()),
                       bad_color(palette()));
  }
}

void DriveTimeline::paint_quality(QPainter& painter, const QRect& row) const {
  const auto& stretches = drive_->stretches;
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    const int from = x_of(stretches[i].time_s);
    const int to = i + 1 < stretches.size() ? x_of(stretches[i + 1].time_s) : from + 1;
    painter.fillRect(QRect(from, row.top(), std::max(1, to - from), row.height()), quality_color(stretches[i].quality));
  }
}

QString DriveTimeline::quality_legend() const {
  QStringList named;
  for (const motion::InsQuality quality : {motion::InsQuality::Good, motion::InsQuality::Degraded,
                                           motion::InsQuality::Invalid, motion::InsQuality::Unknown})
    if (std::any_of(drive_->stretches.begin(), drive_->stretches.end(),
                    [&](const overview::InsStretch& stretch) { return stretch.quality == quality; }))
      named << QStringLiteral("<font color='%1'>■</font> %2").arg(quality_color(quality).name(), quality_text(quality));
  return tr("GNSS fix: %1").arg(named.join(QStringLiteral("  ")));
}

void DriveTimeline::paint_quality_legend(QPainter& painter, const QRect& row) const {
  QTextDocument text;
  text.setDocumentMargin(0.0);
  text.setDefaultFont(font());
  text.setHtml(
      QStringLiteral("<span style='color:%1'>%2</span>").arg(palette().color(QPalette::Text).name(), quality_legend()));
  painter.save();
  painter.translate(4, row.top() - 2);
  text.drawContents(&painter);
  painter.restore();
}

void DriveTimeline::paint_curve(QPainter& painter) const {
  const QRect area = curve_area();
  double top = 0.0;
  for (const overview::InsStretch& stretch : drive_->stretches)
    if (std::isfinite(curve_value(stretch))) top = std::max(top, curve_value(stretch));
  // Up to the next tick and a little more: a line at the edge of the chart would look cut off.
  const double step = nice_step(top > 0.0 ? top : 1.0, std::max(1, area.height() / 28));
  top = step * (std::floor(top / step) + 1.0);
  painter.setPen(palette().color(QPalette::Text));
  painter.drawText(QRect(4, area.top() - fontMetrics().height() - 8, width() - 8, fontMetrics().height()),
                   Qt::AlignLeft | Qt::TextDontClip,
                   shows_sigma() ? tr("position sigma of the INS [m]") : tr("speed [m/s] (the log states no sigma)"));
  for (const double value : nice_ticks(0.0, top, static_cast<int>(std::lround(top / step)))) {
    const int y = area.bottom() - static_cast<int>(value / top * area.height());
    painter.setPen(grid_color(palette()));
    painter.drawLine(area.left(), y, area.right(), y);
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(QRect(0, y - 9, area.left() - 4, 18), Qt::AlignRight | Qt::AlignVCenter,
                     QString::number(value, 'g', 3));
  }
  painter.setRenderHint(QPainter::Antialiasing, true);
  painter.setPen(QPen(state_color(motion::PairState::Proposed, palette()), 1.5));
  QPolygonF line;
  for (const overview::InsStretch& stretch : drive_->stretches) {
    if (!std::isfinite(curve_value(stretch))) {
      painter.drawPolyline(line);
      line.clear();
      continue;
    }
    line << QPointF(x_of(stretch.time_s), area.bottom() - curve_value(stretch) / top * area.height());
  }
  painter.drawPolyline(line);
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setPen(faint_text_color(palette()));
  const QRect below(area.left(), area.bottom() + 2, area.width(), row_height());
  painter.drawText(below, Qt::AlignLeft, tr("0 s"));
  painter.drawText(below, Qt::AlignRight, tr("%1 s").arg(drive_->duration_s, 0, 'f', 1));
}

void DriveTimeline::mousePressEvent(QMouseEvent* event) {
  if (drive_ && event->button() == Qt::LeftButton) emit time_clicked(time_at(event->pos().x()));
}

void DriveTimeline::keyPressEvent(QKeyEvent* event) {
  const int step = event->key() == Qt::Key_Left ? -1 : event->key() == Qt::Key_Right ? 1 : 0;
  if (step == 0 || !drive_) return QWidget::keyPressEvent(event);
  const double from_s = times_s_ ? 0.5 * (times_s_->first + times_s_->second) : 0.0;
  emit time_clicked(std::clamp(from_s + 0.02 * step * drive_->duration_s, 0.0, drive_->duration_s));
}

bool DriveTimeline::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip || !drive_ || drive_->stretches.empty()) return QWidget::event(event);
  auto* help = static_cast<QHelpEvent*>(event);
  const double time_s = time_at(help->pos().x());
  const auto after =
      std::upper_bound(drive_->stretches.begin(), drive_->stretches.end(), time_s,
                       [](double time, const overview::InsStretch& stretch) { return time < stretch.time_s; });
  const overview::InsStretch& stretch = *(after == drive_->stretches.begin() ? after : after - 1);
  QString text = tr("%1 s: GNSS fix %2, %3 m/s")
                     .arg(time_s, 0, 'f', 1)
                     .arg(quality_text(stretch.quality))
                     .arg(stretch.speed_m_s, 0, 'f', 1);
  if (std::isfinite(stretch.position_sigma_m))
    text += tr("\nsigma: position %1 m, attitude %2°")
                .arg(stretch.position_sigma_m, 0, 'g', 3)
                .arg(radians_to_degrees(stretch.attitude_sigma_rad), 0, 'g', 3);
  QToolTip::showText(help->globalPos(), text, this);
  return true;
}

}  // namespace remount::widgets
