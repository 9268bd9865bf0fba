// Option structs as the interface lists them.
#pragma once

#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

#include "algorithms/core/options.h"
#include "remount/settings.h"

namespace remount::api {

/// As it would be typed.
std::string text_of(const OptionValue& value);

/// Visits an option struct.
struct OptionLister {
  std::string before;  ///< the section with its dot; empty for none
  std::vector<Option>& options;

  template <class T>
  void operator()(const OptionInfo& info, const T& value) {
    Option option = described(info);
    if constexpr (std::is_same_v<T, bool>) {
      option.value = value;
    } else if constexpr (std::is_integral_v<T>) {
      option.value = static_cast<std::int64_t>(value);
    } else {
      option.value = value;
    }
    options.push_back(std::move(option));
  }

  template <class T>
  void choice(const OptionInfo& info, const T& value, const std::vector<std::string_view>& names) {
    Option option = described(info);
    option.choices.assign(names.begin(), names.end());
    option.value = option.choices.at(static_cast<std::size_t>(value));
    options.push_back(std::move(option));
  }

  Option described(const OptionInfo& info) const {
    return {
        before + std::string(info.name), std::string(info.unit), Text(info.help()), {}, info.minimum, info.maximum, {}};
  }
};

}  // namespace remount::api
