#include "model/formats/bags/packet_clouds.h"

#include <algorithm>
#include <string_view>

#include "algorithms/core/stamps.h"
#include "model/formats/bags/topic_names.h"

namespace remount::bags {
namespace {

/// "/lidar/front_packets" in its namespace "/lidar/", with the words "front" and "packets".
struct TopicName {
  std::string_view space, begin;  ///< the namespace; all but the last word
  std::vector<std::string_view> words;
};

TopicName parts_of_name(std::string_view topic) {
  const std::string_view space = topic.substr(0, topic.rfind('/') + 1);
  return {space, topic.substr(0, topic.find_last_of("/_")), words_of(topic.substr(space.size()))};
}

/// Namespaces that several sensors share.
bool says_a_device(std::string_view space) {
  constexpr std::string_view kKinds[] = {"lidar",   "lidars", "laser",   "lasers", "sensor",
                                         "sensors", "points", "sensing", "driver", "drivers"};
  const std::vector<std::string_view> words = words_of(space);
  return !words.empty() && std::ranges::find(kKinds, words.back()) == std::end(kKinds);
}

class CloudFinder {
 public:
  CloudFinder(const BagFile& bag, const std::vector<const TopicCandidate*>& sensors, const TopicCandidate& packets)
      : bag_(bag), sensors_(sensors), packets_(packets) {}

  bool is_of_packets(const TopicCandidate& cloud) const {
    if (!is_cloud(cloud.kind) || !cloud.point_times || !is_whole_record(bag_, cloud, packets_)) return false;
    if (packets_.frame.empty() || cloud.frame.empty()) return is_called_alike(cloud);
    return packets_.frame == cloud.frame && !is_of_another_of_this_driver(cloud) && is_nearest(cloud);
  }

 private:
  std::string_view name(const TopicCandidate& candidate) const { return bag_.topics()[candidate.topic].name; }

  /// Names that are the same but for the namespace: two instances of a driver, whose frames are what it is set to
  /// without being asked.
  bool is_of_another_of_this_driver(const TopicCandidate& cloud) const {
    const TopicName own = parts_of_name(name(packets_)), its = parts_of_name(name(cloud));
    const auto driver = [](const TopicName& of) { return of.begin.substr(std::min(of.space.size(), of.begin.size())); };
    return own.space.size() > 1 && its.space.size() > 1 && words_alike(own.space, its.space) == 0 &&
           driver(own) == driver(its);
  }

  /// Of several sensors whose frame is the same, the one that is called most like the cloud.
  bool is_nearest(const TopicCandidate& cloud) const {
    const std::size_t own = words_alike(name(packets_), name(cloud));
    return std::ranges::none_of(sensors_, [&](const TopicCandidate* other) {
      return other != &packets_ && other->frame == packets_.frame && words_alike(name(*other), name(cloud)) >= own;
    });
  }

  bool is_called_alike(const TopicCandidate& cloud) const {
    const TopicName own = parts_of_name(name(packets_)), its = parts_of_name(name(cloud));
    if (!own.begin.empty() && own.begin == its.begin) return true;
    const std::string_view space = std::min(own.space, its.space, [](auto a, auto b) { return a.size() < b.size(); });
    if (!says_a_device(space) || !own.space.starts_with(space) || !its.space.starts_with(space)) return false;
    // "ouster_packets" and "velodyne_points" are two, "lidar_packets" and "points" may be one.
    if (own.words.size() > 1 && its.words.size() > 1) return false;
    return std::ranges::none_of(
        sensors_, [&](const TopicCandidate* other) { return other != &packets_ && name(*other).starts_with(space); });
  }

  const BagFile& bag_;
  const std::vector<const TopicCandidate*>& sensors_;
  const TopicCandidate& packets_;
};

}  // namespace

bool is_whole_record(const BagFile& bag, const TopicCandidate& cloud, const TopicCandidate& packets) {
  constexpr double kSlowest_hz = 4.0, kLeastShare = 0.8;
  const std::vector<BagEntry>&its = bag.topics()[cloud.topic].entries, &all = bag.topics()[packets.topic].entries;
  const double all_s = seconds(all.back().log_time_ns - all.front().log_time_ns);
  const double common_s = seconds(std::min(its.back().log_time_ns, all.back().log_time_ns) -
                                  std::max(its.front().log_time_ns, all.front().log_time_ns));
  return cloud.rate_hz >= kSlowest_hz && common_s >= kLeastShare * all_s;
}

std::vector<const TopicCandidate*> sensors_of_packets(const std::vector<TopicCandidate>& candidates) {
  std::vector<const TopicCandidate*> sensors;
  for (const TopicCandidate& candidate : candidates)
    if (candidate.kind == MessageKind::LidarPackets && !candidate.model.empty()) sensors.push_back(&candidate);
  return sensors;
}

const TopicCandidate* cloud_of_packets(const BagFile& bag, const std::vector<TopicCandidate>& candidates,
                                       const std::vector<const TopicCandidate*>& sensors,
                                       const TopicCandidate& packets) {
  const CloudFinder finder(bag, sensors, packets);
  const auto found =
      std::ranges::find_if(candidates, [&](const TopicCandidate& cloud) { return finder.is_of_packets(cloud); });
  return found == candidates.end() ? nullptr : &*found;
}

}  // namespace remount::bags
