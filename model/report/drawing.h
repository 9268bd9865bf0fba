// A drawing as values: written as SVG by the command line, painted by the window where SVG cannot be shown.
#pragma once

#include <Eigen/Core>
#include <string>
#include <variant>
#include <vector>

namespace remount::report {

/// Positions and sizes are in points, y downwards; colours are "#rrggbb".
struct DrawnLine {
  std::vector<Eigen::Vector2d> points;
  std::string color;
  double width = 1.0;
};
struct DrawnBox {
  Eigen::Vector2d corner, size;
  std::string color;
};
struct DrawnDot {
  Eigen::Vector2d middle;
  double radius = 2.0;
  std::string color;
};
enum class TextAnchor { Start, Middle, End };
struct DrawnText {
  Eigen::Vector2d base;  ///< on the base line
  std::string text;      ///< UTF-8
  TextAnchor anchor = TextAnchor::Start;
  double size = 11.0;
  std::string color = "#333333";
};

struct Drawing {
  double width = 0.0, height = 0.0;
  std::string description;  ///< for people who cannot see it
  std::vector<std::variant<DrawnLine, DrawnBox, DrawnDot, DrawnText>> shapes;
};

/// An <svg> element that stands in HTML by itself.
std::string to_svg(const Drawing& drawing);

}  // namespace remount::report
