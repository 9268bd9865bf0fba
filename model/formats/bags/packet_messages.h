// Messages that hold a LiDAR's packets as they came over the wire. Adding a type is a line in packet_messages.cpp.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/formats/bags/bag_file.h"
#include "model/formats/bags/message_layout.h"
#include "model/formats/bags/message_writer.h"

namespace remount::bags {

/// Whether messages of a type hold packets that are looked at.
bool holds_lidar_packets(std::string_view type);

/// A packet in a message.
struct MessagePacket {
  /// Its own, which of a message with one packet is that of the header, too; 0: there is none. The header of a list is
  /// stamped as its driver likes, by its first point for example.
  std::int64_t stamp_ns = 0;
  std::size_t offset = 0;  ///< in the message
  std::string_view bytes;  ///< as long as the message says that it is
};

/// Where the packets stand in messages of one type: bytes of fixed or other length, in the message or in each item of a
/// list; beside them, in any order, a time and how many of the bytes count (`size`).
class PacketLayout {
 public:
  /// Nothing where no bytes are in it.
  static std::optional<PacketLayout> of(MessageLayout layout);

  /// Hands on each packet. Throws Error as the reader does: packets before were handed on.
  /// @param frame null or where that of the message's header comes to, before its packets are gone through
  void read(MessageReader& reader, const std::function<void(const MessagePacket&)>& take,
            std::string* frame = nullptr) const;
  /// As read, of a message that is nothing else. False where bytes are left over.
  bool fits(MessageReader& reader) const;

  /// A message of some packets, what else is in it zero. One that does not fit its bytes is Error(Contract).
  struct Packet {
    std::int64_t stamp_ns = 0;
    std::string bytes;
  };
  /// @param header_ns its stamp where that is not the first packet's
  std::string write(const std::vector<Packet>& packets, std::string_view frame, MessageEncoding encoding,
                    std::optional<std::int64_t> header_ns = std::nullopt) const;

 private:
  explicit PacketLayout(MessageLayout layout) : layout_(std::move(layout)) {}
  void read_fields(MessageReader& reader, std::size_t message, MessagePacket& packet, std::string* frame) const;

  MessageLayout layout_;
  std::size_t items_field_ = 0, items_message_ = 0;  ///< the list in the message, and what its items are; 0: none
};

/// By the definition that the bag has of the topic, else by what is known of its type; of several variants the one that
/// a message fits. Throws Error(Contract) for a type that holds no packets.
PacketLayout packet_layout(const BagFile& bag, const BagTopic& topic);

/// The first that is known of a type, and how it is described in a bag.
PacketLayout packet_layout(std::string_view type);
MessageDefinition packet_definition(std::string_view type, MessageEncoding encoding);

}  // namespace remount::bags
