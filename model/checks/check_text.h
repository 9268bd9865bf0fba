// What several checks share: texts and times.
#pragma once

#include <cstdint>
#include <cstdio>
#include <string>

#include "algorithms/core/stamps.h"

namespace remount {

/// As printf writes it; up to 500 bytes.
template <class... Values>
std::string check_text(const char* pattern, Values... values) {
  char text[500];
  std::snprintf(text, sizeof text, pattern, values...);
  return text;
}

inline double seconds_between(std::int64_t from_ns, std::int64_t to_ns) { return seconds(to_ns - from_ns); }

}  // namespace remount
