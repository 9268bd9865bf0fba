// What the topics of a bag can serve as, and which to take where nobody has said.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "model/drive/topic_offer.h"
#include "model/formats/bags/bag_packets.h"
#include "model/formats/bags/topic_names.h"

namespace remount::bags {

/// The topic of each role, by its index in BagFile::topics(); nothing where the bag has none for it.
struct TopicRoles {
  std::optional<std::size_t> lidar, ins, ins_position, gnss, imu;
  std::array<std::optional<std::size_t>, 5> all() const { return {lidar, ins, ins_position, gnss, imu}; }
};

/// A topic that would give the INS far more often than the one that was taken.
struct FasterTopic {
  std::string_view role;  ///< of kTopicRoles: "ins" or "ins-position"
  std::string name;
  double rate_hz = 0.0;
};

/// Which topic has which role, and what each topic of the bag can be and is used as.
struct ChosenTopics {
  TopicRoles roles;
  std::vector<drive::OfferedTopic> topics;
  std::optional<FasterTopic> faster;  ///< where the INS has too few messages for its motion
  std::shared_ptr<const PacketTopics> packets;
};

/// Takes what `choice` says and suggests the rest; what of several was taken without being asked is a finding. Reads
/// up to three messages of each topic that comes into question. Throws Error(Contract) for a topic that the bag does
/// not have, that cannot serve as what it was chosen for, or that was chosen for LiDAR and INS at once.
/// @param packets of this bag
ChosenTopics choose_topics(const BagFile& bag, const drive::TopicChoice& choice, std::vector<drive::Finding>& findings,
                           std::shared_ptr<const PacketTopics> packets);

/// Whether a topic has about as many clouds as the one that has most: a map that is published now and then is a cloud,
/// too, and no LiDAR.
bool is_steady(std::size_t messages, std::size_t most_messages);

/// NovAtel's drivers publish Odometry with positions in UTM and the receiver's attitude, which is to true north.
bool is_of_novatel(const std::string& topic);

/// Whether all transforms of a topic are read for the nominal mounting.
bool is_static_transforms(const BagTopic& topic);

}  // namespace remount::bags
