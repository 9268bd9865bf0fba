// Which part of a plane a plot shows, and where on the screen: what zooming and panning change.
#pragma once

#include <QPointF>
#include <QRectF>

namespace remount::widgets {

/// From low to high, in the unit of the axis.
struct AxisSpan {
  double low = 0.0, high = 1.0;
  double length() const { return high - low; }
  bool holds(double value) const { return value >= low && value <= high; }
  friend bool operator==(const AxisSpan&, const AxisSpan&) = default;
};

/// The span of finite numbers with `share` of it as room on either side; of one number, or none, one that can be drawn.
AxisSpan span_with_room(double low, double high, double share);
/// Stretched about `fixed`, a value that keeps its place, by `factor` (below 1: nearer); never shorter than a
/// hundred-thousandth of `whole` and never longer than ten times it.
AxisSpan zoomed(const AxisSpan& span, double fixed, double factor, const AxisSpan& whole);

/// Values grow to the right and upwards.
struct PlotFrame {
  QRectF area;  ///< px
  AxisSpan across, up;

  double x_of(double value) const { return area.left() + (value - across.low) / across.length() * area.width(); }
  double y_of(double value) const { return area.bottom() - (value - up.low) / up.length() * area.height(); }
  QPointF place_of(double x, double y) const { return {x_of(x), y_of(y)}; }
  double x_at(double px) const { return across.low + (px - area.left()) / area.width() * across.length(); }
  double y_at(double px) const { return up.low + (area.bottom() - px) / area.height() * up.length(); }
  /// Follows the hand: what was under it stays there.
  void pan(const QPointF& by_px);
};

/// By how much the wheel stretches what a plot shows.
double wheel_factor(int angle_eighths_deg);

}  // namespace remount::widgets
