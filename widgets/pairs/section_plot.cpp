#include "widgets/pairs/section_plot.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>

#include "algorithms/core/index.h"
#include "widgets/basics/rows.h"
#include "widgets/basics/swatch.h"
#include "widgets/basics/theme.h"
#include "widgets/charts/chart_axis.h"
#include "widgets/scene/pair_colors.h"

namespace remount::widgets {
namespace {

constexpr double kLeastReach_m = 0.05, kMostReach_m = 0.4;
constexpr int kBins = 40;
constexpr double kStep_m = 0.5;

double millimetres(double metres) { return 1000.0 * metres; }

/// So far that the surface under the worst alignment is in the picture.
double reach_of(const std::vector<ShownCut>& cuts, const quality::Section& section) {
  if (section.kind == quality::SectionKind::Pole) return section.half_size_m.y();
  double widest_m = kLeastReach_m;
  for (const ShownCut& shown : cuts)
    widest_m = std::max({widest_m, 4.0 * shown.cut.thickness_together_m,
                         1.5 * std::abs(shown.cut.offset_m) + 3.0 * shown.cut.thickness_b_m});
  return std::min(widest_m, kMostReach_m);
}

QString millimetres_text(double metres) { return QString::number(millimetres(metres), 'f', 0); }

}  // namespace

QString cut_in_words(const quality::SectionCut& cut, quality::SectionKind kind) {
  if (!cut.measured) return SectionPlot::tr("too few points");
  const QString apart = millimetres_text(std::abs(cut.offset_m));
  if (kind == quality::SectionKind::Pole)
    return SectionPlot::tr("axes %1 mm apart; radius %2 mm together (a %3, b %4)")
        .arg(apart, millimetres_text(cut.thickness_together_m), millimetres_text(cut.thickness_a_m),
             millimetres_text(cut.thickness_b_m));
  return SectionPlot::tr("%1 mm thick together (a %2, b %3), %4")
      .arg(millimetres_text(cut.thickness_together_m), millimetres_text(cut.thickness_a_m),
           millimetres_text(cut.thickness_b_m),
           millimetres(std::abs(cut.offset_m)) < 0.5 ? SectionPlot::tr("a on b")
           : cut.offset_m > 0.0                      ? SectionPlot::tr("a %1 mm before b").arg(apart)
                                                     : SectionPlot::tr("a %1 mm behind b").arg(apart));
}

/// Where one of the pictures is, and how its metres become pixels.
struct SectionPlot::Frame {
  QRectF points, histogram;
  QPointF centre_px;
  double along_px_per_m = 1.0, across_px_per_m = 1.0;

  QPointF at(const Eigen::Vector2f& point_m) const {
    return {centre_px.x() + static_cast<double>(point_m.x()) * along_px_per_m,
            centre_px.y() - static_cast<double>(point_m.y()) * across_px_per_m};
  }
};

SectionPlot::SectionPlot(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Section through the pair"));
  setToolTip(
      tr("A slab through a surface that both scans see. The thinner it is, the better the scans lie on each other.\n"
         "Dragging to the side, Left and Right move it along the surface, Up and Down to the side of the slab."));
}

void SectionPlot::show_cuts(const quality::Section& section, std::vector<ShownCut> cuts) {
  section_ = section;
  cuts_ = std::move(cuts);
  message_.clear();
  reach_m_ = reach_of(cuts_, section_);
  tell();
  update();
}

void SectionPlot::show_message(const QString& text) {
  cuts_.clear();
  message_ = text;
  tell();
  update();
}

void SectionPlot::tell() {
  QStringList lines;
  for (const ShownCut& shown : cuts_) lines << tr("%1: %2").arg(shown.title, cut_in_words(shown.cut, section_.kind));
  setAccessibleDescription(cuts_.empty() ? message_ : lines.join('\n'));
}

std::vector<SectionPlot::Frame> SectionPlot::frames() const {
  std::vector<Frame> frames;
  const double line = fontMetrics().height(), left = fontMetrics().horizontalAdvance(QStringLiteral("-000 "));
  const double each = (width() - left) / static_cast<double>(std::max<std::size_t>(1, cuts_.size()));
  for (int i = 0; i < qt_count(cuts_.size()); ++i) {
    Frame frame;
    const QRectF all(left + i * each, 2.0 * line + 4.0, each - 8.0, height() - 3.2 * line - 8.0);
    const double bars = 0.22 * all.width();
    frame.points = all.adjusted(0.0, 0.0, -bars, 0.0);
    frame.histogram = QRectF(frame.points.right() + 2.0, all.top(), bars - 2.0, all.height());
    frame.centre_px = frame.points.center();
    frame.across_px_per_m = 0.5 * frame.points.height() / reach_m_;
    frame.along_px_per_m = 0.5 * frame.points.width() / section_.half_size_m.x();
    if (section_.kind == quality::SectionKind::Pole)
      frame.along_px_per_m = frame.across_px_per_m = std::min(frame.along_px_per_m, frame.across_px_per_m);
    frames.push_back(frame);
  }
  return frames;
}

void SectionPlot::paint_points(QPainter& painter, const Frame& frame, const std::vector<Eigen::Vector2f>& points_m,
                               const QColor& color) const {
  QPolygonF dots;
  for (const Eigen::Vector2f& point : points_m)
    if (const QPointF at = frame.at(point); frame.points.contains(at)) dots << at;
  painter.setPen(QPen(color, 2.0, Qt::SolidLine, Qt::RoundCap));
  painter.drawPoints(dots);
}

void SectionPlot::paint_histogram(QPainter& painter, const Frame& frame, const quality::SectionCut& cut) const {
  std::array<std::vector<double>, 2> shares;
  double most = 1e-9;
  const std::array<const std::vector<Eigen::Vector2f>*, 2> scans{&cut.scan_b_m, &cut.scan_a_m};
  for (std::size_t s = 0; s < scans.size(); ++s) {
    shares[s].assign(kBins, 0.0);
    for (const Eigen::Vector2f& point : *scans[s]) {
      const double place = 0.5 * (static_cast<double>(point.y()) / reach_m_ + 1.0) * kBins;
      if (place >= 0.0 && place < kBins)
        shares[s][static_cast<std::size_t>(place)] += 1.0 / static_cast<double>(scans[s]->size());
    }
    most = std::max(most, *std::max_element(shares[s].begin(), shares[s].end()));
  }
  const scene::ScanColors colors = scene::scan_colors(is_dark(palette()));
  const std::array<QColor, 2> of_scans{to_qt(colors.target), to_qt(colors.orange)};
  const double bar = 2.0 * reach_m_ / kBins * frame.across_px_per_m;
  for (std::size_t s = 0; s < shares.size(); ++s) {
    QPolygonF outline;
    for (int bin = 0; bin < kBins; ++bin) {
      const double y = frame.centre_px.y() + reach_m_ * frame.across_px_per_m - bin * bar;
      const double x = frame.histogram.left() + shares[s][index_at(bin)] / most * frame.histogram.width();
      outline << QPointF(x, y) << QPointF(x, y - bar);
    }
    painter.setPen(QPen(of_scans[s], 1.5));
    painter.drawPolyline(outline);
  }
}

void SectionPlot::paint_axes(QPainter& painter, const Frame& frame) const {
  painter.setPen(grid_color(palette()));
  painter.drawRect(frame.points);
  for (const double tick_mm : nice_ticks(-millimetres(reach_m_), millimetres(reach_m_), 4)) {
    const double y = frame.at(Eigen::Vector2f(0.0F, static_cast<float>(1e-3 * tick_mm))).y();
    if (y < frame.points.top() || y > frame.points.bottom()) continue;
    painter.drawLine(QPointF(frame.points.left(), y), QPointF(frame.histogram.right(), y));
  }
}

void SectionPlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().base());
  if (cuts_.empty()) {
    painter.setPen(faint_text_color(palette()));
    painter.drawText(rect().adjusted(8, 8, -8, -8), Qt::AlignCenter | Qt::TextWordWrap, message_);
    return;
  }
  const scene::ScanColors colors = scene::scan_colors(is_dark(palette()));
  const std::vector<Frame> places = frames();
  const double line = fontMetrics().height();
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Frame& frame = places[i];
    paint_axes(painter, frame);
    paint_points(painter, frame, cuts_[i].cut.scan_b_m, to_qt(colors.target));
    paint_points(painter, frame, cuts_[i].cut.scan_a_m, to_qt(colors.orange));
    paint_histogram(painter, frame, cuts_[i].cut);
    const QRectF words(frame.points.left(), 2.0, frame.histogram.right() - frame.points.left(), line);
    painter.setPen(palette().text().color());
    painter.drawText(words, Qt::AlignLeft, cuts_[i].title);
    painter.setPen(faint_text_color(palette()));
    QString numbers = cut_in_words(cuts_[i].cut, section_.kind);
    if (cuts_[i].cut.measured && fontMetrics().horizontalAdvance(numbers) > words.width())
      numbers = tr("%1 mm, a %2")
                    .arg(millimetres_text(cuts_[i].cut.thickness_together_m))
                    .arg(millimetres(cuts_[i].cut.offset_m), 0, 'f', 0);
    painter.drawText(words.translated(0.0, line), Qt::AlignLeft, numbers);
  }
  const Frame& first = places.front();
  painter.setPen(faint_text_color(palette()));
  for (const double tick_mm : nice_ticks(-millimetres(reach_m_), millimetres(reach_m_), 4)) {
    const double y = first.at(Eigen::Vector2f(0.0F, static_cast<float>(1e-3 * tick_mm))).y();
    painter.drawText(QRectF(0.0, y - 0.5 * line, first.points.left() - 4.0, line), Qt::AlignRight | Qt::AlignVCenter,
                     QString::number(tick_mm, 'f', 0));
  }
  painter.drawText(QRectF(0.0, height() - line - 2.0, width(), line), Qt::AlignCenter,
                   tr("%1 m along the surface, mm across it").arg(2.0 * section_.half_size_m.x(), 0, 'f', 1));
}

void SectionPlot::mousePressEvent(QMouseEvent* event) { pressed_x_ = event->position().x(); }

void SectionPlot::mouseReleaseEvent(QMouseEvent* event) {
  const double by_px = event->position().x() - pressed_x_;
  if (cuts_.empty() || std::abs(by_px) < 4.0) return;
  emit moved(Eigen::Vector3d(-by_px / frames().front().along_px_per_m, 0.0, 0.0));
}

void SectionPlot::keyPressEvent(QKeyEvent* event) {
  Eigen::Vector3d by_m = Eigen::Vector3d::Zero();
  if (event->key() == Qt::Key_Left) by_m.x() = -kStep_m;
  if (event->key() == Qt::Key_Right) by_m.x() = kStep_m;
  if (event->key() == Qt::Key_Up) by_m.z() = kStep_m;
  if (event->key() == Qt::Key_Down) by_m.z() = -kStep_m;
  if (cuts_.empty() || by_m.isZero()) return QWidget::keyPressEvent(event);
  emit moved(by_m);
}

void SectionPlot::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) update();
  QWidget::changeEvent(event);
}

}  // namespace remount::widgets
