#include "model/formats/documents/method_document.h"

#include "messages/files.h"

namespace remount {

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::vector<double> numbers_column(const DocumentView& view) {
  std::vector<double> numbers;
  for (const DocumentView& item : view.items()) numbers.push_back(item.number_or_nan());
  return numbers;
}

Curve curve_of(const DocumentView& view) {
  Curve curve;
  curve.name = view.at("name").string();
  curve.dots = view.at("dots").boolean();
  curve.x = numbers_column(view.at("x"));
  curve.y = numbers_column(view.at("y"));
  if (view.has("sigma")) curve.sigma = numbers_column(view.at("sigma"));
  if (view.has("z")) curve.z = numbers_column(view.at("z"));
  if (curve.y.size() != curve.x.size()) view.at("y").fail(say::document_as_many_as_x());
  if (!curve.sigma.empty() && curve.sigma.size() != curve.x.size()) view.at("sigma").fail(say::document_as_many_as_x());
  if (!curve.z.empty() && curve.z.size() != curve.x.size()) view.at("z").fail(say::document_as_many_as_x());
  return curve;
}

}  // namespace

DocumentNode quantities_document(const std::vector<NamedQuantity>& quantities) {
  DocumentNode list = DocumentNode::sequence();
  for (const NamedQuantity& quantity : quantities) {
    DocumentNode& node = list.add(DocumentNode::map());
    node.on_one_line = true;
    node.add("name", DocumentNode::string(quantity.name));
    node.add("value", DocumentNode::number(quantity.value));
    node.add("sigma", DocumentNode::number(quantity.sigma));
    node.add("unit", DocumentNode::string(quantity.unit));
    node.add("observed", DocumentNode::boolean(quantity.observed));
  }
  return list;
}

std::vector<NamedQuantity> quantities_from_document(const DocumentView& view) {
  std::vector<NamedQuantity> quantities;
  for (const DocumentView& item : view.items()) {
    NamedQuantity quantity;
    quantity.name = item.at("name").string();
    quantity.value = item.at("value").number_or_nan();
    quantity.sigma = item.at("sigma").number_or_nan();
    if (quantity.sigma < 0.0) item.at("sigma").fail(say::document_negative());
    quantity.unit = item.at("unit").string();
    quantity.observed = item.at("observed").boolean();
    quantities.push_back(quantity);
  }
  return quantities;
}

DocumentNode plots_document(const std::vector<Plot>& plots) {
  DocumentNode list = DocumentNode::sequence();
  for (const Plot& plot : plots) {
    DocumentNode& node = list.add(DocumentNode::map());
    node.add("title", DocumentNode::string(plot.title));
    node.add("x_label", DocumentNode::string(plot.x_label));
    node.add("y_label", DocumentNode::string(plot.y_label));
    node.add("equal_axes", DocumentNode::boolean(plot.equal_axes));
    DocumentNode& curves = node.add("curves", DocumentNode::sequence());
    for (const Curve& curve : plot.curves) {
      DocumentNode& item = curves.add(DocumentNode::map());
      item.add("name", DocumentNode::string(curve.name));
      item.add("dots", DocumentNode::boolean(curve.dots));
      item.add("x", DocumentNode::numbers(curve.x));
      item.add("y", DocumentNode::numbers(curve.y));
      if (!curve.sigma.empty()) item.add("sigma", DocumentNode::numbers(curve.sigma));
      if (!curve.z.empty()) item.add("z", DocumentNode::numbers(curve.z));
    }
  }
  return list;
}

std::vector<Plot> plots_from_document(const DocumentView& view) {
  std::vector<Plot> plots;
  for (const DocumentView& item : view.items()) {
    Plot plot;
    plot.title = item.at("title").string();
    plot.x_label = item.at("x_label").string();
    plot.y_label = item.at("y_label").string();
    plot.equal_axes = item.at("equal_axes").boolean();
    for (const DocumentView& curve : item.at("curves").items()) plot.curves.push_back(curve_of(curve));
    plots.push_back(plot);
  }
  return plots;
}

}  // namespace remount
