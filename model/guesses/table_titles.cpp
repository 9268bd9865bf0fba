#include "model/guesses/table_titles.h"

#include <algorithm>
#include <optional>
#include <tuple>

#include "model/formats/files/input_file.h"
#include "model/formats/files/old_encodings.h"
#include "model/formats/files/printable_text.h"
#include "model/guesses/column_names.h"

namespace remount::guesses {

using formats::CsvHeader;
using formats::TableText;
using formats::with_points;

namespace {

/// Words that are titles: what stands in brackets belongs to the one before it.
std::vector<std::string> titles_between_blanks(std::string_view line) {
  std::vector<std::string_view> words;
  line = formats::trim(line);
  while (line.starts_with('#') || line.starts_with('%')) line = formats::trim(line.substr(1));
  formats::split_blanks(line, words);
  std::vector<std::string> titles;
  for (const std::string_view word : words) {
    if ((word.starts_with('(') || word.starts_with('[')) && !titles.empty())
      titles.back() += " " + std::string(word);
    else
      titles.emplace_back(word);
  }
  return titles;
}

std::vector<std::string> titles_of(std::string_view line, std::size_t fields, char separator) {
  std::vector<std::string> titles;
  if (separator == ' ') {
    titles = titles_between_blanks(line);
  } else {
    titles = formats::CsvHeader(line, separator).names();
    if (!titles.empty() && titles[0].starts_with('%')) titles[0] = formats::trim(titles[0].substr(1));
  }
  while (titles.size() > fields && titles.back().empty()) titles.pop_back();
  return titles;
}

}  // namespace

std::string shown_title(std::string_view title) {
  std::string shown(title.substr(0, 60));
  std::erase_if(shown, [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; });
  return shown;
}

namespace {

/// As Chinese text is mostly encoded: bytes beyond ASCII come by twos.
bool comes_by_twos(std::string_view text) {
  std::size_t run = 0;
  for (const char c : text) {
    if (static_cast<unsigned char>(c) >= 0x80)
      ++run;
    else if (run % 2 != 0)
      return false;
    else
      run = 0;
  }
  return run % 2 == 0;
}

}  // namespace

std::vector<std::string> fitting_titles(std::string_view line, const TableText& text, std::size_t fields) {
  for (const char separator : {text.separator, ',', ';', '\t', '|'})
    if (auto titles = titles_of(line, fields, separator); titles.size() == fields) return titles;
  return {};
}

bool names_columns(std::string_view line, const TableText& text, std::size_t fields) {
  std::string memory;
  const CsvHeader header(with_points(line, text, memory), text.separator);
  std::vector<std::string> names = header.names();
  while (names.size() > fields && names.back().empty()) names.pop_back();
  // What is written otherwise above the columns than the reader takes it would not be found.
  if (names.size() != fields || names != titles_of(line, fields, text.separator)) return false;
  for (const std::string& name : names)
    if (name.empty() || formats::parse_integer(name) || name != shown_title(name) || name.find('"') != name.npos ||
        !formats::is_utf8(name))
      return false;
  std::ranges::sort(names);
  return std::ranges::adjacent_find(names) == names.end();
}

bool is_remark(std::string_view line) {
  line = formats::trim(line);
  return line.starts_with('(') || line.starts_with('[');
}

void decode_titles(std::vector<std::string>& titles, std::vector<std::string>& units) {
  if (std::ranges::all_of(titles, formats::is_utf8) && std::ranges::all_of(units, formats::is_utf8)) return;
  const std::vector<std::string> titles_as_read = titles, units_as_read = units;
  const bool by_twos = std::ranges::all_of(titles, comes_by_twos) && std::ranges::all_of(units, comes_by_twos);
  using Merit = std::tuple<std::ptrdiff_t, std::ptrdiff_t, bool>;  // titles that are known; letters that are none
  std::optional<Merit> best;
  for (const auto& [encoding, of_twos] : formats::kOldEncodings) {
    std::vector<std::string> decoded = titles_as_read, decoded_units = units_as_read;
    std::ptrdiff_t known = 0, none = 0;
    for (std::string& title : decoded) {
      title = formats::decoded(title, encoding);
      known += quantity_of(title).has_value();
      none += std::ranges::count(title, '?');
    }
    for (std::string& unit : decoded_units) unit = formats::decoded(unit, encoding);
    const Merit merit(known, -none, of_twos == by_twos);
    if (best && merit <= *best) continue;
    titles = std::move(decoded), units = std::move(decoded_units), best = merit;
  }
}

}  // namespace remount::guesses
