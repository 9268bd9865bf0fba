#include "model/formats/ins/ins_table.h"

#include <cmath>

#include "algorithms/core/index.h"
#include "messages/files.h"
#include "messages/ins_logs.h"
#include "messages/sessions.h"
#include "model/drive/bad_items.h"
#include "model/drive/plausible_values.h"
#include "model/drive/stamped_streams.h"
#include "model/formats/files/csv_table.h"
#include "model/formats/files/cut_line.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/row_fields.h"
#include "model/formats/files/text_file.h"
#include "model/formats/files/time_stamp.h"
#include "model/formats/files/time_unit.h"
#include "model/formats/ins/angle_unit_check.h"

namespace remount::formats {

namespace fs = std::filesystem;

namespace {

constexpr std::array<std::string_view, 4> kQualityNames{"unknown", "good", "degraded", "invalid"};

class RowParser {
 public:
  RowParser(const fs::path& path, const InsTableLayout& layout, const CsvHeader& header, std::size_t most_fields)
      : path_(path), layout_(layout), header_(header), most_fields_(most_fields) {}

  /// Angles of the line that was parsed last, in the unit of the file; where the layout has angles.
  const drive::AttitudeAngles& logged_angles() const { return logged_; }

  motion::InsSample parse(std::string_view line, std::size_t line_number) {
    line_ = line_number;
    split_csv(line, fields_);
    if (filled_fields(fields_) > most_fields_) fail(say::csv_fields(filled_fields(fields_), most_fields_));
    motion::InsSample sample;
    sample.stamp_ns = stamp_ns();
    sample.latitude_rad = known(layout_.latitude) * layout_.position_unit_rad;
    sample.longitude_rad = known(layout_.longitude) * layout_.position_unit_rad;
    sample.height_m = known(layout_.height);
    if (!drive::plausible_geodetic(sample.latitude_rad, sample.longitude_rad, sample.height_m))
      throw Error(ErrorCode::Format, at_line(path_, line_),
                  drive::plausible_geodetic(sample.longitude_rad, sample.latitude_rad, sample.height_m)
                      ? say::log_place_exchanged(Angle{kPi / 2.0})
                      : say::log_place_impossible());
    sample.enu_from_ins = layout_.quaternion ? quaternion() : attitude();
    if (layout_.position_sigma_enu)
      for (int axis = 0; axis < 3; ++axis)
        sample.sigma.position_enu_m[axis] = sigma((*layout_.position_sigma_enu)[index_at(axis)]);
    if (layout_.attitude_sigma_yaw_pitch_roll)
      sample.sigma.attitude_rad = attitude_sigma(*layout_.attitude_sigma_yaw_pitch_roll);
    if (layout_.quality) sample.quality = quality();
    return sample;
  }

 private:
  [[noreturn]] void fail(Message what) const { throw Error(ErrorCode::Format, at_line(path_, line_), std::move(what)); }

  std::string_view field(const ColumnRef& column) const {
    const std::size_t index = column.name.empty() ? column.index : static_cast<std::size_t>(header_.find(column.name));
    if (index >= fields_.size()) fail(say::ins_column_needed(fields_.size(), index + 1));
    return fields_[index];
  }
  static Message label(const ColumnRef& column) {
    return column.name.empty() ? say::ins_column(column.index) : Message::verbatim(column.name);
  }
  double number(const ColumnRef& column) const {
    return require_number(
        field(column), [&] { return label(column); }, path_, line_);
  }
  /// A number that is none of those which stand for a missing one.
  double known(const ColumnRef& column) const {
    const double value = number(column);
    if (drive::means_not_known(value)) fail_not_known(column);
    return value;
  }
  double angle(const ColumnRef& column) const {
    const double value = number(column);
    if (drive::angle_means_not_known(value)) fail_not_known(column);
    return value;
  }
  [[noreturn]] void fail_not_known(const ColumnRef& column) const {
    fail(say::log_not_known(label(column), std::string(field(column).substr(0, 40))));
  }
  /// An empty field, nan or a number that stands for a missing one: this line does not state it.
  double sigma(const ColumnRef& column) const {
    const auto value = parse_number(field(column));
    return value && *value > 0.0 && !drive::means_not_known(*value) ? *value : std::numeric_limits<double>::quiet_NaN();
  }

  std::int64_t stamp_ns() const {
    const std::string_view text = field(layout_.time);
    const auto time = parse_time_ns(text, layout_.time_unit_ns);
    if (!time) fail(no_time(text));
    if (layout_.gps_week) {
      const auto week = parse_integer(field(*layout_.gps_week));
      const auto stamp = week ? unix_ns_from_gps_week(*week, *time) : std::nullopt;
      if (!stamp) fail(say::ins_gps_week());
      return *stamp;
    }
    return layout_.time_scale == TimeScale::Gps ? unix_ns_from_gps_ns(*time) : *time;
  }

  /// A number that is no time in the declared unit, but would be one in a smaller: the usual mistake.
  Message no_time(std::string_view text) const {
    const Message column = label(layout_.time);
    const std::string shown(text.substr(0, 40)), declared(time_unit_name(layout_.time_unit_ns));
    for (const std::int64_t unit_ns : {1'000'000, 1'000, 1})
      if (unit_ns < layout_.time_unit_ns && parse_time_ns(text, unit_ns))
        return say::ins_time_too_large(column, shown, declared, std::string(time_unit_name(unit_ns)));
    return say::ins_no_time(column, shown, declared);
  }

  Eigen::Quaterniond attitude() {
    const auto& columns = layout_.yaw_pitch_roll;
    logged_ = {angle(columns[0]), angle(columns[1]), angle(columns[2])};
    const double unit = layout_.attitude_unit_rad;
    return drive::enu_from_ins({logged_.yaw_rad * unit, logged_.pitch_rad * unit, logged_.roll_rad * unit},
                               layout_.attitude);
  }

  Eigen::Vector3d attitude_sigma(const std::array<ColumnRef, 3>& columns) const {
    const double unit = layout_.quaternion ? 1.0 : layout_.attitude_unit_rad;
    return drive::axis_sigma_rad({sigma(columns[0]) * unit, sigma(columns[1]) * unit, sigma(columns[2]) * unit},
                                 layout_.quaternion ? drive::AttitudeConvention::EnuYaw : layout_.attitude);
  }

  Eigen::Quaterniond quaternion() const {
    const Eigen::Quaterniond logged(number(layout_.quaternion_xyzw[3]), number(layout_.quaternion_xyzw[0]),
                                    number(layout_.quaternion_xyzw[1]), number(layout_.quaternion_xyzw[2]));
    if (std::abs(logged.norm() - 1.0) > 0.01) fail(say::ins_quaternion_length(logged.norm()));
    return drive::enu_from_ins(logged, *layout_.quaternion);
  }

  motion::InsQuality quality() const {
    const std::string_view text = field(*layout_.quality);
    for (std::size_t i = 0; i < kQualityNames.size(); ++i)
      if (kQualityNames[i] == text) return static_cast<motion::InsQuality>(i);
    fail(say::ins_quality(label(*layout_.quality), std::string(text.substr(0, 40))));
  }

  const fs::path& path_;
  const InsTableLayout& layout_;
  const CsvHeader& header_;
  const std::size_t most_fields_;
  std::vector<std::string_view> fields_;
  std::size_t line_ = 0;
  drive::AttitudeAngles logged_;
};

std::vector<ColumnRef> columns_of(const InsTableLayout& layout) {
  std::vector<ColumnRef> columns{layout.time, layout.latitude, layout.longitude, layout.height};
  if (layout.gps_week) columns.push_back(*layout.gps_week);
  if (layout.quality) columns.push_back(*layout.quality);
  if (layout.quaternion)
    columns.insert(columns.end(), layout.quaternion_xyzw.begin(), layout.quaternion_xyzw.end());
  else
    columns.insert(columns.end(), layout.yaw_pitch_roll.begin(), layout.yaw_pitch_roll.end());
  for (const auto* sigma : {&layout.position_sigma_enu, &layout.attitude_sigma_yaw_pitch_roll})
    if (*sigma) columns.insert(columns.end(), (*sigma)->begin(), (*sigma)->end());
  return columns;
}

}  // namespace

std::string_view to_string(motion::InsQuality quality) { return kQualityNames[index_of(quality)]; }

std::vector<motion::InsSample> read_ins_table(const fs::path& path, const InsTableLayout& layout,
                                              std::vector<drive::Finding>& findings) {
  return parse_ins_table(read_text_file(path), path, layout, findings);
}

std::vector<motion::InsSample> parse_ins_table(std::string_view text, const fs::path& path,
                                               const InsTableLayout& layout, std::vector<drive::Finding>& findings) {
  text = without_cut_line(text, path.string(), findings);
  LineReader lines(text);
  std::string_view line;
  const std::vector<ColumnRef> columns = columns_of(layout);
  const bool by_name =
      std::any_of(columns.begin(), columns.end(), [](const ColumnRef& column) { return !column.name.empty(); });
  CsvHeader header;
  if (by_name) {
    if (!lines.next(line)) throw Error(ErrorCode::Format, path.string(), say::file_empty());
    header = CsvHeader(line);
    for (const ColumnRef& column : columns)
      if (!column.name.empty()) header.require(column.name, path);
  }
  const std::size_t most =
      most_fields(lines, header.size(), [](std::string_view row, auto& fields) { split_csv(row, fields); });
  RowParser parser(path, layout, header, most);
  std::vector<motion::InsSample> samples;
  std::vector<drive::AttitudeAngles> logged;
  drive::BadItems bad;
  while (lines.next(line)) {
    if (trim(line).empty() || line.starts_with('#')) continue;
    try {
      samples.push_back(parser.parse(line, lines.line_number()));
      logged.push_back(parser.logged_angles());
    } catch (const Error& error) {
      // Columns by number: a first line without numbers is a header.
      if (by_name || lines.line_number() > 1) bad.add(error);
    }
  }
  if (samples.empty()) throw Error(ErrorCode::Format, path.string(), bad.after(say::ins_none_usable()));
  bad.report(findings, "bad-ins", path.string(), say::left_out_lines);
  if (!layout.quaternion) check_angle_unit(samples, logged, layout.attitude_unit_rad, layout.attitude, path, findings);
  drive::keep_near(samples, path.string(), findings);
  drive::keep_ascending(samples, "ins", path.string(), findings);
  return samples;
}

}  // namespace remount::formats
