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

namespace remount::guesses {

namespace fs = std::filesystem;

namespace {

bool is_text(const fs::path& file) {
  constexpr std::size_t kHead = 4096;
  const std::string head = formats::read_text_head(file, kHead);
  return !head.empty() && head.find('\0') == std::string::npos;
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
        if (!is_text(files[i])) continue;
        if (auto table = sample_table(files[i], formats::read_text_file(files[i]))) add(files[i], std::move(*table));
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
    if (table.columns.size() < kFewestColumnsOfMotion && !may_tell_times(table, clouds_)) {
      small_[file.parent_path()].push_back(file);
      return;
    }
    for (const SampledColumn& column : table.columns) values_ += column.values.size();
    tables_.push_back({file, std::move(table)});
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
