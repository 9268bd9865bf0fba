#include "model/io/inspvax_log.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "algorithms/core/median.h"
#include "model/io/attitude_convention.h"
#include "model/io/crc32.h"
#include "model/io/csv_table.h"
#include "model/io/input_file.h"
#include "model/io/stream_tools.h"
#include "model/io/time_stamp.h"

namespace remount {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kHeadBytes = std::size_t{1} << 20;

/// A value of INSPVAX, the name of its column in a CSV, and its place in the ASCII log after the ';'.
struct Value {
  double InspvaxValues::*value;
  const char* column;
  std::size_t ascii;
};
constexpr std::array<Value, 13> kValues{{{&InspvaxValues::latitude_deg, "latitude", 2},
                                         {&InspvaxValues::longitude_deg, "longitude", 3},
                                         {&InspvaxValues::height_m, "altitude", 4},
                                         {&InspvaxValues::undulation_m, "undulation", 5},
                                         {&InspvaxValues::roll_deg, "roll", 9},
                                         {&InspvaxValues::pitch_deg, "pitch", 10},
                                         {&InspvaxValues::azimuth_deg, "azimuth", 11},
                                         {&InspvaxValues::latitude_std_m, "latitude_std", 12},
                                         {&InspvaxValues::longitude_std_m, "longitude_std", 13},
                                         {&InspvaxValues::height_std_m, "altitude_std", 14},
                                         {&InspvaxValues::roll_std_deg, "roll_std", 18},
                                         {&InspvaxValues::pitch_std_deg, "pitch_std", 19},
                                         {&InspvaxValues::azimuth_std_deg, "azimuth_std", 20}}};
constexpr std::size_t kAsciiFields = 23;

/// Where the status and the values stand among the fields of a line.
struct Columns {
  std::size_t status = 0;
  std::array<std::size_t, kValues.size()> values{};
};

Columns ascii_columns() {
  Columns columns;
  for (std::size_t i = 0; i < kValues.size(); ++i) columns.values[i] = kValues[i].ascii;
  return columns;
}

Columns csv_columns(const CsvHeader& header, const fs::path& path) {
  Columns columns{header.require("ins_status", path)};
  for (std::size_t i = 0; i < kValues.size(); ++i) columns.values[i] = header.require(kValues[i].column, path);
  return columns;
}

InsSample sample_from(const std::vector<std::string_view>& fields, const Columns& columns, const fs::path& path,
                      std::size_t line) {
  InspvaxValues values;
  values.quality = inspvax_quality(fields[columns.status]);
  for (std::size_t i = 0; i < kValues.size(); ++i)
    values.*kValues[i].value = require_number(fields[columns.values[i]], kValues[i].column, path, line);
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
              "GPS week '" + std::string(week_text.substr(0, 20)) + "' and time '" +
                  std::string(time_text.substr(0, 20)) + "' are no GPS time");
}

InsSample parse_ascii(std::string_view line, std::size_t number, const fs::path& path,
                      std::vector<std::string_view>& fields) {
  const std::size_t star = line.rfind('*'), body = line.find(';');
  if (star == std::string_view::npos || body == std::string_view::npos || body > star)
    throw Error(ErrorCode::Format, at_line(path, number), "expected '#INSPVAXA,<header>;<data>*<crc>'");
  const std::string_view digits = trimmed(line.substr(star + 1)).substr(0, 8);
  std::uint32_t crc = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), crc, 16);
  if (error != std::errc() || digits.size() != 8 || end != digits.data() + 8 ||
      crc != novatel_crc32(line.substr(1, star - 1)))
    throw Error(ErrorCode::Format, at_line(path, number), "the checksum does not agree with the line");
  split_csv(line.substr(0, body), fields);
  if (fields.size() < 7) throw Error(ErrorCode::Format, at_line(path, number), "the header has too few fields");
  const std::int64_t stamp_ns = gps_stamp(fields[5], fields[6], 1'000'000'000, path, number);
  split_csv(line.substr(body + 1, star - body - 1), fields);
  if (fields.size() < kAsciiFields)
    throw Error(ErrorCode::Format, at_line(path, number),
                "has " + std::to_string(fields.size()) + " data fields, expected " + std::to_string(kAsciiFields));
  InsSample sample = sample_from(fields, ascii_columns(), path, number);
  sample.stamp_ns = stamp_ns;
  return sample;
}

void read_ascii(const std::string& text, const fs::path& path, InspvaxLog& log, BadItems& bad) {
  LineReader lines(text);
  std::vector<std::string_view> fields;
  for (std::string_view line; lines.next(line);) {
    if (!line.starts_with("#INSPVAXA,")) continue;  // other logs of the same receiver
    try {
      log.ins.push_back(parse_ascii(line, lines.line_number(), path, fields));
    } catch (const Error& error) {
      bad.add(error);
    }
  }
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
void report_host_clock(std::vector<double>& offsets_s, double distinct, const fs::path& path,
                       std::vector<Finding>& findings) {
  if (offsets_s.empty()) return;
  if (distinct < 0.5) {
    findings.push_back(
        make_finding(Severity::Warning, "host-stamps-rounded", path.string(),
                     "The column 'time' was rounded, as a spreadsheet does; GPS time is used, nothing is lost."));
    return;
  }
  const auto middle = offsets_s.begin() + static_cast<std::ptrdiff_t>(offsets_s.size() / 2);
  std::nth_element(offsets_s.begin(), middle, offsets_s.end());
  char text[160];
  std::snprintf(text, sizeof text,
                "The column 'time' (clock of the host, or of a replay) is %.3f s off UTC by GPS; GPS time is used.",
                *middle);
  findings.push_back(make_finding(Severity::Note, "host-clock", path.string(), text));
}

void read_csv(std::string_view text, const fs::path& path, InspvaxLog& log, BadItems& bad,
              std::vector<Finding>& findings) {
  text = without_cut_line(text, path.string(), findings);
  LineReader lines(text);
  std::string_view line;
  if (!lines.next(line)) throw Error(ErrorCode::Format, path.string(), "is empty");
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
  std::size_t distinct = 0;
  while (lines.next(line)) {
    if (trimmed(line).empty()) continue;
    try {
      split_csv(line, fields);
      if (fields.size() != header.size())
        throw Error(ErrorCode::Format, at_line(path, lines.line_number()),
                    "has " + std::to_string(fields.size()) + " fields, expected " + std::to_string(header.size()));
      InsSample sample = sample_from(fields, columns, path, lines.line_number());
      sample.stamp_ns = gps_stamp(fields[week], fields[time], unit_ns, path, lines.line_number());
      log.ins.push_back(sample);
      const auto host_ns = host >= 0 ? parse_number(fields[static_cast<std::size_t>(host)]) : std::nullopt;
      if (!host_ns) continue;
      host_offsets_s.push_back((*host_ns - static_cast<double>(sample.stamp_ns)) * 1e-9);
      if (fields[static_cast<std::size_t>(host)] != last_host)
        ++distinct, last_host = fields[static_cast<std::size_t>(host)];
    } catch (const Error& error) {
      bad.add(error);
    }
  }
  log.distinct_host_times =
      static_cast<double>(distinct) / static_cast<double>(std::max<std::size_t>(log.ins.size(), 1));
  report_host_clock(host_offsets_s, log.distinct_host_times, path, findings);
}

}  // namespace

InsQuality inspvax_quality(std::string_view status) {
  // Numbers in bags and their CSVs, names in ASCII logs (OEM6/OEM7 manuals, "Inertial Solution Status").
  if (status == "3" || status == "INS_SOLUTION_GOOD") return InsQuality::Good;
  if (status == "2" || status == "INS_HIGH_VARIANCE" || status == "6" || status == "INS_SOLUTION_FREE" ||
      status == "7" || status == "INS_ALIGNMENT_COMPLETE")
    return InsQuality::Degraded;
  return InsQuality::Invalid;
}

InsSample ins_sample(const InspvaxValues& values, const std::string& where) {
  InsSample sample;
  sample.latitude_rad = degrees_to_radians(values.latitude_deg);
  sample.longitude_rad = degrees_to_radians(values.longitude_deg);
  sample.height_m = values.height_m + values.undulation_m;
  if (!plausible_geodetic(sample.latitude_rad, sample.longitude_rad, sample.height_m))
    throw Error(ErrorCode::Format, where,
                plausible_geodetic(sample.longitude_rad, sample.latitude_rad, sample.height_m)
                    ? "a latitude beyond 90 degrees is not possible: are latitude and longitude exchanged?"
                    : "latitude, longitude or height is not possible");
  for (const double angle_deg : {values.roll_deg, values.pitch_deg, values.azimuth_deg})
    if (!(std::abs(angle_deg) <= 360.0))
      throw Error(ErrorCode::Format, where, "roll, pitch or azimuth is no angle in degrees");
  sample.enu_from_ins = enu_from_ins({degrees_to_radians(values.azimuth_deg), degrees_to_radians(values.pitch_deg),
                                      degrees_to_radians(values.roll_deg)},
                                     AttitudeConvention::NovAtel);
  sample.sigma.position_enu_m = {values.longitude_std_m, values.latitude_std_m, values.height_std_m};
  sample.sigma.attitude_rad =
      axis_sigma_rad({degrees_to_radians(values.azimuth_std_deg), degrees_to_radians(values.pitch_std_deg),
                      degrees_to_radians(values.roll_std_deg)},
                     AttitudeConvention::NovAtel);
  sample.quality = values.quality;
  return sample;
}

std::uint32_t novatel_crc32(std::string_view text) { return plain_crc32(text); }

std::optional<InspvaxFormat> recognise_inspvax(const fs::path& path) {
  try {
    const std::string head = read_file_head(path, kHeadBytes);
    if (head.starts_with("#INSPVAXA,") || head.find("\n#INSPVAXA,") != std::string::npos)
      return InspvaxFormat::AsciiLog;
    LineReader lines(head);
    std::string_view line;
    if (!lines.next(line) || line.find("gps_week") == std::string_view::npos) return std::nullopt;
    const CsvHeader header(line);
    if (header.has("header.gps_week") && header.has("azimuth") && header.has("undulation"))
      return InspvaxFormat::BagCsv;
  } catch (const Error&) {
    // not readable: not recognised
  }
  return std::nullopt;
}

InspvaxLog read_inspvax(const fs::path& path, InspvaxFormat format, std::vector<Finding>& findings) {
  const std::string text = read_regular_file(path);
  InspvaxLog log;
  BadItems bad;
  if (format == InspvaxFormat::AsciiLog)
    read_ascii(text, path, log, bad);
  else
    read_csv(text, path, log, bad, findings);
  if (log.ins.empty())
    throw Error(ErrorCode::Format, path.string(),
                "holds no usable INSPVAX line." + (bad.count() ? " First problem: " + bad.first() : ""));
  bad.report(findings, "bad-ins", path.string(), "lines");
  keep_near(log.ins, path.string(), findings);
  keep_ascending(log.ins, "ins", path.string(), findings);
  return log;
}

}  // namespace remount
