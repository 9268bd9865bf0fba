#include "widgets/sessions/drive_map.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <map>

#include "widgets/basics/theme.h"
#include "widgets/text/pair_reasons.h"

namespace remount::widgets {
namespace {
constexpr double kMapReach_px = 14.0, kMapMargin_px = 24.0, kFurthest_px = 4.0;
constexpr double kStep = 1.25, kLargest = 2000.0, kSmallest = 1e-4;  // pixels per metre
}  // namespace

DriveMap::DriveMap(QWidget* parent) : QWidget(parent), hint_(tr("The drive appears here once it is open.")) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAccessibleName(tr("Map of the drive"));
  setAccessibleDescription(
      tr("Trajectory with keyframes and pairs. Plus and minus zoom, the arrow keys pan, Home shows all."));
}

void DriveMap::set_hint(const QString& hint) {
  hint_ = hint;
  update();
}

void DriveMap::show_drive(std::shared_ptr<const overview::DriveOverview> drive, motion::SessionIndex session) {
  const bool other = drive != drive_;
  drive_ = std::move(drive);
  session_ = session;
  collect_links();
  if (other) fit();
  update();
}

void DriveMap::show_output(std::shared_ptr<const pipeline::PipelineOutput> output) {
  output_ = std::move(output);
  collect_links();
  update();
}

void DriveMap::collect_links() {
  links_.clear();
  if (!drive_ || !output_) return;
  std::map<motion::KeyframeIndex, int> of_keyframe;
  for (motion::PairIndex i; i < output_->pairs.size(); ++i) {
    const motion::Pair& pair = output_->pairs[i];
    const motion::Keyframe& a = output_->keyframes[pair.keyframe_a];
    const motion::Keyframe& b = output_->keyframes[pair.keyframe_b];
    const std::size_t scans = drive_->scans_m.size();
    if (a.session != session_ || a.scan >= scans || b.scan >= scans) continue;
    Link link{i, drive_->scans_m[a.scan], drive_->scans_m[b.scan], 0.0};
    if (!link.a_m.allFinite() || !link.b_m.allFinite()) continue;
    // Partners of one keyframe lie along the same road: their arcs stand off to both sides in turn.
    const int turn = of_keyframe[pair.keyframe_a]++;
    link.bulge = (turn % 2 == 0 ? 1.0 : -1.0) * (10.0 + 7.0 * (turn / 2));
    links_.push_back(link);
  }
}

QPointF DriveMap::on_screen(const Eigen::Vector2d& place_m) const {
  const Eigen::Vector2d off = (place_m - centre_m_) * pixels_per_m_;
  return {0.5 * width() + off.x(), 0.5 * height() - off.y()};
}

QPointF DriveMap::middle(const Link& link) const {
  const QPointF a = on_screen(link.a_m), b = on_screen(link.b_m), chord = b - a;
  const double length = std::hypot(chord.x(), chord.y());
  const QPointF across = length > 1e-6 ? QPointF(chord.y(), -chord.x()) / length : QPointF(0.0, -1.0);
  return 0.5 * (a + b) + link.bulge * std::min(1.0, 0.05 + length / 90.0) * across;
}

std::optional<QPointF> DriveMap::place_of(motion::PairIndex pair) const {
  const auto found = std::find_if(links_.begin(), links_.end(), [&](const Link& link) { return link.pair == pair; });
  return found == links_.end() ? std::nullopt : std::optional(middle(*found));
}

std::optional<motion::PairIndex> DriveMap::pair_at(const QPointF& position) const {
  std::optional<motion::PairIndex> nearest;
  double shortest = kMapReach_px;
  for (const Link& link : links_) {
    const QPointF off = middle(link) - position;
    const double distance = std::hypot(off.x(), off.y());
    if (distance >= shortest) continue;
    shortest = distance;
    nearest = link.pair;
  }
  return nearest;
}

void DriveMap::show_selected(std::optional<motion::PairIndex> pair) {
  selected_ = pair;
  const std::optional<QPointF> place = pair ? place_of(*pair) : std::nullopt;
  // What is selected elsewhere must be seen here.
  if (place && !rect().adjusted(8, 8, -8, -8).contains(place->toPoint()))
    pan(QPointF(0.5 * width(), 0.5 * height()) - *place);
  update();
}

void DriveMap::fit() {
  fitted_ = true;
  if (!drive_ || drive_->track_m.empty() || width() <= 0 || height() <= 0) return;
  Eigen::Vector2d low = drive_->track_m.front(), high = low;
  for (const Eigen::Vector2d& place : drive_->track_m) {
    low = low.cwiseMin(place);
    high = high.cwiseMax(place);
  }
  centre_m_ = 0.5 * (low + high);
  const Eigen::Vector2d size = (high - low).cwiseMax(1.0);
  pixels_per_m_ = std::max(
      kSmallest, std::min((width() - 2.0 * kMapMargin_px) / size.x(), (height() - 2.0 * kMapMargin_px) / size.y()));
  update();
}

void DriveMap::zoom(double factor, const QPointF& about) {
  const double next = std::clamp(pixels_per_m_ * factor, kSmallest, kLargest);
  // What lies under the cursor stays there.
  const Eigen::Vector2d off(about.x() - 0.5 * width(), 0.5 * height() - about.y());
  centre_m_ += off / pixels_per_m_ - off / next;
  pixels_per_m_ = next;
  fitted_ = false;
  update();
}

void DriveMap::pan(const QPointF& pixels) {
  centre_m_ += Eigen::Vector2d(-pixels.x(), pixels.y()) / pixels_per_m_;
  fitted_ = false;
  update();
}

void DriveMap::resizeEvent(QResizeEvent*) {
  if (fitted_) fit();
}

void DriveMap::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) pressed_ = dragged_from_ = event->position();
}

void DriveMap::mouseMoveEvent(QMouseEvent* event) {
  if (!pressed_) {
    setCursor(pair_at(event->position()) ? Qt::PointingHandCursor : Qt::ArrowCursor);
    return;
  }
  if ((event->position() - *pressed_).manhattanLength() < kFurthest_px && dragged_from_ == pressed_) return;
  pan(event->position() - *dragged_from_);
  dragged_from_ = event->position();
}

void DriveMap::mouseReleaseEvent(QMouseEvent* event) {
  const bool clicked = pressed_ && dragged_from_ == pressed_;
  pressed_ = dragged_from_ = std::nullopt;
  const std::optional<motion::PairIndex> pair = clicked ? pair_at(event->position()) : std::nullopt;
  if (pair) emit pair_clicked(*pair);
}

void DriveMap::wheelEvent(QWheelEvent* event) {
  zoom(std::pow(kStep, event->angleDelta().y() / 120.0), event->position());
  event->accept();
}

void DriveMap::keyPressEvent(QKeyEvent* event) {
  const QPointF middle(0.5 * width(), 0.5 * height());
  const double step = 0.2 * std::min(width(), height());
  switch (event->key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      return zoom(kStep, middle);
    case Qt::Key_Minus:
      return zoom(1.0 / kStep, middle);
    case Qt::Key_Left:
      return pan({step, 0.0});
    case Qt::Key_Right:
      return pan({-step, 0.0});
    case Qt::Key_Up:
      return pan({0.0, step});
    case Qt::Key_Down:
      return pan({0.0, -step});
    case Qt::Key_Home:
      return fit();
    default:
      QWidget::keyPressEvent(event);
  }
}

bool DriveMap::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  auto* help = static_cast<QHelpEvent*>(event);
  const std::optional<motion::PairIndex> pair = pair_at(help->pos());
  if (!pair) {
    QToolTip::hideText();
  } else {
    const motion::Pair& chosen = output_->pairs[*pair];
    QString text = tr("pair %1: %2").arg(*pair).arg(state_text(chosen));
    if (!chosen.reason.empty()) text += '\n' + reason_words(chosen.reason);
    QToolTip::showText(help->globalPos(), text, this);
  }
  return true;
}

}  // namespace remount::widgets
