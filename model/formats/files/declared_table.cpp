#include "model/formats/files/declared_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "algorithms/core/error.h"
#include "messages/files.h"
#include "messages/ins_logs.h"
#include "model/formats/files/row_fields.h"
#include "model/formats/files/time_stamp.h"
#include "model/formats/files/time_unit.h"

namespace remount::formats {
namespace {

constexpr std::int64_t kSecond_ns = 1'000'000'000;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Behind the lines that are left out.
LineReader behind(std::string_view body, std::size_t skip_lines) {
  LineReader lines(body);
  std::string_view line;
  for (std::size_t i = 0; i < skip_lines && lines.next(line); ++i) {
  }
  return lines;
}

}  // namespace

std::vector<ColumnRef> columns_of(const TimeColumns& time) {
  std::vector<ColumnRef> columns{time.time};
  for (const auto* more : {&time.gps_week, &time.day, &time.nanoseconds})
    if (*more) columns.push_back(**more);
  if (time.calendar) {
    const auto& [year, month, day, hour, minute] = *time.calendar;
    columns.insert(columns.end(), {year, month, day, hour, minute});
  }
  return columns;
}

void split_declared(std::string_view line, const TableText& text, std::vector<std::string_view>& fields) {
  if (text.separator == ' ')
    split_blanks(line, fields);
  else
    split_csv(line, fields, text.separator);
}

std::string_view with_points(std::string_view text, const TableText& how, std::string& memory) {
  if (!how.decimal_commas) return text;
  memory = text;
  std::ranges::replace(memory, ',', '.');
  return memory;
}

std::optional<std::int64_t> time_in_name_ns(std::string_view stem, std::int64_t unit_ns) {
  constexpr std::size_t kNanosecondDigits = 9;
  std::vector<std::string_view> numbers;
  for (std::size_t at = 0; at < stem.size();) {
    std::size_t end = at;
    while (end < stem.size() && (is_digit(stem[end]) || (stem[end] == '.' && end > at))) ++end;
    if (end > at) numbers.push_back(stem.substr(at, end - at));
    at = std::max(end, at + 1);
  }
  const auto longest = std::ranges::max_element(numbers, {}, &std::string_view::size);
  if (longest == numbers.end()) return std::nullopt;
  const auto second = std::next(longest);
  if (unit_ns == kSecond_ns && second != numbers.end() && second->size() == kNanosecondDigits &&
      second->data() == longest->data() + longest->size() + 1 && longest->find('.') == std::string_view::npos)
    return parse_seconds_ns(std::string(*longest) + "." + std::string(*second));
  return parse_time_ns(*longest, unit_ns);
}

DeclaredRows::DeclaredRows(const std::filesystem::path& path, const TableText& text, const TimeColumns& time,
                           const std::vector<ColumnRef>& columns, std::string_view body)
    : path_(path), text_(text), time_(time), lines_(behind(body, text.skip_lines)) {
  by_name_ = std::ranges::any_of(columns, [](const ColumnRef& column) { return !column.name.empty(); });
  if (by_name_) {
    std::string_view line;
    if (!lines_.next(line)) throw Error(ErrorCode::Format, path.string(), say::file_empty());
    header_ = CsvHeader(line, text.separator);
    for (const ColumnRef& column : columns)
      if (!column.name.empty()) (void)header_.require(column.name, path);
  }
  most_fields_ = most_fields(lines_, header_.size(),
                             [&](std::string_view row, auto& fields) { split_declared(row, text, fields); });
}

bool DeclaredRows::next() {
  first_ = !started_;
  while (lines_.next(line_))
    if (!trim(line_).empty() && !line_.starts_with('#')) {
      started_ = true;
      return true;
    }
  return false;
}

void DeclaredRows::part() {
  split_declared(line_, text_, fields_);
  if (filled_fields(fields_) > most_fields_) fail(say::csv_fields(filled_fields(fields_), most_fields_));
}

void DeclaredRows::fail(Message what) const { throw Error(ErrorCode::Format, place(), std::move(what)); }

std::string_view DeclaredRows::field(const ColumnRef& column) const {
  const std::size_t index = column.name.empty() ? column.index : static_cast<std::size_t>(header_.find(column.name));
  if (index >= fields_.size()) fail(say::ins_column_needed(fields_.size(), index + 1));
  return fields_[index];
}

Message DeclaredRows::label(const ColumnRef& column) const {
  return column.name.empty() ? say::ins_column(column.index) : Message::verbatim(column.name);
}

LabelledNumber DeclaredRows::labelled(const ColumnRef& column, std::string_view unit) const {
  const std::string_view text = field(column);
  if (is_no_value(text)) fail(say::table_no_value(label(column)));
  const std::optional<LabelledNumber> number = parse_labelled_number(text);
  if (!number) fail_number(text, label(column), path_, line_number());
  if (!number->unit.empty() && number->unit != unit) fail_unit(column);
  if (text_.no_value == number->value) fail(say::log_not_known(label(column), std::string(text.substr(0, 40))));
  return *number;
}

double DeclaredRows::number(const ColumnRef& column, std::string_view unit) const {
  const LabelledNumber number = labelled(column, unit);
  if (number.side != '\0') fail_unit(column);
  return number.value;
}

void DeclaredRows::fail_unit(const ColumnRef& column) const {
  fail(say::table_other_unit(label(column), std::string(field(column).substr(0, 40))));
}

/// Of parts that are whole numbers, and seconds with whatever is a fraction of them.
std::optional<std::int64_t> DeclaredRows::calendar_ns(std::string_view seconds) const {
  std::array<int, 6> parts{};
  std::size_t i = 0;
  for (const ColumnRef* column : {&time_.calendar->year, &time_.calendar->month, &time_.calendar->day,
                                  &time_.calendar->hour, &time_.calendar->minute}) {
    const double value = number(*column);
    constexpr double kLargest = 9999.0;
    if (value != std::floor(value) || !(std::abs(value) <= kLargest)) return std::nullopt;
    parts[i++] = static_cast<int>(value);
  }
  const auto minute_ns = date_of_parts_ns(parts, 0);
  const auto second_ns = parse_time_ns(seconds, kSecond_ns);
  if (!minute_ns || !second_ns || *second_ns < 0 || *second_ns >= 61 * kSecond_ns) return std::nullopt;
  return *minute_ns + *second_ns;
}

std::optional<std::int64_t> DeclaredRows::counted_ns(std::string_view text) const {
  if (time_.is_date) {
    if (!time_.day) return parse_calendar_ns(text, time_.date_order);
    return parse_calendar_ns(std::string(field(*time_.day)) + " " + std::string(text), time_.date_order);
  }
  const auto whole_ns = time_.calendar ? calendar_ns(text) : parse_time_ns(text, time_.time_unit_ns);
  if (!whole_ns || !time_.nanoseconds) return whole_ns;
  const auto rest = parse_integer(field(*time_.nanoseconds));
  if (!rest || *rest < 0 || *rest >= kSecond_ns / time_.rest_unit_ns) return std::nullopt;
  return moved_ns(*whole_ns, *rest * time_.rest_unit_ns);
}

std::int64_t DeclaredRows::stamp_ns() {
  const auto stamp = moved_ns(stamp_before_offset_ns(), time_.offset_ns);
  if (!stamp) fail(no_time(field(time_.time)));
  return *stamp;
}

std::int64_t DeclaredRows::stamp_before_offset_ns() {
  const std::string_view text = field(time_.time);
  const auto counted = counted_ns(text);
  if (!counted || !is_stamp(*counted)) fail(no_time(text));
  if (time_.gps_week) {
    const auto week = parse_integer(field(*time_.gps_week));
    const auto stamp = week ? unix_ns_from_gps_week(*week, *counted) : std::nullopt;
    if (!stamp) fail(say::ins_gps_week());
    return *stamp;
  }
  if (time_.time_scale == TimeScale::Unix) return *counted;
  const bool date = time_.is_date || time_.calendar;
  if (time_.time_scale == TimeScale::Gps) return unix_ns_from_gps_ns(date ? *counted - kGpsEpoch_ns : *counted);
  const auto in_week = *counted >= 0 && *counted <= kGpsWeek_ns ? weeks_.running_ns(*counted) : std::nullopt;
  if (!in_week) fail(say::ins_gps_week());
  return unix_ns_from_gps_ns(*in_week);
}

/// A number that is no time in the declared unit, but would be one in a smaller: the usual mistake.
Message DeclaredRows::no_time(std::string_view text) const {
  const Message column = label(time_.time);
  const std::string shown(text.substr(0, 40));
  if (is_no_value(text)) return say::table_no_value(column);
  if (time_.calendar) return say::ins_no_calendar();
  if (time_.is_date) return say::ins_no_date(column, shown);
  const std::string declared(time_unit_name(time_.time_unit_ns));
  for (const std::int64_t unit_ns : {1'000'000, 1'000, 1})
    if (unit_ns < time_.time_unit_ns && parse_time_ns(text, unit_ns))
      return say::ins_time_too_large(column, shown, declared, std::string(time_unit_name(unit_ns)));
  return say::ins_no_time(column, shown, declared);
}

}  // namespace remount::formats
