#include "model/guesses/scans_guess.h"

#include <algorithm>
#include <set>

#include "algorithms/core/error.h"
#include "algorithms/core/median.h"
#include "messages/guesses.h"
#include "model/formats/clouds/timed_scans.h"
#include "model/formats/files/text_file.h"
#include "model/guesses/time_guess.h"

namespace remount::guesses {

namespace fs = std::filesystem;

namespace {

using drive::ScanFile;
using formats::NameTimes;

constexpr std::int64_t kFirstDate_ns = 946'684'800LL * 1'000'000'000;   // 2000
constexpr std::int64_t kLastDate_ns = 4'102'444'800LL * 1'000'000'000;  // 2100

std::vector<std::int64_t> stamps_of(const std::vector<ScanFile>& scans) {
  std::vector<std::int64_t> stamps_ns;
  for (const ScanFile& scan : scans) stamps_ns.push_back(scan.stamp_ns);
  std::ranges::sort(stamps_ns);
  return stamps_ns;
}

double median_step_s(const std::vector<std::int64_t>& stamps_ns) {
  std::vector<std::int64_t> steps;
  for (std::size_t i = 1; i < stamps_ns.size(); ++i) steps.push_back(stamps_ns[i] - stamps_ns[i - 1]);
  return steps.empty() ? 0.0 : 1e-9 * static_cast<double>(median_of(std::move(steps)));
}

bool are_dates(const std::vector<std::int64_t>& stamps_ns) {
  return !stamps_ns.empty() && stamps_ns.front() > kFirstDate_ns && stamps_ns.back() < kLastDate_ns;
}

/// Scans that follow each other as a LiDAR's do.
bool have_steps_of_scans(const std::vector<std::int64_t>& stamps_ns) {
  constexpr double kShortest_s = 0.002, kLongest_s = 60.0;
  const double step_s = median_step_s(stamps_ns);
  return stamps_ns.size() < 2 || (step_s > kShortest_s && step_s < kLongest_s);
}

/// Names that count the files.
bool are_numbers(const std::vector<fs::path>& in_order) {
  constexpr std::int64_t kLargestNumber = 100'000'000;  // seconds since 1973 go up by one as well
  std::optional<std::int64_t> before;
  std::size_t by_one = 0;
  for (const fs::path& file : in_order) {
    const auto number = formats::time_in_name_ns(file.stem().string(), 1);
    if (!number || *number > kLargestNumber) return false;
    by_one += before && *number - *before == 1;
    before = number;
  }
  return in_order.size() > 1 && 10 * by_one >= 8 * (in_order.size() - 1);
}

Guess stamps_guess(std::vector<Message> evidence, Sureness sureness) {
  return {GuessKind::Stamps, {}, "", sureness, std::move(evidence), {}};
}

/// As a session that has no manifest names them: the whole name a time.
bool take_names(const CloudFolder& folder, const std::vector<fs::path>& in_order, ScansGuess& scans) {
  std::vector<drive::Finding> findings;
  if (are_numbers(in_order)) return false;
  const auto as_they_are =
      stamps_of(formats::scans_from_names(folder.files, folder.directory, folder.format, findings));
  if (as_they_are.size() == in_order.size() && have_steps_of_scans(as_they_are)) {
    scans.stamps_ns = as_they_are;
    scans.guesses.push_back(
        stamps_guess({say::guess_stamps_names()}, are_dates(as_they_are) ? Sureness::Checked : Sureness::Likely));
    return scans.timed = true;
  }
  for (const auto& [unit_ns, unit] : {std::pair(std::int64_t{1}, "ns"),
                                      {std::int64_t{1'000}, "us"},
                                      {std::int64_t{1'000'000}, "ms"},
                                      {std::int64_t{1'000'000'000}, "s"}}) {
    const NameTimes times{unit_ns, formats::TimeScale::Unix, 0};
    findings.clear();
    const auto stamps_ns =
        stamps_of(formats::scans_from_names(folder.files, folder.directory, folder.format, times, findings));
    if (stamps_ns.size() != in_order.size() || !are_dates(stamps_ns) || !have_steps_of_scans(stamps_ns)) continue;
    scans.in_names = times;
    scans.stamps_ns = stamps_ns;
    Guess guess = stamps_guess({say::guess_stamps_in_names(unit)}, Sureness::Checked);
    guess.unit = unit;
    scans.guesses.push_back(std::move(guess));
    return scans.timed = true;
  }
  return false;
}

/// A table with the columns `file` and `stamp_ns`, of files that are in the folder.
bool take_native_table(const CloudFolder& folder, const FoundTable& found, ScansGuess& scans) {
  const auto has = [&](std::string_view name) {
    return std::ranges::any_of(found.table.columns, [&](const SampledColumn& one) { return one.title == name; });
  };
  if (found.table.text.separator != ',' || found.table.text.skip_lines != 0 || !has("file") || !has("stamp_ns"))
    return false;
  std::vector<drive::Finding> findings;
  const auto stamps_ns =
      stamps_of(formats::scans_from_table(formats::read_text_file(found.file), found.file, folder.directory, findings));
  if (2 * stamps_ns.size() < folder.files.size()) return false;
  scans.stamps = found.file;
  scans.stamps_ns = stamps_ns;
  scans.guesses.push_back(
      stamps_guess({say::guess_stamps_table(found.file.filename().string(), stamps_ns.size(), folder.files.size())},
                   Sureness::Checked));
  return scans.timed = true;
}

/// The column that names files of the folder.
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
  ChosenTime time;
  double rank = 0.0;
};

/// How well a table tells when the scans were taken; nothing where it does not.
std::optional<TableOfTimes> times_in(const CloudFolder& folder, const FoundTable& found) {
  const std::optional<std::size_t> scan = scan_column(folder, found.table);
  if (!scan && found.table.rows != folder.files.size()) return std::nullopt;
  ColumnNames names = names_of(found.table);
  auto time = choose_time(found.table, names, {});
  if (!time || time->reading.week_open()) return std::nullopt;
  TableOfTimes out{&found, scan, std::move(*time), 0.0};
  out.rank = (scan ? 10.0 : 0.0) + (found.file.parent_path() == folder.directory ? 2.0 : 0.0) +
             (found.file.parent_path() == folder.directory.parent_path() ? 1.0 : 0.0) -
             0.05 * static_cast<double>(std::min<std::size_t>(found.table.columns.size(), 20));
  return out;
}

bool take_table(const CloudFolder& folder, const std::vector<FoundTable>& tables, ScansGuess& scans) {
  std::optional<TableOfTimes> best;
  for (const FoundTable& found : tables)
    if (auto one = times_in(folder, found); one && (!best || one->rank > best->rank)) best = std::move(one);
  if (!best) return false;
  formats::ScanTimes times{best->found->file, best->found->table.text, best->time.reading.columns, {}};
  if (best->scan) times.scan = best->found->table.ref(*best->scan);
  std::vector<drive::Finding> findings;
  try {
    scans.stamps_ns = stamps_of(formats::scans_from_times(formats::read_text_file(times.table), times, folder.files,
                                                          folder.directory, folder.format, findings));
  } catch (const Error&) {
    return false;
  }
  if (scans.stamps_ns.empty()) return false;
  scans.table = std::move(times);
  Guess guess = best->time.guess;
  guess.kind = GuessKind::Stamps;
  if (guess.sureness == Sureness::Named && best->scan) guess.sureness = Sureness::Checked;
  guess.evidence.insert(
      guess.evidence.begin(),
      best->scan
          ? say::guess_stamps_table(best->found->file.filename().string(), scans.stamps_ns.size(), folder.files.size())
          : say::guess_stamps_by_rows(best->found->file.filename().string(), scans.stamps_ns.size()));
  scans.guesses.push_back(std::move(guess));
  return scans.timed = true;
}

void guess_timing(const CloudFolder& folder, const std::vector<fs::path>& in_order, ScansGuess& scans) {
  std::vector<ScanFile> first;
  for (std::size_t i = 0; i < std::min<std::size_t>(in_order.size(), 3); ++i)
    first.push_back({in_order[i], i < scans.stamps_ns.size() ? scans.stamps_ns[i] : 0});
  if (first.empty()) return;
  const formats::FoundPointTimes found = formats::find_point_times(formats::FileScanSource(first, folder.format));
  scans.per_point = found.usable && !found.misfit;
  Guess guess{GuessKind::Timing, {}, "", scans.per_point ? Sureness::Checked : Sureness::Open, {}, {}};
  guess.evidence.push_back(scans.per_point ? say::guess_points_have_times() : say::guess_points_have_no_times());
  if (!scans.per_point)
    for (const char* timing : {"timing: instant", "timing: sweep"})
      guess.alternatives.push_back(Message::verbatim(timing));
  scans.guesses.push_back(std::move(guess));
}

std::string_view type_of(formats::CloudFormat format) {
  switch (format) {
    case formats::CloudFormat::Ply:
      return "ply";
    case formats::CloudFormat::Las:
      return "las";
    case formats::CloudFormat::Text:
      return "text";
    case formats::CloudFormat::KittiBin:
      return "kitti-bin";
    default:
      return "pcd";
  }
}

}  // namespace

std::string type_name(formats::CloudFormat format) { return std::string(type_of(format)); }

ScansGuess guess_scans(const CloudFolder& folder, const std::vector<FoundTable>& tables) {
  ScansGuess scans;
  scans.directory = folder.directory;
  scans.format = folder.format;
  scans.count = folder.files.size();
  scans.name = folder.directory.filename().string();
  const auto read = formats::read_cloud_file(folder.files.front(), 0, folder.format, formats::PointTimes::Unused);
  scans.guesses.push_back({GuessKind::Scans,
                           {},
                           "",
                           Sureness::Checked,
                           {say::guess_scans_read(folder.files.size(), folder.files.front().filename().string(),
                                                  read.cloud.size(), read.columns_words())},
                           {}});
  const std::vector<fs::path> in_order = formats::scans_in_order(folder.files, folder.format);
  const bool native =
      std::ranges::any_of(tables, [&](const FoundTable& found) { return take_native_table(folder, found, scans); });
  if (!native && !take_names(folder, in_order, scans)) (void)take_table(folder, tables, scans);
  guess_timing(folder, in_order, scans);
  return scans;
}

}  // namespace remount::guesses
