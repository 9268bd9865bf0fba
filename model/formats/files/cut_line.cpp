#include "model/formats/files/cut_line.h"

#include <algorithm>

#include "messages/files.h"
#include "messages/sessions.h"
#include "model/drive/bad_items.h"
#include "model/formats/files/input_file.h"

namespace remount::formats {
namespace {

/// How much a line of a table holds, as far as it shows whether the line is whole.
struct LineEnd {
  std::size_t fields, digits, decimals;  ///< of the line; of its last field, in all and behind the point
  bool number;                           ///< the last field is one
};

LineEnd end_of(std::string_view line) {
  std::vector<std::string_view> fields;
  if (line.find(',') != std::string_view::npos)
    split_csv(line, fields);
  else if (line.find(';') != std::string_view::npos)
    split_csv(line, fields, ';');
  else
    split_blanks(line, fields);
  const std::string_view last = fields.empty() ? std::string_view{} : fields.back();
  const auto digits_from = [&](std::size_t place) -> std::size_t {
    if (place == std::string_view::npos) return 0;
    return static_cast<std::size_t>(std::count_if(last.begin() + static_cast<std::ptrdiff_t>(place), last.end(),
                                                  [](char c) { return c >= '0' && c <= '9'; }));
  };
  // "1.5e-0" is a number, and was none with two digits of exponent; its decimals then say nothing.
  const std::size_t exponent = last.find_first_of("eE");
  const bool exponent_cut = exponent != std::string_view::npos && digits_from(exponent) < 2;
  return {fields.size(), digits_from(0), exponent_cut ? 0 : digits_from(last.find('.')),
          parse_number(last).has_value()};
}

/// Whether the last number of a line has lost so many digits that it is another.
bool lost_digits(const LineEnd& line, const LineEnd& fewest) {
  if (!line.number || !fewest.number || line.fields != fewest.fields) return false;
  return fewest.decimals > 0 ? 2 * line.decimals < fewest.decimals : line.digits < fewest.digits;
}

}  // namespace

std::string_view without_cut_line(std::string_view text, const std::string& path,
                                  std::vector<drive::Finding>& findings) {
  constexpr std::size_t kFewest = 3, kMost = 20;  // numbers that end in zeros are written with fewer digits
  const std::size_t last = text.rfind('\n') + 1;
  const std::string_view line = trim(text.substr(last));
  if (line == "\x1a") return text.substr(0, last);  // the end of a file, to DOS
  if (line.empty() || line.starts_with('#')) return text;
  LineEnd fewest{text.size(), text.size(), text.size(), true};
  std::size_t compared = 0;
  for (std::size_t end = last; compared < kMost && end > 0;) {
    const std::size_t begin = end == 1 ? 0 : text.rfind('\n', end - 2) + 1;
    const std::string_view before = trim(text.substr(begin, end - 1 - begin));
    end = begin;
    if (before.empty() || before.starts_with('#') || begin == 0) continue;  // the first may be a header
    const LineEnd one = end_of(before);
    fewest = {std::min(fewest.fields, one.fields), std::min(fewest.digits, one.digits),
              std::min(fewest.decimals, one.decimals), fewest.number && one.number};
    ++compared;
  }
  const LineEnd cut = end_of(line);
  if (compared < kFewest || (cut.fields >= fewest.fields && !lost_digits(cut, fewest))) return text;
  const auto number = 1 + static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  findings.push_back(
      drive::make_finding(drive::Severity::Warning, "log-cut", at_line(path, number), say::stream_cut()));
  return text.substr(0, last);
}

}  // namespace remount::formats
