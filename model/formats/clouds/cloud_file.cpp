#include "model/formats/clouds/cloud_file.h"

#include <algorithm>
#include <optional>
#include <string>

#include "algorithms/core/error.h"
#include "messages/clouds.h"
#include "model/formats/clouds/cloud_fields.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/output_file.h"
#include "model/formats/files/text_file.h"

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
  if (is_text_cloud_name(path)) return CloudFormat::Text;
  throw Error(ErrorCode::Unsupported, path.string(), say::cloud_no_format());
}

template <class T>
void append_bytes(std::string& bytes, T value) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  if constexpr (kSwap) std::reverse(raw, raw + sizeof(T));
  bytes.append(raw, sizeof(T));
}

}  // namespace

void check_columns(const cloud::PointCloud& cloud) {
  const auto fits = [&](std::size_t size) { return size == 0 || size == cloud.size(); };
  if (!fits(cloud.intensity.size()) || !fits(cloud.ring.size()) || !fits(cloud.time_from_stamp_s.size()))
    throw Error(ErrorCode::Contract, "", say::cloud_columns_differ());
}

bool is_text_cloud_name(const std::filesystem::path& path) {
  const std::string extension = lower_case(path.extension().string());
  constexpr std::string_view kTexts[] = {".txt", ".xyz", ".asc", ".pts", ".csv"};
  return std::find(std::begin(kTexts), std::end(kTexts), extension) != std::end(kTexts);
}

ReadCloud read_cloud_file(const std::filesystem::path& path, std::int64_t stamp_ns, CloudFormat format,
                          PointTimes times) {
  std::string bytes = read_regular_file(path);
  switch (format == CloudFormat::Auto ? recognise(bytes, path) : format) {
    case CloudFormat::Ply:
      return parse_ply(bytes, path, stamp_ns, times);
    case CloudFormat::Las:
      return parse_las(bytes, path, stamp_ns, times);
    case CloudFormat::KittiBin:
      return parse_bin(bytes, path);
    case CloudFormat::NuscenesBin:
      return parse_bin(bytes, path, 5);
    case CloudFormat::Text:
      return parse_text_cloud(utf8_text(std::move(bytes)), path, stamp_ns, times);
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

namespace {

/// x, y, z, intensity and, where it is asked for, the ring; 0 for what the cloud has not.
void write_floats(const std::filesystem::path& path, const cloud::PointCloud& cloud, bool with_ring) {
  check_columns(cloud);
  std::string bytes;
  bytes.reserve(cloud.size() * (with_ring ? 20 : 16));
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) append_bytes(bytes, cloud.points[i][axis]);
    append_bytes(bytes, cloud.intensity.empty() ? 0.0f : cloud.intensity[i]);
    if (with_ring) append_bytes(bytes, cloud.ring.empty() ? 0.0f : static_cast<float>(cloud.ring[i]));
  }
  write_file(path, bytes);
}

}  // namespace

void write_kitti_bin(const std::filesystem::path& path, const cloud::PointCloud& cloud) {
  write_floats(path, cloud, false);
}

void write_nuscenes_bin(const std::filesystem::path& path, const cloud::PointCloud& cloud) {
  write_floats(path, cloud, true);
}

}  // namespace remount::formats
