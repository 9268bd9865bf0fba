// Messages of Apollo from values: what apollo_messages.h reads.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "model/formats/bags/apollo_messages.h"
#include "model/formats/bags/message_writer.h"

namespace remount::bags {

/// How a channel of a type is described: by the name of the type alone.
MessageDefinition apollo_definition(std::string_view type);

/// apollo.drivers.PointCloud as drivers make it: measured when its last point was. Intensities of 0 to 1 become 0 to
/// 255; rings are lost.
std::string apollo_cloud_message(const cloud::PointCloud& cloud, std::int64_t stamp_ns, std::string_view frame);

/// What a pose of Apollo says.
struct ApolloPoseContent {
  std::int64_t stamp_ns = 0;
  Eigen::Vector3d utm_m = Eigen::Vector3d::Zero();
  Eigen::Quaterniond enu_from_vehicle = Eigen::Quaterniond::Identity();  ///< of x right, y forward, z up
};
/// apollo.localization.Gps: stamped by its header.
std::string apollo_gps_message(const ApolloPoseContent& content);
/// apollo.localization.LocalizationEstimate, published so long after it was measured.
std::string apollo_localization_message(const ApolloPoseContent& content, std::int64_t late_ns);
/// apollo.drivers.gnss.InsStat. @param position_type NovAtel's: 56 fixed, 55 floating
std::string apollo_status_message(std::int64_t stamp_ns, unsigned position_type);
/// apollo.drivers.gnss.GnssBestPose, with its time of measurement as GPS time. @param type of the solution, as above:
/// 50
std::string apollo_fix_message(const motion::GnssFix& fix, unsigned type);
/// apollo.transform.TransformStampeds.
std::string apollo_transforms_message(const std::vector<PoseMessage>& parent_from_child);

}  // namespace remount::bags
