// A recorded drive: immutable once opened; scans are read when asked for.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "algorithms/cloud/beam_options.h"
#include "algorithms/cloud/point_cloud.h"
#include "algorithms/messages/message.h"
#include "algorithms/motion/ins_sample.h"
#include "algorithms/motion/sensor_samples.h"
#include "model/drive/attitude_convention.h"
#include "model/drive/finding.h"
#include "model/drive/topic_choice.h"

namespace remount::drive {

/// How the points of a scan relate to the time of its stamp.
enum class ScanTiming {
  Instant,       ///< already compensated, or taken at once
  PerPoint,      ///< time_from_stamp_s is filled
  SweepAzimuth,  ///< one turn; time follows from the azimuth (see SweepModel)
  Unknown,       ///< no times, and nothing says that the scans are compensated: see sweep_trial.h
};

/// Which way the times of points count. Some drivers write how long ago a point was measured, seen from the stamp.
enum class TimesCount {
  Forwards,
  Backwards,
  Open,  ///< the sensor would turn the other way than its points are stored, or than sensors do: see sweep_trial.h
};

/// A spinning sensor's turn, in either direction: time_from_stamp = (angle turned since `stamp_azimuth_rad`) / 2 pi *
/// period, in (-period/2, period/2]. Of a sensor that does not spin, points in the order in which they were measured.
struct SweepModel {
  double period_s = 0.1;
  double stamp_azimuth_rad = 0.0;  ///< azimuth (atan2(y, x)) that the sensor faces at the stamp
  bool clockwise = true;           ///< the direction of the turn, seen from above
  bool certain = true;             ///< false: the format does not say whether scans are already compensated
  bool direction_known = true;     ///< false: the format does not say which way the sensor turns
  bool by_order = false;           ///< times follow from the order of the points instead, evenly over the period
  /// Of a trial only: times follow from those of the points, counted so.
  std::optional<TimesCount> by_times = {};
};

/// The scans of a session. load() is thread-safe and throws Error where a scan cannot be read.
class ScanSource {
 public:
  virtual ~ScanSource() = default;
  virtual std::size_t size() const = 0;
  virtual std::int64_t stamp_ns(std::size_t scan) const = 0;  ///< Unix time on the lidar clock; ascending
  virtual std::string name(std::size_t scan) const = 0;       ///< file name, for messages
  virtual cloud::PointCloud load(std::size_t scan) const = 0;
};

/// A topic of a bag, or one of several LiDARs of another recording.
struct SessionTopic {
  std::string name, type;            ///< "/points", "sensor_msgs/PointCloud2"
  std::size_t count = 0;             ///< 0 as well where it can be something and nobody has counted
  double rate_hz = 0.0;              ///< from the median step; 0 where there are fewer than two messages
  std::vector<std::string> can_be;   ///< roles of kTopicRoles
  std::vector<std::string> used_as;  ///< roles that it has in this session
};

/// One drive. Motion of the INS is either geodetic samples (`ins`) or poses in a metric world (`world_from_ins`);
/// motion of the lidar comes either from scans or from poses of somebody's odometry (`odometry_from_lidar`).
struct Session {
  std::string name;                    ///< for lists: the folder or file name
  std::filesystem::path path;          ///< what was opened
  std::string format;                  ///< id of the reader, "kitti-raw"
  std::vector<motion::InsSample> ins;  ///< ascending stamps; empty where world_from_ins is given
  /// Stamps of the samples of `ins` or `world_from_ins` whose positions were measured: where an orientation comes more
  /// often than the fixes that go with it, positions between these are interpolated. Empty: all were measured.
  std::vector<std::int64_t> ins_fix_stamps_ns;
  std::vector<motion::StampedPose> world_from_ins;
  std::vector<motion::StampedPose> odometry_from_lidar;
  /// Stamps of the poses among these whose motion since the pose before is a guess; ascending. No pair spans one.
  std::vector<std::int64_t> odometry_breaks_ns;
  std::shared_ptr<const ScanSource> scans;  ///< null where odometry_from_lidar is given
  /// The same with the errors of the LiDAR's beams, where `scans` come without those that are known; else null.
  std::shared_ptr<const ScanSource> scans_as_recorded;
  // What other methods than the pairwise one live on; each ascending in time, empty where the drive has none.
  std::vector<motion::ImuSample> imu;
  std::vector<motion::GnssFix> gnss;
  std::vector<motion::WheelSample> wheels;
  std::vector<motion::BarometerSample> barometer;
  ScanTiming scan_timing = ScanTiming::Instant;
  TimesCount times_count = TimesCount::Forwards;  ///< with ScanTiming::PerPoint
  SweepModel sweep;
  cloud::LidarKind lidar = cloud::LidarKind::Unknown;
  /// How motion within the scans is compensated is the best guess of several: no clock is to be told from them.
  bool scan_timing_open = false;
  /// Of the INS frame in which X is expressed; nothing: as a pose file defines them, which does not say.
  std::optional<InsAxes> ins_axes = InsAxes::ForwardLeftUp;
  bool ins_axes_by_travel = false;  ///< told by the direction of travel, against what the format has or says
  /// Errors of the INS as the data declare them; NaN where they do not. White: independent from sample to sample.
  double ins_position_white_sigma_m = std::numeric_limits<double>::quiet_NaN();
  double ins_attitude_white_sigma_rad = std::numeric_limits<double>::quiet_NaN();
  /// Constant over the drive (misalignment, slow heading error); NaN where the data do not declare it.
  double ins_attitude_bias_sigma_rad = std::numeric_limits<double>::quiet_NaN();
  /// 1-sigma of how much older positions of the INS may be than its attitudes, where they come in messages of different
  /// times; 0: both are of one moment.
  double ins_position_lag_sigma_s = 0.0;
  /// Errors that walk randomly, growing with the root of time; NaN where the data do not declare them.
  double ins_position_drift = std::numeric_limits<double>::quiet_NaN();  ///< m per root of a second
  double ins_attitude_drift = std::numeric_limits<double>::quiet_NaN();  ///< rad per root of a second
  /// 1-sigma of an angle about the vertical by which positions and attitudes of world_from_ins may count from different
  /// norths, that of a grid and the true one; no residual shows it.
  double ins_north_sigma_rad = 0.0;
  /// 1-sigma of roll and pitch of world_from_ins, and of its heights, where nobody measured them; 0: they were
  /// measured.
  double ins_tilt_sigma_rad = 0.0;
  double unmeasured_height_sigma_m = 0.0;
  /// The source of world_from_ins is known to give attitudes to true north, whatever its positions count from.
  bool attitudes_to_true_north = false;
  std::string world_frame;  ///< of world_from_ins as its source names it, "utm"; empty: it does not
  /// Stamps of `ins` were made of GPS time by the reader, leap seconds of that time included.
  bool ins_stamps_from_gps = false;
  /// The log of `ins` counts the seconds of a GPS week and does not say of which: stamps are of week 0, in 1980, until
  /// conventions::place_in_week finds the week.
  bool ins_week_open = false;
  std::optional<RigidTransform> nominal_ins_from_lidar;
  std::vector<SessionTopic> topics;  ///< of a bag, all of them; several LiDARs of other formats; else empty
  TopicChoice topic_choice;          ///< what was asked for; the other roles are suggestions
  /// Which LiDAR of the recording this is: "front", of a bag its topic; empty where the format names none.
  std::string lidar_name;
  std::vector<Finding> findings;             ///< of the reader: skipped lines, clock trouble, gaps
  std::vector<std::filesystem::path> files;  ///< what was read, for provenance hashes
};

/// For messages: what was opened, or the name of a session that was made in memory.
inline std::string path_or_name(const Session& session) {
  return session.path.empty() ? session.name : session.path.string();
}

}  // namespace remount::drive
