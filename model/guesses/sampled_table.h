// A table that nobody declared: how its rows are parted, what stands above them, and some of its numbers.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "algorithms/messages/message.h"
#include "model/formats/files/declared_table.h"

namespace remount::guesses {

struct SampledColumn {
  std::size_t index = 0;
  std::string title;  ///< as it stands above the column: "Lat (deg)"; empty where nothing does
  std::string unit;   ///< of a line of units below the titles, or behind its numbers; empty where there is none
  std::vector<double> values;  ///< NaN where the field is no number; of a date its seconds since 1970
  bool numeric = false;        ///< nearly all are numbers
  bool whole = false;          ///< and whole ones
  bool varies = false;         ///< not always the same
  bool date = false;           ///< nearly all are dates with a time of day
  bool day = false;            ///< likewise without one
  bool clock = false;          ///< a time of day without a date
  /// Of dates and days those that read the most of them, the likeliest first; `values` are by that.
  std::vector<formats::DateOrder> orders;
  std::vector<double> other_values;  ///< by the second of them
  std::vector<std::string> texts;    ///< what stands there, a few of them, each once
};

inline constexpr std::size_t kFewestRowsOfTable = 5;

/// Rows in their order, of a long table every second, third, ...
struct SampledTable {
  std::filesystem::path path;
  formats::TableText text;  ///< with skip_lines as the names of columns need it, or its rows
  bool named = false;       ///< columns can be named as the line above the rows has them, else by their number
  std::vector<SampledColumn> columns;
  std::size_t rows = 0;                  ///< in all
  std::size_t bad_rows = 0;              ///< of another number of fields than most
  std::vector<std::string> no_value_in;  ///< columns in which text.no_value stands

  /// How a manifest names a column.
  formats::ColumnRef ref(std::size_t column) const;
  /// The same for people.
  std::string label(std::size_t column) const;
};

/// "day-first": as a manifest has it.
std::string_view date_order_name(formats::DateOrder order);
/// "day, month, year".
Message words(formats::DateOrder order);

/// The largest of the sizes; 0 of none.
double largest_size(const std::vector<double>& values);

/// Nothing where it is no table: fewer than some rows, or hardly a number in them. Never throws but Error(Io) where the
/// file cannot be read. @param text of the file
std::optional<SampledTable> sample_table(const std::filesystem::path& path, std::string_view text);

}  // namespace remount::guesses
