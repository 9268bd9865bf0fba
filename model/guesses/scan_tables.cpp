#include "model/guesses/scan_tables.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "algorithms/core/error.h"
#include "messages/guesses.h"
#include "model/formats/clouds/timed_scans.h"
#include "model/formats/files/text_file.h"
#include "model/guesses/time_guess.h"

namespace remount::guesses {

namespace fs = std::filesystem;

namespace {

using drive::ScanFile;

Guess guess_of_table(std::vector<Message> evidence) {
  return {GuessKind::Stamps, {}, "", Sureness::Checked, std::move(evidence), {}};
}

bool take_as_native(const CloudFolder& folder, const FoundTable& found, ScansGuess& scans) {
  const auto has = [&](std::string_view name) {
    return std::ranges::any_of(found.table.columns, [&](const SampledColumn& one) { return one.title == name; });
  };
  if (found.table.text.separator != ',' || found.table.text.skip_lines != 0 || !has("file") || !has("stamp_ns"))
    return false;
  std::vector<drive::Finding> findings;
  const auto stamps_ns = ascending_stamps(
      formats::scans_from_table(formats::read_text_file(found.file), found.file, folder.directory, findings));
  if (2 * stamps_ns.size() < folder.files.size()) return false;
  scans.stamps = found.file;
  scans.stamps_ns = stamps_ns;
  scans.guesses.push_back(
      guess_of_table({say::guess_stamps_table(found.file.filename().string(), stamps_ns.size(), folder.files.size())}));
  return scans.timed = true;
}

/// The column of which the first texts name files of the folder.
std::optional<std::size_t> scan_column(const CloudFolder& folder, const SampledTable& table) {
  std::set<std::string> names;
  for (const fs::path& file : folder.files) names.insert(file.filename().string()), names.insert(file.stem().string());
  const std::size_t several = std::min<std::size_t>(folder.files.size(), 5);  // of one number all rows may speak
  for (const SampledColumn& column : table.columns)
    if (column.texts.size() >= several && std::ranges::all_of(column.texts, [&](const std::string& text) {
          return names.contains(fs::path(text).filename().string());
        }))
      return column.index;
  return std::nullopt;
}

struct TableOfTimes {
  const FoundTable* found = nullptr;
  std::optional<std::size_t> scan;
  bool named = false;  ///< the column of scans holds more than numbers of rows
  ChosenTime time;
  double rank = 0.0;
};

/// In which ways a table may tell when the scans were taken: by a column that names them, or row by row.
void add_times_in(const CloudFolder& folder, const FoundTable& found, std::vector<TableOfTimes>& ways) {
  const std::optional<std::size_t> scan = scan_column(folder, found.table);
  const bool by_rows = found.table.rows == folder.files.size();
  if (!scan && !by_rows) return;
  const ColumnNames names = names_of(found.table);
  const auto time = choose_time(found.table, names, {});
  if (!time || time->reading.week_open()) return;
  const bool named =
      scan && (!found.table.columns[*scan].whole || (names[*scan] && names[*scan]->quantity == Quantity::Scan));
  const double rank = (found.file.parent_path() == folder.directory ? 2.0 : 0.0) +
                      (found.file.parent_path() == folder.directory.parent_path() ? 1.0 : 0.0) -
                      0.05 * static_cast<double>(std::min<std::size_t>(found.table.columns.size(), 20));
  if (scan) ways.push_back({&found, scan, named, *time, rank + (named ? 10.0 : 0.0)});
  if (by_rows) ways.push_back({&found, std::nullopt, false, *time, rank});
}

/// Whether nearly all rows name a scan, each another one: what counts rows, or satellites, does not.
bool names_scans(const std::vector<ScanFile>& stamped, const SampledTable& table) {
  constexpr double kNearlyAllRows = 0.95;
  std::set<fs::path> different;
  for (const ScanFile& scan : stamped) different.insert(scan.path);
  return different.size() == stamped.size() &&
         static_cast<double>(stamped.size()) >= kNearlyAllRows * static_cast<double>(table.rows);
}

bool take_way(const CloudFolder& folder, const TableOfTimes& way, ScansGuess& scans) {
  const FoundTable& found = *way.found;
  formats::ScanTimes times{found.file, found.table.text, way.time.reading.columns, {}};
  if (way.scan) times.scan = found.table.ref(*way.scan);
  std::vector<drive::Finding> findings;
  std::vector<ScanFile> stamped;
  try {
    stamped = formats::scans_from_times(formats::read_text_file(times.table), times, folder.files, folder.directory,
                                        folder.format, findings);
  } catch (const Error&) {
    return false;
  }
  if (stamped.empty() || (way.scan && !names_scans(stamped, found.table))) return false;
  scans.stamps_ns = ascending_stamps(stamped);
  scans.table = std::move(times);
  Guess guess = way.time.guess;
  guess.kind = GuessKind::Stamps;
  if (guess.sureness == Sureness::Named && way.named) guess.sureness = Sureness::Checked;
  guess.evidence.insert(
      guess.evidence.begin(),
      way.scan ? say::guess_stamps_table(found.file.filename().string(), scans.stamps_ns.size(), folder.files.size())
               : say::guess_stamps_by_rows(found.file.filename().string(), scans.stamps_ns.size()));
  scans.guesses.push_back(std::move(guess));
  return scans.timed = true;
}

}  // namespace

std::vector<std::int64_t> ascending_stamps(const std::vector<ScanFile>& scans) {
  constexpr std::int64_t kLatest_ns = std::int64_t{4'100'000'000} * 1'000'000'000;  // 2099
  std::vector<std::int64_t> stamps_ns;
  for (const ScanFile& scan : scans)
    if (scan.stamp_ns > -kLatest_ns && scan.stamp_ns < kLatest_ns) stamps_ns.push_back(scan.stamp_ns);
  std::ranges::sort(stamps_ns);
  return stamps_ns;
}

bool take_native_table(const CloudFolder& folder, const std::vector<FoundTable>& tables, ScansGuess& scans) {
  return std::ranges::any_of(tables, [&](const FoundTable& found) { return take_as_native(folder, found, scans); });
}

bool take_table(const CloudFolder& folder, const std::vector<FoundTable>& tables, ScansGuess& scans) {
  std::vector<TableOfTimes> ways;
  for (const FoundTable& found : tables) add_times_in(folder, found, ways);
  std::ranges::stable_sort(ways, [](const TableOfTimes& a, const TableOfTimes& b) { return a.rank > b.rank; });
  return std::ranges::any_of(ways, [&](const TableOfTimes& way) { return take_way(folder, way, scans); });
}

}  // namespace remount::guesses
