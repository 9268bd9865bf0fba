// Reading files from outside: regular files of a bounded size only, and numbers that do not depend on the locale.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "algorithms/messages/message.h"

namespace remount::formats {

inline constexpr std::uint64_t kMaxDataFileBytes = std::uint64_t{4} << 30;
inline constexpr std::uint64_t kMaxManifestBytes = std::uint64_t{1} << 20;

/// The bytes of a regular file. Throws Error(Io) naming the path where it is missing, not readable or not a regular
/// file (directories, FIFOs, devices and sockets are refused without blocking), and Error(Unsupported) where it is
/// larger than `max_bytes`. Takes memory for what the file holds and no more.
std::string read_regular_file(const std::filesystem::path& path, std::uint64_t max_bytes = kMaxDataFileBytes);

/// The first bytes of a regular file, at most `bytes`; same errors.
std::string read_file_head(const std::filesystem::path& path, std::size_t bytes);

/// True where the path leads to a regular file. Throws Error(Io) where that cannot be seen: that is not its absence.
bool is_file(const std::filesystem::path& path);
/// True where the path leads to a directory; likewise.
bool is_folder(const std::filesystem::path& path);

/// False where permission to look into a directory is missing: what lies there is somebody else's.
bool may_look_into(const std::filesystem::path& directory);

/// Throws Error(Io) where `problem` kept a directory from being listed to its end: that must not pass for fewer files.
/// One that is not there has none.
void check_listed(const std::error_code& problem, const std::filesystem::path& directory);

/// Regular files of a directory, not of its subdirectories, by name; none where it is not there. Throws Error(Io).
std::vector<std::filesystem::path> files_in(const std::filesystem::path& directory);
/// Subdirectories in the order of their names; likewise.
std::vector<std::filesystem::path> directories_in(const std::filesystem::path& directory);

/// Walks the lines of a text without copying; strips "\r" at the end and a byte order mark at the beginning.
/// Where there is no "\n" at all, lines end at "\r" (old spreadsheets).
class LineReader {
 public:
  explicit LineReader(std::string_view text);
  /// False at the end. A last line without "\n" counts.
  bool next(std::string_view& line);
  std::size_t line_number() const { return line_number_; }  ///< of the line that next() gave, from 1
  std::size_t offset() const { return offset_; }            ///< byte after that line

 private:
  std::string_view text_;
  std::size_t offset_ = 0;
  std::size_t line_number_ = 0;
  char line_end_ = '\n';
};

std::string_view trim(std::string_view text);
std::string lower_case(std::string_view text);
/// Whatever a line holds, it is taken apart into no more fields than this; the last has all that follows. A field takes
/// sixteen times the memory of the separator that it may be made of.
inline constexpr std::size_t kMostFieldsOfLine = 16'384;
/// Tokens between spaces and tabs. Reuses the memory of `tokens`.
void split_blanks(std::string_view line, std::vector<std::string_view>& tokens);
/// Fields of a CSV line, trimmed; commas within double quotes do not separate, the quotes are taken off.
void split_csv(std::string_view line, std::vector<std::string_view>& fields, char separator = ',');
/// How many there are without empty ones at the end: behind the last separator there may be nothing.
std::size_t filled_fields(const std::vector<std::string_view>& fields);

/// The whole text as a number, or nothing. "nan" and "inf" are numbers only to parse_any_number.
std::optional<double> parse_number(std::string_view text);
std::optional<double> parse_any_number(std::string_view text);
/// A number with what instruments write behind it: "250.1 m", "12.5 deg", "48.1° N".
struct LabelledNumber {
  double value = 0.0;     ///< as it stands; not negative where a side stands behind it
  std::string_view unit;  ///< "deg", "m" or "m/s"; empty where none stands
  char side = '\0';       ///< 'N', 'S', 'E' or 'W'

  double signed_value() const { return side == 'S' || side == 'W' ? -value : value; }
};
/// Also of a number alone. Nothing where anything else stands there.
std::optional<LabelledNumber> parse_labelled_number(std::string_view text);
std::optional<std::int64_t> parse_integer(std::string_view text);

/// What tables write where a value was not known: nothing, "nan", "N/A", "-", "null". One list for all that read
/// tables.
bool is_no_value(std::string_view field);

/// A place in a text file, for messages: "path:line".
std::string at_line(const std::filesystem::path& path, std::size_t line);

/// As parse_number; throws Error(Format) "path:line: <name> is '<text>', expected a finite number".
/// @param name as the file writes it, of a column
double require_number(std::string_view text, std::string_view name, const std::filesystem::path& path,
                      std::size_t line);

/// Throws what require_number throws.
[[noreturn]] void fail_number(std::string_view text, Message what, const std::filesystem::path& path, std::size_t line);

/// Likewise. @param what makes words of the program, only where they are needed
template <std::invocable What>
double require_number(std::string_view text, What&& what, const std::filesystem::path& path, std::size_t line) {
  if (const std::optional<double> value = parse_number(text)) return *value;
  fail_number(text, what(), path, line);
}

/// Seconds written in decimal, to nanoseconds without loss ("1636512749.922900677"); nothing where it is no number or
/// beyond the range of int64.
std::optional<std::int64_t> parse_seconds_ns(std::string_view text);

/// A number in units of `unit_ns` as nanoseconds, exactly for integers and for decimals of seconds.
std::optional<std::int64_t> parse_time_ns(std::string_view text, std::int64_t unit_ns);

}  // namespace remount::formats
