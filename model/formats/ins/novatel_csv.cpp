#include "model/formats/ins/novatel_csv.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "algorithms/core/index.h"
#include "algorithms/core/median.h"
#include "messages/files.h"
#include "messages/ins_logs.h"
#include "messages/sessions.h"
#include "model/drive/bad_items.h"
#include "model/formats/files/csv_table.h"
#include "model/formats/files/cut_line.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/text_file.h"
#include "model/formats/files/time_stamp.h"

namespace remount::formats {

namespace fs = std::filesystem;

namespace {

/// A value of INSPVAX, and the name of its column.
struct CsvValue {
  double NovatelValues::*value;
  const char* column;
};
constexpr std::array<CsvValue, 13> kCsvValues{{{&NovatelValues::latitude_deg, "latitude"},
                                               {&NovatelValues::longitude_deg, "longitude"},
                                               {&NovatelValues::height_m, "altitude"},
                                               {&NovatelValues::undulation_m, "undulation"},
                                               {&NovatelValues::roll_deg, "roll"},
                                               {&NovatelValues::pitch_deg, "pitch"},
                                               {&NovatelValues::azimuth_deg, "azimuth"},
                                               {&NovatelValues::latitude_std_m, "latitude_std"},
                                               {&NovatelValues::longitude_std_m, "longitude_std"},
                                               {&NovatelValues::height_std_m, "altitude_std"},
                                               {&NovatelValues::roll_std_deg, "roll_std"},
                                               {&NovatelValues::pitch_std_deg, "pitch_std"},
                                               {&NovatelValues::azimuth_std_deg, "azimuth_std"}}};

/// Where the status and the values stand among the fields of a line.
struct Columns {
  std::size_t status = 0;
  std::array<std::size_t, kCsvValues.size()> values{};
};

Columns csv_columns(const CsvHeader& header, const fs::path& path) {
  Columns columns{header.require("ins_status", path)};
  for (std::size_t i = 0; i < kCsvValues.size(); ++i) columns.values[i] = header.require(kCsvValues[i].column, path);
  return columns;
}

motion::InsSample sample_from(const std::vector<std::string_view>& fields, const Columns& columns, const fs::path& path,
                              std::size_t line) {
  NovatelValues values;
  values.quality = novatel_quality(fields[columns.status]);
  for (std::size_t i = 0; i < kCsvValues.size(); ++i)
    values.*kCsvValues[i].value = require_number(fields[columns.values[i]], kCsvValues[i].column, path, line);
  return ins_sample(values, at_line(path, line));
}

std::int64_t gps_stamp(std::string_view week_text, std::string_view time_text, std::int64_t unit_ns,
                       const fs::path& path, std::size_t line) {
  const auto week = parse_integer(week_text);
  const auto whole = parse_integer(time_text);
  std::optional<std::int64_t> time_ns;
  if (whole && *whole >= 0 && *whole <= 604'800'000)
    time_ns = *whole * unit_ns;
  else if (unit_ns == 1'000'000'000)
    time_ns = parse_seconds_ns(time_text);
  else if (const auto value = parse_number(time_text); value && *value >= 0.0 && *value <= 604'800'000.0)
    time_ns = std::llround(*value * static_cast<double>(unit_ns));
  const auto stamp = week && time_ns ? unix_ns_from_gps_week(*week, *time_ns) : std::nullopt;
  if (stamp) return *stamp;
  throw Error(ErrorCode::Format, at_line(path, line),
              say::inspvax_no_gps_time(std::string(week_text.substr(0, 20)), std::string(time_text.substr(0, 20))));
}

/// The column of the time of week is called seconds and holds milliseconds in some drivers: its steps tell. At 4 units
/// a step, seconds would mean a sample every four seconds, which no INS log has. No week has more than 604800 seconds.
std::int64_t time_unit_ns(std::string_view text, std::size_t column) {
  LineReader lines(text);
  std::string_view line;
  lines.next(line);
  std::vector<std::string_view> fields;
  std::vector<double> steps, values;
  double before = std::nan("");
  while (steps.size() < 200 && lines.next(line)) {
    split_csv(line, fields);
    const auto value = column < fields.size() ? parse_number(fields[column]) : std::nullopt;
    if (!value) continue;
    if (*value > before) steps.push_back(*value - before);
    before = *value;
    if (values.size() < 200) values.push_back(*value);
  }
  const bool beyond_a_week = !values.empty() && median_of(std::move(values)) > 604'800.0;
  const bool long_steps = !steps.empty() && median_of(std::move(steps)) >= 4.0;
  return beyond_a_week || long_steps ? 1'000'000 : 1'000'000'000;
}

/// What the host's clock is off against GPS time, for the engineer; nothing is computed from it.
void report_host_clock(const std::vector<double>& offsets_s, double distinct, const fs::path& path,
                       std::vector<drive::Finding>& findings) {
  if (offsets_s.empty()) return;
  if (distinct < 0.5) {
    findings.push_back(drive::make_finding(drive::Severity::Warning, "host-stamps-rounded", path.string(),
                                           say::inspvax_stamps_rounded()));
    return;
  }
  findings.push_back(drive::make_finding(drive::Severity::Note, "host-clock", path.string(),
                                         say::inspvax_host_clock(Duration{median_of(offsets_s)})));
}

void read_csv(std::string_view text, const fs::path& path, NovatelLog& log, drive::BadItems& bad,
              std::vector<drive::Finding>& findings) {
  text = without_cut_line(text, path.string(), findings);
  LineReader lines(text);
  std::string_view line;
  if (!lines.next(line)) throw Error(ErrorCode::Format, path.string(), say::file_empty());
  const CsvHeader header(line);
  const Columns columns = csv_columns(header, path);
  const std::size_t week = header.require("header.gps_week", path);
  const bool named_milliseconds = header.has("header.gps_week_milliseconds");
  const std::size_t time =
      header.require(named_milliseconds ? "header.gps_week_milliseconds" : "header.gps_week_seconds", path);
  const std::int64_t unit_ns = named_milliseconds ? 1'000'000 : time_unit_ns(text, time);
  const int host = header.find("time");
  std::vector<std::string_view> fields;
  std::vector<double> host_offsets_s;
  std::string last_host;
  std::size_t distinct = 0, misnamed = 0;
  while (lines.next(line)) {
    if (trim(line).empty()) continue;
    try {
      split_csv(line, fields);
      if (fields.size() != header.size())
        throw Error(ErrorCode::Format, at_line(path, lines.line_number()),
                    say::csv_fields(fields.size(), header.size()));
      motion::InsSample sample = sample_from(fields, columns, path, lines.line_number());
      misnamed += is_of_wrong_table(fields[columns.status]);
      sample.stamp_ns = gps_stamp(fields[week], fields[time], unit_ns, path, lines.line_number());
      log.ins.push_back(sample);
      const auto host_ns = host >= 0 ? parse_number(fields[index_at(host)]) : std::nullopt;
      if (!host_ns) continue;
      host_offsets_s.push_back((*host_ns - static_cast<double>(sample.stamp_ns)) * 1e-9);
      if (fields[index_at(host)] != last_host) ++distinct, last_host = fields[index_at(host)];
    } catch (const Error& error) {
      bad.add(error);
    }
  }
  log.distinct_host_times =
      static_cast<double>(distinct) / static_cast<double>(std::max<std::size_t>(log.ins.size(), 1));
  report_misnamed(misnamed, path.string(), findings);
  report_host_clock(host_offsets_s, log.distinct_host_times, path, findings);
}

}  // namespace

bool is_inspvax_csv(std::string_view head) {
  LineReader lines(head);
  std::string_view line;
  if (!lines.next(line) || line.find("gps_week") == std::string_view::npos) return false;
  const CsvHeader header(line);
  return header.has("header.gps_week") && header.has("azimuth") && header.has("undulation");
}

NovatelLog read_inspvax_csv(const fs::path& path) {
  NovatelLog log;
  log.path = path;
  log.taken = "INSPVAX";
  log.states_errors = true;
  drive::BadItems bad;
  read_csv(read_text_file(path), path, log, bad, log.findings);
  if (log.ins.empty()) throw Error(ErrorCode::Format, path.string(), bad.after(say::inspvax_none_usable()));
  bad.report(log.findings, "bad-ins", path.string(), say::left_out_lines);
  return log;
}

}  // namespace remount::formats
