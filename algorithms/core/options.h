// Option structs describe themselves once; forms, configuration files, checks and provenance read that description.
#pragma once

#include <cmath>
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
        problems.push_back(std::string(info.name) + " = " + std::to_string(number) + " is outside " +
                           std::to_string(info.minimum) + " to " + std::to_string(info.maximum) + " " +
                           std::string(info.unit));
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
