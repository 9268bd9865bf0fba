// Text from files and file names, made safe to be printed.
#pragma once

#include <string>
#include <string_view>

namespace remount::formats {

enum class LineBreaks {
  Kept,     ///< of texts that have lines
  Escaped,  ///< of names, which must not look like a line of ours
};

/// Whether all of it is UTF-8.
bool is_utf8(std::string_view text);

/// What would steer a terminal, or turn the direction of the text around it, as an escape that shows it: "\x1b" for a
/// control character or a byte that is no UTF-8, "\u202e" for one of Unicode's. All else stays, whatever its script.
std::string printable(std::string_view text, LineBreaks line_breaks = LineBreaks::Kept);

/// Text for HTML: & < > " replaced, and what steers a terminal or the direction of text escaped.
std::string escape_html(std::string_view text);

}  // namespace remount::formats
