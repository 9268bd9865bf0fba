// Bags of a drive, stream by stream.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>

#include "algorithms/geometry/rotation.h"
#include "tests/model/formats/bags/bag_fixtures.h"

namespace remount::bags {

inline constexpr MessageEncoding kRos1 = MessageEncoding::Ros1;
inline constexpr std::int64_t kStep_ns = 100'000'000;

/// What a bag for these tests holds; topics are added by name and written in the order of their log times.
class BagMaker {
 public:
  explicit BagMaker(const fs::path& path, ChunkCompression compression = ChunkCompression::Lz4)
      : BagMaker(make_rosbag1_writer(path, compression, 4000)) {}
  explicit BagMaker(std::unique_ptr<BagWriter> writer) : writer_(std::move(writer)) {}
  MessageEncoding encoding() const { return writer_->encoding(); }
  virtual ~BagMaker() = default;
  void add(std::int64_t log_time_ns, const std::string& topic, const std::string& type, std::string bytes) {
    messages_.push_back({log_time_ns, topic, type, std::move(bytes)});
  }
  void finish() {
    std::stable_sort(messages_.begin(), messages_.end(),
                     [](const Message& a, const Message& b) { return a.log_time_ns < b.log_time_ns; });
    std::map<std::string, std::uint32_t> ids;
    for (const Message& message : messages_) {
      if (!ids.contains(message.topic))
        ids[message.topic] = writer_->add_topic(message.topic, definition_of(message.type));
      writer_->write(ids[message.topic], message.log_time_ns, message.bytes);
    }
    writer_->finish();
  }

  /// Scans that last nine tenths of their period.
  void add_scans(const std::string& topic, int count, int points, bool timed = true, std::int64_t clock_ns = 0,
                 std::int64_t period_ns = kStep_ns, std::int64_t delay_ns = 20'000'000,
                 const std::string& frame = "lidar") {
    for (int i = 0; i < count; ++i) {
      cloud::PointCloud cloud;
      for (int k = 0; k < points; ++k) {
        cloud.points.emplace_back(static_cast<float>(k + 1), static_cast<float>(i), 1.0f);
        if (timed)
          cloud.time_from_stamp_s.push_back(9e-10f * static_cast<float>(period_ns) * static_cast<float>(k) /
                                            static_cast<float>(points));
      }
      const std::int64_t stamp_ns = kStart_ns + i * period_ns;
      add(stamp_ns + delay_ns, topic, "sensor_msgs/PointCloud2",
          cloud_message(cloud, stamp_ns + clock_ns, frame, kRos1));
    }
  }
  /// A circle driven at 5 m/s; INS axes x forward.
  void add_ins(const std::string& device, int count, std::int64_t clock_ns = 0, std::int64_t delay_ns = 10'000'000) {
    for (int i = 0; i < count; ++i) {
      motion::InsSample sample = on_circle(i);
      const std::int64_t log_ns = sample.stamp_ns + delay_ns;
      sample.stamp_ns += clock_ns;
      add(log_ns, device + "/imu", "sensor_msgs/Imu", attitude_message(sample, 0.001, "ins", kRos1));
      motion::GnssFix fix{sample.stamp_ns, sample.latitude_rad, sample.longitude_rad, sample.height_m, {}};
      fix.covariance_enu_m2 = 0.0004 * Eigen::Matrix3d::Identity();
      add(log_ns, device + "/fix", "sensor_msgs/NavSatFix", fix_message(fix, 2, "ins", kRos1));
    }
  }
  /// @param stamped false: the headers have no stamps
  void add_odometry(const std::string& topic, int count, bool stamped = true) {
    for (int i = 0; i < count; ++i) {
      MessageWriter writer(kRos1);
      const double yaw = 0.05 * i;
      writer.header(stamped ? kStart_ns + i * kStep_ns / 2 : 0, "map").string("base");
      for (const double value :
           {10.0 * std::cos(yaw), 10.0 * std::sin(yaw), 0.0, 0.0, 0.0, std::sin(yaw / 2.0), std::cos(yaw / 2.0)})
        writer.number(value);
      for (int k = 0; k < 36 + 6 + 36; ++k) writer.number(0.0);
      add(kStart_ns + i * kStep_ns / 2, topic, "nav_msgs/Odometry", writer.bytes());
    }
  }
  /// INSPVAX of novatel_oem7_driver on the circle. @param every of its places, which are 50 ms apart
  /// @param weeks_back by which the receiver counts too few
  void add_inspvax(const std::string& topic, int count, int every, std::uint32_t position_type = 56, int first = 0,
                   int weeks_back = 0) {
    constexpr std::int64_t kStartOfDrive_ms = 44'818'000;  // kStart_ns
    for (int i = first; i < first + count; ++i) {
      const motion::InsSample sample = on_circle(i * every);
      const std::int64_t since_ns = sample.stamp_ns - kStart_ns;
      MessageWriter writer(kRos1);
      writer.header(sample.stamp_ns, "gps").string("INSPVAX").number<std::uint16_t>(1465).number<std::uint8_t>(0);
      writer.number<std::uint32_t>(0).number<std::uint8_t>(180).number(static_cast<std::uint16_t>(2123 - weeks_back));
      writer.number(static_cast<std::uint32_t>(kStartOfDrive_ms + since_ns / 1'000'000));
      writer.number<std::uint32_t>(3).number(position_type);
      writer.number(radians_to_degrees(sample.latitude_rad)).number(radians_to_degrees(sample.longitude_rad));
      writer.number(sample.height_m).number(0.0f);
      for (int k = 0; k < 3 + 2; ++k) writer.number(0.0);  // velocity, roll, pitch
      writer.number(360.0 - radians_to_degrees(std::fmod(0.05 * i * every, 2.0 * kPi)));
      for (int k = 0; k < 9; ++k) writer.number(0.02f);
      add(sample.stamp_ns + 10'000'000, topic, "novatel_oem7_msgs/INSPVAX", writer.bytes());
    }
  }
  /// INSPVA of novatel_oem7_driver on the circle, at its places.
  void add_inspva(const std::string& topic, int count, int weeks_back = 0) {
    for (int i = 0; i < count; ++i) {
      const motion::InsSample sample = on_circle(i);
      MessageWriter writer(kRos1);
      writer.header(sample.stamp_ns, "gps").string("INSPVA").number<std::uint16_t>(507).number<std::uint8_t>(0);
      writer.number<std::uint32_t>(0).number<std::uint8_t>(180).number(static_cast<std::uint16_t>(2123 - weeks_back));
      writer.number(static_cast<std::uint32_t>(44'818'000 + (sample.stamp_ns - kStart_ns) / 1'000'000));
      writer.number(radians_to_degrees(sample.latitude_rad)).number(radians_to_degrees(sample.longitude_rad));
      writer.number(sample.height_m);
      for (int k = 0; k < 3 + 2; ++k) writer.number(0.0);  // velocity, roll, pitch
      writer.number(360.0 - radians_to_degrees(std::fmod(0.05 * i, 2.0 * kPi))).number<std::uint32_t>(3);
      add(sample.stamp_ns + 10'000'000, topic, "novatel_oem7_msgs/INSPVA", writer.bytes());
    }
  }
  /// INSSTDEV of novatel_oem7_driver. @param every of the places of the circle
  void add_insstdev(const std::string& topic, int count, int every, double sigma_m) {
    for (int i = 0; i < count; ++i) {
      const std::int64_t stamp_ns = on_circle(i * every).stamp_ns;
      add(stamp_ns + 10'000'000, topic, "novatel_oem7_msgs/INSSTDEV",
          insstdev_message(stamp_ns, Eigen::Vector3d::Constant(sigma_m), 0.01, "gps", kRos1));
    }
  }
  /// Odometry whose orientation nobody fills in: four times `value`.
  void add_unoriented(const std::string& topic, int count, double value = 0.0) {
    for (int i = 0; i < count; ++i) {
      MessageWriter writer(kRos1);
      writer.header(kStart_ns + i * kStep_ns / 2, "map").string("base");
      for (const double number : {1.0 * i, 0.0, 0.0, value, value, value, value}) writer.number(number);
      for (int k = 0; k < 36 + 6 + 36; ++k) writer.number(0.0);
      add(kStart_ns + i * kStep_ns / 2, topic, "nav_msgs/Odometry", writer.bytes());
    }
  }
  /// What an Imu says: variances of -1 stand for "not measured".
  struct ImuContent {
    Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
    double orientation_variance = 0.0;
    Eigen::Vector3d rate = Eigen::Vector3d::Zero();
    double rate_variance = 0.0;
  };
  void add_imu(const std::string& topic, int i, const ImuContent& content) {
    MessageWriter writer(kRos1);
    writer.header(kStart_ns + i * kStep_ns / 2, "imu");
    for (const double value : content.orientation.coeffs()) writer.number(value);
    const auto covariance = [&](double variance) {
      for (int k = 0; k < 9; ++k) writer.number(k % 4 == 0 && (variance > 0.0 || k == 0) ? variance : 0.0);
    };
    covariance(content.orientation_variance);
    for (const double value : content.rate) writer.number(value);
    covariance(content.rate_variance);
    for (const double value : {0.0, 0.0, 9.8}) writer.number(value);
    covariance(content.rate_variance);
    add(kStart_ns + i * kStep_ns / 2 + 10'000'000, topic, "sensor_msgs/Imu", writer.bytes());
  }
  /// One fix of the circle. @param stated whether it states its covariance
  void add_fix(const std::string& topic, int i, int status, bool stated = true) {
    const motion::InsSample sample = on_circle(i);
    motion::GnssFix fix{sample.stamp_ns, sample.latitude_rad, sample.longitude_rad, sample.height_m, {}};
    fix.covariance_enu_m2 = Eigen::Matrix3d::Identity() * (stated ? 0.0004 : std::nan(""));
    add(sample.stamp_ns + 10'000'000, topic, "sensor_msgs/NavSatFix", fix_message(fix, status, "gps", kRos1));
  }
  void add_static_transform(const std::string& parent, const std::string& child, double x_m) {
    MessageWriter writer(kRos1);
    writer.number<std::uint32_t>(1).header(kStart_ns, parent).string(child);
    for (const double value : {x_m, 0.0, 1.5, 0.0, 0.0, 0.0, 1.0}) writer.number(value);
    add(kStart_ns, "/tf_static", "tf2_msgs/TFMessage", writer.bytes());
  }

  static motion::InsSample on_circle(int i) {
    motion::InsSample sample;
    sample.stamp_ns = kStart_ns + i * kStep_ns / 2;
    const double yaw = 0.05 * i, radius_rad = 5.0 / 6.378e6;
    sample.latitude_rad = 0.7 + radius_rad * std::sin(yaw);
    sample.longitude_rad = 0.2 + radius_rad * std::cos(yaw) / std::cos(0.7);
    sample.height_m = 100.0;
    sample.enu_from_ins = Eigen::AngleAxisd(yaw + kPi / 2.0, Eigen::Vector3d::UnitZ());
    return sample;
  }

 private:
  struct Message {
    std::int64_t log_time_ns = 0;
    std::string topic, type, bytes;
  };
  virtual MessageDefinition definition_of(const std::string& type) const { return definition(type); }
  std::unique_ptr<BagWriter> writer_;
  std::vector<Message> messages_;
};

}  // namespace remount::bags
