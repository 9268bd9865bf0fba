#include "widgets/charts/chart_axis.h"

#include <cmath>

namespace remount::widgets {

double nice_step(double span, int steps) {
  const double raw = span / std::max(1, steps);
  if (!(raw > 0.0) || !std::isfinite(raw)) return 1.0;
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  for (double factor : {1.0, 2.0, 5.0})
    if (factor * power >= raw * (1.0 - 1e-9)) return factor * power;
  return 10.0 * power;
}

QColor grid_color(const QPalette& palette) {
  QColor grid = palette.color(QPalette::Text);
  grid.setAlphaF(0.15F);
  return grid;
}

QColor faint_text_color(const QPalette& palette) {
  QColor text = palette.color(QPalette::Text);
  text.setAlphaF(0.65F);
  return text;
}

std::vector<double> nice_ticks(double low, double high, int steps) {
  std::vector<double> ticks;
  const double step = nice_step(high - low, steps);
  for (double tick = std::ceil(low / step - 1e-9) * step; tick <= high + 1e-9 * step && ticks.size() < 100;
       tick += step)
    ticks.push_back(std::abs(tick) < 1e-9 * step ? 0.0 : tick);
  return ticks;
}

}  // namespace remount::widgets
