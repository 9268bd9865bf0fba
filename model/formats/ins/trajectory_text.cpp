#include "model/formats/ins/trajectory_text.h"

#include <algorithm>
#include <cmath>

#include "algorithms/core/error.h"
#include "algorithms/geometry/rotation.h"
#include "messages/ins_logs.h"
#include "messages/sessions.h"
#include "model/drive/bad_items.h"
#include "model/drive/plausible_values.h"
#include "model/drive/stamped_streams.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/row_fields.h"
#include "model/formats/files/text_file.h"
#include "model/formats/ins/text_layout.h"
#include "model/formats/ins/text_times.h"

namespace remount::formats {

namespace fs = std::filesystem;

namespace {

/// Of the file, in whatever encoding: the names stand within them.
constexpr std::size_t kHeadBytes = 64 * 1024;

/// What a trajectory needs beside its time: each column, and what it is called for people.
constexpr std::pair<TextColumn, std::string_view> kNeeded[] = {{TextColumn::Latitude, "latitude"},
                                                               {TextColumn::Longitude, "longitude"},
                                                               {TextColumn::Roll, "roll"},
                                                               {TextColumn::Pitch, "pitch"},
                                                               {TextColumn::Heading, "heading"}};

void require_columns(const TextLayout& layout, const fs::path& path) {
  std::vector<std::string> missing;
  for (const auto& [column, name] : kNeeded)
    if (!layout.has(column)) missing.emplace_back(name);
  if (!layout.has(TextColumn::Height) && !layout.has(TextColumn::SeaHeight)) missing.emplace_back("height");
  if (!has_time(layout)) missing.emplace_back("time");
  if (!missing.empty())
    throw Error(ErrorCode::Format, at_line(path, layout.rows_line), say::trajectory_lacks(std::move(missing)));
}

void require_units(const TextLayout& layout, const fs::path& path) {
  for (const auto& column : layout.columns) {
    if (!column) continue;
    if (column->unit == TextUnit::Unknown)
      throw Error(ErrorCode::Format, at_line(path, layout.rows_line),
                  say::trajectory_unit(column->name, column->unit_name));
    if (column->unit == TextUnit::UnknownZone)
      throw Error(ErrorCode::Format, at_line(path, layout.rows_line),
                  say::trajectory_zone(column->name, column->unit_name));
  }
}

/// Between blanks a name may be two words: a field more in every row does not say where it belongs.
std::size_t most_fields_of(const TextLayout& layout, std::string_view body) {
  if (layout.separator == ' ') return layout.fields;
  return most_fields(LineReader(body), layout.fields,
                     [&](std::string_view row, auto& fields) { split_row(row, layout.separator, fields); });
}

class TrajectoryRows {
 public:
  TrajectoryRows(const TextLayout& layout, std::string_view body, const fs::path& path)
      : layout_(layout), path_(path), times_(layout), most_fields_(most_fields_of(layout, body)) {}

  bool week_open() const { return times_.week_open(); }
  bool from_gps() const { return times_.from_gps(); }

  bool wants_count() const { return times_.has_open_seconds(); }
  void count(std::string_view line) {
    split_row(line, layout_.separator, fields_);
    if (is_whole()) times_.count(fields_);
  }

  motion::InsSample sample(std::string_view line, std::size_t number) {
    line_ = number;
    split_row(line, layout_.separator, fields_);
    if (!is_whole()) fail(say::csv_fields(fields_.size(), std::clamp(fields_.size(), layout_.fields, most_fields_)));
    motion::InsSample sample;
    sample.latitude_rad = angle(TextColumn::Latitude);
    sample.longitude_rad = angle(TextColumn::Longitude);
    sample.height_m = height_m();
    if (!drive::plausible_geodetic(sample.latitude_rad, sample.longitude_rad, sample.height_m))
      fail(drive::plausible_geodetic(sample.longitude_rad, sample.latitude_rad, sample.height_m)
               ? say::log_place_exchanged(Angle{kPi / 2.0})
               : say::log_place_impossible());
    const drive::AttitudeAngles angles{angle(TextColumn::Heading), angle(TextColumn::Pitch), angle(TextColumn::Roll)};
    if (!(std::abs(angles.yaw_rad) <= 2.0 * kPi && std::abs(angles.pitch_rad) <= kPi / 2.0 + 1e-9 &&
          std::abs(angles.roll_rad) <= 2.0 * kPi))
      fail(say::log_angles_impossible());
    sample.enu_from_ins = drive::enu_from_ins(angles, convention());
    sample.sigma.position_enu_m = {sigma(TextColumn::SigmaEast), sigma(TextColumn::SigmaNorth),
                                   sigma(TextColumn::SigmaUp)};
    sample.sigma.attitude_rad =
        drive::axis_sigma_rad({angle_sigma(TextColumn::SigmaHeading), angle_sigma(TextColumn::SigmaPitch),
                               angle_sigma(TextColumn::SigmaRoll)},
                              convention());
    sample.quality = quality();
    const auto stamp_ns = times_.stamp_ns(fields_);
    if (!stamp_ns) fail(times_.lacks_date(fields_) ? say::trajectory_no_date() : say::trajectory_no_time());
    sample.stamp_ns = *stamp_ns;
    return sample;
  }

 private:
  bool is_whole() const { return fields_.size() >= layout_.fields && filled_fields(fields_) <= most_fields_; }
  [[noreturn]] void fail(Message what) const { throw Error(ErrorCode::Format, at_line(path_, line_), std::move(what)); }
  drive::AttitudeConvention convention() const {
    return layout_.inertial_explorer ? drive::AttitudeConvention::NovAtel : drive::AttitudeConvention::Heading;
  }
  double number(const PlacedColumn& column) const {
    const double value = require_number(fields_[column.at], column.name, path_, line_);
    if (drive::angle_means_not_known(value) || drive::means_not_known(value))
      fail(say::log_not_known(Message::verbatim(column.name), std::string(fields_[column.at].substr(0, 40))));
    return value;
  }
  double angle(TextColumn column) const {
    const PlacedColumn& placed = *layout_.of(column);
    if (placed.unit == TextUnit::DegreesMinutesSeconds) return sexagesimal_rad(placed);
    return placed.unit == TextUnit::Radians ? number(placed) : degrees_to_radians(number(placed));
  }
  /// "-79 28 10.85149": three fields where blanks part them, else one.
  double sexagesimal_rad(const PlacedColumn& column) const {
    std::vector<std::string_view> parts;
    if (layout_.separator == ' ')
      parts = {fields_[column.at], fields_[column.at + 1], fields_[column.at + 2]};
    else
      split_blanks(fields_[column.at], parts);
    if (parts.size() != 3) fail(say::trajectory_no_sexagesimal(column.name));
    std::array<double, 3> values{};
    for (std::size_t i = 0; i < 3; ++i) values[i] = require_number(parts[i], column.name, path_, line_);
    if (values[1] < 0.0 || values[1] >= 60.0 || values[2] < 0.0 || values[2] > 60.0)
      fail(say::trajectory_no_sexagesimal(column.name));
    const double size_deg = std::abs(values[0]) + values[1] / 60.0 + values[2] / 3600.0;
    return degrees_to_radians(parts[0].starts_with('-') ? -size_deg : size_deg);  // also of -0
  }
  double height_m() const {
    if (layout_.has(TextColumn::Height)) return number(*layout_.of(TextColumn::Height));
    const auto& undulation = layout_.of(TextColumn::Undulation);
    return number(*layout_.of(TextColumn::SeaHeight)) + (undulation ? number(*undulation) : 0.0);
  }
  /// NaN where the table has no such column, or nothing in it.
  double sigma(TextColumn column) const {
    const auto& placed = layout_.of(column);
    const auto value = placed ? parse_number(fields_[placed->at]) : std::nullopt;
    return value && *value > 0.0 && !drive::means_not_known(*value) ? *value : std::nan("");
  }
  double angle_sigma(TextColumn column) const {
    const auto& placed = layout_.of(column);
    const double value = sigma(column);
    return placed && placed->unit == TextUnit::Radians ? value : degrees_to_radians(value);
  }
  /// Inertial Explorer's quality goes from 1 to 6; behind 2 ambiguities are not fixed.
  motion::InsQuality quality() const {
    const auto& placed = layout_.of(TextColumn::Quality);
    const auto value = placed && layout_.inertial_explorer ? parse_integer(fields_[placed->at]) : std::nullopt;
    if (!value || *value < 1) return motion::InsQuality::Unknown;
    return *value <= 2 ? motion::InsQuality::Good : motion::InsQuality::Degraded;
  }

  const TextLayout& layout_;
  const fs::path& path_;
  TextTimes times_;
  std::size_t most_fields_;
  std::vector<std::string_view> fields_;
  std::size_t line_ = 0;
};

/// Programs write what they have done behind an empty line at the end.
bool is_remark(std::string_view line) {
  return std::string_view("0123456789+-.\"").find(line.front()) == std::string_view::npos;
}

void read_rows(std::string_view body, const TextLayout& layout, TrajectoryRows& rows,
               std::vector<motion::InsSample>& ins, drive::BadItems& bad) {
  constexpr std::size_t kShortestRow = 16;
  ins.reserve(std::min(static_cast<std::size_t>(std::ranges::count(body, '\n')) + 1, body.size() / kShortestRow + 1));
  if (rows.wants_count()) {
    LineReader counted(body);
    for (std::string_view line; counted.next(line);) rows.count(line);
  }
  LineReader lines(body);
  bool behind_gap = false;
  for (std::string_view line; lines.next(line);) {
    const std::string_view trimmed = trim(line);
    if (trimmed.empty() || (behind_gap && is_remark(trimmed))) {
      behind_gap = behind_gap || (trimmed.empty() && !ins.empty());
      continue;
    }
    try {
      ins.push_back(rows.sample(line, layout.rows_line + lines.line_number()));
    } catch (const Error& error) {
      bad.add(error);
    }
  }
}

/// What prose has not that speaks of latitudes and angles.
bool has_row(std::string_view text, const TextLayout& layout) {
  std::vector<std::string_view> fields, parts;
  const auto holds_number = [&](TextColumn column) {
    split_blanks(fields[layout.of(column)->at], parts);  // degrees may have their minutes behind them
    return !parts.empty() && parse_number(parts.front());
  };
  LineReader lines(text.substr(layout.rows_at));
  for (std::string_view line; lines.next(line);) {
    split_row(line, layout.separator, fields);
    if (fields.size() >= layout.fields && holds_number(TextColumn::Latitude) && holds_number(TextColumn::Longitude))
      return true;
  }
  return false;
}

}  // namespace

bool recognise_trajectory_text(const fs::path& path) {
  try {
    const std::string text = read_text_head(path, kHeadBytes);
    const auto layout = find_text_layout(text);
    if (!layout || !has_row(text, *layout)) return false;
    if (layout->names_program) return true;
    return has_time(*layout) &&
           (layout->has(TextColumn::Roll) || layout->has(TextColumn::Pitch) || layout->has(TextColumn::Heading));
  } catch (const Error&) {
    return false;  // not readable: not recognised
  }
}

bool is_post_processed_text(const fs::path& path) {
  try {
    const auto layout = find_text_layout(read_text_head(path, kHeadBytes));
    if (!layout || !layout->names_program) return false;
    require_columns(*layout, path);
    require_units(*layout, path);
    return true;
  } catch (const Error&) {
    return false;
  }
}

InsLog read_trajectory_text(const fs::path& path, std::vector<drive::Finding>& findings) {
  InsLog log;
  log.files = {path};
  const std::string text = read_text_file(path);
  const auto layout = find_text_layout(read_text_head(path, kHeadBytes));  // as it is recognised
  if (!layout) throw Error(ErrorCode::Format, path.string(), say::trajectory_no_head());
  require_columns(*layout, path);
  require_units(*layout, path);
  drive::BadItems bad;
  const std::string_view body = std::string_view(text).substr(layout->rows_at);
  TrajectoryRows rows(*layout, body, path);
  read_rows(body, *layout, rows, log.ins, bad);
  if (log.ins.empty()) throw Error(ErrorCode::Format, path.string(), bad.after(say::ins_none_usable()));
  bad.report(findings, "bad-ins", path.string(), say::left_out_lines);
  log.axes = layout->inertial_explorer ? drive::InsAxes::RightForwardUp : drive::InsAxes::ForwardLeftUp;
  log.stamps_from_gps = rows.from_gps();
  log.week_open = rows.week_open();
  if (!layout->has(TextColumn::Height) && !layout->has(TextColumn::Undulation))
    findings.push_back(
        drive::make_finding(drive::Severity::Note, "height-above-sea", path.string(), say::trajectory_above_sea()));
  drive::keep_near(log.ins, path.string(), findings);
  drive::keep_ascending(log.ins, "ins", path.string(), findings);
  return log;
}

}  // namespace remount::formats
