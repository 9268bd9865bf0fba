// What each topic of a bag is, from its type, its rate and some of its messages.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "model/formats/bags/bag_file.h"
#include "model/formats/bags/ros_messages.h"

namespace remount::bags {

struct PacketTopics;

/// A topic that can serve as something, and what tells it from others of its kind.
struct TopicCandidate {
  std::size_t topic = 0;  ///< by its index in BagFile::topics()
  MessageKind kind = MessageKind::Other;
  bool damaged = false;            ///< none of the messages that were looked at can be read, perhaps others can
  bool oriented = true;            ///< IMU: its orientation is measured; poses: their orientation is filled in
  bool orientation_sigma = false;  ///< IMU: its orientation states its error
  bool inertial = true;            ///< IMU: its rates are measured
  bool timed = false;              ///< cloud: its points have times or rings
  bool point_times = false;        ///< cloud: they have times
  bool compensated = false;        ///< cloud: by its name; its times are not used
  std::string model = {};          ///< packets: the sensor that they are of; empty: of none that is known
  Message refusal = {};            ///< packets: why they are not decoded; empty: they are, where a model is known
  std::string frame = {};          ///< cloud, packets; empty: it says none
  std::uint64_t points = 0;        ///< cloud
  std::size_t messages = 0;
  double rate_hz = 0.0;  ///< messages over the time that they span; 0 for a single one
};

/// All topics whose messages can be read. @param packets of this bag. Of an IMU and of poses the first message, the
/// middle and the last are looked at: drivers publish before the INS has aligned. Throws Error(Io) where the disk
/// fails.
std::vector<TopicCandidate> candidates_of(const BagFile& bag, const PacketTopics& packets);

/// Whether it comes into question for a role, as far as its type and the messages that were looked at tell.
bool can_be(const TopicCandidate& candidate, std::string_view role);

/// Whether a topic may be asked for as a role: messages that were not looked at may hold what those lack.
bool may_be_asked_for(const TopicCandidate& candidate, std::string_view role);

}  // namespace remount::bags
