#include "model/formats/documents/method_document.h"

#include <algorithm>
#include <charconv>

#include "algorithms/messages/catalogue.h"
#include "messages/files.h"
#include "messages/plots.h"
#include "messages/quantities.h"
#include "model/formats/documents/message_document.h"

namespace remount {

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::vector<double> numbers_column(const DocumentView& view) {
  std::vector<double> numbers;
  for (const DocumentView& item : view.items()) numbers.push_back(item.number_or_nan());
  return numbers;
}

/// What stands behind `start`, or nothing where `text` begins otherwise.
std::optional<std::string> text_after(std::string_view start, std::string_view text) {
  if (!text.starts_with(start)) return std::nullopt;
  return std::string(text.substr(start.size()));
}

std::optional<int> count_after(std::string_view start, std::string_view text) {
  const std::optional<std::string> digits = text_after(start, text);
  int count = 0;
  if (!digits || digits->empty()) return std::nullopt;
  const auto [end, error] = std::from_chars(digits->data(), digits->data() + digits->size(), count);
  return error == std::errc() && end == digits->data() + digits->size() ? std::optional(count) : std::nullopt;
}

/// The name of a quantity of which a former version wrote the id alone.
Message former_quantity(const std::string& id) {
  if (const auto session = text_after("distance driven, ", id)) return say::quantity_distance_driven_in(*session);
  if (const auto session = count_after("odometry scale ", id)) return say::quantity_odometry_scale_of(*session);
  if (const auto number = count_after("rotation equation singular value ", id))
    return say::quantity_rotation_equation_singular_value(*number);
  std::string code = "quantity-" + id;
  std::replace(code.begin(), code.end(), ' ', '-');
  return find_in_catalogue(code) ? Message(code, {}) : Message::verbatim(id);
}

/// What a plot of a former version, which wrote English words alone, says by a sentence without places.
std::optional<Message> former_plot_sentence(std::string_view words) {
  for (const CatalogueEntry& entry : catalogue())
    if (entry.text[0] == words && (entry.code.starts_with("plot-") || entry.code.starts_with("parameter-")))
      return Message(entry.code, {});
  return std::nullopt;
}

Message former_plot_words(const std::string& words) {
  if (const auto sentence = former_plot_sentence(words)) return *sentence;
  const std::size_t colon = words.find(": ");
  if (colon != std::string::npos)
    if (const auto title = former_plot_sentence(std::string_view(words).substr(0, colon)))
      return say::plot_of_session(*title, words.substr(colon + 2));
  return Message::verbatim(words);
}

/// A title, an axis or the name of a curve. Throws Error(Format).
Message plot_words(const DocumentView& view) {
  return view.is_map() ? message_from_document(view) : former_plot_words(view.string());
}

Curve curve_of(const DocumentView& view) {
  Curve curve;
  curve.name = plot_words(view.at("name"));
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
    node.add("name", DocumentNode::string(quantity.id));
    node.add("words", message_document(quantity.name));
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
    quantity.id = item.at("name").string();
    quantity.name = item.has("words") ? message_from_document(item.at("words")) : former_quantity(quantity.id);
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
    node.add("title", message_document(plot.title));
    node.add("x_label", message_document(plot.x_label));
    node.add("y_label", message_document(plot.y_label));
    node.add("equal_axes", DocumentNode::boolean(plot.equal_axes));
    DocumentNode& curves = node.add("curves", DocumentNode::sequence());
    for (const Curve& curve : plot.curves) {
      DocumentNode& item = curves.add(DocumentNode::map());
      item.add("name", message_document(curve.name));
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
    plot.title = plot_words(item.at("title"));
    plot.x_label = plot_words(item.at("x_label"));
    plot.y_label = plot_words(item.at("y_label"));
    plot.equal_axes = item.at("equal_axes").boolean();
    for (const DocumentView& curve : item.at("curves").items()) plot.curves.push_back(curve_of(curve));
    plots.push_back(plot);
  }
  return plots;
}

}  // namespace remount
