#include "model/formats/clouds/scan_list.h"

#include "messages/general.h"
#include "messages/sessions.h"
#include "model/drive/bad_items.h"
#include "model/formats/files/csv_table.h"
#include "model/formats/files/cut_line.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/time_stamp.h"

namespace remount::formats {

namespace fs = std::filesystem;

namespace {

/// "1317384506400000000" (ns), "1317384506.4" (s) or a date.
std::optional<std::int64_t> stamp_from_name(std::string_view stem) {
  if (stem.find('.') == std::string_view::npos && stem.size() > 15) return parse_integer(stem);
  if (const auto date = parse_date_ns(stem)) return date;
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
      return extension == ".las";
    case CloudFormat::Text:
      return is_text_cloud_name(file);
    default:
      return extension == ".bin";
  }
}

}  // namespace

std::vector<drive::ScanFile> scans_from_names(const std::vector<fs::path>& files, const fs::path& directory,
                                              CloudFormat format, std::vector<drive::Finding>& findings) {
  std::vector<drive::ScanFile> scans;
  drive::BadItems bad;
  for (const fs::path& file : files) {
    if (!has_extension(file, format)) continue;
    if (const auto stamp = stamp_from_name(file.stem().string()))
      scans.push_back({file, *stamp});
    else
      bad.add(say::of_file(file.string(), say::scans_name_no_stamp()));
  }
  bad.report(findings, "bad-scan-names", directory.string(), say::left_out_files);
  std::stable_sort(scans.begin(), scans.end(),
                   [](const drive::ScanFile& a, const drive::ScanFile& b) { return a.stamp_ns < b.stamp_ns; });
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
