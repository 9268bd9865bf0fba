#include "model/formats/poses/pose_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "algorithms/core/index.h"
#include "messages/files.h"
#include "messages/ins_logs.h"
#include "messages/poses.h"
#include "messages/sessions.h"
#include "model/conventions/impossible_motion.h"
#include "model/drive/bad_items.h"
#include "model/drive/plausible_values.h"
#include "model/drive/stamped_streams.h"
#include "model/formats/files/csv_table.h"
#include "model/formats/files/cut_line.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/row_fields.h"
#include "model/formats/files/text_file.h"
#include "model/formats/files/time_stamp.h"
#include "model/formats/poses/pose_columns.h"

namespace remount::formats {

namespace fs = std::filesystem;

namespace {

constexpr std::array<std::string_view, 5> kNames{"tum", "eth-csv", "aloam-csv", "pose-lines", "apollo-csv"};
constexpr std::array<std::string_view, 9> kApolloColumns{"timestamp", "position_type", "qw", "qx", "qy", "qz", "x", "y",
                                                         "z"};
constexpr double kNotableDefect = 1e-3;
/// NovAtel's position types with whole ambiguities, which Apollo's position_type holds.
constexpr std::array<std::int64_t, 5> kFixedTypes{48, 49, 50, 56, 69};

constexpr std::int64_t kSecond_ns = 1'000'000'000;

Message unit_words(std::int64_t unit_ns) {
  return unit_ns == kSecond_ns  ? say::pose_unit_seconds()
         : unit_ns == 1'000'000 ? say::pose_unit_milliseconds()
         : unit_ns == 1'000     ? say::pose_unit_microseconds()
                                : say::pose_unit_nanoseconds();
}

void split_pose_line(std::string_view line, PoseFormat format, std::vector<std::string_view>& fields) {
  if (format == PoseFormat::Tum || format == PoseFormat::PoseLines)
    split_blanks(line, fields);
  else
    split_csv(line, fields);
}

/// What turns a line into a pose. `place` is "file:line", for errors.
class LineParser {
 public:
  LineParser(PoseFormat format, const fs::path& path) : format_(format), path_(path) {}

  void set_columns(const PoseColumns& columns, std::int64_t time_unit_ns) {
    columns_ = columns;
    time_unit_ns_ = time_unit_ns;
  }
  void set_most_fields(std::size_t most_fields) { most_fields_ = most_fields; }
  /// The header line of Apollo's odometry; without one, columns in its order.
  void read_apollo_header(const CsvHeader* header) {
    for (std::size_t i = 0; i < kApolloColumns.size(); ++i)
      apollo_columns_[i] = header != nullptr ? header->require(kApolloColumns[i], path_) : i;
  }

  motion::StampedPose parse(std::string_view line, std::size_t line_number) {
    line_ = line_number;
    split_pose_line(line, format_, fields_);
    if (format_ == PoseFormat::PoseLines) return parse_matrix();
    if (filled_fields(fields_) > most_fields_)
      throw Error(ErrorCode::Format, at_line(path_, line_), say::csv_fields(filled_fields(fields_), most_fields_));
    if (format_ == PoseFormat::ApolloCsv) return parse_apollo();
    motion::StampedPose pose;
    pose.stamp_ns = columns_.nanoseconds ? host_stamp() : stamp(field(columns_.time));
    const auto& [x, y, z] = columns_.position;
    const auto& [qx, qy, qz, qw] = columns_.quaternion_xyzw;
    const Eigen::Vector3d position(number(x), number(y), number(z));
    pose.pose = pose_of(Eigen::Quaterniond(number(qw), number(qx), number(qy), number(qz)), position);
    return pose;
  }

  double worst_defect() const { return worst_defect_; }
  std::size_t not_fixed() const { return not_fixed_; }

 private:
  std::string_view field(std::size_t i) const {
    if (i < fields_.size()) return fields_[i];
    throw Error(ErrorCode::Format, at_line(path_, line_), say::pose_fields(fields_.size(), i));
  }
  double number(std::size_t i) const {
    const double value = require_number(
        field(i), [&] { return say::pose_field(i + 1); }, path_, line_);
    if (std::abs(value) < conventions::kFarthestPosition_m) return value;
    throw Error(ErrorCode::Format, at_line(path_, line_), say::pose_field_beyond(i + 1));
  }
  std::int64_t stamp(std::string_view text) const {
    if (const auto stamp_ns = parse_time_ns(text, time_unit_ns_)) return *stamp_ns;
    throw Error(ErrorCode::Format, at_line(path_, line_),
                say::pose_no_time(std::string(text.substr(0, 40)), unit_words(time_unit_ns_)));
  }
  std::int64_t host_stamp() const {
    const auto seconds = parse_integer(field(columns_.time)), nanoseconds = parse_integer(field(*columns_.nanoseconds));
    if (!seconds || !nanoseconds || *seconds < 0 || *seconds > 9'000'000'000 || *nanoseconds < 0 ||
        *nanoseconds >= 1'000'000'000)
      throw Error(ErrorCode::Format, at_line(path_, line_), say::pose_no_stamp_in_parts());
    return *seconds * 1'000'000'000 + *nanoseconds;
  }
  RigidTransform pose_of(const Eigen::Quaterniond& quaternion, const Eigen::Vector3d& position) const {
    if (std::abs(quaternion.norm() - 1.0) > 0.01)
      throw Error(ErrorCode::Format, at_line(path_, line_), say::pose_quaternion_length(quaternion.norm()));
    return make_rigid(quaternion.normalized().toRotationMatrix(), position);
  }
  motion::StampedPose parse_apollo() {
    std::array<double, 7> values{};  // qw, qx, qy, qz, x, y, z
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = number(apollo_columns_[i + 2]);
    const auto type = parse_integer(field(apollo_columns_[1]));
    if (!type)
      throw Error(ErrorCode::Format, at_line(path_, line_),
                  say::pose_no_position_type(std::string(field(apollo_columns_[1]).substr(0, 40))));
    not_fixed_ += std::find(kFixedTypes.begin(), kFixedTypes.end(), *type) == kFixedTypes.end();
    return {stamp(field(apollo_columns_[0])),
            pose_of({values[0], values[1], values[2], values[3]}, {values[4], values[5], values[6]})};
  }
  motion::StampedPose parse_matrix() {
    if (fields_.size() != 13)
      throw Error(ErrorCode::Format, at_line(path_, line_), say::pose_line_fields(fields_.size()));
    const auto stamp = parse_date_ns(fields_[0]);
    if (!stamp)
      throw Error(ErrorCode::Format, at_line(path_, line_), say::pose_no_date(std::string(fields_[0].substr(0, 40))));
    Eigen::Matrix3d rotation;
    Eigen::Vector3d position;
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column)
        rotation(row, column) = number(static_cast<std::size_t>(1 + 4 * row + column));
      position[row] = number(static_cast<std::size_t>(4 + 4 * row));
    }
    double defect = 0.0;
    rotation = drive::checked_rotation(rotation, at_line(path_, line_), defect);
    worst_defect_ = std::max(worst_defect_, defect);
    return {*stamp, make_rigid(rotation, position)};
  }

  PoseFormat format_;
  const fs::path& path_;
  PoseColumns columns_;
  std::int64_t time_unit_ns_ = kSecond_ns;
  std::size_t most_fields_ = std::numeric_limits<std::size_t>::max();
  std::array<std::size_t, 9> apollo_columns_{};
  std::vector<std::string_view> fields_;
  std::size_t line_ = 0;
  double worst_defect_ = 0.0;
  std::size_t not_fixed_ = 0;
};

/// True where the line is the header of Apollo's odometry.
bool is_apollo_header(std::string_view line) {
  const CsvHeader header(line);
  return std::all_of(kApolloColumns.begin(), kApolloColumns.end(), [&](auto name) { return header.has(name); });
}

bool all_numbers(const std::vector<std::string_view>& fields, std::size_t from) {
  for (std::size_t i = from; i < fields.size(); ++i)
    if (!parse_number(fields[i])) return false;
  return true;
}

bool is_aloam_header(std::string_view line) {
  return line.find("header.stamp.secs") != std::string_view::npos &&
         line.find("pose.pose.orientation.w") != std::string_view::npos;
}

bool are_unit_quaternion(const std::vector<std::string_view>& fields, std::size_t from) {
  double norm2 = 0.0;
  for (std::size_t i = from; i < from + 4; ++i) norm2 += std::pow(*parse_number(fields[i]), 2);
  return std::abs(norm2 - 1.0) < 0.02;
}

/// A number of the line before the pose, as some write it.
bool is_numbered(const std::vector<std::string_view>& fields) {
  return fields.size() == 9 && all_numbers(fields, 0) && parse_integer(fields[0]) && are_unit_quaternion(fields, 5);
}

bool fits(const std::vector<std::string_view>& fields, const PoseColumns& columns) {
  if (fields.size() <= columns.last() || !parse_number(fields[columns.time])) return false;
  const auto is_number = [&](std::size_t column) { return parse_number(fields[column]).has_value(); };
  return std::all_of(columns.position.begin(), columns.position.end(), is_number) &&
         std::all_of(columns.quaternion_xyzw.begin(), columns.quaternion_xyzw.end(), is_number);
}

/// @param named by a header above it
std::optional<PoseFormat> recognise_line(std::string_view line, const std::optional<PoseColumns>& named) {
  std::vector<std::string_view> fields;
  split_csv(line, fields);
  if (named && fields.size() > 1) return fits(fields, *named) ? std::optional(PoseFormat::EthCsv) : std::nullopt;
  if (fields.size() == 8 && all_numbers(fields, 0)) return PoseFormat::EthCsv;
  if (fields.size() == 9 && all_numbers(fields, 0) && parse_integer(fields[1]) && are_unit_quaternion(fields, 2))
    return PoseFormat::ApolloCsv;
  if (is_numbered(fields)) return PoseFormat::EthCsv;
  split_blanks(line, fields);
  if (named) return fits(fields, *named) ? std::optional(PoseFormat::Tum) : std::nullopt;
  if ((fields.size() == 8 && all_numbers(fields, 0)) || is_numbered(fields)) return PoseFormat::Tum;
  if (fields.size() == 13 && parse_date_ns(fields[0]) && all_numbers(fields, 1)) return PoseFormat::PoseLines;
  return std::nullopt;
}

}  // namespace

std::string_view to_string(PoseFormat format) { return kNames[index_of(format)]; }

std::optional<PoseFormat> pose_format_from_string(std::string_view text) {
  for (std::size_t i = 0; i < kNames.size(); ++i)
    if (kNames[i] == text) return static_cast<PoseFormat>(i);
  return std::nullopt;
}

std::optional<PoseFormat> recognise_pose_file(const fs::path& path) {
  try {
    const std::string head = read_text_head(path, 16 * 1024);
    LineReader lines(head);
    std::optional<PoseColumns> named;
    for (std::string_view line; lines.next(line);) {
      line = trim(line);
      if (line.empty()) continue;
      if (is_apollo_header(line)) return PoseFormat::ApolloCsv;
      if (is_aloam_header(line)) return PoseFormat::AloamCsv;
      if (const auto format = recognise_line(line, named)) return format;
      const std::optional<PoseColumns> columns = named_pose_columns(line);
      if (!columns && !line.starts_with('#')) return std::nullopt;
      if (columns) named = columns;
    }
  } catch (const Error&) {
    // not readable: not a pose file
  }
  return std::nullopt;
}

std::optional<drive::InsAxes> axes_of(PoseFormat format) {
  return format == PoseFormat::ApolloCsv ? std::optional(drive::InsAxes::RightForwardUp) : std::nullopt;
}

bool counts_from_true_north(PoseFormat format) { return format == PoseFormat::ApolloCsv; }

namespace {

/// Columns and unit of the stamps: as a header above the first line of numbers names them, else in the usual order and
/// by their size. Leaves `lines` behind the header.
struct NamedColumns {
  PoseColumns columns;
  bool named = false;
};
NamedColumns columns_of(PoseFormat format, LineReader& lines) {
  NamedColumns out;
  std::vector<std::string_view> fields;
  LineReader ahead = lines;
  for (std::string_view line; ahead.next(line);) {
    line = trim(line);
    if (line.empty()) continue;
    const std::optional<PoseColumns> columns = named_pose_columns(line);
    if (columns) out = {*columns, true};
    if (columns && !line.starts_with('#')) lines = ahead;
    if (columns || line.starts_with('#')) continue;
    split_pose_line(line, format, fields);
    if (!out.named) out.columns = usual_pose_columns(is_numbered(fields));
    break;
  }
  return out;
}

/// Stamps at the begin, and whether all of them are whole numbers.
std::pair<std::vector<double>, bool> first_stamps(PoseFormat format, const PoseColumns& columns, LineReader lines) {
  constexpr std::size_t kEnough = 200;
  std::vector<std::string_view> fields;
  std::vector<double> stamps;
  bool whole = true;
  for (std::string_view line; stamps.size() < kEnough && lines.next(line);) {
    if (trim(line).empty() || line.starts_with('#')) continue;
    split_pose_line(line, format, fields);
    const auto stamp = columns.time < fields.size() ? parse_number(fields[columns.time]) : std::nullopt;
    if (!stamp) continue;
    stamps.push_back(*stamp);
    whole = whole && parse_integer(fields[columns.time]).has_value();
  }
  return {std::move(stamps), whole};
}

std::int64_t time_unit_of(PoseFormat format, const PoseColumns& columns, const LineReader& lines, const fs::path& path,
                          std::vector<drive::Finding>& findings) {
  if (columns.time_unit_ns != 0) return columns.time_unit_ns;
  const auto [stamps, whole] = first_stamps(format, columns, lines);
  const std::optional<std::int64_t> unit_ns = unit_of_stamps_ns(stamps);
  if (!unit_ns && whole && !stamps.empty()) throw Error(ErrorCode::Format, path.string(), say::pose_unit_open());
  if (unit_ns.value_or(kSecond_ns) != kSecond_ns)
    findings.push_back(drive::make_finding(drive::Severity::Note, "stamps-unit", path.string(),
                                           say::pose_unit_by_size(unit_words(*unit_ns))));
  return unit_ns.value_or(kSecond_ns);
}

PoseColumns aloam_columns(std::string_view line, const fs::path& path) {
  const CsvHeader header(line);
  PoseColumns columns;
  columns.time = header.require("header.stamp.secs", path);
  columns.nanoseconds = header.require("header.stamp.nsecs", path);
  std::size_t i = 0;
  for (const char* axis : {"x", "y", "z"})
    columns.position[i++] = header.require(std::string("pose.pose.position.") + axis, path);
  i = 0;
  for (const char* axis : {"x", "y", "z", "w"})
    columns.quaternion_xyzw[i++] = header.require(std::string("pose.pose.orientation.") + axis, path);
  return columns;
}

/// Reads the header line where there is one, and leaves `lines` where the poses begin.
void read_head(PoseFormat format, const fs::path& path, LineParser& parser, LineReader& lines,
               std::vector<drive::Finding>& findings) {
  std::string_view line;
  if (format == PoseFormat::AloamCsv) {
    if (!lines.next(line)) throw Error(ErrorCode::Format, path.string(), say::file_empty());
    parser.set_columns(aloam_columns(line, path), kSecond_ns);
  } else if (format == PoseFormat::ApolloCsv) {
    LineReader ahead = lines;
    const bool named = ahead.next(line) && is_apollo_header(line);
    const CsvHeader header(line);
    parser.read_apollo_header(named ? &header : nullptr);
    if (named) lines = ahead;
  } else if (format != PoseFormat::PoseLines) {
    const PoseColumns columns = columns_of(format, lines).columns;
    const bool in_parts = columns.nanoseconds.has_value();
    parser.set_columns(columns, in_parts ? kSecond_ns : time_unit_of(format, columns, lines, path, findings));
  }
}

void tell_not_fixed(const std::vector<motion::StampedPose>& poses, std::size_t not_fixed, const fs::path& path,
                    std::vector<drive::Finding>& findings) {
  if (not_fixed > 0)
    findings.push_back(drive::make_finding(drive::Severity::Warning, "rtk-lost", path.string(),
                                           say::pose_not_fixed(not_fixed, poses.size())));
}

}  // namespace

std::vector<motion::StampedPose> read_pose_file(const fs::path& path, PoseFormat format,
                                                std::vector<drive::Finding>& findings) {
  return parse_poses(read_text_file(path), path, format, findings);
}

std::vector<motion::StampedPose> parse_poses(std::string_view text, const fs::path& path, PoseFormat format,
                                             std::vector<drive::Finding>& findings) {
  LineParser parser(format, path);
  text = without_cut_line(text, path.string(), findings);
  LineReader lines(text);
  std::string_view line;
  read_head(format, path, parser, lines, findings);
  parser.set_most_fields(
      most_fields(lines, 0, [format](std::string_view row, auto& fields) { split_pose_line(row, format, fields); }));
  std::vector<motion::StampedPose> poses;
  poses.reserve(possible_poses(text));  // they are large, and would be there twice while the list grows
  drive::BadItems bad;
  while (lines.next(line)) {
    if (trim(line).empty() || line.starts_with('#')) continue;
    try {
      poses.push_back(parser.parse(line, lines.line_number()));
    } catch (const Error& error) {
      bad.add(error);
    }
  }
  if (poses.empty())
    throw Error(ErrorCode::Format, path.string(), bad.after(say::pose_none_usable(std::string(to_string(format)))));
  bad.report(findings, "bad-poses", path.string(), say::left_out_lines);
  if (parser.worst_defect() > kNotableDefect)
    findings.push_back(drive::make_finding(drive::Severity::Warning, "rotation-not-orthonormal", path.string(),
                                           say::pose_not_orthonormal(parser.worst_defect())));
  if (format == PoseFormat::ApolloCsv) tell_not_fixed(poses, parser.not_fixed(), path, findings);
  drive::keep_ascending(poses, "pose", path.string(), findings);
  return poses;
}

}  // namespace remount::formats
