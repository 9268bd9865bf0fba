// Scans as text: a point a line, its numbers apart by blanks, commas or semicolons (XYZ, ASC, PTS, CSV). A line of
// names above the numbers, with or without a mark of comments, says what they are; without one their count does.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

#include "algorithms/core/error.h"
#include "algorithms/core/index.h"
#include "messages/clouds.h"
#include "model/formats/clouds/cloud_fields.h"
#include "model/formats/clouds/decimal_commas.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/output_file.h"
#include "model/formats/files/row_fields.h"
#include "model/formats/files/time_unit.h"

namespace remount::formats {

namespace {

constexpr std::size_t kShownText = 40;
/// Of a line with a point or the names of columns. Its fields take many times the memory of what separates them.
constexpr std::size_t kLongestLine = 64 * 1024;

/// Blanks where the line has neither of the others.
char separator_of(std::string_view line) {
  for (const char separator : {';', ','})
    if (line.find(separator) != std::string_view::npos) return separator;
  return ' ';
}

void split_point_line(std::string_view line, char separator, std::vector<std::string_view>& fields) {
  if (separator == ' ')
    split_blanks(line, fields);
  else
    split_csv(line, fields, separator);
}

/// What programs call coordinates that others call x, y and z: VeloView and ParaView number them.
std::string_view usual_name(std::string_view name) {
  constexpr std::pair<std::string_view, std::string_view> kOthers[] = {{"points:0", "x"},
                                                                       {"points:1", "y"},
                                                                       {"points:2", "z"},
                                                                       {"points_m_xyz:0", "x"},
                                                                       {"points_m_xyz:1", "y"},
                                                                       {"points_m_xyz:2", "z"},
                                                                       {"x_m", "x"},
                                                                       {"y_m", "y"},
                                                                       {"z_m", "z"},
                                                                       {"point.x", "x"},
                                                                       {"point.y", "y"},
                                                                       {"point.z", "z"}};
  for (const auto& [other, usual] : kOthers)
    if (name == other) return usual;
  return name;
}

/// A column as a line of names has it: "X [m]".
struct PointTextColumn {
  std::string name;  ///< lower case, without the unit
  std::string unit;  ///< between brackets; empty where none stands there
};

PointTextColumn text_column(std::string_view text) {
  text = trim(text);
  while (text.size() > 1 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
  PointTextColumn column;
  const std::size_t bracket = text.find_first_of("[(");
  column.name = usual_name(lower_case(trim(text.substr(0, bracket))));
  if (bracket == std::string_view::npos) return column;
  const std::string_view rest = text.substr(bracket + 1);
  column.unit = lower_case(trim(rest.substr(0, rest.find_first_of("])"))));
  return column;
}

/// Of a line without its mark of comments. A unit behind a blank belongs to the name before it.
std::vector<PointTextColumn> columns_named_by(std::string_view line) {
  std::vector<std::string_view> fields;
  split_point_line(line, separator_of(line), fields);
  std::vector<PointTextColumn> columns;
  for (const std::string_view field : fields) {
    PointTextColumn column = text_column(field);
    if (column.name.empty() && !column.unit.empty() && !columns.empty())
      columns.back().unit = column.unit;
    else
      columns.push_back(std::move(column));
  }
  return columns;
}

bool names_coordinates(const std::vector<PointTextColumn>& columns) {
  const auto has = [&](std::string_view name) {
    return std::any_of(columns.begin(), columns.end(), [&](const PointTextColumn& column) {
      return column.name == name || column.name == "scalar_" + std::string(name);
    });
  };
  return has("x") && has("y") && has("z");
}

bool is_metre(std::string_view unit) {
  return unit.empty() || unit == "m" || unit == "metre" || unit == "metres" || unit == "meter" || unit == "meters";
}

/// How the lines of numbers are to be read.
struct PointTextLayout {
  std::vector<CloudField> fields;
  CloudColumns columns;
  TimeColumn time;
  char separator = ' ';
  std::size_t most_fields = 0;  ///< of a row: one with more has a field that is none, and those behind it moved
  bool more_than_used = false;  ///< columns that nothing names

  std::size_t needed() const {
    return index_at(std::max({columns.x, columns.y, columns.z, columns.intensity, columns.ring, columns.time})) + 1;
  }
};

std::vector<CloudField> fields_called(const std::vector<std::string>& names) {
  std::vector<CloudField> fields;
  for (const std::string& name : names) fields.push_back({name, ScalarType::F64});
  return fields;
}

PointTextLayout layout_by_names(const std::vector<PointTextColumn>& columns, const std::string& where) {
  PointTextLayout layout;
  for (const PointTextColumn& column : columns) layout.fields.push_back({column.name, ScalarType::F64});
  layout.columns = find_cloud_columns(layout.fields, where);
  for (const int axis : {layout.columns.x, layout.columns.y, layout.columns.z}) {
    const PointTextColumn& column = columns[index_at(axis)];
    if (!is_metre(column.unit))
      throw Error(ErrorCode::Unsupported, where, say::cloud_text_unit(column.name, column.unit.substr(0, kShownText)));
  }
  layout.time = time_column(layout.fields, layout.columns);
  if (layout.columns.time >= 0)
    if (const auto unit_ns = time_unit_named_ns(columns[index_at(layout.columns.time)].unit))
      layout.time.unit_s = static_cast<double>(*unit_ns) / 1e9;
  return layout;
}

/// Three coordinates; a fourth number is the intensity, and with three colours behind it, as PTS has them.
PointTextLayout layout_by_count(std::size_t count, const std::string& where) {
  constexpr std::size_t kOfPts = 7;
  if (count < 3) throw Error(ErrorCode::Format, where, say::cloud_text_head());
  const bool intensity = count == 4 || count == kOfPts;
  PointTextLayout layout;
  layout.fields = fields_called({"x", "y", "z"});
  if (intensity) layout.fields.push_back({"intensity", ScalarType::F64});
  layout.columns = find_cloud_columns(layout.fields, where);
  layout.more_than_used = count > layout.fields.size();
  return layout;
}

/// The line without the mark that makes it a comment; nothing where it is none.
std::optional<std::string_view> comment_in(std::string_view line) {
  if (!line.starts_with("//") && !line.starts_with('#') && !line.starts_with('%')) return std::nullopt;
  const std::size_t text = line.find_first_not_of("/#% \t");
  return line.substr(std::min(text, line.size()));
}

void refuse_long_line(std::string_view line, const std::string& where) {
  if (line.size() > kLongestLine) throw Error(ErrorCode::Format, where, say::cloud_text_long_line(Bytes{kLongestLine}));
}

bool are_numbers(const std::vector<std::string_view>& fields) {
  return !fields.empty() &&
         std::all_of(fields.begin(), fields.end(), [](auto field) { return field.empty() || parse_any_number(field); });
}

[[noreturn]] void refuse_head(std::string_view line, const std::string& where) {
  const std::string_view comma = decimal_comma_in(line);
  if (comma.empty()) throw Error(ErrorCode::Format, where, say::cloud_text_head());
  throw Error(ErrorCode::Format, where, say::cloud_text_comma(std::string(comma.substr(0, kShownText))));
}

/// Throws Error where the rows behind have decimal commas beside those between numbers.
void refuse_decimal_commas(LineReader lines, const PointTextLayout& layout, std::size_t names,
                           const std::filesystem::path& path) {
  constexpr std::size_t kEnough = 200;
  if (layout.separator != ',') return;
  DecimalCommas commas;
  std::string_view first;
  std::size_t first_line = 0, rows = 0;
  for (std::string_view line; rows < kEnough && lines.next(line);) {
    line = trim(line);
    if (line.empty() || comment_in(line) || line.size() > kLongestLine) continue;
    if (rows++ == 0) first = line, first_line = lines.line_number();
    commas.add(line);
  }
  std::vector<std::string_view> fields;
  split_csv(first, fields);
  const bool two_for_each_name = names > 0 && fields.size() == 2 * names;
  if (names > 0 ? !(two_for_each_name && commas.possible()) : !commas.proved()) return;
  throw Error(ErrorCode::Format, at_line(path, first_line),
              say::cloud_text_comma(std::string(first.substr(0, kShownText))));
}

/// How many fields a row may have. Numbers that stand apart by blanks, or have points, are not parted by a comma: as
/// many as most rows have are columns then, with or without a name.
std::size_t most_fields_of(const LineReader& lines, char separator, std::size_t names,
                           const std::vector<std::string_view>& first_row) {
  const auto split = [&](std::string_view row, auto& into) {
    row = trim(row);
    into.clear();
    if (!comment_in(row) && row.size() <= kLongestLine) split_point_line(row, separator, into);
  };
  const std::size_t most = most_fields(lines, names, split);
  const bool whole = std::ranges::none_of(first_row, [](auto field) { return field.find('.') != field.npos; });
  return names == 0 || (separator == ',' && whole) ? most : std::max(most, most_fields(lines, 0, split));
}

/// Leaves `lines` in front of the first line of numbers.
PointTextLayout read_point_head(LineReader& lines, const std::filesystem::path& path) {
  std::optional<PointTextLayout> named;
  std::vector<std::string_view> fields;
  bool counted = false;
  LineReader ahead = lines;
  for (std::string_view line; ahead.next(line); lines = ahead) {
    line = trim(line);
    if (line.empty()) continue;
    const std::string where = at_line(path, ahead.line_number());
    const std::optional<std::string_view> comment = comment_in(line);
    if (comment && line.size() > kLongestLine) continue;
    refuse_long_line(line, where);
    const char separator = separator_of(line);
    split_point_line(line, separator, fields);
    const bool numbers = !comment && are_numbers(fields);
    if (!numbers) {
      const std::vector<PointTextColumn> columns = columns_named_by(comment.value_or(line));
      if (names_coordinates(columns)) named = layout_by_names(columns, where);
      if (!comment && !names_coordinates(columns)) refuse_head(line, where);
      continue;
    }
    if (fields.size() == 1 && !counted && !named && parse_integer(fields[0])) {
      counted = true;  // PTS: how many points there are
      continue;
    }
    PointTextLayout layout = named ? *named : layout_by_count(filled_fields(fields), where);
    layout.separator = separator;
    const std::size_t names = named ? layout.fields.size() : 0;
    refuse_decimal_commas(lines, layout, names, path);
    layout.most_fields = std::max(most_fields_of(lines, separator, names, fields), layout.needed());
    return layout;
  }
  throw Error(ErrorCode::Format, path.string(), say::cloud_no_points());
}

/// The numbers of a line. An empty field is a number that is not known.
class PointLine {
 public:
  PointLine(const PointTextLayout& layout, const std::filesystem::path& path) : layout_(layout), path_(path) {}

  /// Nothing where the line is empty or a comment.
  std::optional<RawPoint> parse(std::string_view line, std::size_t line_number) {
    line = trim(line);
    if (line.empty() || comment_in(line)) return std::nullopt;
    if (line.size() > kLongestLine) refuse_long_line(line, at_line(path_, line_number));
    split_point_line(line, layout_.separator, fields_);
    if (const std::size_t filled = filled_fields(fields_); filled > layout_.most_fields)
      throw Error(ErrorCode::Format, at_line(path_, line_number), say::cloud_text_more(filled, layout_.most_fields));
    if (fields_.size() < layout_.needed())
      throw Error(ErrorCode::Format, at_line(path_, line_number),
                  say::cloud_text_line(fields_.size(), layout_.needed(), column_names(layout_.fields)));
    const auto value = [&](int column) { return column < 0 ? 0.0 : number(index_at(column), line_number); };
    const CloudColumns& columns = layout_.columns;
    return RawPoint{value(columns.x),         value(columns.y),    value(columns.z),
                    value(columns.intensity), value(columns.ring), value(columns.time)};
  }

 private:
  double number(std::size_t column, std::size_t line_number) const {
    const std::string_view text = fields_[column];
    if (text.empty()) return std::numeric_limits<double>::quiet_NaN();
    if (const auto value = parse_any_number(text)) return *value;
    const std::string shown(text.substr(0, kShownText));
    throw Error(ErrorCode::Format, at_line(path_, line_number),
                text.find(',') != std::string_view::npos ? say::cloud_text_comma(shown) : say::cloud_no_number(shown));
  }

  const PointTextLayout& layout_;
  const std::filesystem::path& path_;
  std::vector<std::string_view> fields_;
};

std::size_t lines_at_most(std::string_view bytes, const PointTextLayout& layout) {
  const auto ends =
      std::max(std::count(bytes.begin(), bytes.end(), '\n'), std::count(bytes.begin(), bytes.end(), '\r'));
  // A number has a digit and what is between it and the next.
  return std::min(static_cast<std::size_t>(ends) + 1, bytes.size() / (2 * layout.needed()) + 1);
}

/// The shortest text that reads back as the same float.
void append_number(std::string& text, float value) {
  char buffer[32];
  const auto result = std::to_chars(buffer, buffer + sizeof buffer, value);
  text.append(buffer, result.ptr);
}

}  // namespace

ReadCloud parse_text_cloud(std::string_view bytes, const std::filesystem::path& path, std::int64_t stamp_ns,
                           PointTimes times) {
  LineReader lines(bytes);
  const PointTextLayout layout = read_point_head(lines, path);
  CloudBuilder builder(layout.columns, layout.time, lines_at_most(bytes, layout));
  PointLine point_line(layout, path);
  for (std::string_view line; lines.next(line);)
    if (const auto point = point_line.parse(line, lines.line_number())) builder.add(*point);
  ReadCloud read = builder.finish(stamp_ns, path.string(), times);
  read.columns = column_names(layout.fields);
  if (layout.more_than_used) read.note = say::cloud_text_unnamed;
  return read;
}

void write_text_cloud(const std::filesystem::path& path, const cloud::PointCloud& cloud) {
  check_columns(cloud);
  std::string text = "x,y,z";
  if (!cloud.intensity.empty()) text += ",intensity";
  if (!cloud.ring.empty()) text += ",ring";
  if (!cloud.time_from_stamp_s.empty()) text += ",time_s";
  text += '\n';
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      if (axis > 0) text += ',';
      append_number(text, cloud.points[i][axis]);
    }
    if (!cloud.intensity.empty()) append_number(text += ',', cloud.intensity[i]);
    if (!cloud.ring.empty()) (text += ',') += std::to_string(cloud.ring[i]);
    if (!cloud.time_from_stamp_s.empty()) append_number(text += ',', cloud.time_from_stamp_s[i]);
    text += '\n';
  }
  write_file(path, text);
}

}  // namespace remount::formats
