// Columns of tables on a terminal.
#pragma once

#include <string>

namespace remount::cli {

/// How many columns of a terminal a text takes: letters of Chinese take two. UTF-8 gives them three bytes.
inline std::size_t columns_of(const std::string& text) {
  std::size_t columns = 0;
  for (const char letter : text) {
    const auto byte = static_cast<unsigned char>(letter);
    if (byte < 0x80 || (byte >= 0xC0 && byte < 0xE0)) columns += 1;
    if (byte >= 0xE0) columns += 2;  // others continue a letter
  }
  return columns;
}

/// With blanks behind it up to that many columns.
inline std::string padded(std::string text, std::size_t columns) {
  const std::size_t has = columns_of(text);
  if (has < columns) text.append(columns - has, ' ');
  return text;
}

}  // namespace remount::cli
