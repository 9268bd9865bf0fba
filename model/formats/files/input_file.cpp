#include "model/formats/files/input_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <system_error>
#include <utility>

#include "algorithms/core/error.h"
#include "messages/files.h"
#include "model/formats/files/regular_file.h"
#include "model/formats/files/system_call.h"
#include "model/formats/files/system_words.h"

namespace remount::formats {

namespace {

std::uint64_t size_of(const FileDescriptor& file, const std::filesystem::path& path) {
  struct stat status {};
  if (retry_interrupted([&] { return ::fstat(file.get(), &status); }) != 0)
    throw Error(ErrorCode::Io, path.string(), say::file_cannot_be_examined(system_words(errno)));
  return static_cast<std::uint64_t>(status.st_size);
}

std::string read_bytes(const FileDescriptor& file, const std::filesystem::path& path, std::uint64_t size) {
  std::string bytes(size, '\0');
  std::size_t filled = 0;
  while (filled < bytes.size()) {
    const ssize_t count =
        retry_interrupted([&] { return ::read(file.get(), bytes.data() + filled, bytes.size() - filled); });
    if (count < 0) throw Error(ErrorCode::Io, path.string(), say::file_cannot_be_read(system_words(errno)));
    if (count == 0) break;  // became shorter since fstat
    filled += static_cast<std::size_t>(count);
  }
  bytes.resize(filled);
  return bytes;
}

/// A link that leads nowhere that may be seen is none of the data; what lies in the folder itself is asked for.
bool leads_out_of_sight(const std::filesystem::directory_entry& entry, const std::error_code& unknown) {
  if (unknown == std::errc::too_many_symbolic_link_levels) return true;
  std::error_code ignored;
  return unknown == std::errc::permission_denied && entry.is_symlink(ignored);
}

template <class Keep>
std::vector<std::filesystem::path> entries(const std::filesystem::path& directory, Keep&& keep) {
  std::vector<std::filesystem::path> found;
  std::error_code problem;
  for (std::filesystem::directory_iterator entry(directory, problem), end; !problem && entry != end;
       entry.increment(problem)) {
    std::error_code unknown;
    if (keep(*entry, unknown)) found.push_back(entry->path());
    if (!leads_out_of_sight(*entry, unknown)) check_listed(unknown, entry->path());
  }
  if (problem == std::errc::interrupted) return entries(directory, keep);
  check_listed(problem, directory);
  std::sort(found.begin(), found.end());
  return found;
}

std::optional<double> parse_double(std::string_view text) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || text.empty()) return std::nullopt;
  return value;
}

}  // namespace

std::string read_regular_file(const std::filesystem::path& path, std::uint64_t max_bytes) {
  const FileDescriptor file = open_regular_file(path);
  const std::uint64_t size = size_of(file, path);
  if (size > max_bytes)
    throw Error(ErrorCode::Unsupported, path.string(), say::file_too_large(Bytes{size}, Bytes{max_bytes}));
  return read_bytes(file, path, size);
}

std::string read_file_head(const std::filesystem::path& path, std::size_t bytes) {
  const FileDescriptor file = open_regular_file(path);
  return read_bytes(file, path, std::min<std::uint64_t>(size_of(file, path), bytes));
}

bool is_file(const std::filesystem::path& path) {
  const std::optional<struct stat> there = status_of(path);
  return there && S_ISREG(there->st_mode);
}

bool is_folder(const std::filesystem::path& path) {
  const std::optional<struct stat> there = status_of(path);
  return there && S_ISDIR(there->st_mode);
}

bool may_look_into(const std::filesystem::path& directory) {
  return retry_interrupted([&] { return ::faccessat(AT_FDCWD, directory.c_str(), R_OK | X_OK, AT_EACCESS); }) == 0 ||
         errno != EACCES;
}

void check_listed(const std::error_code& problem, const std::filesystem::path& directory) {
  if (problem && problem != std::errc::no_such_file_or_directory && problem != std::errc::not_a_directory)
    throw Error(ErrorCode::Io, directory.string(), say::file_cannot_be_listed(system_words(problem)));
}

std::vector<std::filesystem::path> files_in(const std::filesystem::path& directory) {
  return entries(directory, [](const auto& entry, std::error_code& unknown) { return entry.is_regular_file(unknown); });
}

std::vector<std::filesystem::path> directories_in(const std::filesystem::path& directory) {
  return entries(directory, [](const auto& entry, std::error_code& unknown) { return entry.is_directory(unknown); });
}

LineReader::LineReader(std::string_view text) : text_(text) {
  if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);
  if (text_.find('\n') == std::string_view::npos && text_.find('\r') != std::string_view::npos) line_end_ = '\r';
}

bool LineReader::next(std::string_view& line) {
  if (offset_ >= text_.size()) return false;
  const std::size_t end = text_.find(line_end_, offset_);
  line = text_.substr(offset_, end == std::string_view::npos ? end : end - offset_);
  offset_ = end == std::string_view::npos ? text_.size() : end + 1;
  if (line.ends_with('\r')) line.remove_suffix(1);
  ++line_number_;
  return true;
}

std::string_view trim(std::string_view text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return text;
}

std::string lower_case(std::string_view text) {
  std::string lowered(text);
  for (char& c : lowered)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return lowered;
}

void split_blanks(std::string_view line, std::vector<std::string_view>& tokens) {
  tokens.clear();
  std::size_t at = 0;
  while (at < line.size()) {
    const std::size_t begin = line.find_first_not_of(" \t\r", at);
    if (begin == std::string_view::npos) return;
    const bool last = tokens.size() + 1 == kMostFieldsOfLine;
    at = last ? line.size() : std::min(line.find_first_of(" \t\r", begin), line.size());
    tokens.push_back(line.substr(begin, at - begin));
  }
}

void split_csv(std::string_view line, std::vector<std::string_view>& fields, char separator) {
  fields.clear();
  const auto keep = [&](std::string_view field) {
    field = trim(field);
    if (field.size() >= 2 && field.front() == '"' && field.back() == '"') field = field.substr(1, field.size() - 2);
    fields.push_back(field);
  };
  bool quoted = false;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < line.size() && fields.size() + 1 < kMostFieldsOfLine; ++i) {
    if (line[i] == '"') quoted = !quoted;
    if (line[i] != separator || quoted) continue;
    keep(line.substr(begin, i - begin));
    begin = i + 1;
  }
  keep(line.substr(begin));
}

std::size_t filled_fields(const std::vector<std::string_view>& fields) {
  std::size_t filled = fields.size();
  while (filled > 0 && fields[filled - 1].empty()) --filled;
  return filled;
}

std::optional<double> parse_number(std::string_view text) {
  const std::optional<double> value = parse_double(trim(text));
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<double> parse_any_number(std::string_view text) { return parse_double(trim(text)); }

std::optional<LabelledNumber> parse_labelled_number(std::string_view text) {
  static constexpr std::string_view kDegreeSigns[] = {"\xc2\xb0", "\xb0", "deg"};  // UTF-8, Latin-1
  text = trim(text);
  const std::size_t end = text.find_last_of("0123456789.") + 1;  // 0 where there is no digit at all
  const std::optional<double> value = parse_number(text.substr(0, end));
  if (!value) return std::nullopt;
  LabelledNumber number{*value, {}, '\0'};
  std::string_view label = trim(text.substr(end));
  for (const std::string_view sign : kDegreeSigns)
    if (number.unit.empty() && label.starts_with(sign)) number.unit = "deg", label = trim(label.substr(sign.size()));
  if (number.unit.empty() && (label == "m" || label == "m/s")) number.unit = std::exchange(label, {});
  if (label.size() == 1 && std::string_view("NSEW").find(label[0]) != std::string_view::npos) {
    if (std::signbit(*value)) return std::nullopt;  // "-48.1 S" may be either
    number.side = std::exchange(label, {})[0];
  }
  return label.empty() ? std::optional(number) : std::nullopt;
}

std::optional<std::int64_t> parse_integer(std::string_view text) {
  text = trim(text);
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || text.empty()) return std::nullopt;
  return value;
}

bool is_no_value(std::string_view field) {
  constexpr std::size_t kLongest = 6;
  field = trim(field);
  if (field.empty()) return true;
  if (field.size() > kLongest) return false;
  const std::string plain = lower_case(field);
  static constexpr std::string_view kNone[] = {"nan", "+nan", "-nan", "n/a",  "na",   "#n/a",   "n.a.",
                                               "-",   "--",   "---",  "null", "none", "(null)", "\\n"};
  return std::find(std::begin(kNone), std::end(kNone), plain) != std::end(kNone);
}

std::string at_line(const std::filesystem::path& path, std::size_t line) {
  return path.string() + ":" + std::to_string(line);
}

namespace {

/// The beginning of what a file holds, for messages: bytes that are no text would end them, or garble a terminal.
std::string shown(std::string_view text) {
  std::string begin(text.substr(0, 60));
  for (char& c : begin)
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = '?';
  return begin;
}

}  // namespace

double require_number(std::string_view text, std::string_view name, const std::filesystem::path& path,
                      std::size_t line) {
  if (const std::optional<double> value = parse_number(text)) return *value;
  fail_number(text, Message::verbatim(std::string(name)), path, line);
}

void fail_number(std::string_view text, Message what, const std::filesystem::path& path, std::size_t line) {
  throw Error(ErrorCode::Format, at_line(path, line), say::file_no_finite_number(std::move(what), shown(text)));
}

std::optional<std::int64_t> parse_seconds_ns(std::string_view text) {
  text = trim(text);
  const std::size_t point = text.find('.');
  const std::string_view whole = text.substr(0, point);
  std::string_view fraction = point == std::string_view::npos ? std::string_view{} : text.substr(point + 1);
  const std::optional<std::int64_t> seconds = parse_integer(whole);
  const bool digits = std::all_of(fraction.begin(), fraction.end(), [](char c) { return c >= '0' && c <= '9'; });
  if (!seconds || !digits) {  // exponents and the like: as good as a double is
    const std::optional<double> value = parse_number(text);
    if (!value || std::abs(*value) > 9.2e9) return std::nullopt;
    return std::llround(*value * 1e9);
  }
  // Compared, not negated: the smallest integer has no absolute value.
  if (*seconds > 9'200'000'000 || *seconds < -9'200'000'000) return std::nullopt;
  std::int64_t nanoseconds = 0;
  for (std::size_t i = 0; i < 9; ++i) nanoseconds = nanoseconds * 10 + (i < fraction.size() ? fraction[i] - '0' : 0);
  if (fraction.size() > 9 && fraction[9] >= '5') ++nanoseconds;
  return *seconds * 1'000'000'000 + (whole.starts_with('-') ? -nanoseconds : nanoseconds);
}

std::optional<std::int64_t> parse_time_ns(std::string_view text, std::int64_t unit_ns) {
  if (unit_ns == 1'000'000'000) return parse_seconds_ns(text);
  constexpr double kLimit = 8e18;  // leaves room for the difference between time scales
  if (const auto whole = parse_integer(text)) {
    if (std::abs(static_cast<double>(*whole)) * static_cast<double>(unit_ns) > kLimit) return std::nullopt;
    return *whole * unit_ns;
  }
  const auto value = parse_number(text);
  if (!value || std::abs(*value) * static_cast<double>(unit_ns) > kLimit) return std::nullopt;
  return std::llround(*value * static_cast<double>(unit_ns));
}

}  // namespace remount::formats
