#include "model/formats/documents/method_document.h"

#include <algorithm>
#include <charconv>

#include "algorithms/messages/catalogue.h"
#include "messages/files.h"
#include "messages/plots.h"
#include "messages/quantities.h"
#include "model/formats/documents/notations.h"

namespace remount::formats {
namespace {

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

/// Of a title, an axis or the name of a curve. Throws Error(Format).
Message plot_words_from_document(const DocumentView& view) {
  return view.is_map() ? message_from_document(view) : former_plot_words(view.string());
}

constexpr Through kPlotWords{message_document, plot_words_from_document};

}  // namespace

void describe(RecordOf<calibration::NamedQuantity> auto& quantity, auto& fields) {
  fields.on_one_line();
  fields("name", quantity.id);
  fields.later_or("words", quantity.name, [&] { return former_quantity(quantity.id); });
  fields("value", quantity.value);
  fields("sigma", quantity.sigma);
  fields.require(!(quantity.sigma < 0.0), "sigma", say::document_negative);
  fields("unit", quantity.unit);
  fields("observed", quantity.observed);
}

void describe(RecordOf<calibration::Curve> auto& curve, auto& fields) {
  const auto fits = [&curve](const std::vector<double>& column) { return column.size() == curve.x.size(); };
  fields("name", curve.name, kPlotWords);
  fields("dots", curve.dots);
  fields("x", curve.x);
  fields("y", curve.y);
  fields.where(!curve.sigma.empty(), "sigma", curve.sigma);
  fields.where(!curve.z.empty(), "z", curve.z);
  fields.require(fits(curve.y), "y", say::document_as_many_as_x);
  fields.require(curve.sigma.empty() || fits(curve.sigma), "sigma", say::document_as_many_as_x);
  fields.require(curve.z.empty() || fits(curve.z), "z", say::document_as_many_as_x);
}

void describe(RecordOf<calibration::Plot> auto& plot, auto& fields) {
  fields("title", plot.title, kPlotWords);
  fields("x_label", plot.x_label, kPlotWords);
  fields("y_label", plot.y_label, kPlotWords);
  fields("equal_axes", plot.equal_axes);
  fields("curves", plot.curves);
}

DocumentNode quantities_document(const std::vector<calibration::NamedQuantity>& quantities) {
  return document_of(quantities);
}

std::vector<calibration::NamedQuantity> quantities_from_document(const DocumentView& view) {
  std::vector<calibration::NamedQuantity> quantities;
  read_fields(view, quantities);
  return quantities;
}

DocumentNode plots_document(const std::vector<calibration::Plot>& plots) { return document_of(plots); }

std::vector<calibration::Plot> plots_from_document(const DocumentView& view) {
  std::vector<calibration::Plot> plots;
  read_fields(view, plots);
  return plots;
}

}  // namespace remount::formats
