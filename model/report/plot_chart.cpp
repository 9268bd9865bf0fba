#include "model/report/plot_chart.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "algorithms/geometry/rotation.h"
#include "algorithms/messages/render.h"
#include "messages/report.h"
#include "model/formats/files/number_text.h"

namespace remount::report {
namespace {

constexpr double kWidth = 680.0, kHeight = 230.0, kLeft = 64.0, kRight = 12.0, kTop = 38.0, kBottom = 36.0;
constexpr double kTallestMap = 420.0;
// Told apart by people who do not see red and green apart.
constexpr std::array<const char*, 6> kColors{"#2a6fbb", "#d9730d", "#4b9a52", "#8a4fa3", "#555a61", "#b33a3a"};
constexpr std::array<const char*, 6> kBands{"#a9c5e4", "#f2c39b", "#b4d6b7", "#d0b9dc", "#bfc2c6", "#e0b0b0"};

std::string tick_label(double value, double step) {
  return formats::rounded_text(value, std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 9));
}

/// 1, 2 or 5 times a power of ten that divides `span` into about `parts`.
double tick_step(double span, double parts) {
  const double rough = std::max(span, 1e-9) / parts, power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double step : {1.0, 2.0, 5.0})
    if (step * power >= rough) return step * power;
  return 10.0 * power;
}

/// The multiples of a step from `low` to `high`; zero without a sign.
std::vector<double> ticks(double low, double high, double step) {
  std::vector<double> values;
  for (double count = std::ceil(low / step); count * step <= high; ++count) values.push_back(count * step + 0.0);
  return values;
}

/// Which values the frame of a plot shows.
struct Frame {
  Eigen::AlignedBox2d values;
  Eigen::Vector2d size;  ///< points

  Eigen::Vector2d at(double x, double y) const {
    const Eigen::Vector2d share = (Eigen::Vector2d(x, y) - values.min()).cwiseQuotient(values.sizes());
    return {kLeft + share.x() * size.x(), kTop + (1.0 - share.y()) * size.y()};
  }
};

Eigen::AlignedBox2d bounds_of(const calibration::Plot& plot) {
  Eigen::AlignedBox2d bounds;
  for (const calibration::Curve& curve : plot.curves)
    for (std::size_t i = 0; i < std::min(curve.x.size(), curve.y.size()); ++i)
      if (std::isfinite(curve.x[i]) && std::isfinite(curve.y[i]))
        bounds.extend(Eigen::Vector2d(curve.x[i], curve.y[i]));
  return bounds;
}

Frame frame_of(const calibration::Plot& plot) {
  Frame frame{bounds_of(plot), {kWidth - kLeft - kRight, kHeight - kTop - kBottom}};
  // A curve that stays where it is still needs a scale; its value's last digits would not be one.
  const Eigen::Vector2d middle = frame.values.center();
  Eigen::Vector2d half = 0.52 * frame.values.sizes();
  half = half.cwiseMax(1e-6 * middle.cwiseAbs()).cwiseMax(1e-9);
  if (plot.equal_axes) {
    double points_a_unit = frame.size.x() / (2.0 * half.x());
    frame.size.y() = std::clamp(points_a_unit * 2.0 * half.y(), frame.size.y(), kTallestMap);
    points_a_unit = std::min(points_a_unit, frame.size.y() / (2.0 * half.y()));
    half = 0.5 * frame.size / points_a_unit;
  }
  frame.values = Eigen::AlignedBox2d(middle - half, middle + half);
  return frame;
}

void draw_axes(const calibration::Plot& plot, const Frame& frame, Language language, Drawing& drawing) {
  const Eigen::Vector2d low = frame.values.min(), high = frame.values.max();
  const double bottom = kTop + frame.size.y();
  const double step_x = tick_step(high.x() - low.x(), 7.0), step_y = tick_step(high.y() - low.y(), 5.0);
  for (const double x : ticks(low.x(), high.x(), step_x)) {
    const double at = frame.at(x, low.y()).x();
    drawing.shapes.push_back(DrawnLine{{{at, kTop}, {at, bottom}}, "#eceef1", 1.0});
    drawing.shapes.push_back(DrawnText{{at, bottom + 14.0}, tick_label(x, step_x), TextAnchor::Middle, 10.0});
  }
  for (const double y : ticks(low.y(), high.y(), step_y)) {
    const double at = frame.at(low.x(), y).y();
    drawing.shapes.push_back(DrawnLine{{{kLeft, at}, {kLeft + frame.size.x(), at}}, "#eceef1", 1.0});
    drawing.shapes.push_back(DrawnText{{kLeft - 5.0, at + 3.5}, tick_label(y, step_y), TextAnchor::End, 10.0});
  }
  drawing.shapes.push_back(
      DrawnLine{{{kLeft, kTop}, {kLeft, bottom}, {kLeft + frame.size.x(), bottom}}, "#8a8f98", 1.0});
  drawing.shapes.push_back(
      DrawnText{{kWidth - kRight, bottom + 28.0}, render(plot.x_label, language), TextAnchor::End, 10.0});
  drawing.shapes.push_back(DrawnText{{6.0, kTop - 8.0}, render(plot.y_label, language), TextAnchor::Start, 10.0});
}

/// The runs of finite points of y(x).
std::vector<DrawnLine> lines_of(const std::vector<double>& x, const std::vector<double>& y, const Frame& frame,
                                const char* color, double width) {
  std::vector<DrawnLine> lines;
  bool open = false;
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
    const bool shown = std::isfinite(x[i]) && std::isfinite(y[i]);
    if (shown && !open) lines.push_back({{}, color, width});
    open = shown;
    if (!shown) continue;
    const Eigen::Vector2d lowest = frame.values.min(), highest = frame.values.max();
    lines.back().points.push_back(frame.at(x[i], std::clamp(y[i], lowest.y(), highest.y())));
  }
  return lines;
}

void draw_band(const calibration::Curve& curve, const Frame& frame, const char* color, Drawing& drawing) {
  if (curve.sigma.size() != curve.y.size()) return;
  for (const double side : {-3.0, 3.0}) {
    std::vector<double> y = curve.y;
    for (std::size_t i = 0; i < y.size(); ++i) y[i] += side * curve.sigma[i];
    for (DrawnLine& line : lines_of(curve.x, y, frame, color, 1.0)) drawing.shapes.push_back(std::move(line));
  }
}

void draw_curve(const calibration::Curve& curve, const Frame& frame, const char* color, Drawing& drawing) {
  for (DrawnLine& line : lines_of(curve.x, curve.y, frame, color, 1.5)) {
    if (!curve.dots) {
      drawing.shapes.push_back(std::move(line));
      continue;
    }
    for (const Eigen::Vector2d& point : line.points) drawing.shapes.push_back(DrawnDot{point, 1.6, color});
  }
}

/// About how wide a text of 10 points is. Letters of Chinese are as wide as they are high; UTF-8 gives them three
/// bytes.
double width_of(std::string_view text) {
  double width = 0.0;
  for (const char letter : text) {
    const auto byte = static_cast<unsigned char>(letter);
    if (byte < 0x80) width += 6.2;
    if (byte >= 0xC0) width += byte < 0xE0 ? 6.2 : 10.5;  // others continue a letter
  }
  return width;
}

void draw_names(const calibration::Plot& plot, Language language, Drawing& drawing) {
  double at = kWidth - kRight;
  for (std::size_t i = plot.curves.size(); i-- > 0;) {
    const std::string name = render(plot.curves[i].name, language);
    drawing.shapes.push_back(DrawnText{{at, 27.0}, name, TextAnchor::End, 10.0, curve_color(i)});
    at -= width_of(name) + 14.0;
  }
}

}  // namespace

const char* curve_color(std::size_t curve) { return kColors[curve % kColors.size()]; }

Drawing plot_chart(const calibration::Plot& plot, Language language) {
  Drawing drawing;
  drawing.width = kWidth;
  drawing.height = kHeight;
  const std::string title = render(plot.title, language);
  drawing.description = title;
  drawing.shapes.push_back(DrawnText{{6.0, 13.0}, title, TextAnchor::Start, 12.0});
  if (bounds_of(plot).isEmpty()) {
    drawing.height = 44.0;
    drawing.shapes.push_back(DrawnText{{6.0, 32.0}, render(say::chart_no_values(), language), TextAnchor::Start, 10.0});
    return drawing;
  }
  const Frame frame = frame_of(plot);
  drawing.height = kTop + frame.size.y() + kBottom;
  draw_axes(plot, frame, language, drawing);
  for (std::size_t i = 0; i < plot.curves.size(); ++i)
    draw_band(plot.curves[i], frame, kBands[i % kBands.size()], drawing);
  for (std::size_t i = 0; i < plot.curves.size(); ++i) draw_curve(plot.curves[i], frame, curve_color(i), drawing);
  draw_names(plot, language, drawing);
  return drawing;
}

std::string quantity_text(const calibration::NamedQuantity& quantity, Language language) {
  if (!quantity.observed || !std::isfinite(quantity.value)) return render(say::report_not_observed(), language);
  const bool angle = quantity.unit == "rad";
  const auto shown = [&](double value) { return angle ? radians_to_degrees(value) : value; };
  const std::string unit = angle ? " °" : quantity.unit.empty() ? "" : " " + quantity.unit;
  std::string text = formats::rounded_text(shown(quantity.value), 4);
  if (std::isfinite(quantity.sigma)) text += " ± " + formats::spread_text(shown(quantity.sigma), 4);
  return text + unit;
}

}  // namespace remount::report
