// What several checks share: texts, times, medians.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

namespace remount {

/// As printf writes it; up to 500 bytes.
template <class... Values>
std::string check_text(const char* pattern, Values... values) {
  char text[500];
  std::snprintf(text, sizeof text, pattern, values...);
  return text;
}

inline double seconds_between(std::int64_t from_ns, std::int64_t to_ns) {
  return static_cast<double>(to_ns - from_ns) * 1e-9;
}

/// Of at least one value.
inline double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace remount
