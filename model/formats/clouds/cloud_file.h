// One door to every format of a single scan.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "algorithms/cloud/point_cloud.h"
#include "algorithms/messages/message.h"

namespace remount::formats {

enum class CloudFormat { Auto, Pcd, Ply, KittiBin, NuscenesBin, Text, Las };

/// What times of points are read for.
enum class PointTimes {
  Used,    ///< a point that is of no time of the scan is left out
  Unused,  ///< no point is left out for its time; where some are of no time of the scan, the times are
};

/// A scan, with what is to be known of its times.
struct ReadCloud {
  cloud::PointCloud cloud;
  /// The points' own times are neither from the stamp on nor on its clock. They are taken from the scan's first point
  /// on then, as if that had been taken at the stamp.
  bool points_have_another_clock = false;
  /// Of a scan that was read without its stamp: the earliest time of a point (Unix time), where times are dates to a
  /// microsecond or better.
  std::optional<std::int64_t> first_point_ns{};
  std::string columns{};  ///< names of what the file has, for messages: "x y z intensity"
  /// What is to be said of the columns beside their names; null where nothing is.
  Message (*note)(std::string columns) = nullptr;

  Message columns_words() const { return note != nullptr ? note(columns) : Message::verbatim(columns); }
};

/// Reads a scan: PCD (ascii, binary, binary_compressed), PLY (ascii, binary of either byte order), LAS and LAZ, .bin of
/// 3 to 6 floats a point, or text of a point a line. Auto decides by content, then by extension. Points that are not
/// finite, at zero range or of no time of the scan are left out and counted. Per-point times are taken relative to
/// `stamp_ns` (Unix time of the scan; 0: not known), see find_time_scale. Throws Error naming file and line or byte,
/// and Error(Unsupported) for coordinates of a map.
ReadCloud read_cloud_file(const std::filesystem::path& path, std::int64_t stamp_ns,
                          CloudFormat format = CloudFormat::Auto, PointTimes times = PointTimes::Used);
/// Its points alone.
cloud::PointCloud load_cloud(const std::filesystem::path& path, std::int64_t stamp_ns,
                             CloudFormat format = CloudFormat::Auto);

/// Binary PCD with x y z and those of intensity, ring (16 bits) and time (seconds from the stamp, float) that are
/// there.
void write_pcd(const std::filesystem::path& path, const cloud::PointCloud& cloud);

/// LAS 1.2 with intensity, of which 0 to 1 becomes 0 to 65535, and GPS time where the cloud has times from `stamp_ns`
/// (Unix time). Points to 0.1 mm, times to a microsecond; rings are lost.
void write_las(const std::filesystem::path& path, const cloud::PointCloud& cloud, std::int64_t stamp_ns);

/// A CSV with a line of names, as write_pcd: x, y, z, intensity, ring, time_s; numbers read back as the same floats.
void write_text_cloud(const std::filesystem::path& path, const cloud::PointCloud& cloud);

/// Whether the name is one that scans in text have: .txt, .xyz, .asc, .pts, .csv.
bool is_text_cloud_name(const std::filesystem::path& path);

/// KITTI: x, y, z, intensity as little-endian floats; intensity 0 where the cloud has none. Ring and time are lost.
void write_kitti_bin(const std::filesystem::path& path, const cloud::PointCloud& cloud);

/// nuScenes: the ring behind these as a fifth float; 0 where the cloud has none.
void write_nuscenes_bin(const std::filesystem::path& path, const cloud::PointCloud& cloud);

}  // namespace remount::formats
