// What the readers of point clouds share: scalar types, which column means what, and time columns of any kind.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "model/io/cloud_file.h"
#include "model/io/point_times.h"

namespace remount {

std::size_t size_of(ScalarType type);

/// One scalar at `bytes`, swapped where the file's byte order is not the machine's.
double read_scalar(const char* bytes, ScalarType type, bool swap_bytes);

/// A named column of a cloud.
struct CloudField {
  std::string name;  ///< lower case
  ScalarType type = ScalarType::F32;
  std::size_t count = 1;   ///< values in this column for each point
  std::size_t offset = 0;  ///< bytes from the start of the point (of the value list in text)
};

/// Indices into the list of fields; -1 where there is none.
struct CloudColumns {
  int x = -1, y = -1, z = -1, intensity = -1, ring = -1, time = -1;
};

/// Columns by name in any case: x y z; intensity, i, reflectivity, reflectance, remission; ring, channel, laser_id,
/// line; time, t, timestamp, time_stamp, offset_time. Throws Error(Format) where x, y or z is missing or has several
/// values.
CloudColumns find_cloud_columns(const std::vector<CloudField>& fields, const std::string& where);

/// Of points that are stored as bytes. Throws Error(Format) where x, y or z has one byte alone: no sensor writes that,
/// and the cloud would take many times the memory of its file.
void refuse_narrow_coordinates(const std::vector<CloudField>& fields, const CloudColumns& columns,
                               const std::string& where);

/// One point as the file gives it. Columns that are absent are ignored.
struct RawPoint {
  double x = 0.0, y = 0.0, z = 0.0;
  double intensity = 0.0, ring = 0.0, time = 0.0;
};

/// Collects points: leaves out those that are not finite, at zero range or of no time of the scan and counts them, and
/// turns the time column into seconds from the scan's stamp when all are there.
class CloudBuilder {
 public:
  /// @param expected_points memory is taken for so many; bounded by the caller by what the file can hold
  CloudBuilder(const CloudColumns& columns, const TimeColumn& time, std::size_t expected_points);
  void add(const RawPoint& point);

  /// Units and clocks of time columns: see find_time_scale.
  ReadCloud finish(std::int64_t stamp_ns);

 private:
  double time_at(std::size_t i) const { return times_.empty() ? cloud_.time_from_stamp_s[i] : times_[i]; }
  std::size_t move_point(std::size_t from, std::size_t to);
  void cut_to(std::size_t points);

  CloudColumns columns_;
  TimeColumn time_;
  PointCloud cloud_;
  std::vector<double> times_;  ///< as the column has them; those of up to two bytes fit where their result goes
};

/// Readers of the single formats; `bytes` is the whole file and `path` serves for messages. Errors name path and line
/// or byte. Memory taken is bounded by a small multiple of the file's size.
ReadCloud parse_pcd(std::string_view bytes, const std::filesystem::path& path, std::int64_t stamp_ns);
ReadCloud parse_ply(std::string_view bytes, const std::filesystem::path& path, std::int64_t stamp_ns);
/// LAS 1.2 to 1.4 in the frame of the sensor, with intensity and GPS time; classes and returns are not used.
ReadCloud parse_las(std::string_view bytes, const std::filesystem::path& path, std::int64_t stamp_ns);
/// KITTI: x, y, z, reflectance as little-endian 32-bit floats.
PointCloud parse_kitti_bin(std::string_view bytes, const std::filesystem::path& path);
/// KITTI extract: x y z reflectance as text, one point a line.
PointCloud parse_xyzi_text(std::string_view bytes, const std::filesystem::path& path);

}  // namespace remount
