// PCD v.5 to v.7 in its three encodings. Written for files from outside: every count is checked against what the file
// holds before memory is taken.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "algorithms/core/error.h"
#include "algorithms/core/index.h"
#include "messages/clouds.h"
#include "model/formats/clouds/cloud_fields.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/lzf.h"

namespace remount::formats {

namespace {

constexpr std::size_t kMaxHeaderBytes = 64 * 1024;
constexpr std::size_t kMaxFields = 512;
constexpr std::int64_t kMostOfField = 1 << 20;

enum class Encoding { Ascii, Binary, Compressed };

struct Header {
  std::vector<CloudField> fields;
  std::size_t points = 0;
  std::size_t values_per_point = 0;  ///< numbers on a line of text
  std::size_t bytes_per_point = 0;
  Encoding encoding = Encoding::Ascii;
  std::size_t data_offset = 0;
  std::size_t data_line = 0;
};

/// The header's lines as they stand; their order does not matter, as writers differ.
struct Entries {
  std::vector<std::string> fields;
  std::vector<std::int64_t> sizes, counts;
  std::string types;
  std::optional<std::int64_t> width, height, points;
  std::size_t fields_line = 0;
};

[[noreturn]] void fail(const std::filesystem::path& path, std::size_t line, Message what) {
  throw Error(ErrorCode::Format, at_line(path, line), std::move(what));
}

std::int64_t header_integer(std::string_view text, std::string_view key, std::int64_t low, std::int64_t high,
                            const std::filesystem::path& path, std::size_t line) {
  const std::optional<std::int64_t> value = parse_integer(text);
  if (value && *value >= low && *value <= high) return *value;
  fail(path, line, say::pcd_integer(std::string(key), std::string(text.substr(0, 40)), low, high));
}

void read_entry(Entries& entries, const std::vector<std::string_view>& tokens, const std::filesystem::path& path,
                std::size_t line) {
  const std::string key = lower_case(tokens[0]);
  if (tokens.size() > kMaxFields + 1) fail(path, line, say::pcd_too_many_columns(tokens.size() - 1, kMaxFields));
  const auto single = [&](std::int64_t high) {
    if (tokens.size() != 2) fail(path, line, say::pcd_one_number(std::string(tokens[0])));
    return header_integer(tokens[1], tokens[0], 0, high, path, line);
  };
  constexpr std::int64_t kLarge = std::numeric_limits<std::int64_t>::max();
  if (key == "fields" || key == "columns") {
    entries.fields_line = line;
    entries.fields.clear();
    for (std::size_t i = 1; i < tokens.size(); ++i) entries.fields.push_back(lower_case(tokens[i]));
  } else if (key == "size") {
    entries.sizes.clear();
    for (std::size_t i = 1; i < tokens.size(); ++i)
      entries.sizes.push_back(header_integer(tokens[i], "SIZE", 1, 8, path, line));
  } else if (key == "count") {
    entries.counts.clear();
    for (std::size_t i = 1; i < tokens.size(); ++i)
      entries.counts.push_back(header_integer(tokens[i], "COUNT", 0, kMostOfField, path, line));
  } else if (key == "type") {
    entries.types.clear();
    for (std::size_t i = 1; i < tokens.size(); ++i) {
      if (tokens[i].size() != 1) fail(path, line, say::pcd_type(std::string(tokens[i].substr(0, 40))));
      entries.types.push_back(tokens[i][0]);
    }
  } else if (key == "width") {
    entries.width = single(kLarge);
  } else if (key == "height") {
    entries.height = single(kLarge);
  } else if (key == "points") {
    entries.points = single(kLarge);
  } else if (key != "version" && key != "viewpoint") {
    fail(path, line, say::pcd_unknown_line(std::string(tokens[0].substr(0, 40))));
  }
}

ScalarType scalar_type(char type, std::int64_t size, const std::filesystem::path& path, std::size_t line) {
  switch (type | 0x20) {
    case 'i':
      if (size == 1) return ScalarType::I8;
      if (size == 2) return ScalarType::I16;
      if (size == 4) return ScalarType::I32;
      if (size == 8) return ScalarType::I64;
      break;
    case 'u':
      if (size == 1) return ScalarType::U8;
      if (size == 2) return ScalarType::U16;
      if (size == 4) return ScalarType::U32;
      if (size == 8) return ScalarType::U64;
      break;
    case 'f':
      if (size == 4) return ScalarType::F32;
      if (size == 8) return ScalarType::F64;
      break;
    default:
      break;
  }
  fail(path, line, say::pcd_no_number_type(std::string(1, type), size));
}

void describe_fields(Header& header, const Entries& entries, const std::filesystem::path& path) {
  const std::size_t line = entries.fields_line, n = entries.fields.size();
  if (n == 0) fail(path, header.data_line, say::pcd_no_fields());
  if (entries.sizes.size() != n || entries.types.size() != n || (!entries.counts.empty() && entries.counts.size() != n))
    fail(path, line, say::pcd_fields_differ(n, entries.sizes.size(), entries.types.size(), entries.counts.size()));
  for (std::size_t i = 0; i < n; ++i) {
    CloudField field;
    field.name = entries.fields[i];
    field.type = scalar_type(entries.types[i], entries.sizes[i], path, line);
    field.count = entries.counts.empty() ? 1 : static_cast<std::size_t>(entries.counts[i]);
    field.offset = header.encoding == Encoding::Ascii ? header.values_per_point : header.bytes_per_point;
    header.values_per_point += field.count;
    header.bytes_per_point += field.count * size_of(field.type);
    header.fields.push_back(std::move(field));
  }
}

void count_points(Header& header, const Entries& entries, const std::filesystem::path& path) {
  const std::int64_t height = entries.height.value_or(1);
  if (!entries.points && !entries.width) fail(path, header.data_line, say::pcd_no_points());
  const std::int64_t width = entries.width.value_or(*entries.points / std::max<std::int64_t>(height, 1));
  if (height != 0 && width > std::numeric_limits<std::int64_t>::max() / height)
    fail(path, header.data_line, say::pcd_too_many_points());
  const std::int64_t points = entries.points.value_or(width * height);
  // Some writers leave WIDTH or HEIGHT at 0: what follows is as many points as POINTS says.
  if (width * height != points && width * height != 0)
    fail(path, header.data_line, say::pcd_points_differ(points, width * height));
  header.points = static_cast<std::size_t>(points);
}

Header read_header(std::string_view bytes, const std::filesystem::path& path) {
  if (bytes.empty()) fail(path, 1, say::pcd_empty());
  Header header;
  Entries entries;
  LineReader lines(bytes.substr(0, kMaxHeaderBytes));
  std::vector<std::string_view> tokens;
  for (std::string_view line; lines.next(line);) {
    if (line.starts_with('#')) continue;
    split_blanks(line, tokens);
    if (tokens.empty()) continue;
    if (lower_case(tokens[0]) != "data") {
      read_entry(entries, tokens, path, lines.line_number());
      continue;
    }
    const std::string encoding = tokens.size() == 2 ? lower_case(tokens[1]) : "";
    if (encoding == "ascii")
      header.encoding = Encoding::Ascii;
    else if (encoding == "binary")
      header.encoding = Encoding::Binary;
    else if (encoding == "binary_compressed")
      header.encoding = Encoding::Compressed;
    else
      fail(path, lines.line_number(), say::pcd_data(encoding));
    header.data_offset = lines.offset();
    header.data_line = lines.line_number();
    describe_fields(header, entries, path);
    count_points(header, entries, path);
    return header;
  }
  fail(path, lines.line_number(), say::pcd_no_data(Bytes{kMaxHeaderBytes}));
}

/// Fills a point from where `value(field index)` finds its numbers.
template <class Value>
RawPoint raw_point(const CloudColumns& columns, Value&& value) {
  RawPoint point{value(columns.x), value(columns.y), value(columns.z)};
  if (columns.intensity >= 0) point.intensity = value(columns.intensity);
  if (columns.ring >= 0) point.ring = value(columns.ring);
  if (columns.time >= 0) point.time = value(columns.time);
  return point;
}

void read_ascii(CloudBuilder& builder, const Header& header, const CloudColumns& columns, std::string_view data,
                const std::filesystem::path& path) {
  LineReader lines(data);
  std::vector<std::string_view> tokens;
  std::size_t read = 0;
  for (std::string_view line; read < header.points && lines.next(line);) {
    split_blanks(line, tokens);
    if (tokens.empty()) continue;
    const std::size_t number = header.data_line + lines.line_number();
    if (tokens.size() != header.values_per_point)
      fail(path, number, say::pcd_values(tokens.size(), header.values_per_point));
    builder.add(raw_point(columns, [&](int field) {
      const CloudField& column = header.fields[index_at(field)];
      const std::optional<double> value = parse_any_number(tokens[column.offset]);
      if (!value) fail(path, number, say::pcd_no_number(column.name, std::string(tokens[column.offset].substr(0, 40))));
      return *value;
    }));
    ++read;
  }
  if (read < header.points)
    fail(path, header.data_line + lines.line_number(), say::pcd_ends_early(read, header.points));
}

/// Points one after the other (binary) or one column after the other (compressed).
void read_binary(CloudBuilder& builder, const Header& header, const CloudColumns& columns, const char* data) {
  const bool by_column = header.encoding == Encoding::Compressed;
  for (std::size_t i = 0; i < header.points; ++i)
    builder.add(raw_point(columns, [&](int index) {
      const CloudField& field = header.fields[index_at(index)];
      const std::size_t at = by_column ? field.offset * header.points + i * size_of(field.type) * field.count
                                       : i * header.bytes_per_point + field.offset;
      return read_scalar(data + at, field.type, std::endian::native == std::endian::big);
    }));
}

std::string decompress(const Header& header, std::string_view data, const std::filesystem::path& path) {
  const auto place = path.string() + ": byte " + std::to_string(header.data_offset);
  if (data.size() < 8) throw Error(ErrorCode::Format, place, say::pcd_no_sizes());
  const auto packed =
      static_cast<std::size_t>(read_scalar(data.data(), ScalarType::U32, std::endian::native == std::endian::big));
  const auto unpacked =
      static_cast<std::size_t>(read_scalar(data.data() + 4, ScalarType::U32, std::endian::native == std::endian::big));
  if (packed > data.size() - 8)
    throw Error(ErrorCode::Format, place, say::pcd_compressed_bytes(packed, data.size() - 8));
  if (unpacked / header.bytes_per_point != header.points || unpacked % header.bytes_per_point != 0)
    throw Error(ErrorCode::Format, place,
                say::pcd_unpacked_bytes(Bytes{unpacked}, header.points, Bytes{header.bytes_per_point}));
  std::optional<std::string> decoded = lzf_decode(data.substr(8, packed), unpacked);
  if (!decoded) throw Error(ErrorCode::Format, place, say::pcd_broken_stream());
  return *std::move(decoded);
}

}  // namespace

ReadCloud parse_pcd(std::string_view bytes, const std::filesystem::path& path, std::int64_t stamp_ns,
                    PointTimes times) {
  const Header header = read_header(bytes, path);
  const CloudColumns columns = find_cloud_columns(header.fields, path.string());
  if (header.encoding != Encoding::Ascii) refuse_narrow_coordinates(header.fields, columns, path.string());
  const std::string_view data = bytes.substr(header.data_offset);
  const std::size_t smallest = header.encoding == Encoding::Ascii        ? 2 * header.values_per_point
                               : header.encoding == Encoding::Compressed ? 1
                                                                         : header.bytes_per_point;
  const std::size_t fitting =
      (header.encoding == Encoding::Compressed ? lzf_max_output(data.size()) / header.bytes_per_point
                                               : (data.size() + 1) / smallest);
  if (header.points > fitting)
    fail(path, header.data_line, say::pcd_points_beyond_end(header.points, Bytes{data.size()}, fitting));
  if (header.points == 0) return {};
  std::string decoded;
  if (header.encoding == Encoding::Compressed) decoded = decompress(header, data, path);
  CloudBuilder builder(columns, time_column(header.fields, columns), header.points);
  if (header.encoding == Encoding::Ascii)
    read_ascii(builder, header, columns, data, path);
  else
    read_binary(builder, header, columns, header.encoding == Encoding::Compressed ? decoded.data() : data.data());
  ReadCloud read = builder.finish(stamp_ns, path.string(), times);
  read.columns = column_names(header.fields);
  return read;
}

}  // namespace remount::formats
