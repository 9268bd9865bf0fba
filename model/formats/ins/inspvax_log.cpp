#include "model/formats/ins/inspvax_log.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "algorithms/core/index.h"
#include "algorithms/core/median.h"
#include "messages/files.h"
#include "messages/ins_logs.h"
#include "messages/sessions.h"
#include "model/drive/attitude_convention.h"
#include "model/drive/bad_items.h"
#include "model/drive/plausible_values.h"
#include "model/drive/stamped_streams.h"
#include "model/formats/files/crc32.h"
#include "model/formats/files/csv_table.h"
#include "model/formats/files/cut_line.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/text_file.h"
#include "model/formats/files/time_stamp.h"

namespace remount::formats {

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

motion::InsSample sample_from(const std::vector<std::string_view>& fields, const Columns& columns, const fs::path& path,
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
              say::inspvax_no_gps_time(std::string(week_text.substr(0, 20)), std::string(time_text.substr(0, 20))));
}

/// The ASCII logs that are read. INSPVA has no errors; INSPVAS is the same with a short header.
enum class AsciiKind { Inspvax, Inspva };
struct AsciiMark {
  std::string_view begin;
  AsciiKind kind;
  std::size_t time;  ///< place of the week in the header, behind which the time of week stands
};
constexpr std::array<AsciiMark, 3> kMarks{
    {{"#INSPVAXA,", AsciiKind::Inspvax, 5}, {"#INSPVAA,", AsciiKind::Inspva, 5}, {"%INSPVASA,", AsciiKind::Inspva, 1}}};

/// Where a log begins within a line, from a place on; null where none does. Looks at no byte beyond the first that
/// does: a line may be a whole file.
const AsciiMark* find_mark(std::string_view line, std::size_t from, std::size_t& at) {
  for (at = line.find_first_of("#%", from); at != std::string_view::npos; at = line.find_first_of("#%", at + 1))
    for (const AsciiMark& mark : kMarks)
      if (line.substr(at).starts_with(mark.begin)) return &mark;
  return nullptr;
}

/// "<week>,<seconds>,<latitude>,<longitude>,<height>,3 speeds,<roll>,<pitch>,<azimuth>,<status>"
InspvaxValues inspva_values(const std::vector<std::string_view>& fields, const fs::path& path, std::size_t line) {
  constexpr std::size_t kInspvaFields = 12;
  if (fields.size() < kInspvaFields)
    throw Error(ErrorCode::Format, at_line(path, line), say::inspvax_data_fields(fields.size(), kInspvaFields));
  const auto number = [&](std::size_t i, Message (*what)()) { return require_number(fields[i], what, path, line); };
  InspvaxValues values = InspvaxValues::without_errors();
  values.quality = inspvax_quality(fields[11]);
  values.latitude_deg = number(2, say::log_latitude);
  values.longitude_deg = number(3, say::log_longitude);
  values.height_m = number(4, say::log_height);
  values.roll_deg = number(8, say::log_roll);
  values.pitch_deg = number(9, say::log_pitch);
  values.azimuth_deg = number(10, say::log_azimuth);
  return values;
}

/// @param log from its '#' or '%' on
/// @param misnamed becomes larger where the status is none of an INS
motion::InsSample parse_ascii(std::string_view log, const AsciiMark& mark, std::size_t number, const fs::path& path,
                              std::vector<std::string_view>& fields, std::size_t& misnamed) {
  const std::size_t body = log.find(';'), star = log.find('*', std::min(body, log.size()));
  if (star == std::string_view::npos || body == std::string_view::npos)
    throw Error(ErrorCode::Format, at_line(path, number), say::inspvax_no_record(std::string(mark.begin)));
  const std::string_view digits = trim(log.substr(star + 1)).substr(0, 8);
  std::uint32_t crc = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), crc, 16);
  if (error != std::errc() || digits.size() != 8 || end != digits.data() + 8 ||
      crc != novatel_crc32(log.substr(1, star - 1)))
    throw Error(ErrorCode::Format, at_line(path, number), say::inspvax_checksum());
  split_csv(log.substr(0, body), fields);
  if (fields.size() < mark.time + 2) throw Error(ErrorCode::Format, at_line(path, number), say::inspvax_short_header());
  std::int64_t stamp_ns = gps_stamp(fields[mark.time], fields[mark.time + 1], 1'000'000'000, path, number);
  split_csv(log.substr(body + 1, star - body - 1), fields);
  motion::InsSample sample;
  if (mark.kind == AsciiKind::Inspva) {
    sample = ins_sample(inspva_values(fields, path, number), at_line(path, number));
    misnamed += is_of_wrong_table(fields[11]);
    stamp_ns = gps_stamp(fields[0], fields[1], 1'000'000'000, path, number);  // to nanoseconds, the header's to ms
  } else {
    if (fields.size() < kAsciiFields)
      throw Error(ErrorCode::Format, at_line(path, number), say::inspvax_data_fields(fields.size(), kAsciiFields));
    sample = sample_from(fields, ascii_columns(), path, number);
    misnamed += is_of_wrong_table(fields[0]);
  }
  sample.stamp_ns = stamp_ns;
  return sample;
}

void read_ascii(const std::string& text, const fs::path& path, InspvaxLog& log, drive::BadItems& bad,
                std::vector<drive::Finding>& findings) {
  LineReader lines(text);
  std::vector<std::string_view> fields;
  std::vector<motion::InsSample> inspva;
  std::size_t misnamed = 0;
  for (std::string_view line; lines.next(line);) {
    std::size_t at = 0;
    for (const AsciiMark* mark = find_mark(line, 0, at); mark != nullptr;) {
      std::size_t next_at = 0;
      const AsciiMark* next = find_mark(line, at + 1, next_at);
      try {
        auto& ins = mark->kind == AsciiKind::Inspva ? inspva : log.ins;
        ins.push_back(parse_ascii(line.substr(at, next_at - at), *mark, lines.line_number(), path, fields, misnamed));
      } catch (const Error& error) {
        bad.add(error);
      }
      mark = next;
      at = next_at;
    }
  }
  report_misnamed(misnamed, path.string(), findings);
  if (inspva.size() <= 3 * log.ins.size()) return;
  std::swap(log.ins, inspva);
  if (inspva.empty()) return;
  std::vector<drive::Finding> told_elsewhere;
  drive::keep_ascending(log.ins, "ins", path.string(), findings);
  drive::keep_ascending(inspva, "ins", path.string(), told_elsewhere);
  give_errors(log.ins, inspva);
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

void read_csv(std::string_view text, const fs::path& path, InspvaxLog& log, drive::BadItems& bad,
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

motion::InsSample ins_sample(const InspvaxValues& values, const std::string& where) {
  motion::InsSample sample;
  sample.latitude_rad = degrees_to_radians(values.latitude_deg);
  sample.longitude_rad = degrees_to_radians(values.longitude_deg);
  sample.height_m = values.height_m + values.undulation_m;
  if (!drive::plausible_geodetic(sample.latitude_rad, sample.longitude_rad, sample.height_m))
    throw Error(ErrorCode::Format, where,
                drive::plausible_geodetic(sample.longitude_rad, sample.latitude_rad, sample.height_m)
                    ? say::log_place_exchanged(Angle{kPi / 2.0})
                    : say::log_place_impossible());
  for (const double angle_deg : {values.roll_deg, values.pitch_deg, values.azimuth_deg})
    if (!(std::abs(angle_deg) <= 360.0))
      throw Error(ErrorCode::Format, where,
                  drive::angle_means_not_known(angle_deg) ? say::inspvax_angles_not_known() : say::inspvax_no_angles());
  sample.enu_from_ins = drive::enu_from_ins({degrees_to_radians(values.azimuth_deg),
                                             degrees_to_radians(values.pitch_deg), degrees_to_radians(values.roll_deg)},
                                            drive::AttitudeConvention::NovAtel);
  const auto stated = [](double sigma) { return drive::means_not_known(sigma) || sigma < 0.0 ? std::nan("") : sigma; };
  sample.sigma.position_enu_m = {stated(values.longitude_std_m), stated(values.latitude_std_m),
                                 stated(values.height_std_m)};
  sample.sigma.attitude_rad = drive::axis_sigma_rad(
      {degrees_to_radians(stated(values.azimuth_std_deg)), degrees_to_radians(stated(values.pitch_std_deg)),
       degrees_to_radians(stated(values.roll_std_deg))},
      drive::AttitudeConvention::NovAtel);
  sample.quality = values.quality;
  return sample;
}

InspvaxValues InspvaxValues::without_errors() {
  InspvaxValues values;
  for (double InspvaxValues::*const error :
       {&InspvaxValues::latitude_std_m, &InspvaxValues::longitude_std_m, &InspvaxValues::height_std_m,
        &InspvaxValues::roll_std_deg, &InspvaxValues::pitch_std_deg, &InspvaxValues::azimuth_std_deg})
    values.*error = std::numeric_limits<double>::quiet_NaN();
  return values;
}

std::uint32_t novatel_crc32(std::string_view text) { return plain_crc32(text); }

std::optional<InspvaxFormat> recognise_inspvax(const fs::path& path) {
  try {
    const std::string head = read_text_head(path, kHeadBytes);
    std::size_t at = 0;
    while (find_mark(head, at, at) != nullptr) {
      at = std::min(head.find_first_of("\r\n;", at), head.size());
      if (at < head.size() && head[at] == ';') return InspvaxFormat::AsciiLog;  // not only mentioned in a text
    }
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

InspvaxLog read_inspvax(const fs::path& path, InspvaxFormat format, std::vector<drive::Finding>& findings) {
  const std::string text = read_text_file(path);
  InspvaxLog log;
  drive::BadItems bad;
  if (format == InspvaxFormat::AsciiLog)
    read_ascii(text, path, log, bad, findings);
  else
    read_csv(text, path, log, bad, findings);
  if (log.ins.empty()) throw Error(ErrorCode::Format, path.string(), bad.after(say::inspvax_none_usable()));
  bad.report(findings, "bad-ins", path.string(), say::left_out_lines);
  drive::keep_near(log.ins, path.string(), findings);
  drive::keep_ascending(log.ins, "ins", path.string(), findings);
  return log;
}

}  // namespace remount::formats
