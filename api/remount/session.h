// A recorded drive: opened from files, or made of what a reader of your own has read.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "remount/matrices.h"
#include "remount/progress.h"
#include "remount/settings.h"
#include "remount/text.h"

namespace remount::drive {
struct Session;
}  // namespace remount::drive

namespace remount::api {

enum class Severity { Note, Warning, Problem };
std::string_view to_string(Severity severity);  ///< "warning": as in files

/// What is suspicious about data or a result.
struct Finding {
  Severity severity = Severity::Note;
  std::string code;  ///< stays: "ins-gap"
  Text place;
  Text explanation;  ///< with what to do about it
};

/// What one sensor recorded.
struct Stream {
  std::string sensor;  ///< "lidar", "ins", "imu", "gnss", "wheels", "barometer"
  std::size_t count = 0;
  std::int64_t first_ns = 0, last_ns = 0;  ///< Unix time
  double rate_hz = 0.0;                    ///< from the median step; 0 where there are fewer than two
  std::size_t gaps = 0;                    ///< steps longer than three median steps
  double longest_gap_s = 0.0;
};

/// A scan chosen for calibration.
struct Keyframe {
  std::size_t session = 0, scan = 0;
  std::int64_t stamp_ns = 0;  ///< of the scan, on the LiDAR's clock
  double travelled_m = 0.0;   ///< since the session's start
};

/// What `pose` maps from and to is named by the variable that holds it.
struct Pose {
  std::int64_t stamp_ns = 0;  ///< Unix time
  Matrix4 pose = Matrix4::Identity();
};

/// One solution of a navigation system: geodetic position, and attitude relative to true north and the local level.
struct InsSample {
  std::int64_t stamp_ns = 0;  ///< Unix time, UTC
  double latitude_rad = 0.0, longitude_rad = 0.0;
  double height_m = 0.0;                                               ///< above the ellipsoid
  Vector4 enu_from_ins_xyzw = Vector4(0, 0, 0, 1);                     ///< quaternion; INS axes x forward, y left, z up
  double position_sigma_m = std::numeric_limits<double>::quiet_NaN();  ///< 1-sigma of each axis; NaN: not known
  double attitude_sigma_rad = std::numeric_limits<double>::quiet_NaN();  ///< likewise
};

/// Columns but the points are empty or as long as these.
struct Scan {
  std::vector<Eigen::Vector3f> points_in_lidar;  ///< m
  std::vector<float> time_from_stamp_s;
  std::vector<float> intensity;
  std::vector<std::uint16_t> ring;  ///< beam, 0 is the lowest
};

/// The scans of a reader of your own. `load` is called from several threads at once; a scan that it throws for is left
/// out, with a finding.
class ScanSource {
 public:
  virtual ~ScanSource();
  virtual std::size_t size() const = 0;
  virtual std::int64_t stamp_ns(std::size_t scan) const = 0;  ///< Unix time on the LiDAR's clock; ascending
  virtual std::string name(std::size_t scan) const { return std::to_string(scan); }  ///< for messages
  virtual Scan load(std::size_t scan) const = 0;
};

/// How the points of a scan relate to its stamp.
enum class ScanTimes {
  AtStamp,   ///< motion within the scan is compensated already, or it is taken at once
  PerPoint,  ///< time_from_stamp_s is filled
  Unknown,   ///< no times, and nothing says that scans are compensated: it is tried
};

/// What a reader of your own has read. Motion of the INS is `ins` or `world_from_ins`, that of the LiDAR comes from
/// `scans` or from the poses of an odometry. Stamps ascend.
struct Recording {
  std::string name;  ///< for lists and messages
  std::vector<InsSample> ins;
  std::vector<Pose> world_from_ins;  ///< in a metric world
  std::shared_ptr<const ScanSource> scans;
  ScanTimes scan_times = ScanTimes::AtStamp;
  std::vector<Pose> odometry_from_lidar;
  std::optional<Matrix4> nominal_ins_from_lidar;
  std::vector<std::filesystem::path> files;  ///< that were read, for the hashes in a result
};

struct OpenOptions {
  std::string lidar;                          ///< of a recording with several (lidars_of); empty: as it suggests
  std::map<std::string, std::string> topics;  ///< of a bag, by their roles: {"lidar", "/points"}
};

/// Immutable; copies are of the same session.
class Session {
 public:
  explicit Session(std::shared_ptr<const drive::Session> session);

  std::string name() const;
  std::filesystem::path path() const;  ///< empty where it was not opened from files
  std::string format() const;          ///< "kitti-raw"
  std::string lidar() const;           ///< which of several; empty where the format names none
  std::optional<Matrix4> nominal_ins_from_lidar() const;
  std::vector<Stream> sensors() const;  ///< those that it has
  std::vector<Finding> findings() const;
  /// The scans that a calibration would begin with under these settings.
  std::vector<Keyframe> keyframes(const Settings& settings = Settings()) const;
  std::size_t scan_count() const;
  std::int64_t scan_stamp_ns(std::size_t scan) const;
  /// As recorded. Throws Error(Contract) for one that is not there.
  Scan load_scan(std::size_t scan) const;
  /// local_from_ins in metres: local is east, north, up of the first sample, or the world of the poses.
  std::vector<Pose> local_from_ins() const;

  const std::shared_ptr<const drive::Session>& inside() const { return session_; }  ///< for Remount itself

 private:
  std::shared_ptr<const drive::Session> session_;
};

/// Of whatever format, recognised by its content. Throws Error(Unsupported) that says what is looked for.
Session open_session(const std::filesystem::path& path, const OpenOptions& options = {},
                     const Progress& progress = Progress());

/// The LiDARs of a recording, in its order; an empty name where it names none.
std::vector<std::string> lidars_of(const std::filesystem::path& path, const Progress& progress = Progress());

/// Looks at the data as open_session does. Throws Error(Contract) where stamps do not ascend or a pose is none.
Session make_session(const Recording& recording, const Progress& progress = Progress());

}  // namespace remount::api
