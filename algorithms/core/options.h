// Option structs describe themselves once; forms, configuration files, checks and provenance read that description.
#pragma once

#include <cmath>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "messages/parameters.h"

namespace remount {

/// Makes what is said of an option where somebody reads it, in their language: a maker of messages/options.h and its
/// like.
using OptionText = Message (*)();
/// Of options that no window shows: the command line calls them by their flags.
inline constexpr OptionText kNoLabel = nullptr;

/// Description of one option. For booleans and enumerations the bounds are not used.
struct OptionInfo {
  std::string_view name;        ///< key in files, with its unit as suffix
  std::string_view unit;        ///< "m", "s", "rad", "" for none
  OptionText label = kNoLabel;  ///< what it is called: "Max gap"
  OptionText help = nullptr;    ///< one sentence
  double minimum = 0.0;
  double maximum = 0.0;
};

/// "-4 rad (-229.183 deg) is outside -3.14159 rad to 3.14159 rad (-180 deg to 180 deg)": degrees as well, since people
/// type those.
inline Message outside_bounds(const OptionInfo& info, double value) {
  if (info.unit == "rad") return say::option_angle_outside({value}, {info.minimum}, {info.maximum});
  std::string unit(info.unit);
  if (!unit.empty()) unit.insert(unit.begin(), ' ');
  return say::option_outside(value, std::move(unit), info.minimum, info.maximum);
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
  std::vector<Message>& problems;
  template <class T>
  void operator()(const OptionInfo& info, const T& value) {
    if constexpr (std::is_arithmetic_v<T> && !std::is_same_v<T, bool>) {
      const double number = static_cast<double>(value);
      if (!std::isfinite(number) || number < info.minimum || number > info.maximum)
        problems.push_back(say::option_problem(std::string(info.name), outside_bounds(info, number)));
    }
  }
  template <class T>
  void choice(const OptionInfo& info, const T& value, const std::vector<std::string_view>& names) {
    if (static_cast<std::size_t>(value) >= names.size())
      problems.push_back(say::option_no_choice(std::string(info.name)));
  }
};
}  // namespace detail

/// Every problem of an option struct, not only the first; empty where it is valid.
template <class Options>
std::vector<Message> option_problems(const Options& options) {
  std::vector<Message> problems;
  Options::visit(options, detail::OptionChecker{problems});
  return problems;
}

/// Several problems as one message; empty where there is none.
inline Message in_one(std::vector<Message> problems) {
  Message all;
  for (Message& problem : problems)
    all = all.empty() ? std::move(problem) : say::option_and(std::move(all), std::move(problem));
  return all;
}

}  // namespace remount
