// What the topics of a bag can serve as, and which to take where nobody has said.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "model/io/bag/bag_file.h"
#include "model/topic_choice.h"

namespace remount {

/// The topic of each role, by its index in BagFile::topics(); nothing where the bag has none for it.
struct TopicRoles {
  std::optional<std::size_t> lidar, ins, ins_position, gnss, imu;
  std::array<const std::optional<std::size_t>*, 5> all() const { return {&lidar, &ins, &ins_position, &gnss, &imu}; }
};

/// Takes what `choice` says and suggests the rest; what of several was taken without being asked is a finding. Reads
/// one message of each topic that comes into question. Throws Error(Contract) for a topic that the bag does not have,
/// or that cannot serve as what it was chosen for.
TopicRoles choose_topics(const BagFile& bag, const TopicChoice& choice, std::vector<Finding>& findings);

/// All topics, with what each can be and is used as.
std::vector<SessionTopic> list_topics(const BagFile& bag, const TopicRoles& roles);

}  // namespace remount
