// Numbers as text that reads back to the same number, in any locale.
#pragma once

#include <charconv>
#include <string>

namespace remount::formats {

/// The shortest text that from_chars reads back as the same double; "nan" where it is not finite.
inline std::string exact_text(double value) {
  char buffer[64];
  const auto result = std::to_chars(buffer, buffer + sizeof buffer, value);
  return {buffer, result.ptr};
}

}  // namespace remount::formats
