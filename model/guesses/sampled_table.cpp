#include "model/guesses/sampled_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <span>

#include "messages/guesses.h"
#include "model/formats/files/time_stamp.h"
#include "model/guesses/column_names.h"
#include "model/guesses/no_value_number.h"
#include "model/guesses/table_titles.h"

namespace remount::guesses {
namespace {

using formats::DateOrder;
using formats::LineReader;
using formats::TableText;

constexpr std::size_t kHeadLines = 400;       ///< that may stand above the rows
constexpr std::size_t kMostColumns = 400;     ///< of a table that is looked at
constexpr std::size_t kSampledRows = 20'000;  ///< that are kept, about
constexpr std::size_t kMostTexts = 12;
constexpr double kNearlyAll = 0.95;
constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr char kSomeDay[] = "2000-01-01 ";

bool is_comment(std::string_view line) { return line.starts_with('#'); }

/// "48,5", with a comma in place of the point.
std::optional<double> number_with_comma(std::string_view field) {
  if (std::ranges::count(field, ',') != 1 || field.find('.') != std::string_view::npos) return std::nullopt;
  std::string mended(field);
  std::ranges::replace(mended, ',', '.');
  return formats::parse_number(mended);
}

std::optional<double> number_of(std::string_view field, const TableText& text) {
  if (const auto number = formats::parse_any_number(field)) return number;
  if (const auto number = formats::parse_labelled_number(field)) return number->signed_value();
  return text.decimal_commas ? number_with_comma(field) : std::nullopt;
}

bool is_clock(std::string_view field) {
  const auto colons = std::ranges::count(field, ':');
  return (colons == 2 || colons == 3) && formats::parse_calendar_ns("2000-01-01 " + std::string(field));
}
constexpr std::array kDateOrders{DateOrder::YearFirst, DateOrder::DayFirst, DateOrder::MonthFirst};
bool is_day(std::string_view field, DateOrder order) {
  return field.size() <= 10 && formats::parse_calendar_ns(std::string(field) + " 00:00:00", order).has_value();
}
bool is_date_or_day(std::string_view field) {
  return std::ranges::any_of(
      kDateOrders, [&](DateOrder order) { return is_day(field, order) || formats::parse_calendar_ns(field, order); });
}
/// Of a table that is no prose.
bool is_value(std::string_view field, const TableText& text) {
  return number_of(field, text) || is_clock(field) || is_date_or_day(field);
}

/// How lines look that are parted in one way.
struct Parting {
  TableText text;
  std::size_t fields = 0;  ///< of most lines that hold numbers
  double score = 0.0;
};

Parting parting_of(const std::vector<std::string_view>& lines, char separator, bool decimal_commas) {
  Parting parting{{separator, decimal_commas, 0}, 0, 0.0};
  std::vector<std::string_view> fields;
  struct Lines {
    double score = 0.0;      // values less the fields that are none
    std::size_t parted = 0;  // fields of the last, with empty ones at the end
  };
  std::map<std::size_t, Lines> by_count;              // of fields
  std::map<std::size_t, std::size_t> most_of_parted;  // fields of the fullest, by those with empty ones
  std::size_t commas = 0;
  for (const std::string_view line : lines) {
    formats::split_declared(line, parting.text, fields);
    const std::size_t filled = formats::filled_fields(fields);
    if (filled > kMostColumns) continue;
    double score = 0.0;
    for (std::size_t i = 0; i < filled; ++i) {
      score += formats::is_no_value(fields[i]) ? 0.0 : is_value(fields[i], parting.text) ? 1.0 : -0.5;
      commas += decimal_commas && number_with_comma(fields[i]).has_value();
    }
    if (score <= 0.0) continue;
    by_count[filled].score += score;
    by_count[filled].parted = fields.size();
    most_of_parted[fields.size()] = std::max(most_of_parted[fields.size()], filled);
  }
  if (decimal_commas && commas == 0) return parting;
  // Where the last columns are empty in most lines, others of as many separators tell how many there are.
  for (const auto& [count, lines_of_it] : by_count)
    if (lines_of_it.score > parting.score)
      parting.fields = most_of_parted[lines_of_it.parted], parting.score = lines_of_it.score;
  return parting;
}

/// The way that gives most values; of several alike the first.
Parting best_parting(const std::vector<std::string_view>& lines) {
  Parting best;
  for (const char separator : {',', ';', '\t', '|', ' '})
    for (const bool decimal_commas : {false, true}) {
      if (decimal_commas && separator == ',') continue;
      const Parting one = parting_of(lines, separator, decimal_commas);
      if (one.score > best.score * 1.001) best = one;
    }
  return best;
}

bool is_row(std::string_view line, const Parting& parting, std::vector<std::string_view>& fields) {
  formats::split_declared(line, parting.text, fields);
  const std::size_t filled = formats::filled_fields(fields);
  if (filled == 0 || filled > parting.fields + 1 || fields.size() < parting.fields) return false;
  std::size_t values = 0, none = 0;
  for (const std::string_view field : std::span(fields).first(filled))
    formats::is_no_value(field) ? ++none : values += is_value(field, parting.text);
  return values > 0 && 2 * (values + none) >= filled;
}

/// What stands above the rows.
struct Head {
  std::size_t row_line = 0;  ///< of the first row, from 1; 0: there is none
  std::vector<std::string> titles, units;
  std::size_t names_line = 0;  ///< of the names, where they can name columns; else 0
};

Head head_of(std::string_view text, const Parting& parting) {
  Head head;
  struct Line {
    std::size_t number;
    std::string_view text;
  };
  std::vector<Line> above;
  std::vector<std::string_view> fields;
  LineReader lines(text);
  for (std::string_view line; head.row_line == 0 && lines.next(line) && lines.line_number() <= kHeadLines;) {
    if (!is_comment(line) && is_row(line, parting, fields))
      head.row_line = lines.line_number();
    else if (!formats::trim(line).empty())
      above.push_back({lines.line_number(), line});
  }
  if (head.row_line == 0) return head;
  // From below: titles, or units with titles above them. Between them and the rows a remark may stand.
  if (!above.empty() && is_remark(above.back().text) &&
      fitting_titles(above.back().text, parting.text, parting.fields).empty())
    above.pop_back();
  if (above.empty()) return head;
  head.titles = fitting_titles(above.back().text, parting.text, parting.fields);
  if (head.titles.empty()) return head;
  const auto above_them = above.size() > 1 && above[above.size() - 2].number + 1 == above.back().number
                              ? fitting_titles(above[above.size() - 2].text, parting.text, parting.fields)
                              : std::vector<std::string>();
  if (!above_them.empty()) {
    const auto units = std::ranges::count_if(head.titles, [](const std::string& title) {
      return title.empty() || title.starts_with('(') || title.starts_with('[') || title.starts_with("deg") ||
             is_unit(title);
    });
    if (2 * static_cast<std::size_t>(units) > head.titles.size()) {
      head.units = std::move(head.titles);
      head.titles = above_them;
      return head;  // by numbers: the units would be a row
    }
  }
  std::string_view names;
  bool only_comments_between = true;
  LineReader again(text);
  for (std::string_view line; again.next(line) && again.line_number() < head.row_line;) {
    if (again.line_number() == above.back().number) names = line;
    if (again.line_number() > above.back().number && !formats::trim(line).empty() && !is_comment(line))
      only_comments_between = false;
  }
  if (only_comments_between && names_columns(names, parting.text, parting.fields))
    head.names_line = above.back().number;
  return head;
}

double value_of(std::string_view field, const TableText& text, DateOrder order) {
  if (const auto number = number_of(field, text)) return *number;
  // Of a day its midnight, of a clock some day's.
  for (const std::string& date : {std::string(field), std::string(field) + " 00:00:00", kSomeDay + std::string(field)})
    if (const auto date_ns =
            formats::parse_calendar_ns(date, date.starts_with(kSomeDay) ? DateOrder::YearFirst : order))
      return 1e-9 * static_cast<double>(*date_ns);
  return kNotANumber;
}

struct ColumnCounts {
  std::size_t numbers = 0, whole = 0, dates = 0, days = 0, clocks = 0;
  std::size_t none = 0;                             ///< without a value
  std::size_t degrees = 0, metres = 0, speeds = 0;  ///< that stand behind numbers
  std::array<std::size_t, 3> of_order{};            ///< dates and days
  std::size_t points = 0;                           ///< of these, that have points between day, month and year
  std::set<std::string> texts;
};

/// What reads the most; between day and month a point leaves no doubt where both are possible.
std::vector<DateOrder> orders_of(const ColumnCounts& counts) {
  std::vector<DateOrder> orders;
  const std::size_t most = std::ranges::max(counts.of_order);
  for (std::size_t i = 0; i < kDateOrders.size(); ++i)
    if (most > 0 && counts.of_order[i] == most) orders.push_back(kDateOrders[i]);
  if (orders.size() == 2 && orders.front() == DateOrder::DayFirst && counts.points == most) orders.pop_back();
  return orders;
}

void count_field(std::string_view field, const TableText& text, ColumnCounts& counts) {
  if (formats::is_no_value(field)) {
    ++counts.none;
    return;
  }
  if (counts.texts.size() < kMostTexts && !field.empty()) counts.texts.emplace(shown_title(field));
  if (number_of(field, text)) {
    ++counts.numbers;
    counts.whole += formats::parse_integer(field).has_value();
    const auto labelled = formats::parse_labelled_number(field);
    counts.degrees += labelled && labelled->unit == "deg";
    counts.metres += labelled && labelled->unit == "m";
    counts.speeds += labelled && labelled->unit == "m/s";
  } else if (is_clock(field)) {
    ++counts.clocks;
  } else {
    bool day = false, date = false;
    for (std::size_t i = 0; i < kDateOrders.size(); ++i) {
      const bool is_one = is_day(field, kDateOrders[i]),
                 dated = formats::parse_calendar_ns(field, kDateOrders[i]).has_value();
      day = day || is_one, date = date || dated;
      counts.of_order[i] += is_one || dated;
    }
    counts.days += day;
    counts.dates += date && !day;
    counts.points += (day || date) && field.find('.') < field.find_first_of("/-");
  }
}

void take_order(std::vector<DateOrder> orders, std::vector<double>& by_day, std::vector<double>& by_month,
                SampledColumn& column) {
  column.orders = std::move(orders);
  if (column.orders.empty() || column.orders.front() == DateOrder::YearFirst) return;
  by_day.resize(column.values.size(), kNotANumber), by_month.resize(column.values.size(), kNotANumber);
  // The fifth of the fifth is one day in either order.
  const bool alike = std::ranges::equal(by_day, by_month, [](double a, double b) { return a == b || std::isnan(a); });
  if (column.orders.size() > 1 && alike) column.orders.pop_back();
  if (column.orders.size() > 1) column.other_values = by_month;
  column.values = std::move(column.orders.front() == DateOrder::DayFirst ? by_day : by_month);
}

/// The rows from the first on. @param stride of those that are kept
void take_values(std::string_view text, const Parting& parting, std::size_t first_line, SampledTable& table) {
  const auto lines_in_all = static_cast<std::size_t>(std::ranges::count(text, '\n'));
  const std::size_t stride = 1 + lines_in_all / kSampledRows;
  std::vector<ColumnCounts> counts(parting.fields);
  std::vector<std::vector<double>> by_day(parting.fields), by_month(parting.fields);
  std::vector<std::string_view> fields;
  LineReader lines(text);
  for (std::string_view line; lines.next(line);) {
    if (lines.line_number() < first_line || formats::trim(line).empty() || is_comment(line)) continue;
    if (table.rows++ % stride != 0) continue;
    formats::split_declared(line, parting.text, fields);
    if (fields.size() < parting.fields || formats::filled_fields(fields) > parting.fields + 1) {
      ++table.bad_rows;
      continue;
    }
    for (std::size_t i = 0; i < parting.fields; ++i) {
      count_field(fields[i], parting.text, counts[i]);
      // Which order dates have all of them tell: those of a year that comes first are values at once.
      table.columns[i].values.push_back(value_of(fields[i], parting.text, DateOrder::YearFirst));
      if (counts[i].of_order[1] + counts[i].of_order[2] == 0) continue;
      by_day[i].resize(table.columns[i].values.size(), kNotANumber);
      by_month[i].resize(table.columns[i].values.size(), kNotANumber);
      by_day[i].back() = value_of(fields[i], parting.text, DateOrder::DayFirst);
      by_month[i].back() = value_of(fields[i], parting.text, DateOrder::MonthFirst);
    }
  }
  for (std::size_t i = 0; i < parting.fields; ++i) {
    constexpr std::size_t kFewestOf = 10;  // one row in so many has a value at least
    const std::size_t all = table.columns[i].values.size(), known = all - counts[i].none;
    const auto nearly_all = [&](std::size_t count) {
      return kFewestOf * known >= all && static_cast<double>(count) >= kNearlyAll * static_cast<double>(known);
    };
    table.columns[i].numeric = nearly_all(counts[i].numbers);
    table.columns[i].whole = table.columns[i].numeric && counts[i].whole >= counts[i].numbers;
    if (table.columns[i].unit.empty())
      table.columns[i].unit = nearly_all(counts[i].degrees)  ? "deg"
                              : nearly_all(counts[i].metres) ? "m"
                              : nearly_all(counts[i].speeds) ? "m/s"
                                                             : "";
    table.columns[i].varies = counts[i].texts.size() > 1;
    table.columns[i].date = nearly_all(counts[i].dates);
    table.columns[i].day = nearly_all(counts[i].days);
    table.columns[i].clock = nearly_all(counts[i].clocks);
    if (table.columns[i].date || table.columns[i].day)
      take_order(orders_of(counts[i]), by_day[i], by_month[i], table.columns[i]);
    table.columns[i].texts.assign(counts[i].texts.begin(), counts[i].texts.end());
  }
  find_no_value(table);
}

}  // namespace

formats::ColumnRef SampledTable::ref(std::size_t column) const {
  return named ? formats::ColumnRef{columns[column].title, 0} : formats::ColumnRef{"", column};
}

std::string SampledTable::label(std::size_t column) const {
  return columns[column].title.empty() ? std::to_string(column) : columns[column].title;
}

std::string_view date_order_name(DateOrder order) {
  return order == DateOrder::DayFirst ? "day-first" : order == DateOrder::MonthFirst ? "month-first" : "year-first";
}

Message words(DateOrder order) {
  return order == DateOrder::DayFirst     ? say::guess_day_first()
         : order == DateOrder::MonthFirst ? say::guess_month_first()
                                          : say::guess_year_first();
}

double largest_size(const std::vector<double>& values) {
  double largest = 0.0;
  for (const double value : values)
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  return largest;
}

std::optional<SampledTable> sample_table(const std::filesystem::path& path, std::string_view text) {
  std::vector<std::string_view> lines;
  LineReader reader(text);
  for (std::string_view line; lines.size() < kHeadLines && reader.next(line);)
    if (!formats::trim(line).empty() && !is_comment(line)) lines.push_back(line);
  const Parting parting = best_parting(lines);
  if (parting.fields == 0) return std::nullopt;
  Head head = head_of(text, parting);
  if (head.row_line == 0) return std::nullopt;
  decode_titles(head.titles, head.units);
  SampledTable table;
  table.path = path;
  table.text = parting.text;
  table.named = head.names_line != 0;
  table.text.skip_lines = table.named ? head.names_line - 1 : head.row_line - 1;
  table.columns.resize(parting.fields);
  for (std::size_t i = 0; i < parting.fields; ++i) {
    table.columns[i].index = i;
    if (i < head.titles.size()) table.columns[i].title = shown_title(head.titles[i]);
    if (i < head.units.size()) table.columns[i].unit = shown_title(head.units[i]);
  }
  take_values(text, parting, head.row_line, table);
  if (table.columns.front().values.size() < kFewestRowsOfTable ||
      2 * table.bad_rows > table.columns.front().values.size())
    return std::nullopt;
  return table;
}

}  // namespace remount::guesses
