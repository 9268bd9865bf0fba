#include "widgets/vehicle/vehicle_picture.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "widgets/basics/swatch.h"
#include "widgets/scene/lidar_colors.h"

namespace remount::widgets {
namespace {

constexpr double kMargin_px = 46.0;  // for fields of view and names
constexpr double kField_px = 40.0;   // how far a field of view is drawn
constexpr double kName_px = 7.0;     // between a place and its name
constexpr double kAxis_px = 18.0, kInsAxis_px = 26.0;
constexpr int kSectors = 72;
constexpr double kSeenFromAside = 0.6;  // what goes into the picture, or out of it, has no direction there
constexpr double kSeen = 0.15;          // of what the fullest sector holds: less is what strays into one

/// Directions around a LiDAR in a picture of which it sees something.
std::array<bool, kSectors> sectors_of(const std::vector<Eigen::Vector2d>& directions) {
  std::array<int, kSectors> counts{};
  for (const Eigen::Vector2d& direction : directions) {
    const double turn = std::atan2(direction.y(), direction.x()) / (2.0 * std::numbers::pi);
    ++counts[static_cast<std::size_t>(std::floor((turn - std::floor(turn)) * kSectors)) % kSectors];
  }
  const int most = *std::ranges::max_element(counts);
  std::array<bool, kSectors> seen{};
  for (std::size_t s = 0; s < kSectors; ++s) seen[s] = counts[s] > 0 && counts[s] >= kSeen * most;
  return seen;
}

}  // namespace

VehiclePicture::VehiclePicture(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("The vehicle with its LiDARs"));
  setToolTip(
      tr("Axes: x red, y green, z blue; of the INS and of each LiDAR. Coloured sectors: where a LiDAR looks. Thin "
         "dashed axes: the nominal mounting."));
}

void VehiclePicture::show_lidars(std::vector<Lidar> lidars, const RigidTransform& vehicle_from_ins) {
  lidars_ = std::move(lidars);
  vehicle_from_ins_ = vehicle_from_ins;
  update();
}

QPointF VehiclePicture::View::at(const Eigen::Vector3d& place_m) const {
  return centre + QPointF(pixels_per_m * place_m.dot(right), -pixels_per_m * place_m.dot(up));
}

VehiclePicture::View VehiclePicture::fitted(const Eigen::Vector3d& right, const Eigen::Vector3d& up,
                                            const QRectF& area) const {
  View view{right, up, area, area.center()};
  double left_m = 0.0, right_m = 0.0, low_m = 0.0, high_m = 0.0;  // the INS is in sight
  for (const Lidar& lidar : lidars_) {
    const Eigen::Vector3d place_m = (vehicle_from_ins_ * lidar.ins_from_lidar).translation();
    left_m = std::min(left_m, place_m.dot(right));
    right_m = std::max(right_m, place_m.dot(right));
    low_m = std::min(low_m, place_m.dot(up));
    high_m = std::max(high_m, place_m.dot(up));
  }
  constexpr double kLeast_m = 0.5, kMost = 400.0;
  const double across = (area.width() - 2.0 * kMargin_px) / std::max(right_m - left_m, kLeast_m);
  const double along = (area.height() - 2.0 * kMargin_px) / std::max(high_m - low_m, kLeast_m);
  view.pixels_per_m = std::clamp(std::min(across, along), 5.0, kMost);
  view.centre -= QPointF(view.pixels_per_m * 0.5 * (left_m + right_m), -view.pixels_per_m * 0.5 * (low_m + high_m));
  return view;
}

void VehiclePicture::paint_axes(QPainter& painter, const View& view, const RigidTransform& vehicle_from_sensor,
                                double length, bool solid) const {
  static const std::array<QColor, 3> kColors{QColor(200, 50, 40), QColor(40, 150, 60), QColor(50, 90, 210)};
  const QPointF origin = view.at(vehicle_from_sensor.translation());
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d direction = vehicle_from_sensor.linear().col(axis);
    const QPointF end = origin + length * QPointF(direction.dot(view.right), -direction.dot(view.up));
    painter.setPen(
        QPen(kColors[static_cast<std::size_t>(axis)], solid ? 2.0 : 1.0, solid ? Qt::SolidLine : Qt::DashLine));
    painter.drawLine(origin, end);
  }
}

void VehiclePicture::paint_field(QPainter& painter, const View& view, const Lidar& lidar) const {
  const RigidTransform vehicle_from_lidar = vehicle_from_ins_ * lidar.ins_from_lidar;
  std::vector<Eigen::Vector2d> directions;
  for (const Eigen::Vector3f& point : lidar.seen_m) {
    const Eigen::Vector3d direction = vehicle_from_lidar.linear() * point.cast<double>();
    const Eigen::Vector2d drawn(direction.dot(view.right), direction.dot(view.up));
    if (drawn.norm() > kSeenFromAside * direction.norm()) directions.push_back(drawn);
  }
  if (directions.empty()) return;
  const std::array<bool, kSectors> seen = sectors_of(directions);
  QColor color = to_qt(scene::lidar_color(lidar.place));
  color.setAlpha(70);
  painter.setPen(Qt::NoPen);
  painter.setBrush(color);
  const QPointF origin = view.at(vehicle_from_lidar.translation());
  const QRectF round(origin - QPointF(kField_px, kField_px), origin + QPointF(kField_px, kField_px));
  constexpr double kSector_deg = 360.0 / kSectors;
  for (int s = 0; s < kSectors; ++s)
    if (seen[static_cast<std::size_t>(s)])
      painter.drawPie(round, static_cast<int>(16.0 * kSector_deg * s), static_cast<int>(16.0 * kSector_deg));
}

// Names stand to the right of their places, or to the left where the picture ends; that of the INS where no LiDAR is.
void VehiclePicture::paint_names(QPainter& painter, const View& view) const {
  const QFontMetricsF metrics(painter.font());
  painter.setPen(palette().color(QPalette::Text));
  std::vector<QPointF> places;
  for (const Lidar& lidar : lidars_) {
    const QPointF origin = view.at((vehicle_from_ins_ * lidar.ins_from_lidar).translation());
    const double width = metrics.horizontalAdvance(lidar.name);
    const bool fits = origin.x() + kName_px + width < view.area.right();
    const double left = fits ? origin.x() + kName_px : std::max(view.area.left() + 2.0, origin.x() - kName_px - width);
    painter.drawText(QPointF(left, origin.y() - 6.0), lidar.name);
    places.push_back(origin);
  }
  const QPointF ins = view.at(vehicle_from_ins_.translation());
  const double width = metrics.horizontalAdvance(tr("INS"));
  const auto is_free = [&](const QPointF& at) {
    const QRectF text = QRectF(at.x(), at.y() - metrics.ascent(), width, metrics.height()).adjusted(-6, -6, 6, 6);
    return std::ranges::none_of(places, [&](const QPointF& place) { return text.contains(place); });
  };
  const std::array<QPointF, 4> around{QPointF(4.0, 16.0), QPointF(-width - kName_px, 16.0),
                                      QPointF(-width - kName_px, -6.0), QPointF(4.0, 32.0)};
  const auto* free = std::ranges::find_if(around, [&](const QPointF& by) { return is_free(ins + by); });
  painter.drawText(ins + (free == around.end() ? around.front() : *free), tr("INS"));
}

void VehiclePicture::paint_scale(QPainter& painter, const View& view) const {
  constexpr double kMost_px = 90.0;
  double length_m = 0.1;
  for (const double longer_m : {0.2, 0.5, 1.0, 2.0, 5.0, 10.0})
    if (longer_m * view.pixels_per_m <= kMost_px) length_m = longer_m;
  const QPointF right = view.area.bottomRight() - QPointF(10.0, 8.0);
  const QPointF left = right - QPointF(length_m * view.pixels_per_m, 0.0), tick(0.0, 4.0);
  painter.setPen(QPen(palette().color(QPalette::Text), 1.5));
  painter.drawLine(left, right);
  painter.drawLine(left - tick, left);
  painter.drawLine(right - tick, right);
  painter.drawText(left + QPointF(2.0, -4.0), tr("%1 m").arg(length_m));
}

void VehiclePicture::paint_view(QPainter& painter, const View& view, const QString& title) const {
  painter.save();
  painter.setClipRect(view.area);
  for (const Lidar& lidar : lidars_) paint_field(painter, view, lidar);
  paint_axes(painter, view, vehicle_from_ins_, kInsAxis_px, true);
  for (const Lidar& lidar : lidars_) {
    const RigidTransform vehicle_from_lidar = vehicle_from_ins_ * lidar.ins_from_lidar;
    if (lidar.nominal_ins_from_lidar)
      paint_axes(painter, view, vehicle_from_ins_ * *lidar.nominal_ins_from_lidar, 1.4 * kAxis_px, false);
    paint_axes(painter, view, vehicle_from_lidar, kAxis_px, true);
    const QPointF origin = view.at(vehicle_from_lidar.translation());
    painter.setPen(palette().color(QPalette::Text));
    painter.setBrush(to_qt(scene::lidar_color(lidar.place)));
    painter.drawEllipse(origin, 4.0, 4.0);
  }
  paint_names(painter, view);
  paint_scale(painter, view);
  painter.setPen(palette().color(QPalette::PlaceholderText));
  painter.drawText(view.area.adjusted(4.0, 2.0, -4.0, -2.0), Qt::AlignTop | Qt::AlignLeft, title);
  painter.restore();
}

void VehiclePicture::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), palette().base());
  if (lidars_.empty()) {
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap,
                     tr("The vehicle is drawn here when its LiDARs are calibrated together."));
    return;
  }
  const QRectF all = rect();
  const bool beside = all.width() > all.height();
  const QRectF first = beside ? QRectF(all.topLeft(), QSizeF(0.5 * all.width(), all.height()))
                              : QRectF(all.topLeft(), QSizeF(all.width(), 0.5 * all.height()));
  const QRectF second = first.translated(beside ? first.width() : 0.0, beside ? 0.0 : first.height());
  const bool heights_known = std::ranges::all_of(lidars_, &Lidar::height_known);
  paint_view(painter, fitted(Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY(), first),
             tr("From above, forward to the right"));
  paint_view(painter, fitted(Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitZ(), second),
             heights_known ? tr("From its right side")
                           : tr("From its right side; heights are known against each other alone, or not at all"));
  painter.setPen(palette().color(QPalette::Mid));
  painter.drawLine(second.topLeft(), beside ? second.bottomLeft() : second.topRight());
}

}  // namespace remount::widgets
