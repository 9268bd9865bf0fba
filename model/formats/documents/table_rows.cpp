#include "model/formats/documents/table_rows.h"

#include <algorithm>

#include "algorithms/core/error.h"
#include "messages/files.h"
#include "model/formats/files/input_file.h"

namespace remount::formats {

namespace {

constexpr std::uint64_t kPieceBytes = 1U << 20;
constexpr std::size_t kLongestRow = 64 * 1024;
constexpr std::string_view kJsonBlanks = " \t\r\n";

bool is_json_blank(char c) { return kJsonBlanks.find(c) != std::string_view::npos; }

/// Where a value ends that begins at `at`: behind its closing quote or bracket, or before what stands behind a plain
/// word. npos where it does not end.
std::size_t end_of_value(std::string_view text, std::size_t at) {
  int depth = 0;
  bool quoted = false;
  for (std::size_t i = at; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted) {
      if (c == '\\') ++i;
      if (c == '"') quoted = false;
      if (c == '"' && depth == 0) return i + 1;
    } else if (c == '"') {
      quoted = true;
    } else if (c == '[' || c == '{') {
      ++depth;
    } else if (c == ']' || c == '}') {
      if (depth == 0) return i;
      if (--depth == 0) return i + 1;
    } else if (depth == 0 && (c == ',' || is_json_blank(c))) {
      return i;
    }
  }
  return std::string_view::npos;
}

}  // namespace

std::string TableRows::place() const { return row_line_ > 1 ? at_line(path_, row_line_) : file_.place(row_begin_); }

void TableRows::fail(Message what) const { throw Error(ErrorCode::Format, place(), std::move(what)); }

bool TableRows::has_more() {
  if (at_ < piece_.size()) return true;
  if (read_to_ >= file_.size()) return false;
  const std::uint64_t count = std::min(kPieceBytes, file_.size() - read_to_);
  piece_ = file_.read(read_to_, count);
  read_to_ += count;
  at_ = 0;
  return true;
}

/// The next character that is no blank, which is passed; 0 at the end of the file.
char TableRows::skip_to_sign() {
  while (has_more()) {
    const char c = piece_[at_++];
    if (c == '\n') ++line_;
    if (!is_json_blank(c)) return c;
  }
  return '\0';
}

bool TableRows::next() {
  if (ended_) return false;
  char sign = skip_to_sign();
  if (!begun_) {
    ended_ = sign != '[';
    if (ended_) fail(say::table_no_list());
    begun_list_ = true;
    sign = skip_to_sign();
  } else if (sign == ',') {
    sign = skip_to_sign();
    if (sign == ']') sign = '\0';
  } else if (sign != ']') {
    sign = '\0';
  }
  row_begin_ = read_to_ - piece_.size() + at_ - (at_ > 0 ? 1 : 0);
  row_line_ = line_;
  begun_ = true;
  ended_ = sign != '{';
  if (sign == ']') return false;
  if (ended_) fail(say::table_no_row());
  cut_row();
  take_apart();
  return true;
}

/// From behind the opening brace to the one that closes it.
void TableRows::cut_row() {
  row_ = "{";
  int depth = 1;
  bool quoted = false, escaped = false;
  bool too_long = false;
  while (depth > 0) {
    ended_ = !has_more();
    if (ended_) fail(say::table_cut_row());
    too_long = too_long || row_.size() >= kLongestRow;
    const char c = piece_[at_++];
    if (c == '\n') ++line_;
    if (!too_long) row_ += c;
    if (escaped)
      escaped = false;
    else if (quoted && c == '\\')
      escaped = true;
    else if (c == '"')
      quoted = !quoted;
    else if (!quoted && (c == '{' || c == '['))
      ++depth;
    else if (!quoted && (c == '}' || c == ']'))
      --depth;
  }
  if (too_long) fail(say::table_long_row(Bytes{kLongestRow}));
}

void TableRows::take_apart() {
  values_.clear();
  const std::string_view row = row_;
  std::size_t at = 1;
  const auto skip = [&] {
    at = std::min(row.find_first_not_of(kJsonBlanks, at), row.size() - 1);
    return row[at];
  };
  while (skip() != '}') {
    if (!values_.empty()) {
      if (row[at] != ',') fail(say::table_no_row());
      ++at, skip();
    }
    const std::size_t key_end = row[at] == '"' ? end_of_value(row, at) : std::string_view::npos;
    if (key_end == std::string_view::npos) fail(say::table_no_row());
    Value value{row.substr(at + 1, key_end - at - 2), {}, false};
    at = key_end;
    if (skip() != ':') fail(say::table_no_row());
    ++at, skip();
    const std::size_t end = end_of_value(row, at);
    if (end == std::string_view::npos || end == at) fail(say::table_no_row());
    value.is_text = row[at] == '"';
    value.raw = value.is_text ? row.substr(at + 1, end - at - 2) : row.substr(at, end - at);
    values_.push_back(value);
    at = end;
  }
}

const TableRows::Value& TableRows::value(std::string_view key) const {
  for (const Value& value : values_)
    if (value.key == key) return value;
  fail(say::table_no_key(std::string(key)));
}

std::string TableRows::text(std::string_view key) const {
  const Value& found = value(key);
  if (!found.is_text) fail(say::table_no_text(std::string(key)));
  std::string text;
  for (std::size_t i = 0; i < found.raw.size(); ++i) {
    const bool resolved = found.raw[i] == '\\' && i + 1 < found.raw.size() &&
                          std::string_view("/\"\\").find(found.raw[i + 1]) != std::string_view::npos;
    text += found.raw[resolved ? ++i : i];
  }
  return text;
}

std::int64_t TableRows::integer(std::string_view key) const {
  const Value& found = value(key);
  const auto number = found.is_text ? std::nullopt : parse_integer(found.raw);
  if (!number) fail(say::table_no_integer(std::string(key)));
  return *number;
}

std::vector<double> TableRows::numbers(std::string_view key, std::size_t count) const {
  const Value& found = value(key);
  std::vector<double> numbers;
  const bool list = !found.is_text && found.raw.size() >= 2 && found.raw.front() == '[' && found.raw.back() == ']';
  std::vector<std::string_view> fields;
  if (list) split_csv(found.raw.substr(1, found.raw.size() - 2), fields);
  for (const std::string_view field : fields)
    if (const auto number = parse_number(field)) numbers.push_back(*number);
  if (numbers.size() != count || fields.size() != count) fail(say::table_no_numbers(std::string(key), count));
  return numbers;
}

}  // namespace remount::formats
