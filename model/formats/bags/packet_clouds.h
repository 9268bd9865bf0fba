// Which cloud of a bag is what a sensor's driver made of packets that the bag has as well.
#pragma once

#include <vector>

#include "model/formats/bags/topic_candidates.h"

namespace remount::bags {

/// Whether a cloud is all of what a LiDAR saw while packets came: others are a preview, or thinned out, for no LiDAR
/// turns so slowly.
bool is_whole_record(const BagFile& bag, const TopicCandidate& cloud, const TopicCandidate& packets);

/// Those that are packets of a LiDAR.
std::vector<const TopicCandidate*> sensors_of_packets(const std::vector<TopicCandidate>& candidates);

/// The topic whose points, with times, are those of the packets, as a whole record of them; null where there is none,
/// or where that is not certain. By frames where both have one, else by names: alike but for the last word, or of one
/// namespace that is a device's and has no other sensor's packets.
/// @param sensors of the candidates, no more than kMostPacketLidars @param packets one of them
const TopicCandidate* cloud_of_packets(const BagFile& bag, const std::vector<TopicCandidate>& candidates,
                                       const std::vector<const TopicCandidate*>& sensors,
                                       const TopicCandidate& packets);

}  // namespace remount::bags
