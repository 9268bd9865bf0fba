#include "model/formats/clouds/scan_list.h"

#include <algorithm>
#include <atomic>
#include <map>
#include <utility>

#include "algorithms/core/error.h"
#include "algorithms/core/parallel.h"
#include "messages/general.h"
#include "messages/sessions.h"
#include "messages/stages.h"
#include "model/drive/bad_items.h"
#include "model/formats/files/csv_table.h"
#include "model/formats/files/cut_line.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/time_stamp.h"

namespace remount::formats {

namespace fs = std::filesystem;

namespace {

std::optional<std::int64_t> date_from_name(std::string_view stem) {
  const auto whole = parse_date_ns(stem);
  return whole ? whole : date_in_name_ns(stem);
}

/// "1317384506400000000" (ns), "1317384506.4" (s) or a date.
std::optional<std::int64_t> stamp_from_name(std::string_view stem) {
  if (const auto date = date_from_name(stem)) return date;
  if (stem.find('.') == std::string_view::npos && stem.size() > 15) return parse_integer(stem);
  return parse_seconds_ns(stem);
}

bool has_extension(const fs::path& file, CloudFormat format) {
  const std::string extension = lower_case(file.extension().string());
  switch (format) {
    case CloudFormat::Pcd:
      return extension == ".pcd";
    case CloudFormat::Ply:
      return extension == ".ply";
    case CloudFormat::Las:
      return extension == ".las" || extension == ".laz";
    case CloudFormat::Text:
      return is_text_cloud_name(file);
    default:
      return extension == ".bin";
  }
}

}  // namespace

namespace {

template <class StampOf>
std::vector<drive::ScanFile> stamped_by_name(const std::vector<fs::path>& files, const fs::path& directory,
                                             CloudFormat format, std::vector<drive::Finding>& findings,
                                             StampOf&& stamp_of) {
  std::vector<drive::ScanFile> scans;
  drive::BadItems bad;
  for (const fs::path& file : files) {
    if (!has_extension(file, format)) continue;
    if (const std::optional<std::int64_t> stamp = stamp_of(file.stem().string()); stamp && is_stamp(*stamp))
      scans.push_back({file, *stamp});
    else
      bad.add(say::of_file(file.string(), say::scans_name_no_stamp()));
  }
  bad.report(findings, "bad-scan-names", directory.string(), say::left_out_files);
  std::stable_sort(scans.begin(), scans.end(),
                   [](const drive::ScanFile& a, const drive::ScanFile& b) { return a.stamp_ns < b.stamp_ns; });
  return scans;
}

/// The last number of a name, without zeros before it: longer ones are larger.
std::string_view last_number(std::string_view stem) {
  constexpr std::string_view kDigits = "0123456789";
  const std::size_t end = stem.find_last_of(kDigits);
  if (end == std::string_view::npos) return {};
  const std::size_t before = stem.find_last_not_of(kDigits, end);
  std::string_view number = stem.substr(before + 1, end - before);
  number.remove_prefix(std::min(number.find_first_not_of('0'), number.size()));
  return number;
}

}  // namespace

std::vector<drive::ScanFile> scans_from_names(const std::vector<fs::path>& files, const fs::path& directory,
                                              CloudFormat format, std::vector<drive::Finding>& findings) {
  return stamped_by_name(files, directory, format, findings,
                         [](const std::string& stem) { return stamp_from_name(stem); });
}

std::vector<drive::ScanFile> scans_from_names(const std::vector<fs::path>& files, const fs::path& directory,
                                              CloudFormat format, const NameTimes& times,
                                              std::vector<drive::Finding>& findings) {
  return stamped_by_name(files, directory, format, findings, [&](const std::string& stem) {
    const bool dates = times.unit_ns == 0;
    const std::optional<std::int64_t> its_ns = dates ? date_from_name(stem) : time_in_name_ns(stem, times.unit_ns);
    if (!its_ns || !is_stamp(*its_ns)) return std::optional<std::int64_t>();
    const bool gps = times.scale == TimeScale::Gps;
    return moved_ns(gps ? unix_ns_from_gps_ns(*its_ns - (dates ? kGpsEpoch_ns : 0)) : *its_ns, times.offset_ns);
  });
}

namespace {

/// Of one file: when its first point was taken, or why that is not known.
struct FirstPoint {
  std::optional<std::int64_t> stamp_ns;
  std::optional<Error> problem;
};

FirstPoint first_point_of(const fs::path& file, CloudFormat format) {
  try {
    const ReadCloud read = read_cloud_file(file, 0, format);
    if (read.first_point_ns) return {read.first_point_ns, std::nullopt};
    return {std::nullopt, Error(ErrorCode::Format, file.string(), say::scans_points_no_date(read.columns_words()))};
  } catch (const Error& error) {
    return {std::nullopt, error};
  }
}

}  // namespace

std::vector<drive::ScanFile> scans_from_points(const std::vector<fs::path>& files, const fs::path& directory,
                                               CloudFormat format, std::vector<drive::Finding>& findings,
                                               Progress& progress) {
  const std::vector<fs::path> in_order = scans_in_order(files, format);
  std::vector<FirstPoint> first(in_order.size());
  std::atomic<std::size_t> done{0};
  parallel_for(in_order.size(), 0, [&](std::size_t i) {
    if (progress.cancelled()) return;
    first[i] = first_point_of(in_order[i], format);
    progress.report(say::stage_reading_point_times, ++done, in_order.size());
  });
  std::vector<drive::ScanFile> scans;
  if (progress.cancelled()) return scans;
  drive::BadItems bad;
  for (std::size_t i = 0; i < in_order.size(); ++i)
    if (first[i].stamp_ns)
      scans.push_back({in_order[i], *first[i].stamp_ns});
    else
      bad.add(*first[i].problem);
  if (scans.empty() && !in_order.empty()) throw *first.front().problem;
  bad.report(findings, "missing-scans", directory.string(), say::left_out_scans);
  std::stable_sort(scans.begin(), scans.end(),
                   [](const drive::ScanFile& a, const drive::ScanFile& b) { return a.stamp_ns < b.stamp_ns; });
  return scans;
}

std::vector<fs::path> scans_in_order(const std::vector<fs::path>& files, CloudFormat format) {
  std::vector<fs::path> scans;
  for (const fs::path& file : files)
    if (has_extension(file, format)) scans.push_back(file);
  std::stable_sort(scans.begin(), scans.end(), [](const fs::path& a, const fs::path& b) {
    const std::string stem_a = a.stem().string(), stem_b = b.stem().string();
    const std::string_view number_a = last_number(stem_a), number_b = last_number(stem_b);
    return std::pair(number_a.size(), number_a) < std::pair(number_b.size(), number_b);
  });
  return scans;
}

std::vector<drive::ScanFile> scans_from_times(std::string_view text, const ScanTimes& times,
                                              const std::vector<fs::path>& files, const fs::path& directory,
                                              CloudFormat format, std::vector<drive::Finding>& findings) {
  text = without_cut_line(text, times.table.string(), findings);
  std::vector<ColumnRef> columns = columns_of(times.time);
  if (times.scan) columns.push_back(*times.scan);
  std::string memory;
  DeclaredRows rows(times.table, times.text, times.time, columns, with_points(text, times.text, memory));
  const std::vector<fs::path> in_order = scans_in_order(files, format);
  std::map<std::string, fs::path> by_name;
  for (const fs::path& file : in_order) {
    by_name.emplace(file.filename().string(), file);
    by_name.emplace(file.stem().string(), file);
  }
  std::vector<drive::ScanFile> scans;
  std::size_t row = 0;
  drive::BadItems bad;
  while (rows.next()) {
    try {
      rows.part();
      const std::int64_t stamp_ns = rows.stamp_ns();
      const std::string name = times.scan ? fs::path(rows.field(*times.scan)).filename().string() : "";
      const auto named = by_name.find(name);
      if (!times.scan)
        scans.push_back({row < in_order.size() ? in_order[row] : fs::path(), stamp_ns});
      else if (named != by_name.end())
        scans.push_back({named->second, stamp_ns});
      else
        bad.add(say::of_file((directory / name).string(), say::scans_not_regular()));
      ++row;
    } catch (const Error& error) {
      if (rows.may_be_header()) continue;
      ++row;  // of a scan all the same
      bad.add(error);
    }
  }
  if (!times.scan && row != in_order.size())
    throw Error(ErrorCode::Format, times.table.string(),
                say::native_stamp_count(row, in_order.size(), directory.string()));
  // Names may stand in any order.
  if (times.scan)
    std::stable_sort(scans.begin(), scans.end(),
                     [](const drive::ScanFile& a, const drive::ScanFile& b) { return a.stamp_ns < b.stamp_ns; });
  bad.report(findings, "missing-scans", times.table.string(), say::left_out_scans);
  return scans;
}

std::vector<drive::ScanFile> scans_from_table(std::string_view text, const fs::path& table, const fs::path& directory,
                                              std::vector<drive::Finding>& findings) {
  text = without_cut_line(text, table.string(), findings);
  LineReader lines(text);
  std::string_view line;
  lines.next(line);
  const CsvHeader header(line);
  const std::size_t file_column = header.require("file", table), stamp_column = header.require("stamp_ns", table);
  std::vector<drive::ScanFile> scans;
  drive::BadItems bad;
  std::vector<std::string_view> fields;
  while (lines.next(line)) {
    if (trim(line).empty()) continue;
    split_csv(line, fields);
    const auto stamp = fields.size() == header.size() ? parse_integer(fields[stamp_column]) : std::nullopt;
    const fs::path file = stamp ? directory / std::string(fields[file_column]) : fs::path();
    if (!stamp)
      bad.add(say::of_file(at_line(table, lines.line_number()), say::scans_table_line()));
    else if (!is_file(file))
      bad.add(say::of_file(file.string(), say::scans_not_regular()));
    else
      scans.push_back({file, *stamp});
  }
  bad.report(findings, "missing-scans", table.string(), say::left_out_scans);
  return scans;
}

}  // namespace remount::formats
