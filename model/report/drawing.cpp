#include "model/report/drawing.h"

#include "algorithms/core/index.h"
#include "model/formats/files/number_text.h"
#include "model/formats/files/printable_text.h"

namespace remount::report {
namespace {

std::string coordinate(double value) { return formats::rounded_text(value, 1); }

struct SvgWriter {
  std::string& svg;

  void operator()(const DrawnLine& line) const {
    svg += "<polyline fill=\"none\" stroke=\"" + line.color + "\" stroke-width=\"" + coordinate(line.width) +
           "\" points=\"";
    for (const Eigen::Vector2d& point : line.points) svg += coordinate(point.x()) + "," + coordinate(point.y()) + " ";
    svg += "\"/>";
  }
  void operator()(const DrawnBox& box) const {
    svg += "<rect x=\"" + coordinate(box.corner.x()) + "\" y=\"" + coordinate(box.corner.y()) + "\" width=\"" +
           coordinate(box.size.x()) + "\" height=\"" + coordinate(box.size.y()) + "\" fill=\"" + box.color + "\"/>";
  }
  void operator()(const DrawnDot& dot) const {
    svg += "<circle cx=\"" + coordinate(dot.middle.x()) + "\" cy=\"" + coordinate(dot.middle.y()) + "\" r=\"" +
           coordinate(dot.radius) + "\" fill=\"" + dot.color + "\"/>";
  }
  void operator()(const DrawnText& text) const {
    static constexpr const char* kAnchors[] = {"start", "middle", "end"};
    svg += "<text x=\"" + coordinate(text.base.x()) + "\" y=\"" + coordinate(text.base.y()) + "\" font-size=\"" +
           coordinate(text.size) + "\" fill=\"" + text.color + "\" text-anchor=\"" + kAnchors[index_of(text.anchor)] +
           "\">" + formats::escape_html(text.text) + "</text>";
  }
};

}  // namespace

std::string to_svg(const Drawing& drawing) {
  const std::string size = coordinate(drawing.width) + " " + coordinate(drawing.height);
  std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" width=\"" + coordinate(drawing.width) +
                    "\" viewBox=\"0 0 " + size + "\"><title>" + formats::escape_html(drawing.description) + "</title>";
  for (const auto& shape : drawing.shapes) std::visit(SvgWriter{svg}, shape);
  return svg + "</svg>";
}

}  // namespace remount::report
