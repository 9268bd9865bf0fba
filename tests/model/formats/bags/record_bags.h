// Records of Cyber for tests, message by message.
#pragma once

#include <string>
#include <vector>

#include "algorithms/geodesy/geodesy.h"
#include "model/formats/bags/apollo_writer.h"
#include "model/formats/bags/record_file.h"
#include "tests/model/formats/bags/bag_maker.h"

namespace remount::bags {

inline constexpr const char *kApolloCloud = "apollo.drivers.PointCloud", *kApolloGps = "apollo.localization.Gps",
                            *kApolloEstimate = "apollo.localization.LocalizationEstimate",
                            *kApolloFix = "apollo.drivers.gnss.GnssBestPose",
                            *kApolloStat = "apollo.drivers.gnss.InsStat",
                            *kApolloTransforms = "apollo.transform.TransformStampeds";

inline std::shared_ptr<const BagFile> opened_record(const fs::path& path) {
  Progress progress;
  return open_record(path, progress);
}

/// Where the vehicle of BagMaker::on_circle is, as Apollo has it.
inline ApolloPoseContent apollo_on_circle(int i) {
  const motion::InsSample sample = BagMaker::on_circle(i);
  const geodesy::GridFix place =
      geodesy::UtmGrid(sample.latitude_rad, sample.longitude_rad).project(sample.latitude_rad, sample.longitude_rad);
  const Eigen::Quaterniond flu_from_rfu(Eigen::AngleAxisd(-0.5 * kPi, Eigen::Vector3d::UnitZ()));
  return {sample.stamp_ns, {place.easting_m, place.northing_m, sample.height_m}, sample.enu_from_ins * flu_from_rfu};
}

class RecordMaker : public BagMaker {
 public:
  explicit RecordMaker(const fs::path& path) : BagMaker(make_record_writer(path, 4000)) {}
  /// Scans that last nine tenths of 0.1 s, from a stamp of which the name says how late they are recorded.
  void add_clouds(const std::string& channel, int count, int points, const std::string& frame = "velodyne128",
                  bool timed = true) {
    for (int i = 0; i < count; ++i) {
      cloud::PointCloud cloud;
      for (int k = 0; k < points; ++k) {
        cloud.points.emplace_back(static_cast<float>(k + 1), static_cast<float>(i), 1.0f);
        cloud.intensity.push_back(0.5f);
        if (timed) cloud.time_from_stamp_s.push_back(0.09f * static_cast<float>(k) / static_cast<float>(points));
      }
      const std::int64_t stamp_ns = kStart_ns + i * kStep_ns;
      add(stamp_ns + 100'000'000, channel, kApolloCloud, apollo_cloud_message(cloud, stamp_ns, frame));
    }
  }
  void add_gps(int count, const std::string& channel = "/apollo/sensor/gnss/odometry") {
    for (int i = 0; i < count; ++i) {
      const ApolloPoseContent content = apollo_on_circle(i);
      add(content.stamp_ns + 5'000'000, channel, kApolloGps, apollo_gps_message(content));
    }
  }
  void add_estimates(int count, const std::string& channel = "/apollo/localization/pose") {
    for (int i = 0; i < count; ++i) {
      const ApolloPoseContent content = apollo_on_circle(i);
      add(content.stamp_ns + 6'000'000, channel, kApolloEstimate, apollo_localization_message(content, 6'000'000));
    }
  }

 private:
  MessageDefinition definition_of(const std::string& type) const override { return apollo_definition(type); }
};

}  // namespace remount::bags
