// All settings of a calibration, by their names in files: "pairing.max_gap_s".
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "remount/text.h"

namespace remount::settings {
struct Settings;
}  // namespace remount::settings

namespace remount::api {

/// A choice is the name of what is chosen. Angles are in the unit that the name ends with.
using OptionValue = std::variant<bool, std::int64_t, double, std::string>;

struct Option {
  std::string name;  ///< "pairing.max_gap_s"
  std::string unit;  ///< "s"; empty for none
  Text meaning;      ///< one sentence
  OptionValue value;
  double minimum = 0.0, maximum = 0.0;  ///< of numbers
  std::vector<std::string> choices;     ///< of choices
};

/// A value: copies do not change each other.
class Settings {
 public:
  Settings();
  explicit Settings(const settings::Settings& settings);

  /// A configuration file (YAML or JSON) as `remount-cli settings` writes it; what it does not mention has its default.
  /// Throws Error(Io), and Error(Format) that lists every problem with its line.
  static Settings load(const std::filesystem::path& path);

  /// Throws Error(Contract) for a name that is none, and for a value out of range.
  void set(std::string_view name, const OptionValue& value);
  void set(std::string_view name, const char* value) { set(name, OptionValue(std::string(value))); }
  template <class Number, std::enable_if_t<std::is_arithmetic_v<Number>, int> = 0>
  void set(std::string_view name, Number value) {
    if constexpr (std::is_same_v<Number, bool>)
      set(name, OptionValue(value));
    else if constexpr (std::is_integral_v<Number>)
      set(name, OptionValue(static_cast<std::int64_t>(value)));
    else
      set(name, OptionValue(static_cast<double>(value)));
  }
  /// Throws Error(Contract) for a name that is none.
  OptionValue get(std::string_view name) const;
  std::vector<Option> all() const;
  /// The text of a configuration file, with comments.
  std::string text(Language language = Language::English) const;

  const settings::Settings& inside() const { return *settings_; }  ///< for Remount itself

 private:
  std::shared_ptr<const settings::Settings> settings_;
};

}  // namespace remount::api
