// What the readers of point clouds share: scalar types, which column means what, and time columns of any kind.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "algorithms/cloud/point_cloud.h"

namespace remount {

enum class ScalarType { I8, U8, I16, U16, I32, U32, I64, U64, F32, F64 };
std::size_t size_of(ScalarType type);

/// One scalar at `bytes`, swapped where the file's byte order is not the machine's.
double read_scalar(const char* bytes, ScalarType type, bool swap_bytes);

/// A named column of a cloud file with its unsigned-integer-ness, which decides the unit of a time column.
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

/// One point as the file gives it. Columns that are absent are ignored.
struct RawPoint {
  double x = 0.0, y = 0.0, z = 0.0;
  double intensity = 0.0, ring = 0.0, time = 0.0;
};

/// Collects points: leaves out those that are not finite or at zero range and counts them, and turns the time column
/// into seconds from the scan's stamp when all are there.
class CloudBuilder {
 public:
  /// @param expected_points memory is taken for so many; bounded by the caller by what the file can hold
  CloudBuilder(const CloudColumns& columns, ScalarType time_type, std::size_t expected_points);
  void add(const RawPoint& point);

  /// Time columns hold seconds, milliseconds, microseconds or nanoseconds, absolute or relative; formats do not say
  /// which. Absolute: all values above 1e6 and close together; the unit follows from their size, and they become
  /// relative to `stamp_ns`, after taking out a time zone (a whole number of half hours, up to 14 h: file names are
  /// often local time); to the first point where the stamp is 0 or still differs by more than a minute: another clock.
  /// Relative: 32-bit unsigned integers are nanoseconds (Ouster `t`, Livox `offset_time`); otherwise the unit
  /// is the one that makes the scan shorter than two seconds.
  PointCloud finish(std::int64_t stamp_ns);

 private:
  CloudColumns columns_;
  ScalarType time_type_;
  PointCloud cloud_;
  std::vector<double> times_;
};

/// Readers of the single formats; `bytes` is the whole file and `path` serves for messages. Errors name path and line
/// or byte. Memory taken is bounded by a small multiple of the file's size.
PointCloud parse_pcd(std::string_view bytes, const std::filesystem::path& path, std::int64_t stamp_ns);
PointCloud parse_ply(std::string_view bytes, const std::filesystem::path& path, std::int64_t stamp_ns);
/// LAS 1.2 to 1.4 in the frame of the sensor, with intensity and GPS time; classes and returns are not used.
PointCloud parse_las(std::string_view bytes, const std::filesystem::path& path, std::int64_t stamp_ns);
/// KITTI: x, y, z, reflectance as little-endian 32-bit floats.
PointCloud parse_kitti_bin(std::string_view bytes, const std::filesystem::path& path);
/// KITTI extract: x y z reflectance as text, one point a line.
PointCloud parse_xyzi_text(std::string_view bytes, const std::filesystem::path& path);

}  // namespace remount
