#include "model/io/pose_file.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "model/io/csv_table.h"
#include "model/io/input_file.h"
#include "model/io/text_file.h"
#include "model/io/stream_tools.h"
#include "model/io/time_stamp.h"

namespace remount {

namespace fs = std::filesystem;

namespace {

constexpr std::array<std::string_view, 5> kNames{"tum", "eth-csv", "aloam-csv", "pose-lines", "apollo-csv"};
constexpr std::array<std::string_view, 9> kApolloColumns{"timestamp", "position_type", "qw", "qx", "qy", "qz", "x", "y",
                                                         "z"};
constexpr double kNotableDefect = 1e-3;
/// NovAtel's position types with whole ambiguities, which Apollo's position_type holds.
constexpr std::array<std::int64_t, 5> kFixedTypes{48, 49, 50, 56, 69};

/// What turns a line into a pose. `place` is "file:line", for errors.
class LineParser {
 public:
  LineParser(PoseFormat format, const fs::path& path) : format_(format), path_(path) {}

  void read_header(std::string_view line) {
    const CsvHeader header(line);
    constexpr std::array<std::string_view, 9> kColumns{
        "header.stamp.secs",       "header.stamp.nsecs",      "pose.pose.position.x",
        "pose.pose.position.y",    "pose.pose.position.z",    "pose.pose.orientation.x",
        "pose.pose.orientation.y", "pose.pose.orientation.z", "pose.pose.orientation.w"};
    for (std::size_t i = 0; i < kColumns.size(); ++i) columns_[i] = header.require(kColumns[i], path_);
  }
  /// The header line of Apollo's odometry; without one, columns in its order.
  void read_apollo_header(const CsvHeader* header) {
    for (std::size_t i = 0; i < kApolloColumns.size(); ++i)
      columns_[i] = header != nullptr ? header->require(kApolloColumns[i], path_) : i;
  }

  StampedPose parse(std::string_view line, std::size_t line_number) {
    line_ = line_number;
    const bool csv = format_ != PoseFormat::Tum && format_ != PoseFormat::PoseLines;
    if (csv)
      split_csv(line, fields_);
    else
      split_blanks(line, fields_);
    if (format_ == PoseFormat::PoseLines) return parse_matrix();
    if (format_ == PoseFormat::ApolloCsv) return parse_apollo();
    if (format_ != PoseFormat::AloamCsv)
      for (std::size_t i = 0; i < 8; ++i) columns_[i + 1] = i;
    StampedPose pose;
    pose.stamp_ns = format_ == PoseFormat::AloamCsv ? host_stamp() : seconds_stamp(field(columns_[1]));
    const std::size_t first = 2;
    const Eigen::Vector3d position(number(columns_[first]), number(columns_[first + 1]), number(columns_[first + 2]));
    pose.pose = posed(Eigen::Quaterniond(number(columns_[first + 6]), number(columns_[first + 3]),
                                         number(columns_[first + 4]), number(columns_[first + 5])),
                      position);
    return pose;
  }

  double worst_defect() const { return worst_defect_; }
  std::size_t not_fixed() const { return not_fixed_; }

 private:
  std::string_view field(std::size_t i) const {
    if (i < fields_.size()) return fields_[i];
    throw Error(ErrorCode::Format, at_line(path_, line_),
                "has " + std::to_string(fields_.size()) + " fields, expected more than " + std::to_string(i));
  }
  double number(std::size_t i) const {
    const double value = require_number(field(i), "field " + std::to_string(i + 1), path_, line_);
    if (std::abs(value) < 1e9) return value;
    throw Error(ErrorCode::Format, at_line(path_, line_), "field " + std::to_string(i + 1) + " is beyond 1e9");
  }
  std::int64_t seconds_stamp(std::string_view text) const {
    if (const auto stamp = parse_seconds_ns(text)) return *stamp;
    throw Error(ErrorCode::Format, at_line(path_, line_),
                "'" + std::string(text.substr(0, 40)) + "' is no time in seconds");
  }
  std::int64_t host_stamp() const {
    const auto seconds = parse_integer(field(columns_[0])), nanoseconds = parse_integer(field(columns_[1]));
    if (!seconds || !nanoseconds || *seconds < 0 || *seconds > 9'000'000'000 || *nanoseconds < 0 ||
        *nanoseconds >= 1'000'000'000)
      throw Error(ErrorCode::Format, at_line(path_, line_), "header.stamp holds no seconds and nanoseconds");
    return *seconds * 1'000'000'000 + *nanoseconds;
  }
  RigidTransform posed(const Eigen::Quaterniond& quaternion, const Eigen::Vector3d& position) const {
    if (std::abs(quaternion.norm() - 1.0) > 0.01)
      throw Error(ErrorCode::Format, at_line(path_, line_),
                  "the quaternion has length " + std::to_string(quaternion.norm()) + ", expected 1");
    return make_rigid(quaternion.normalized().toRotationMatrix(), position);
  }
  StampedPose parse_apollo() {
    std::array<double, 7> values{};  // qw, qx, qy, qz, x, y, z
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = number(columns_[i + 2]);
    const auto type = parse_integer(field(columns_[1]));
    if (!type)
      throw Error(
          ErrorCode::Format, at_line(path_, line_),
          "'" + std::string(field(columns_[1]).substr(0, 40)) + "' is no position type, expected a whole number");
    not_fixed_ += std::find(kFixedTypes.begin(), kFixedTypes.end(), *type) == kFixedTypes.end();
    return {seconds_stamp(field(columns_[0])),
            posed({values[0], values[1], values[2], values[3]}, {values[4], values[5], values[6]})};
  }
  StampedPose parse_matrix() {
    if (fields_.size() != 13)
      throw Error(ErrorCode::Format, at_line(path_, line_),
                  "has " + std::to_string(fields_.size()) + " fields, expected a time stamp and 12 numbers");
    const auto stamp = parse_date_ns(fields_[0]);
    if (!stamp)
      throw Error(ErrorCode::Format, at_line(path_, line_),
                  "'" + std::string(fields_[0].substr(0, 40)) + "' is no time like 2021-10-26-16-21-29-468");
    Eigen::Matrix3d rotation;
    Eigen::Vector3d position;
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column)
        rotation(row, column) = number(static_cast<std::size_t>(1 + 4 * row + column));
      position[row] = number(static_cast<std::size_t>(4 + 4 * row));
    }
    double defect = 0.0;
    rotation = checked_rotation(rotation, at_line(path_, line_), defect);
    worst_defect_ = std::max(worst_defect_, defect);
    return {*stamp, make_rigid(rotation, position)};
  }

  PoseFormat format_;
  const fs::path& path_;
  /// Stamp (two columns, or the second alone), position, quaternion x y z w.
  std::array<std::size_t, 9> columns_{};
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

std::optional<PoseFormat> recognise_line(std::string_view line) {
  std::vector<std::string_view> fields;
  split_csv(line, fields);
  if (fields.size() == 8 && all_numbers(fields, 0)) return PoseFormat::EthCsv;
  if (is_apollo_header(line)) return PoseFormat::ApolloCsv;
  if (fields.size() == 9 && all_numbers(fields, 0) && parse_integer(fields[1])) {
    double norm = 0.0;
    for (std::size_t i = 2; i < 6; ++i) norm += std::pow(*parse_number(fields[i]), 2);
    if (std::abs(norm - 1.0) < 0.02) return PoseFormat::ApolloCsv;
  }
  if (line.find("header.stamp.secs") != std::string_view::npos &&
      line.find("pose.pose.orientation.w") != std::string_view::npos)
    return PoseFormat::AloamCsv;
  split_blanks(line, fields);
  if (fields.size() == 8 && all_numbers(fields, 0)) return PoseFormat::Tum;
  if (fields.size() == 13 && parse_date_ns(fields[0]) && all_numbers(fields, 1)) return PoseFormat::PoseLines;
  return std::nullopt;
}

}  // namespace

std::string_view to_string(PoseFormat format) { return kNames[static_cast<std::size_t>(format)]; }

std::optional<PoseFormat> pose_format_from_string(std::string_view text) {
  for (std::size_t i = 0; i < kNames.size(); ++i)
    if (kNames[i] == text) return static_cast<PoseFormat>(i);
  return std::nullopt;
}

std::optional<PoseFormat> recognise_pose_file(const fs::path& path) {
  try {
    const std::string head = read_text_head(path, 16 * 1024);
    LineReader lines(head);
    for (std::string_view line; lines.next(line);) {
      line = trimmed(line);
      if (line.empty()) continue;
      if (const auto format = recognise_line(line)) return format;
      if (!line.starts_with('#')) return std::nullopt;
    }
  } catch (const Error&) {
    // not readable: not a pose file
  }
  return std::nullopt;
}

std::optional<InsAxes> axes_of(PoseFormat format) {
  return format == PoseFormat::ApolloCsv ? std::optional(InsAxes::RightForwardUp) : std::nullopt;
}

namespace {

/// Lines that are long enough: eight numbers of one digit. Others, however many, are to take no memory.
std::size_t possible_poses(std::string_view text) {
  constexpr std::size_t kShortest = 15;
  std::size_t count = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    count += end - at >= kShortest ? 1 : 0;
    at = end + 1;
  }
  return count;
}

/// Reads the header line where the format has one, and says where the poses begin.
void read_head(PoseFormat format, std::string_view text, const fs::path& path, LineParser& parser, LineReader& lines) {
  std::string_view line;
  if (format == PoseFormat::AloamCsv) {
    if (!lines.next(line)) throw Error(ErrorCode::Format, path.string(), "is empty");
    parser.read_header(line);
  } else if (format == PoseFormat::ApolloCsv) {
    LineReader ahead(text);
    const bool named = ahead.next(line) && is_apollo_header(line);
    const CsvHeader header(line);
    parser.read_apollo_header(named ? &header : nullptr);
    if (named) lines.next(line);
  }
}

/// UTM turns against true north away from the middle of its zone.
void tell_apollo(const std::vector<StampedPose>& poses, std::size_t not_fixed, const fs::path& path,
                 std::vector<Finding>& findings) {
  findings.push_back(make_finding(
      Severity::Note, "utm-poses", path.string(),
      "Positions are taken to be UTM, and attitudes to be relative to true north, as Apollo's GNSS driver writes them: "
      "away from the middle of a zone yaw of X is off by the grid convergence, up to some 2 degrees, which no residual "
      "shows."));
  if (not_fixed > 0)
    findings.push_back(make_finding(Severity::Warning, "rtk-lost", path.string(),
                                    std::to_string(not_fixed) + " of " + std::to_string(poses.size()) +
                                        " positions are not fixed by their position type."));
}

}  // namespace

std::vector<StampedPose> read_pose_file(const fs::path& path, PoseFormat format, std::vector<Finding>& findings) {
  return parse_poses(read_text_file(path), path, format, findings);
}

std::vector<StampedPose> parse_poses(std::string_view text, const fs::path& path, PoseFormat format,
                                     std::vector<Finding>& findings) {
  LineParser parser(format, path);
  text = without_cut_line(text, path.string(), findings);
  LineReader lines(text);
  std::string_view line;
  read_head(format, text, path, parser, lines);
  std::vector<StampedPose> poses;
  poses.reserve(possible_poses(text));  // they are large, and would be there twice while the list grows
  BadItems bad;
  while (lines.next(line)) {
    if (trimmed(line).empty() || line.starts_with('#')) continue;
    try {
      poses.push_back(parser.parse(line, lines.line_number()));
    } catch (const Error& error) {
      bad.add(error);
    }
  }
  if (poses.empty())
    throw Error(ErrorCode::Format, path.string(),
                "holds no usable pose (" + std::string(to_string(format)) + ")." +
                    (bad.count() ? " First problem: " + bad.first() : ""));
  bad.report(findings, "bad-poses", path.string(), "lines");
  if (parser.worst_defect() > kNotableDefect)
    findings.push_back(make_finding(Severity::Warning, "rotation-not-orthonormal", path.string(),
                                    "Rotations were off by up to " + std::to_string(parser.worst_defect()) +
                                        " in an entry; the nearest rotation is used."));
  if (format == PoseFormat::ApolloCsv) tell_apollo(poses, parser.not_fixed(), path, findings);
  keep_ascending(poses, "pose", path.string(), findings);
  return poses;
}

}  // namespace remount
