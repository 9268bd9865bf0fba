#include "model/formats/clouds/cloud_file.h"

#include <algorithm>
#include <optional>
#include <string>

#include "algorithms/core/error.h"
#include "messages/clouds.h"
#include "model/formats/clouds/cloud_fields.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/output_file.h"

namespace remount::formats {

namespace {

constexpr bool kSwap = std::endian::native == std::endian::big;

CloudFormat recognise(std::string_view bytes, const std::filesystem::path& path) {
  if (bytes.starts_with("ply\n") || bytes.starts_with("ply\r")) return CloudFormat::Ply;
  if (bytes.starts_with("# .PCD") || bytes.starts_with("VERSION") || bytes.starts_with("FIELDS"))
    return CloudFormat::Pcd;
  if (bytes.starts_with("LASF")) return CloudFormat::Las;
  const std::string extension = lower_case(path.extension().string());
  if (extension == ".pcd") return CloudFormat::Pcd;
  if (extension == ".ply") return CloudFormat::Ply;
  if (extension == ".bin") return CloudFormat::KittiBin;
  if (extension == ".txt" || extension == ".xyz") return CloudFormat::XyziText;
  throw Error(ErrorCode::Unsupported, path.string(), say::cloud_no_format());
}

template <class T>
void append_bytes(std::string& bytes, T value) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  if constexpr (kSwap) std::reverse(raw, raw + sizeof(T));
  bytes.append(raw, sizeof(T));
}

void check_columns(const cloud::PointCloud& cloud) {
  const auto fits = [&](std::size_t size) { return size == 0 || size == cloud.size(); };
  if (!fits(cloud.intensity.size()) || !fits(cloud.ring.size()) || !fits(cloud.time_from_stamp_s.size()))
    throw Error(ErrorCode::Contract, "", say::cloud_columns_differ());
}

}  // namespace

ReadCloud parse_xyzi_text(std::string_view bytes, const std::filesystem::path& path) {
  CloudColumns columns;
  columns.intensity = 3;
  // A line has three numbers and three separators at least.
  const auto lines_at_most = static_cast<std::size_t>(std::count(bytes.begin(), bytes.end(), '\n')) + 1;
  CloudBuilder builder(columns, {}, std::min(lines_at_most, bytes.size() / 6 + 1));
  LineReader lines(bytes);
  std::vector<std::string_view> tokens;
  bool any = false;
  for (std::string_view line; lines.next(line);) {
    split_blanks(line, tokens);
    if (tokens.empty()) continue;
    if (tokens.size() < 3) throw Error(ErrorCode::Format, at_line(path, lines.line_number()), say::cloud_text_line());
    const auto value = [&](std::size_t i) {
      const std::optional<double> number = i < tokens.size() ? parse_any_number(tokens[i]) : 0.0;
      if (!number)
        throw Error(ErrorCode::Format, at_line(path, lines.line_number()),
                    say::cloud_no_number(std::string(tokens[i].substr(0, 40))));
      return *number;
    };
    builder.add({value(0), value(1), value(2), value(3)});
    any = true;
  }
  if (!any) throw Error(ErrorCode::Format, path.string(), say::cloud_no_points());
  ReadCloud read = builder.finish(0, path.string());
  read.columns = "x y z reflectance";
  return read;
}

ReadCloud read_cloud_file(const std::filesystem::path& path, std::int64_t stamp_ns, CloudFormat format,
                          PointTimes times) {
  const std::string bytes = read_regular_file(path);
  switch (format == CloudFormat::Auto ? recognise(bytes, path) : format) {
    case CloudFormat::Ply:
      return parse_ply(bytes, path, stamp_ns, times);
    case CloudFormat::Las:
      return parse_las(bytes, path, stamp_ns, times);
    case CloudFormat::KittiBin:
      return parse_bin(bytes, path);
    case CloudFormat::XyziText:
      return parse_xyzi_text(bytes, path);
    default:
      return parse_pcd(bytes, path, stamp_ns, times);
  }
}

cloud::PointCloud load_cloud(const std::filesystem::path& path, std::int64_t stamp_ns, CloudFormat format) {
  return read_cloud_file(path, stamp_ns, format).cloud;
}

void write_pcd(const std::filesystem::path& path, const cloud::PointCloud& cloud) {
  check_columns(cloud);
  std::string fields = "x y z", sizes = "4 4 4", types = "F F F", counts = "1 1 1";
  const auto column = [&](bool present, const char* name, const char* size, const char* type) {
    if (!present) return;
    fields += std::string(" ") + name;
    sizes += std::string(" ") + size;
    types += std::string(" ") + type;
    counts += " 1";
  };
  column(!cloud.intensity.empty(), "intensity", "4", "F");
  column(!cloud.ring.empty(), "ring", "2", "U");
  column(!cloud.time_from_stamp_s.empty(), "time", "4", "F");
  const std::string count = std::to_string(cloud.size());
  std::string bytes = "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS " + fields + "\nSIZE " + sizes +
                      "\nTYPE " + types + "\nCOUNT " + counts + "\nWIDTH " + count +
                      "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + count + "\nDATA binary\n";
  bytes.reserve(bytes.size() + cloud.size() * 22);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) append_bytes(bytes, cloud.points[i][axis]);
    if (!cloud.intensity.empty()) append_bytes(bytes, cloud.intensity[i]);
    if (!cloud.ring.empty()) append_bytes(bytes, cloud.ring[i]);
    if (!cloud.time_from_stamp_s.empty()) append_bytes(bytes, cloud.time_from_stamp_s[i]);
  }
  write_file(path, bytes);
}

void write_kitti_bin(const std::filesystem::path& path, const cloud::PointCloud& cloud) {
  check_columns(cloud);
  std::string bytes;
  bytes.reserve(cloud.size() * 16);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) append_bytes(bytes, cloud.points[i][axis]);
    append_bytes(bytes, cloud.intensity.empty() ? 0.0f : cloud.intensity[i]);
  }
  write_file(path, bytes);
}

}  // namespace remount::formats
