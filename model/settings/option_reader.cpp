#include "model/settings/option_reader.h"

#include <algorithm>
#include <array>
#include <string>

#include "messages/general.h"
#include "messages/projects.h"
#include "model/formats/documents/parse_document.h"

namespace remount::settings {
namespace {

/// Throws Error(Format) that says what would have been a number here.
double signed_of(const formats::DocumentView& view, const OptionInfo& info) {
  try {
    return view.number();
  } catch (const Error&) {
    const std::string unit = (info.unit.empty() ? "" : " ") + std::string(info.unit);
    view.fail(say::expected_number_from_to(info.minimum, info.maximum, unit, view.described()));
  }
}

double snapped_to_bounds(const OptionInfo& info, double value) {
  constexpr double kSlack_rad = 0.5 / 57.295779513082323;
  if (info.unit != "rad") return value;
  if (value > info.maximum && value <= info.maximum + kSlack_rad) return info.maximum;
  if (value < info.minimum && value >= info.minimum - kSlack_rad) return info.minimum;
  return value;
}

std::size_t place_of(std::string_view name, const std::vector<std::string_view>& names) {
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

/// Choices that have yes and no among them were switches in former versions, whose files have true and false.
std::optional<bool> switch_of_before(const formats::DocumentView& view, const std::vector<std::string_view>& names) {
  if (place_of("yes", names) == names.size() || place_of("no", names) == names.size()) return std::nullopt;
  const std::string text = view.string();
  if (text != "true" && text != "false") return std::nullopt;
  return text == "true";
}

}  // namespace

formats::DocumentNode typed_value(std::string_view text, const std::string& where) {
  formats::DocumentNode value = formats::DocumentNode::string(std::string(text));
  try {
    if (!text.empty()) value = formats::parse_yaml(text, where);
  } catch (const Error&) {
  }
  value.line = 0;
  return value;
}

double bounded_number(const formats::DocumentView& view, const OptionInfo& info) {
  const double number = snapped_to_bounds(info, signed_of(view, info));
  if (number < info.minimum || number > info.maximum) view.fail(outside_bounds(info, number));
  return number;
}

std::size_t chosen_name(const formats::DocumentView& view, const std::vector<std::string_view>& names) {
  const std::optional<bool> was_switch = switch_of_before(view, names);
  return was_switch ? place_of(*was_switch ? "yes" : "no", names) : view.choice(names);
}

void OptionReader::report_unknown_keys() const {
  // Settings of former versions that changed nothing but the sample of a bootstrap: files that hold them stay
  // readable.
  constexpr std::array<std::string_view, 2> kRetired{"bootstrap_samples", "seed"};
  const std::vector<std::string> names(known_.begin(), known_.end());
  for (const auto& [key, view] : section_.entries()) {
    if (std::find(known_.begin(), known_.end(), key) != known_.end()) continue;
    if (std::find(kRetired.begin(), kRetired.end(), key) != kRetired.end()) continue;
    try {
      view.fail(say::settings_unknown_key(names));
    } catch (const Error& error) {
      problems_.push_back(error.message());
    }
  }
}

}  // namespace remount::settings
