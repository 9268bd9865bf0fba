#include "model/guesses/found_tables.h"

#include <algorithm>
#include <map>
#include <span>
#include <string>
#include <utility>

#include "algorithms/core/error.h"
#include "messages/guesses.h"
#include "model/drive/bad_items.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/text_file.h"
#include "model/guesses/motion_parts.h"

namespace remount::guesses {

namespace fs = std::filesystem;

namespace {

enum class TextKind { Text, Empty, Other };
TextKind text_kind(const fs::path& file) {
  constexpr std::size_t kHead = 4096;
  const std::string head = formats::read_text_head(file, kHead);
  if (head.find('\0') != std::string::npos) return TextKind::Other;
  return formats::trim(head).find_first_not_of("\r\n") == std::string_view::npos ? TextKind::Empty : TextKind::Text;
}
bool is_text(const fs::path& file) { return text_kind(file) == TextKind::Text; }

/// Whether somebody would look for a table there.
bool is_called_table(const fs::path& file) {
  const std::string extension = formats::lower_case(file.extension().string());
  return extension == ".csv" || extension == ".tsv" || extension == ".txt";
}

/// Rows with more numbers than words, however they are parted.
std::size_t rows_of_numbers(std::string_view text) {
  std::size_t rows = 0;
  formats::LineReader lines(text);
  std::vector<std::string_view> fields;
  for (std::string_view line; lines.next(line);) {
    std::string parted(line);
    std::ranges::replace_if(
        parted, [](char c) { return c == ',' || c == ';' || c == '|'; }, ' ');
    formats::split_blanks(parted, fields);
    const auto numbers =
        std::ranges::count_if(fields, [](auto field) { return formats::parse_number(field).has_value(); });
    rows += numbers > 1 && 2 * static_cast<std::size_t>(numbers) >= fields.size();
  }
  return rows;
}

/// Whether its rows may be those of the scans of a folder.
bool may_tell_times(const SampledTable& table, const std::vector<CloudFolder>& clouds) {
  return std::ranges::any_of(clouds, [&](const CloudFolder& one) { return 2 * table.rows >= one.files.size(); });
}

/// Tables that may be of use, within bounds of their number and of the memory for their values.
class TablesFound {
 public:
  TablesFound(const std::vector<CloudFolder>& clouds, std::vector<NotUsed>& not_used)
      : clouds_(clouds), not_used_(not_used) {}

  std::vector<FoundTable> of(const std::vector<fs::path>& files, const Progress& progress) {
    for (std::size_t i = 0; i < files.size() && !progress.cancelled(); ++i) {
      if (tables_.size() == kMostTables || values_ > kMostValues) {
        tell_left(std::span(files).subspan(i));
        break;
      }
      try {
        const TextKind kind = text_kind(files[i]);
        if (kind != TextKind::Text) {
          tell_no_text(files[i], kind);
          continue;
        }
        const std::string text = formats::read_text_file(files[i]);
        if (auto table = sample_table(files[i], text))
          add(files[i], std::move(*table));
        else
          tell_no_table(files[i], text);
      } catch (const Error& error) {
        not_used_.push_back({files[i], drive::message_of(error)});
      }
    }
    tell_small();
    return std::move(tables_);
  }

 private:
  static constexpr std::size_t kMostTables = 200, kMostValues = 20'000'000;  // 160 MB

  void add(const fs::path& file, SampledTable table) {
    const bool part = table.columns.size() >= kFewestColumnsOfPart && motion_part_of(table) != MotionPart::None;
    if (table.columns.size() < kFewestColumnsOfMotion && !part && !may_tell_times(table, clouds_)) {
      small_[file.parent_path()].push_back(file);
      return;
    }
    for (const SampledColumn& column : table.columns) values_ += column.values.size();
    tables_.push_back({file, std::move(table)});
  }

  void tell_no_text(const fs::path& file, TextKind kind) {
    if (!is_called_table(file)) return;
    not_used_.push_back({file, kind == TextKind::Empty ? say::guess_file_empty() : say::guess_file_not_text()});
  }
  /// Prose is nothing that anybody would look for.
  void tell_no_table(const fs::path& file, std::string_view text) {
    if (!is_called_table(file)) return;
    const std::size_t rows = rows_of_numbers(text);
    const bool prose = rows == 0 && formats::lower_case(file.extension().string()) == ".txt";
    if (rows < kFewestRowsOfTable && !prose)
      not_used_.push_back({file, say::guess_too_few_rows(rows, kFewestRowsOfTable)});
  }

  /// Of texts alone: what else lies there, as pictures, is nothing that anybody would name.
  void tell_left(std::span<const fs::path> files) {
    std::vector<fs::path> texts;
    for (const fs::path& file : files) try {
        if (is_text(file)) texts.push_back(file);
      } catch (const Error& error) {
        not_used_.push_back({file, drive::message_of(error)});
      }
    if (!texts.empty()) not_used_.push_back({texts.front(), say::guess_not_looked_at(texts.size())});
  }

  void tell_small() {
    constexpr std::size_t kFew = 3;
    for (const auto& [folder, files] : small_) {
      if (files.size() > kFew) {
        not_used_.push_back({folder, say::guess_too_few_columns_in_many(files.size())});
        continue;
      }
      for (const fs::path& file : files) not_used_.push_back({file, say::guess_too_few_columns()});
    }
  }

  const std::vector<CloudFolder>& clouds_;
  std::vector<NotUsed>& not_used_;
  std::vector<FoundTable> tables_;
  std::map<fs::path, std::vector<fs::path>> small_;  ///< by their folders
  std::size_t values_ = 0;
};

}  // namespace

void put_rare_kinds_first(std::vector<fs::path>& files) {
  const auto kind = [](const fs::path& file) { return std::pair(file.parent_path(), file.extension()); };
  std::map<std::pair<fs::path, fs::path>, std::size_t> counts;
  for (const fs::path& file : files) ++counts[kind(file)];
  std::ranges::stable_sort(files, {}, [&](const fs::path& file) { return counts[kind(file)]; });
}

std::vector<FoundTable> find_tables(const std::vector<fs::path>& files, const std::vector<CloudFolder>& clouds,
                                    const Progress& progress, std::vector<NotUsed>& not_used) {
  return TablesFound(clouds, not_used).of(files, progress);
}

}  // namespace remount::guesses
