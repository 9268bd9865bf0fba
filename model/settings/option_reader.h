// Reads option structs from maps of a document, by what they say of themselves.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <type_traits>
#include <vector>

#include "algorithms/core/error.h"
#include "algorithms/core/options.h"
#include "model/formats/documents/document.h"

namespace remount::settings {

/// What was typed for one value, read as files are, so that both accept the same. No option is a list or a map: what is
/// no YAML, or nothing, is a text that the option refuses, saying what it takes.
formats::DocumentNode typed_value(std::string_view text, const std::string& where);

/// Within the bounds of the option. Half a turn is typed as 3.1416 or 3.15 rad, which is beyond it by less than half a
/// degree: the bound is meant. Throws Error(Format) that says what would have been a number here.
double bounded_number(const formats::DocumentView& view, const OptionInfo& info);

/// Which of the names stands there. Throws Error(Format) that lists them.
std::size_t chosen_name(const formats::DocumentView& view, const std::vector<std::string_view>& names);

/// Visits an option struct: reads those members that a map mentions.
class OptionReader {
 public:
  /// @param problems to which a message is added for each value that does not fit
  OptionReader(const formats::DocumentView& section, std::vector<Message>& problems)
      : section_(section), problems_(problems) {}

  template <class T>
  void operator()(const OptionInfo& info, T& value) {
    read(info, [&](const formats::DocumentView& view) {
      if constexpr (std::is_same_v<T, bool>) {
        value = view.boolean();
      } else if constexpr (std::is_integral_v<T>) {
        value = static_cast<T>(
            view.integer(static_cast<std::int64_t>(info.minimum), static_cast<std::int64_t>(info.maximum)));
      } else if constexpr (std::is_floating_point_v<T>) {
        value = bounded_number(view, info);
      } else {
        value = view.string();
      }
    });
  }

  template <class T>
  void choice(const OptionInfo& info, T& value, const std::vector<std::string_view>& names) {
    read(info, [&](const formats::DocumentView& view) { value = static_cast<T>(chosen_name(view, names)); });
  }

  /// Adds a problem for each key of the map that no member has.
  void report_unknown_keys() const;

 private:
  template <class Assign>
  void read(const OptionInfo& info, Assign&& assign) {
    known_.push_back(info.name);
    if (!section_.has(info.name)) return;
    try {
      assign(section_.at(info.name));
    } catch (const Error& error) {
      problems_.push_back(error.message());
    }
  }

  formats::DocumentView section_;
  std::vector<Message>& problems_;
  std::vector<std::string_view> known_{};
};

}  // namespace remount::settings
