// Topics with a LiDAR's packets, as the source of them that a capture is otherwise.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/formats/bags/packet_messages.h"
#include "model/formats/packets/packet_index.h"

namespace remount::bags {

/// What a topic of packets is, by some of its messages.
struct PacketTopic {
  std::string model;             ///< of the sensor; empty: it is not known, or no packets of points are among them
  std::string frame;             ///< empty: it has none
  std::optional<Error> refused;  ///< why its points are not decoded
  bool damaged = false;          ///< none of the messages that were looked at can be read
  bool is_lidar() const { return !model.empty() || refused; }
};
/// @param said in this bag. Throws Error(Io) where the disk fails.
PacketTopic examine_packets(const BagFile& bag, const BagTopic& topic, const std::vector<formats::SaidOfSensors>& said);

/// What topics of text and of bytes hold, which may be files of sensors: each is published once, when its driver
/// starts.
std::vector<formats::SaidOfSensors> said_of_sensors(const BagFile& bag);

/// The packets of one LiDAR on the way through a bag.
class PacketStream {
 public:
  /// @param lidar the topic of its points
  PacketStream(const BagFile& bag, std::size_t lidar);
  /// That of its points, and those on which it says something of itself, of its clock or of its receiver.
  const std::vector<std::size_t>& topics() const { return topics_; }
  /// Throws Error as the reader of a message does: packets before are taken.
  void take(std::size_t topic, const BagEntry& entry, std::size_t index, MessageReader& reader);
  const std::string& frame() const { return frame_; }
  /// Once all messages are taken. Sensors of other topics stand behind this one, with a few of their packets.
  /// @param bag the one that it was made for. Throws Error(Unsupported, Format) where there is none on the topic.
  formats::PacketIndex made(const std::shared_ptr<const BagFile>& bag);

 private:
  const BagFile& bag_;
  std::size_t lidar_;
  std::vector<std::size_t> topics_, other_lidars_;
  std::vector<PacketLayout> layouts_;  ///< of `topics_`
  std::vector<formats::SaidOfSensors> said_;
  formats::PacketIndexing indexing_;
  std::string frame_;
};

/// Which message of its topic an indexed packet lies in.
std::size_t message_of(const formats::IndexedPacket& packet);

}  // namespace remount::bags
