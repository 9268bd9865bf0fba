// What the readers of point clouds share: scalar types, which column means what, and time columns of any kind.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "model/formats/clouds/cloud_file.h"
#include "model/formats/clouds/point_times.h"

namespace remount::formats {

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

/// Columns by name in any case, with or without what CloudCompare sets before those of its scalar fields ("scalar_"):
/// x y z; intensity, i, reflectivity, reflectance, remission; ring, channel, laser_id, line; those of kTimeColumns.
/// Throws Error(Format) where x, y or z is missing or has several values.
CloudColumns find_cloud_columns(const std::vector<CloudField>& fields, const std::string& where);

/// Names of columns of times, the best first.
inline constexpr std::array<std::string_view, 21> kTimeColumns{"time",
                                                               "t",
                                                               "timestamp",
                                                               "time_stamp",
                                                               "offset_time",
                                                               "gpstime",
                                                               "gps_time",
                                                               "time_s",
                                                               "time_ms",
                                                               "time_us",
                                                               "time_ns",
                                                               "time_offset",
                                                               "time_offset_ns",
                                                               "point_time",
                                                               "offset_ns",
                                                               "offset_us",
                                                               "point_time_offset",
                                                               "point_time_offset_ns",
                                                               "timestamp_ns",
                                                               "offset_time_ns",
                                                               "t_ns"};

/// Type and unit of the column of times; a unit where the name ends in one ("offset_ns").
TimeColumn time_column(const std::vector<CloudField>& fields, const CloudColumns& columns);

/// "x y z intensity": the first of them, for messages.
std::string column_names(const std::vector<CloudField>& fields);

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
  /// The column of times turned out to say nothing: the cloud has none.
  void leave_out_times();

  /// Units and clocks of time columns: see find_time_scale. Throws Error(Unsupported) at `where` for coordinates of a
  /// map: no sensor has all of its returns so far away.
  ReadCloud finish(std::int64_t stamp_ns, const std::string& where, PointTimes times = PointTimes::Used);

 private:
  ReadCloud without_times();
  void refuse_map_coordinates(const std::string& where) const;
  double time_at(std::size_t i) const { return times_.empty() ? cloud_.time_from_stamp_s[i] : times_[i]; }
  std::size_t move_point(std::size_t from, std::size_t to);
  void cut_to(std::size_t points);

  CloudColumns columns_;
  TimeColumn time_;
  cloud::PointCloud cloud_;
  double farthest_m_ = 0.0;    ///< coordinate of all points, those that are no returns too
  double nearest2_m2_ = 1e60;  ///< squared distance of what was kept
  std::size_t beyond_ = 0;     ///< points that no sensor sees
  std::vector<double> times_;  ///< as the column has them; those of up to two bytes fit where their result goes
};

/// Readers of the single formats; `bytes` is the whole file and `path` serves for messages. Errors name path and line
/// or byte. Memory taken is bounded by a small multiple of the file's size.
ReadCloud parse_pcd(std::string_view bytes, const std::filesystem::path& path, std::int64_t stamp_ns,
                    PointTimes times = PointTimes::Used);
ReadCloud parse_ply(std::string_view bytes, const std::filesystem::path& path, std::int64_t stamp_ns,
                    PointTimes times = PointTimes::Used);
/// LAS 1.0 to 1.4, plain or compressed (LAZ), in the frame of the sensor, with intensity and GPS time; classes and
/// returns are not used.
ReadCloud parse_las(std::string_view bytes, const std::filesystem::path& path, std::int64_t stamp_ns,
                    PointTimes times = PointTimes::Used);
/// Little-endian 32-bit floats, 3 to 6 a point: x, y, z; with reflectance (KITTI); with the ring behind it (nuScenes);
/// with two more (Waymo), which are not used. How many is told by the numbers themselves: see bin_file.cpp. Throws
/// Error(Format) where no such layout makes a scan of them.
/// @param known_width floats a point, where the data say so; 0: they do not
ReadCloud parse_bin(std::string_view bytes, const std::filesystem::path& path, std::size_t known_width = 0);
/// Text, a point a line, apart by blanks, commas or semicolons; metres. Columns by their names, where a line of them
/// stands above the numbers (with or without '#', '//' or '%'; units in brackets), else x y z, with four or, as PTS has
/// them, seven numbers the intensity behind these. The count that PTS has in its first line is passed over.
ReadCloud parse_text_cloud(std::string_view bytes, const std::filesystem::path& path, std::int64_t stamp_ns,
                           PointTimes times = PointTimes::Used);

/// Throws Error(Contract) where the columns of a cloud that is to be written differ in length.
void check_columns(const cloud::PointCloud& cloud);

}  // namespace remount::formats
