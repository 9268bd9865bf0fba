// Option structs describe themselves once; forms, configuration files, checks and provenance read that description.
#pragma once

#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace remount {

/// Description of one option. For booleans and enumerations the bounds are not used.
struct OptionInfo {
  std::string_view name;  ///< key in files, with its unit as suffix
  std::string_view unit;  ///< "m", "s", "rad", "" for none
  std::string_view help;  ///< one sentence
  double minimum = 0.0;
  double maximum = 0.0;
};

/// "-4 rad (-229.183 deg) is outside -3.14159 to 3.14159 rad (-180 to 180 deg)": degrees as well, since people type
/// those.
inline std::string outside_bounds(const OptionInfo& info, double value) {
  constexpr double kToDeg = 57.295779513082323;
  const bool angle = info.unit == "rad";
  std::string unit(info.unit);
  if (!unit.empty()) unit.insert(unit.begin(), ' ');
  char text[320];
  if (angle)
    std::snprintf(text, sizeof text, "%.6g rad (%.6g deg) is outside %.6g to %.6g rad (%.6g to %.6g deg)", value,
                  value * kToDeg, info.minimum, info.maximum, info.minimum * kToDeg, info.maximum * kToDeg);
  else
    std::snprintf(text, sizeof text, "%.6g%s is outside %.6g to %.6g%s", value, unit.c_str(), info.minimum,
                  info.maximum, unit.c_str());
  return text;
}

/// An enumeration as an option: `index` refers to `names`.
struct ChoiceRef {
  int index = 0;
  std::vector<std::string_view> names;
};

/// Option structs offer `template <class Self, class Visitor> static void visit(Self& self, Visitor&& visitor)`
/// that calls `visitor(OptionInfo, member)` for each member (bool, int, double or std::string) and
/// `visitor.choice(OptionInfo, member, names)` for each enumeration.
namespace detail {
struct OptionChecker {
  std::vector<std::string>& problems;
  template <class T>
  void operator()(const OptionInfo& info, const T& value) {
    if constexpr (std::is_arithmetic_v<T> && !std::is_same_v<T, bool>) {
      const double number = static_cast<double>(value);
      if (!std::isfinite(number) || number < info.minimum || number > info.maximum)
        problems.push_back(std::string(info.name) + " = " + outside_bounds(info, number));
    }
  }
  template <class T>
  void choice(const OptionInfo& info, const T& value, const std::vector<std::string_view>& names) {
    if (static_cast<std::size_t>(value) >= names.size())
      problems.push_back(std::string(info.name) + " is not one of its choices");
  }
};
}  // namespace detail

/// Every problem of an option struct, not only the first; empty where it is valid.
template <class Options>
std::vector<std::string> option_problems(const Options& options) {
  std::vector<std::string> problems;
  Options::visit(options, detail::OptionChecker{problems});
  return problems;
}

}  // namespace remount
