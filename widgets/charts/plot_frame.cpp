#include "widgets/charts/plot_frame.h"

#include <algorithm>
#include <cmath>

namespace remount::widgets {

AxisSpan span_with_room(double low, double high, double share) {
  if (!(high >= low) || !std::isfinite(high - low)) return {0.0, 1.0};
  const double least = 1e-6 * std::max({1.0, std::abs(low), std::abs(high)});
  const double room = high - low > least ? share * (high - low) : std::max(0.5 * std::abs(high), 0.5);
  return {low - room, high + room};
}

AxisSpan zoomed(const AxisSpan& span, double fixed, double factor, const AxisSpan& whole) {
  constexpr double kNearest = 1e-5, kFarthest = 10.0;
  const double length = std::clamp(factor * span.length(), kNearest * whole.length(), kFarthest * whole.length());
  const double share = (fixed - span.low) / span.length();
  return {fixed - share * length, fixed + (1.0 - share) * length};
}

void PlotFrame::pan(const QPointF& by_px) {
  const double x = by_px.x() / area.width() * across.length(), y = by_px.y() / area.height() * up.length();
  across = {across.low - x, across.high - x};
  up = {up.low + y, up.high + y};
}

double wheel_factor(int angle_eighths_deg) { return std::pow(1.2, -angle_eighths_deg / 120.0); }

}  // namespace remount::widgets
