#include "model/formats/bags/apollo_writer.h"

#include <algorithm>
#include <cmath>

#include "algorithms/geometry/rotation.h"
#include "model/formats/bags/proto_reader.h"
#include "model/formats/files/time_stamp.h"

namespace remount::bags {
namespace {

double seconds_of(std::int64_t stamp_ns) {
  constexpr std::int64_t kSecond_ns = 1'000'000'000;
  return static_cast<double>(stamp_ns / kSecond_ns) + 1e-9 * static_cast<double>(stamp_ns % kSecond_ns);
}

std::string header_at(std::int64_t stamp_ns) { return ProtoWriter().real(1, seconds_of(stamp_ns)).message(); }

std::string vector_of(const Eigen::Vector3d& v) {
  return ProtoWriter().real(1, v.x()).real(2, v.y()).real(3, v.z()).message();
}

std::string quaternion_of(const Eigen::Quaterniond& q) {
  return ProtoWriter().real(1, q.x()).real(2, q.y()).real(3, q.z()).real(4, q.w()).message();
}

/// apollo.localization.Pose. Its heading counts from east, counter-clockwise.
std::string pose_of(const ApolloPoseContent& content) {
  const Eigen::Vector3d ahead = content.enu_from_vehicle * Eigen::Vector3d::UnitY();
  return ProtoWriter()
      .bytes(1, vector_of(content.utm_m))
      .bytes(2, quaternion_of(content.enu_from_vehicle))
      .real(6, std::atan2(ahead.y(), ahead.x()))
      .message();
}

}  // namespace

MessageDefinition apollo_definition(std::string_view type) { return {std::string(type), "", ""}; }

std::string apollo_cloud_message(const cloud::PointCloud& cloud, std::int64_t stamp_ns, std::string_view frame) {
  const auto time_ns = [&](std::size_t i) {
    const double after_s = cloud.time_from_stamp_s.empty() ? 0.0 : static_cast<double>(cloud.time_from_stamp_s[i]);
    return static_cast<std::uint64_t>(stamp_ns + std::llround(1e9 * after_s));
  };
  std::uint64_t last_ns = cloud.size() == 0 ? static_cast<std::uint64_t>(stamp_ns) : 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) last_ns = std::max(last_ns, time_ns(i));
  const auto measured_ns = static_cast<std::int64_t>(last_ns);
  ProtoWriter header;
  header.real(1, seconds_of(measured_ns)).whole(4, last_ns).bytes(9, frame);
  ProtoWriter message;
  message.bytes(1, header.message()).bytes(2, frame).whole(3, 1);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    ProtoWriter point;
    point.narrow(1, cloud.points[i].x()).narrow(2, cloud.points[i].y()).narrow(3, cloud.points[i].z());
    if (!cloud.intensity.empty())
      point.whole(4, static_cast<std::uint64_t>(std::lround(255.0f * std::clamp(cloud.intensity[i], 0.0f, 1.0f))));
    if (!cloud.time_from_stamp_s.empty()) point.whole(5, time_ns(i));
    message.bytes(4, point.message());
  }
  message.real(5, seconds_of(measured_ns)).whole(6, cloud.size()).whole(7, 1);
  return message.message();
}

std::string apollo_gps_message(const ApolloPoseContent& content) {
  return ProtoWriter().bytes(1, header_at(content.stamp_ns)).bytes(2, pose_of(content)).message();
}

std::string apollo_localization_message(const ApolloPoseContent& content, std::int64_t late_ns) {
  return ProtoWriter()
      .bytes(1, header_at(content.stamp_ns + late_ns))
      .bytes(2, pose_of(content))
      .real(4, seconds_of(content.stamp_ns))
      .message();
}

std::string apollo_status_message(std::int64_t stamp_ns, unsigned position_type) {
  constexpr unsigned kGood = 3;  // of the INS
  return ProtoWriter().bytes(1, header_at(stamp_ns)).whole(2, kGood).whole(3, position_type).message();
}

std::string apollo_fix_message(const motion::GnssFix& fix, unsigned type) {
  const Eigen::Vector3d sigma_m = fix.covariance_enu_m2.diagonal().cwiseSqrt();
  return ProtoWriter()
      .bytes(1, header_at(fix.stamp_ns))
      .real(2, seconds_of(formats::gps_ns_from_unix_ns(fix.stamp_ns)))
      .whole(3, 0)
      .whole(4, type)
      .real(5, radians_to_degrees(fix.latitude_rad))
      .real(6, radians_to_degrees(fix.longitude_rad))
      .real(7, fix.height_m)
      .narrow(8, 0.0f)
      .narrow(10, static_cast<float>(sigma_m.y()))
      .narrow(11, static_cast<float>(sigma_m.x()))
      .narrow(12, static_cast<float>(sigma_m.z()))
      .message();
}

std::string apollo_transforms_message(const std::vector<PoseMessage>& parent_from_child) {
  ProtoWriter message;
  for (const PoseMessage& one : parent_from_child) {
    const std::string transform = ProtoWriter()
                                      .bytes(1, vector_of(one.world_from_child.translation()))
                                      .bytes(2, quaternion_of(Eigen::Quaterniond(one.world_from_child.linear())))
                                      .message();
    message.bytes(2, ProtoWriter()
                         .bytes(1, ProtoWriter().bytes(9, one.header.frame).message())
                         .bytes(2, one.child_frame)
                         .bytes(3, transform)
                         .message());
  }
  return message.message();
}

}  // namespace remount::bags
