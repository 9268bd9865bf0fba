// How well a topic serves as something, by what is known of it alone.
#pragma once

#include <string>

#include "model/formats/bags/topic_candidates.h"

namespace remount::bags {

/// Higher is better; 0: not without being asked.
struct Fitness {
  double points = 0.0;
  Message why;
};

/// As scans. @param steady as often as others of the bag
Fitness fit_lidar(const TopicCandidate& candidate, bool steady);

/// Of what Apollo's driver, its compensator and its fusion publish of one LiDAR, the driver's is its scans.
/// @param raw_beside the bag has the driver's of the same frame @param as_scans by fit_lidar
Fitness fit_cloud_of_apollo(const TopicCandidate& candidate, const std::string& topic, bool raw_beside,
                            Fitness as_scans);

/// As the INS, of poses.
Fitness fit_pose(const std::string& topic, MessageKind kind);

/// Whether a topic is called as what an INS publishes.
bool name_speaks_of_ins(const std::string& topic);

/// Why a topic that no role can have has none. @param candidate null where its messages cannot be read
Message unusable_reason(const BagTopic& topic, const TopicCandidate* candidate);

}  // namespace remount::bags
