// How many drives the long tests simulate.
#pragma once

#include <cstdlib>

namespace remount::testing {

/// As the environment says in REMOUNT_DRIVES; `usual` without.
inline std::size_t drive_count(std::size_t usual) {
  const char* text = std::getenv("REMOUNT_DRIVES");
  const int count = text != nullptr ? std::atoi(text) : 0;
  return count > 0 ? static_cast<std::size_t>(count) : usual;
}

}  // namespace remount::testing
