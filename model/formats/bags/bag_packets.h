// Topics with a LiDAR's packets, as the source of them that a capture is otherwise.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "algorithms/core/progress.h"
#include "model/formats/bags/packet_messages.h"
#include "model/formats/packets/packet_index.h"

namespace remount::bags {

/// What a topic of packets is, by some of its messages.
struct PacketTopic {
  std::string model;             ///< of the sensor; empty: it is not known, or no packets of points are among them
  std::string frame;             ///< empty: it has none
  std::optional<Error> refused;  ///< why its points are not decoded
  bool damaged = false;          ///< none of the messages that were looked at can be read
  std::shared_ptr<formats::PacketDecoder> decoder = nullptr;  ///< that has looked beside; null: it is refused
  bool is_lidar() const { return !model.empty() || refused; }
};

/// On no vehicle there are more, and a bag may be made to take for ever: of more nothing is compared with each other.
inline constexpr std::size_t kMostPacketLidars = 64;

/// All topics of packets in a bag, each looked at once.
struct PacketTopics {
  formats::SaidInRecording said;             ///< null: nothing
  std::map<std::size_t, PacketTopic> found;  ///< by their index in BagFile::topics()
  std::vector<std::size_t> lidars;           ///< those of a LiDAR's points, read or not
  /// The topic of a LiDAR's points, and those on which it says something of itself, of its clock or of its receiver:
  /// each is of the LiDAR whose name it has most words of, and of none where that is open between two.
  std::vector<std::size_t> of_lidar(const BagFile& bag, std::size_t lidar) const;
};
/// A sensor that needs a description is refused where it gives none within seconds. Returns early where `progress` is
/// cancelled. Throws Error(Io) where the disk fails.
PacketTopics examine_packets(const BagFile& bag, const Progress& progress);

/// What topics of text and of bytes hold, which may be files of sensors: each is published once, when its driver
/// starts.
std::vector<formats::SaidOfSensors> said_of_sensors(const BagFile& bag);

/// The packets of one LiDAR on the way through a bag.
class PacketStream {
 public:
  /// @param topics of the bag, which outlive it @param lidar the topic of its points
  PacketStream(const BagFile& bag, const PacketTopics& topics, std::size_t lidar);
  /// That of its points, and those on which it says something of itself, of its clock or of its receiver.
  const std::vector<std::size_t>& topics() const { return topics_; }
  /// Throws Error as the reader of a message does: packets before are taken.
  void take(std::size_t topic, const BagEntry& entry, std::size_t index, MessageReader& reader);
  const std::string& frame() const { return frame_; }
  /// Once all messages are taken. Sensors of other topics stand behind this one, without packets.
  /// @param bag the one that it was made for. Throws Error(Unsupported, Format) where there is none on the topic.
  formats::PacketIndex made(const std::shared_ptr<const BagFile>& bag);

 private:
  /// What is the same of all packets of a topic.
  struct Source {
    PacketLayout layout;
    formats::Datagram datagram;
  };

  const BagFile& bag_;
  const PacketTopics& all_;
  std::size_t lidar_;
  std::vector<std::size_t> topics_;
  std::vector<Source> sources_;  ///< of `topics_`
  formats::PacketIndexing indexing_;
  std::string frame_;
};

/// Which message of its topic an indexed packet lies in.
std::size_t message_of(const formats::IndexedPacket& packet);

}  // namespace remount::bags
