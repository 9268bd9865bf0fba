// Numbers as text that reads back to the same number, in any locale.
#pragma once

#include <charconv>
#include <cmath>
#include <cstdio>
#include <string>

namespace remount::formats {

/// The shortest text that from_chars reads back as the same number (0 for a negative zero); "nan" where it is none.
inline std::string exact_text(double value) {
  constexpr double kNoSign = 0.0;  // -0.0 + 0.0 is 0.0
  char buffer[64];
  const auto result = std::to_chars(buffer, buffer + sizeof buffer, value + kNoSign);
  return {buffer, result.ptr};
}

/// Numbers as `pattern` of printf has them, which has less than 256 characters.
std::string format_numbers(const char* pattern, auto... values) {
  char text[256];
  std::snprintf(text, sizeof text, pattern, values...);
  return text;
}

/// Whether the text of a number has no digit but 0.
inline bool shows_zero(const std::string& number) { return number.find_first_not_of("+-0.") == std::string::npos; }

/// For people: so many decimals, and no sign before what rounds to zero.
inline std::string rounded_text(double value, int decimals) {
  std::string text = format_numbers("%.*f", decimals, value);
  if (text.starts_with('-') && shows_zero(text)) text.erase(0, 1);
  return text;
}

/// A difference: "+0.0012", "-0.0012", "0.0000".
inline std::string signed_text(double value, int decimals) {
  const std::string text = rounded_text(value, decimals);
  return value > 0.0 && !shows_zero(text) ? "+" + text : text;
}

/// A sigma, which is never nothing: "0.0012", "< 0.0001" where it rounds to zero.
inline std::string spread_text(double spread, int decimals) {
  const std::string text = rounded_text(spread, decimals);
  return spread > 0.0 && shows_zero(text) ? "< " + rounded_text(std::pow(10.0, -decimals), decimals) : text;
}

}  // namespace remount::formats
