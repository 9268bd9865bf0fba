// Tables whose columns, units and clocks are declared: how their rows are parted, which column is which, and when each
// row was.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/formats/files/calendar_text.h"
#include "model/formats/files/csv_table.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/running_period.h"

namespace remount::formats {

/// How the rows of a table are parted.
struct TableText {
  char separator = ',';  ///< ' ': any blanks
  bool decimal_commas = false;
  std::size_t skip_lines = 0;        ///< above the line of names, or above the rows where columns go by their number
  std::optional<double> no_value{};  ///< a number that stands for one that was not known
};

/// A column by its name in the header line, or by its number from 0 where the name is empty.
struct ColumnRef {
  std::string name;
  std::size_t index = 0;
};

enum class TimeScale {
  Unix,
  Gps,
  GpsWeek,  ///< counts from the start of a week of GPS that nothing names
};

/// Columns that hold the parts of a date, beside one with its seconds.
struct CalendarColumns {
  ColumnRef year, month, day, hour, minute;
};

/// What times count.
struct TimeColumns {
  ColumnRef time;
  std::int64_t time_unit_ns = 1'000'000'000;  ///< nanoseconds in one unit of the time column
  TimeScale time_scale = TimeScale::Unix;
  std::optional<ColumnRef> gps_week;  ///< the time column then counts from the start of the week
  bool is_date = false;               ///< the time column is a text "2023-11-14 22:13:20.5"
  DateOrder date_order = DateOrder::YearFirst;
  std::optional<ColumnRef> day;             ///< of such a text, where another column holds the day
  std::optional<ColumnRef> nanoseconds;     ///< beside whole seconds in the time column
  std::int64_t rest_unit_ns = 1;            ///< what they count: of microseconds 1000
  std::optional<CalendarColumns> calendar;  ///< the time column holds the seconds of a minute then
  std::int64_t offset_ns = 0;               ///< added to what the columns say
};

std::vector<ColumnRef> columns_of(const TimeColumns& time);

/// Parts a line as `text` declares.
void split_declared(std::string_view line, const TableText& text, std::vector<std::string_view>& fields);

/// The text with points of decimals in place of commas; in `memory` where that makes another text.
std::string_view with_points(std::string_view text, const TableText& how, std::string& memory);

/// A time that stands in the name of a file: its longest number, in units of `unit_ns`. Of seconds also those with nine
/// digits of nanoseconds apart ("1600000000_123456789").
std::optional<std::int64_t> time_in_name_ns(std::string_view stem, std::int64_t unit_ns);

/// Takes the lines of a declared table in their order.
class DeclaredRows {
 public:
  /// @param body the text behind the lines that are skipped, with points of decimals (with_points): the line of names
  /// is read here where a column of `columns` goes by its name. Throws Error(Format) where one is missing.
  DeclaredRows(const std::filesystem::path& path, const TableText& text, const TimeColumns& time,
               const std::vector<ColumnRef>& columns, std::string_view body);

  /// Comments and empty lines are passed over. False at the end.
  bool next();
  /// A first line that holds no numbers, where columns go by their number, is a header.
  bool may_be_header() const { return !by_name_ && first_; }

  /// Parts the line, and throws Error(Format) where it has more fields than columns.
  void part();
  std::string_view field(const ColumnRef& column) const;
  /// @param unit that may stand behind it ("deg", "m"); another one there would be another number
  double number(const ColumnRef& column, std::string_view unit = {}) const;
  /// Also with the letter of a side behind it.
  LabelledNumber labelled(const ColumnRef& column, std::string_view unit) const;
  Message label(const ColumnRef& column) const;
  /// UTC; of week 0 where the week is open. Throws Error(Format).
  std::int64_t stamp_ns();

  [[noreturn]] void fail(Message what) const;
  [[noreturn]] void fail_unit(const ColumnRef& column) const;
  std::size_t line_number() const { return lines_.line_number(); }
  std::string place() const { return at_line(path_, line_number()); }

 private:
  Message no_time(std::string_view text) const;
  std::optional<std::int64_t> calendar_ns(std::string_view seconds) const;
  std::optional<std::int64_t> counted_ns(std::string_view text) const;
  std::int64_t stamp_before_offset_ns();

  const std::filesystem::path& path_;
  const TableText& text_;
  const TimeColumns& time_;
  LineReader lines_;
  CsvHeader header_;
  std::size_t most_fields_ = 0;
  bool by_name_ = false, first_ = true, started_ = false;
  std::string_view line_;
  std::vector<std::string_view> fields_;
  RunningPeriod weeks_ = count_weeks();
};

}  // namespace remount::formats
