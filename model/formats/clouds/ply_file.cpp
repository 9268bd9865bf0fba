// PLY in its three encodings: the vertex element is read, whatever else stands before it is skipped.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "algorithms/core/error.h"
#include "messages/clouds.h"
#include "model/formats/clouds/cloud_fields.h"
#include "model/formats/files/input_file.h"

namespace remount::formats {

namespace {

constexpr std::size_t kMaxPlyHeaderBytes = 64 * 1024;
constexpr std::size_t kMaxProperties = 512;

enum class PlyEncoding { Ascii, Little, Big };

struct Property {
  CloudField field;                ///< type of the scalar, or of the values of a list
  std::optional<ScalarType> list;  ///< type of a list's length
};

struct Element {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;
  bool has_list = false;
  std::size_t smallest_row = 0;  ///< bytes of a binary row with empty lists
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::Ascii;
  std::vector<Element> elements;
  std::size_t data_offset = 0;
  std::size_t lines = 0;
};

[[noreturn]] void fail_ply(const std::filesystem::path& path, std::size_t line, Message what) {
  throw Error(ErrorCode::Format, at_line(path, line), std::move(what));
}

ScalarType scalar_type(std::string_view name, const std::filesystem::path& path, std::size_t line) {
  if (name == "char" || name == "int8") return ScalarType::I8;
  if (name == "uchar" || name == "uint8") return ScalarType::U8;
  if (name == "short" || name == "int16") return ScalarType::I16;
  if (name == "ushort" || name == "uint16") return ScalarType::U16;
  if (name == "int" || name == "int32") return ScalarType::I32;
  if (name == "uint" || name == "uint32") return ScalarType::U32;
  if (name == "int64" || name == "long") return ScalarType::I64;
  if (name == "uint64" || name == "ulong") return ScalarType::U64;
  if (name == "float" || name == "float32") return ScalarType::F32;
  if (name == "double" || name == "float64") return ScalarType::F64;
  fail_ply(path, line, say::ply_no_number_type(std::string(name.substr(0, 40))));
}

void add_property(Element& element, const std::vector<std::string_view>& tokens, const std::filesystem::path& path,
                  std::size_t line) {
  Property property;
  if (element.properties.size() >= kMaxProperties) fail_ply(path, line, say::ply_too_many_properties(kMaxProperties));
  if (tokens.size() == 5 && tokens[1] == "list") {
    property.list = scalar_type(tokens[2], path, line);
    property.field.type = scalar_type(tokens[3], path, line);
    property.field.count = 2;  // never mistaken for a coordinate
    element.has_list = true;
    element.smallest_row += size_of(*property.list);
  } else if (tokens.size() == 3) {
    property.field.type = scalar_type(tokens[1], path, line);
    element.smallest_row += size_of(property.field.type);
  } else {
    fail_ply(path, line, say::ply_property());
  }
  property.field.name = lower_case(tokens.back());
  element.properties.push_back(std::move(property));
}

void read_header_line(PlyHeader& header, const std::vector<std::string_view>& tokens, const std::filesystem::path& path,
                      std::size_t line) {
  if (tokens[0] == "comment" || tokens[0] == "obj_info") return;
  if (tokens[0] == "format") {
    const std::string_view encoding = tokens.size() > 1 ? tokens[1] : "";
    if (encoding == "ascii")
      header.encoding = PlyEncoding::Ascii;
    else if (encoding == "binary_little_endian")
      header.encoding = PlyEncoding::Little;
    else if (encoding == "binary_big_endian")
      header.encoding = PlyEncoding::Big;
    else
      fail_ply(path, line, say::ply_format(std::string(encoding.substr(0, 40))));
  } else if (tokens[0] == "element") {
    const std::optional<std::int64_t> count = tokens.size() == 3 ? parse_integer(tokens[2]) : std::nullopt;
    if (!count || *count < 0) fail_ply(path, line, say::ply_element());
    header.elements.push_back({std::string(tokens[1]), static_cast<std::size_t>(*count), {}, false, 0});
  } else if (tokens[0] == "property") {
    if (header.elements.empty()) fail_ply(path, line, say::ply_property_alone());
    add_property(header.elements.back(), tokens, path, line);
  } else {
    fail_ply(path, line, say::ply_unknown_line(std::string(tokens[0].substr(0, 40))));
  }
}

PlyHeader read_ply_header(std::string_view bytes, const std::filesystem::path& path) {
  LineReader lines(bytes.substr(0, kMaxPlyHeaderBytes));
  std::string_view line;
  if (!lines.next(line) || trim(line) != "ply") fail_ply(path, 1, say::ply_no_mark());
  PlyHeader header;
  bool format = false;
  std::vector<std::string_view> tokens;
  while (lines.next(line)) {
    split_blanks(line, tokens);
    if (tokens.empty()) continue;
    if (tokens[0] == "end_header") {
      if (!format) fail_ply(path, lines.line_number(), say::ply_no_format());
      header.data_offset = lines.offset();
      header.lines = lines.line_number();
      return header;
    }
    format = format || tokens[0] == "format";
    read_header_line(header, tokens, path, lines.line_number());
  }
  fail_ply(path, lines.line_number(), say::ply_no_end(Bytes{kMaxPlyHeaderBytes}));
}

/// Walks the data of all elements; `values` of a row hold one number for each property (0 for lists).
class RowReader {
 public:
  RowReader(const PlyHeader& header, std::string_view data, const std::filesystem::path& path)
      : header_(header), data_(data), path_(path), lines_(data) {}

  void read(const Element& element, std::vector<double>& values) {
    values.assign(element.properties.size(), 0.0);
    if (header_.encoding == PlyEncoding::Ascii)
      read_text(element, values);
    else
      read_binary(element, values);
  }

  /// Rows of `element` that the rest of the file can hold at most.
  std::size_t fitting_rows(const Element& element) const {
    const std::size_t rest = data_.size() - (header_.encoding == PlyEncoding::Ascii ? lines_.offset() : offset_);
    const std::size_t row =
        header_.encoding == PlyEncoding::Ascii ? 2 * element.properties.size() : element.smallest_row;
    return row == 0 ? std::numeric_limits<std::size_t>::max() : (rest + 1) / row;
  }

  std::string place() const {
    return header_.encoding == PlyEncoding::Ascii
               ? at_line(path_, header_.lines + lines_.line_number())
               : path_.string() + ": byte " + std::to_string(header_.data_offset + offset_);
  }

 private:
  void read_text(const Element& element, std::vector<double>& values) {
    std::string_view line;
    do {
      if (!lines_.next(line)) throw Error(ErrorCode::Format, place(), say::ply_ends_early(element.name));
      split_blanks(line, tokens_);
    } while (tokens_.empty());
    std::size_t at = 0;
    const auto next = [&] {
      const std::optional<double> value = at < tokens_.size() ? parse_any_number(tokens_[at]) : std::nullopt;
      if (!value) throw Error(ErrorCode::Format, place(), say::ply_no_value(at + 1));
      ++at;
      return *value;
    };
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double value = next();
      if (!element.properties[i].list)
        values[i] = value;
      else
        at += list_length(value, tokens_.size() - at, 1);
    }
  }

  void read_binary(const Element& element, std::vector<double>& values) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      const Property& property = element.properties[i];
      const double value = next_scalar(property.list.value_or(property.field.type), element);
      if (!property.list)
        values[i] = value;
      else
        offset_ +=
            list_length(value, data_.size() - offset_, size_of(property.field.type)) * size_of(property.field.type);
    }
  }

  double next_scalar(ScalarType type, const Element& element) {
    if (size_of(type) > data_.size() - offset_)
      throw Error(ErrorCode::Format, place(), say::ply_ends_early(element.name));
    const bool swap = (header_.encoding == PlyEncoding::Big) != (std::endian::native == std::endian::big);
    const double value = read_scalar(data_.data() + offset_, type, swap);
    offset_ += size_of(type);
    return value;
  }

  std::size_t list_length(double length, std::size_t rest, std::size_t unit) const {
    if (!(length >= 0.0) || length > static_cast<double>(rest / unit))
      throw Error(ErrorCode::Format, place(), say::ply_list_too_long());
    return static_cast<std::size_t>(length);
  }

  const PlyHeader& header_;
  std::string_view data_;
  const std::filesystem::path& path_;
  LineReader lines_;
  std::size_t offset_ = 0;
  std::vector<std::string_view> tokens_;
};

ReadCloud read_vertices(RowReader& rows, const Element& element, bool as_bytes, const std::filesystem::path& path,
                        std::int64_t stamp_ns, PointTimes times) {
  std::vector<CloudField> fields;
  for (const Property& property : element.properties) fields.push_back(property.field);
  const CloudColumns columns = find_cloud_columns(fields, path.string());
  if (as_bytes) refuse_narrow_coordinates(fields, columns, path.string());
  const auto at = [](int index) { return static_cast<std::size_t>(index); };
  CloudBuilder builder(columns, time_column(fields, columns), element.count);
  std::vector<double> values;
  for (std::size_t i = 0; i < element.count; ++i) {
    rows.read(element, values);
    RawPoint point{values[at(columns.x)], values[at(columns.y)], values[at(columns.z)]};
    if (columns.intensity >= 0) point.intensity = values[at(columns.intensity)];
    if (columns.ring >= 0) point.ring = values[at(columns.ring)];
    if (columns.time >= 0) point.time = values[at(columns.time)];
    builder.add(point);
  }
  ReadCloud read = builder.finish(stamp_ns, path.string(), times);
  read.columns = column_names(fields);
  return read;
}

}  // namespace

ReadCloud parse_ply(std::string_view bytes, const std::filesystem::path& path, std::int64_t stamp_ns,
                    PointTimes times) {
  const PlyHeader header = read_ply_header(bytes, path);
  RowReader rows(header, bytes.substr(header.data_offset), path);
  std::vector<double> skipped;
  for (const Element& element : header.elements) {
    if (element.count > rows.fitting_rows(element))
      throw Error(ErrorCode::Format, rows.place(),
                  say::ply_rows_beyond_end(element.name, element.count, rows.fitting_rows(element)));
    if (element.name == "vertex")
      return read_vertices(rows, element, header.encoding != PlyEncoding::Ascii, path, stamp_ns, times);
    if (element.properties.empty()) continue;
    for (std::size_t i = 0; i < element.count; ++i) rows.read(element, skipped);
  }
  throw Error(ErrorCode::Format, path.string(), say::ply_no_vertices());
}

}  // namespace remount::formats
