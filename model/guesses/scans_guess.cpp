#include "model/guesses/scans_guess.h"

#include <algorithm>

#include "algorithms/core/error.h"
#include "algorithms/core/median.h"
#include "algorithms/core/stamps.h"
#include "messages/guesses.h"
#include "model/formats/clouds/timed_scans.h"
#include "model/formats/files/time_unit.h"
#include "model/guesses/scan_tables.h"

namespace remount::guesses {

namespace fs = std::filesystem;

namespace {

using drive::ScanFile;
using formats::NameTimes;

constexpr std::int64_t kFirstDate_ns = 946'684'800LL * 1'000'000'000;   // 2000
constexpr std::int64_t kLastDate_ns = 4'102'444'800LL * 1'000'000'000;  // 2100

bool are_dates(const std::vector<std::int64_t>& stamps_ns) {
  return !stamps_ns.empty() && stamps_ns.front() > kFirstDate_ns && stamps_ns.back() < kLastDate_ns;
}

constexpr double kLongestStepOfDates_s = 60.0;  ///< some of a recording may be kept alone
constexpr double kLongestStepOfNumbers_s = 5.5;

/// Scans that follow each other as a LiDAR's do.
bool have_steps_of_scans(const std::vector<std::int64_t>& stamps_ns, double longest_s) {
  constexpr double kShortest_s = 0.002;
  const double step_s = median_step_s(stamps_ns);
  return stamps_ns.size() < 2 || (step_s > kShortest_s && step_s < longest_s);
}

/// Names that count the files.
bool are_numbers(const std::vector<fs::path>& in_order) {
  constexpr std::int64_t kLargestNumber = 100'000'000;  // seconds since 1973 go up by one as well
  std::optional<std::int64_t> before;
  std::size_t by_one = 0;
  for (const fs::path& file : in_order) {
    const std::string stem = file.stem().string();
    const auto number = formats::time_in_name_ns(stem, 1);
    if (!number || stem.find('.') != std::string::npos || *number > kLargestNumber) return false;
    by_one += before && *number - *before == 1;
    before = number;
  }
  return in_order.size() > 1 && 10 * by_one >= 8 * (in_order.size() - 1);
}

Guess stamps_guess(std::vector<Message> evidence, Sureness sureness) {
  return {GuessKind::Stamps, {}, "", sureness, std::move(evidence), {}};
}

/// As a session that has no manifest names them: the whole name a time.
std::vector<std::int64_t> stamps_of_names(const CloudFolder& folder) {
  std::vector<drive::Finding> findings;
  return ascending_stamps(formats::scans_from_names(folder.files, folder.directory, folder.format, findings));
}

/// Numbers behind a date that would be seconds from midnight on: "20210101_000007" is the seventh of that day.
bool count_from_midnight(const std::vector<std::int64_t>& stamps_ns) {
  constexpr std::int64_t kOneSecond_ns = 1'000'000'000, kDay_ns = 86'400 * kOneSecond_ns;
  if (stamps_ns.size() < 2 || stamps_ns.front() % kDay_ns > 10 * kOneSecond_ns) return false;
  for (std::size_t i = 1; i < stamps_ns.size(); ++i)
    if (stamps_ns[i] - stamps_ns[i - 1] != kOneSecond_ns) return false;
  return stamps_ns.front() % kOneSecond_ns == 0;
}

/// Names that are dates, whole or in part.
bool take_dates(const CloudFolder& folder, const std::vector<fs::path>& in_order, ScansGuess& scans) {
  const auto fit = [&](const std::vector<std::int64_t>& stamps_ns) {
    return stamps_ns.size() == in_order.size() && are_dates(stamps_ns) && !count_from_midnight(stamps_ns) &&
           have_steps_of_scans(stamps_ns, kLongestStepOfDates_s);
  };
  scans.stamps_ns = stamps_of_names(folder);
  if (fit(scans.stamps_ns)) {
    scans.guesses.push_back(stamps_guess({say::guess_stamps_names()}, Sureness::Checked));
    return scans.timed = true;
  }
  std::vector<drive::Finding> findings;
  for (const std::int64_t unit_ns : {1, 1'000, 1'000'000, 1'000'000'000}) {
    const NameTimes times{unit_ns, formats::TimeScale::Unix, 0};
    scans.stamps_ns =
        ascending_stamps(formats::scans_from_names(folder.files, folder.directory, folder.format, times, findings));
    if (!fit(scans.stamps_ns)) continue;
    scans.in_names = times;
    const std::string unit(formats::time_unit_name(unit_ns));
    scans.guesses.push_back(stamps_guess({say::guess_stamps_in_names(unit)}, Sureness::Checked));
    scans.guesses.back().unit = unit;
    return scans.timed = true;
  }
  scans.stamps_ns.clear();
  return false;
}

bool have_dates_in_points(const fs::path& scan, formats::CloudFormat format) {
  try {
    return formats::read_cloud_file(scan, 0, format).first_point_ns.has_value();
  } catch (const Error&) {
    return false;  // what cannot be read is told where the scans are listed
  }
}

/// The dates of the points, where nothing else tells when the scans were taken.
bool take_points(const CloudFolder& folder, const std::vector<fs::path>& in_order, ScansGuess& scans,
                 Progress& progress) {
  if (!have_dates_in_points(folder.read.file, folder.format)) return false;
  std::vector<drive::Finding> findings;
  const std::vector<ScanFile> stamped =
      formats::scans_from_points(folder.files, folder.directory, folder.format, findings, progress);
  const std::vector<std::int64_t> stamps_ns = ascending_stamps(stamped);
  if (2 * stamps_ns.size() < in_order.size() || !have_steps_of_scans(stamps_ns, kLongestStepOfDates_s)) return false;
  scans.stamps_ns = stamps_ns;
  scans.in_points = true;
  scans.guesses.push_back(
      stamps_guess({say::guess_stamps_in_points(stamps_ns.size(), in_order.size())}, Sureness::Checked));
  return scans.timed = true;
}

/// Names that are numbers and no dates: seconds of a clock of its own, or numbers of scans of which some were left out.
bool take_numbers(const CloudFolder& folder, const std::vector<fs::path>& in_order, ScansGuess& scans) {
  if (are_numbers(in_order)) return false;
  const std::vector<std::int64_t> stamps_ns = stamps_of_names(folder);
  if (stamps_ns.size() != in_order.size() || !have_steps_of_scans(stamps_ns, kLongestStepOfNumbers_s)) return false;
  scans.stamps_ns = stamps_ns;
  Guess guess = stamps_guess({say::guess_stamps_names()}, Sureness::Open);
  guess.alternatives.push_back(say::guess_stamps_may_be_numbers());
  scans.guesses.push_back(std::move(guess));
  scans.by_numbers = true;
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

double median_step_s(const std::vector<std::int64_t>& stamps_ns) {
  std::vector<std::int64_t> steps;
  for (std::size_t i = 1; i < stamps_ns.size(); ++i) steps.push_back(stamps_ns[i] - stamps_ns[i - 1]);
  return steps.empty() ? 0.0 : seconds(median_of(std::move(steps)));
}

bool names_count(const CloudFolder& folder) {
  return are_numbers(formats::scans_in_order(folder.files, folder.format));
}

std::string type_name(formats::CloudFormat format) { return std::string(type_of(format)); }

ScansGuess guess_scans(const CloudFolder& folder, const std::vector<FoundTable>& tables, Progress& progress) {
  ScansGuess scans;
  scans.directory = folder.directory;
  scans.format = folder.format;
  scans.count = folder.files.size();
  scans.name = folder.directory.filename().string();
  scans.guesses.push_back({GuessKind::Scans,
                           {},
                           "",
                           Sureness::Checked,
                           {say::guess_scans_read(folder.files.size(), folder.read.file.filename().string(),
                                                  folder.read.points, folder.read.columns)},
                           {}});
  const std::vector<fs::path> in_order = formats::scans_in_order(folder.files, folder.format);
  // What is told by a table comes before numbers that may be times.
  (void)(take_native_table(folder, tables, scans) || take_dates(folder, in_order, scans) ||
         take_table(folder, tables, scans) || take_points(folder, in_order, scans, progress) ||
         take_numbers(folder, in_order, scans));
  guess_timing(folder, in_order, scans);
  return scans;
}

}  // namespace remount::guesses
