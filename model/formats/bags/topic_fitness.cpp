#include "model/formats/bags/topic_fitness.h"

#include <algorithm>
#include <initializer_list>
#include <string_view>

#include "messages/topics.h"
#include "model/formats/bags/apollo_messages.h"
#include "model/formats/sessions/pose_session_reader.h"

namespace remount::bags {
namespace {

/// Of these words of a topic's name, parted by '/' and '_'.
bool name_speaks_of(std::string topic, std::initializer_list<std::string_view> words) {
  std::replace(topic.begin(), topic.end(), '/', '_');
  return formats::name_has_word(topic, words);
}

/// Apollo's fusion takes what its LiDARs see into its poses, the driver of its INS does not; msf_gnss and msf_lidar are
/// what the fusion is made of.
Fitness fit_pose_of_apollo(const std::string& topic, MessageKind kind) {
  if (name_speaks_of(topic, {"msf", "lidar", "ndt"})) return {0.0, say::topic_named_as_other_sensor()};
  if (kind == MessageKind::ApolloGps) return {140.0, say::topic_apollo_ins()};
  return {135.0, say::topic_apollo_localization()};
}

}  // namespace

Message unusable_reason(const BagTopic& topic, const TopicCandidate* candidate) {
  if (topic.entries.empty()) return say::topic_empty();
  if (topic.encoding == MessageEncoding::Other) return say::topic_not_read();
  if (candidate && !candidate->refusal.empty()) return candidate->refusal;
  const MessageKind kind = message_kind(topic.type);
  if (kind == MessageKind::Transforms) return say::topic_moving_transforms();
  if (kind == MessageKind::Imu) return say::topic_imu_without_measurements();
  if (is_pose(kind)) return say::topic_pose_without_orientation();
  if (kind == MessageKind::Insstdev) return say::topic_insstdev();
  if (kind == MessageKind::Gsof50) return say::topic_gsof50();
  if (kind == MessageKind::ApolloInsStat) return say::topic_ins_stat();
  if (is_attitude(kind)) return say::topic_attitude_not_valid();
  if (is_raw_packets(topic.type)) return say::topic_of_packets();
  return say::topic_of_other_type();
}

Fitness fit_cloud_of_apollo(const TopicCandidate& candidate, const std::string& topic, bool raw_beside,
                            Fitness as_scans) {
  if (is_of_fusion(topic)) return {0.0, say::topic_of_several_lidars()};
  if (!candidate.compensated) return as_scans;
  return {raw_beside ? 0.0 : as_scans.points, say::topic_compensated()};
}

Fitness fit_lidar(const TopicCandidate& candidate, bool steady) {
  constexpr double kSteady = 1e12, kTimed = 1e11, kPointTimes = 1e10;
  // Behind clouds whose points have times, which are what the sensor's own driver makes, and before all others.
  if (candidate.kind == MessageKind::LidarPackets)
    return {kSteady + kTimed + 0.5 * kPointTimes, say::topic_lidar_packets(candidate.model)};
  if (!is_cloud(candidate.kind)) return {0.0, say::topic_poses_for_lidar()};
  const double points = 1.0 + (steady ? kSteady : 0.0) + (candidate.timed ? kTimed : 0.0) +
                        (candidate.point_times ? kPointTimes : 0.0) +
                        std::min(static_cast<double>(candidate.points), 0.1 * kPointTimes);
  if (candidate.damaged) return {points, say::topic_damaged_scans()};
  if (!steady) return {points, say::topic_rare_clouds(candidate.points)};
  return {points,
          candidate.timed ? say::topic_timed_scans(candidate.points) : say::topic_untimed_scans(candidate.points)};
}

bool name_speaks_of_ins(const std::string& topic) {
  return name_speaks_of(topic,
                        {"ins", "gnss", "gps", "novatel", "span", "oxts", "septentrio", "applanix", "pos", "nav"});
}

Fitness fit_pose(const std::string& topic, MessageKind kind) {
  if (is_apollo_pose(kind)) return fit_pose_of_apollo(topic, kind);
  if (name_speaks_of(topic, {"lidar", "laser", "loam", "lio", "visual", "camera", "wheel", "wheels", "icp", "mapped"}))
    return {0.0, say::topic_named_as_other_sensor()};
  const double score = kind == MessageKind::Odometry ? 30.0 : kind == MessageKind::TransformStamped ? 10.0 : 20.0;
  if (name_speaks_of_ins(topic)) return {score + 100.0, say::topic_named_as_ins()};
  return {score, say::topic_named_as_nothing()};
}

}  // namespace remount::bags
