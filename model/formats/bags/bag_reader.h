// Bags of ROS as sessions, without ROS, and records of Apollo's Cyber, which are as bags.
#pragma once

#include "model/drive/topic_offer.h"
#include "model/formats/bags/bag_file.h"
#include "model/formats/sessions/session_reader.h"

namespace remount::bags {

/// Opens a bag, or a folder that holds one. The streams of the INS are read when it is opened, scans when they are
/// asked for, by the index.
///
/// INS, as ROS's conventions (REP 103, REP 105) have it: poses of an Odometry, PoseStamped, PoseWithCovarianceStamped
/// or TransformStamped as they are; an Imu whose orientation is relative to east, north and up, at the positions and
/// stamps of a NavSatFix; or INSPVAX, in NovatelReader's conventions. INS axes are x forward, y left, z up for Odometry
/// and Imu, and not known for the other poses.
/// Stamps are those of the messages' headers. Where the INS is of another clock than the LiDAR (more than half a second
/// apart by the recorder's, beside what a scan lasts), it is moved to the LiDAR's: finding "clock-moved"; what is apart
/// by less, but more than by delays, is finding "host-clock".
/// Static transforms between the frames of the two give the nominal mounting.
class BagReader : public formats::SessionReader {
 public:
  std::string_view id() const override { return "ros-bag"; }
  Message description() const override;
  int probe(const std::filesystem::path& path) const override;
  drive::Session open(const std::filesystem::path& path, Progress& progress) const override;
  drive::Session open_topics(const std::filesystem::path& path, const drive::TopicChoice& topics,
                             Progress& progress) const override;
  std::optional<drive::TopicOffer> offer_topics(const std::filesystem::path& path, Progress& progress) const override;
  /// Every topic that is a LiDAR without being asked to be; poses are not.
  std::vector<drive::LidarOffer> offer_lidars(const std::filesystem::path& path, Progress& progress) const override;

 protected:
  virtual std::shared_ptr<const BagFile> open_file(const std::filesystem::path& path, Progress& progress) const;
};

/// Opens a record, or a folder with one. Scans are those of PointCloud, each channel a LiDAR; the INS is Gps or
/// LocalizationEstimate, poses in UTM with INS axes x right, y forward, z up and attitudes to true north; GNSS is
/// GnssBestPose. Clouds of a compensator are scans that were taken at once, with a finding "scans-compensated".
class RecordReader final : public BagReader {
 public:
  std::string_view id() const override { return "apollo-record"; }
  Message description() const override;
  int probe(const std::filesystem::path& path) const override;

 protected:
  std::shared_ptr<const BagFile> open_file(const std::filesystem::path& path, Progress& progress) const override;
};

}  // namespace remount::bags
