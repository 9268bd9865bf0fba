#include "model/formats/bags/packet_messages.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "algorithms/core/error.h"

namespace remount::bags {
namespace {

/// A type that holds packets. Of a list of packets (`item` not empty) the message is a header and `packets`.
struct PacketType {
  std::string_view type, item;
  std::string_view fields;  ///< of the item, or of the message
};

constexpr std::string_view kStamped1206 = "time stamp\nuint8[1206] data\n",
                           kStamped1248 = "time stamp\nuint8[1248] data\n",
                           kSized1500 = "time stamp\nuint8[1500] data\nuint32 size\n",
                           kSized = "time stamp\nuint8[] data\nuint32 size\n", kBuffer = "uint8[] buf\n",
                           kDifopOrMsop =
                               "std_msgs/Header header\nuint8 is_difop\nuint8 is_frame_begin\nuint8[] data\n";

/// Rows of one type are its variants: bags before rosbag2 of Iron do not say which they have.
constexpr PacketType kTypes[] = {
    {"velodyne_msgs/VelodyneScan", "velodyne_msgs/VelodynePacket", kStamped1206},
    {"velodyne_msgs/VelodynePacket", "", kStamped1206},
    {"ouster_ros/PacketMsg", "", kBuffer},
    {"ouster_msgs/PacketMsg", "", kBuffer},
    {"ouster_sensor_msgs/PacketMsg", "", kBuffer},
    {"pandar_msgs/PandarScan", "pandar_msgs/PandarPacket", kSized1500},
    {"pandar_msgs/PandarScan", "pandar_msgs/PandarPacket", kSized},
    {"hesai_lidar/PandarScan", "hesai_lidar/PandarPacket", kSized},
    {"hesai_lidar/PandarScan", "hesai_lidar/PandarPacket", kSized1500},
    {"hesai_ros_driver/UdpFrame", "hesai_ros_driver/UdpPacket", kSized},
    {"hesai_ros_driver/UdpPacket", "", kSized},
    {"rslidar_msgs/rslidarScan", "rslidar_msgs/rslidarPacket", kStamped1248},
    {"rslidar_msgs/rslidarPacket", "", kStamped1248},
    {"rslidar_msg/RslidarScan", "rslidar_msg/RslidarPacket", kStamped1248},
    {"rslidar_msg/RslidarPacket", "", kDifopOrMsop},
    {"rslidar_msg/RslidarPacket", "", kStamped1248},
    {"nebula_msgs/NebulaPackets", "nebula_msgs/NebulaPacket", "time stamp\nuint8[] data\n"},
};

std::string definition_of(const PacketType& known, MessageEncoding encoding) {
  std::string fields(known.fields);
  if (encoding != MessageEncoding::Ros1 && fields.starts_with("time ")) fields.replace(0, 4, "builtin_interfaces/Time");
  if (!known.item.empty())
    fields =
        "std_msgs/Header header\n" + std::string(known.item) + "[] packets\n" + definition_part(known.item, fields);
  return fields + header_definition_part(encoding);
}

std::vector<PacketLayout> known_layouts(std::string_view type) {
  std::vector<PacketLayout> layouts;
  for (const PacketType& known : kTypes)
    if (known.type == type)
      if (auto layout = parse_message_layout(definition_of(known, MessageEncoding::Ros1), type))
        if (auto packets = PacketLayout::of(std::move(*layout))) layouts.push_back(std::move(*packets));
  if (layouts.empty())
    throw Error(ErrorCode::Contract, std::string(type), Message::verbatim("no message of packets is called so"));
  return layouts;
}

const MessageField* bytes_of(const std::vector<MessageField>& fields) {
  const auto named = std::ranges::find_if(fields, [](const MessageField& field) {
    return field.is_bytes() && (field.name == "data" || field.name == "buf");
  });
  if (named != fields.end()) return &*named;
  const auto any = std::ranges::find_if(fields, &MessageField::is_bytes);
  return any == fields.end() ? nullptr : &*any;
}

bool is_size(const MessageField& field) {
  return field.name == "size" && field.kind == MessageField::Kind::Number && field.many == MessageField::Many::One;
}

std::uint64_t whole_number(MessageReader& reader, const MessageField& field) {
  switch (field.bytes) {
    case 1:
      return reader.number<std::uint8_t>();
    case 2:
      return reader.number<std::uint16_t>();
    case 4:
      return reader.number<std::uint32_t>();
    default:
      return reader.number<std::uint64_t>();
  }
}

void write_zero(MessageWriter& writer, const MessageLayout& layout, const MessageField& field) {
  if (field.many == MessageField::Many::Sequence) {
    writer.number<std::uint32_t>(0);
  } else if (field.kind == MessageField::Kind::Message) {
    for (const MessageField& inner : layout.messages[field.message]) write_zero(writer, layout, inner);
  } else if (field.kind == MessageField::Kind::Number) {
    for (std::uint32_t i = 0; i < (field.many == MessageField::Many::Fixed ? field.count : 1); ++i)
      field.bytes == 1   ? writer.number<std::uint8_t>(0)
      : field.bytes == 2 ? writer.number<std::uint16_t>(0)
      : field.bytes == 4 ? writer.number<std::uint32_t>(0)
                         : writer.number<std::uint64_t>(0);
  } else {
    writer.string("");
  }
}

void write_packet_field(MessageWriter& writer, const MessageLayout& layout, const MessageField& field,
                        const PacketLayout::Packet& packet, std::string_view frame, bool is_data) {
  const std::string& bytes = packet.bytes;
  if (field.kind == MessageField::Kind::Header) {
    writer.header(packet.stamp_ns, frame);
  } else if (field.kind == MessageField::Kind::Time && field.many == MessageField::Many::One) {
    writer.time(packet.stamp_ns);
  } else if (is_size(field) && field.bytes == 4) {
    writer.number(static_cast<std::uint32_t>(bytes.size()));
  } else if (is_data && field.many == MessageField::Many::Sequence) {
    writer.byte_sequence(bytes);
  } else if (is_data) {
    if (bytes.size() > field.count)
      throw Error(ErrorCode::Contract, field.name, Message::verbatim("a packet is longer than its message has room"));
    for (std::uint32_t i = 0; i < field.count; ++i)
      writer.number(static_cast<std::uint8_t>(i < bytes.size() ? bytes[i] : '\0'));
  } else {
    write_zero(writer, layout, field);
  }
}

}  // namespace

bool holds_lidar_packets(std::string_view type) {
  return std::ranges::find(kTypes, type, &PacketType::type) != std::end(kTypes);
}

std::optional<PacketLayout> PacketLayout::of(MessageLayout layout) {
  PacketLayout packets(std::move(layout));
  const std::vector<MessageField>& fields = packets.layout_.messages.front();
  if (bytes_of(fields) != nullptr) return packets;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const MessageField& field = fields[i];
    if (field.kind != MessageField::Kind::Message || field.many != MessageField::Many::Sequence) continue;
    if (bytes_of(packets.layout_.messages[field.message]) == nullptr) continue;
    packets.items_field_ = i, packets.items_message_ = field.message;
    return packets;
  }
  return std::nullopt;
}

/// All fields of the message with a packet, or of an item.
void PacketLayout::read_fields(MessageReader& reader, std::size_t message, MessagePacket& packet,
                               std::string* frame) const {
  const std::vector<MessageField>& fields = layout_.messages[message];
  const MessageField* data = bytes_of(fields);
  std::uint64_t size = ~std::uint64_t{0};
  for (const MessageField& field : fields) {
    if (&field == data) {
      packet.bytes = field.many == MessageField::Many::Fixed ? reader.bytes(field.count) : reader.byte_sequence();
      packet.offset = reader.position() - packet.bytes.size();
    } else if (field.kind == MessageField::Kind::Header && field.many == MessageField::Many::One) {
      MessageHeader header = read_header(reader);
      packet.stamp_ns = header.stamp_ns;
      if (frame) *frame = std::move(header.frame);
    } else if (field.kind == MessageField::Kind::Time && field.many == MessageField::Many::One) {
      if (const std::int64_t own_ns = reader.time_ns(); own_ns != 0) packet.stamp_ns = own_ns;
    } else if (is_size(field)) {
      size = whole_number(reader, field);
    } else {
      skip_field(reader, layout_, field);
    }
  }
  packet.bytes = packet.bytes.substr(0, std::min<std::uint64_t>(size, packet.bytes.size()));
}

void PacketLayout::read(MessageReader& reader, const std::function<void(const MessagePacket&)>& take,
                        std::string* frame) const {
  if (items_message_ == 0) {
    MessagePacket packet;
    read_fields(reader, 0, packet, frame);
    take(packet);
    return;
  }
  const std::vector<MessageField>& fields = layout_.messages.front();
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (fields[i].kind == MessageField::Kind::Header && fields[i].many == MessageField::Many::One) {
      MessageHeader header = read_header(reader);
      if (frame) *frame = std::move(header.frame);
    } else if (i == items_field_) {
      for (std::size_t left = reader.sequence(1); left > 0; --left) {
        MessagePacket packet;
        const std::size_t before = reader.left();
        read_fields(reader, items_message_, packet, nullptr);
        take(packet);
        if (reader.left() == before) break;  // without end
      }
    } else {
      skip_field(reader, layout_, fields[i]);
    }
  }
}

bool PacketLayout::fits(MessageReader& reader) const {
  constexpr std::size_t kMostPadding = 3;  // behind a message in CDR
  read(reader, [](const MessagePacket&) {});
  return reader.left() <= (reader.encoding() == MessageEncoding::Cdr ? kMostPadding : 0);
}

std::string PacketLayout::write(const std::vector<Packet>& packets, std::string_view frame, MessageEncoding encoding,
                                std::optional<std::int64_t> header_ns) const {
  MessageWriter writer(encoding);
  const std::vector<MessageField>& fields = layout_.messages.front();
  const auto write_one = [&](const Packet& packet, const std::vector<MessageField>& its) {
    const MessageField* data = bytes_of(its);
    for (const MessageField& field : its) write_packet_field(writer, layout_, field, packet, frame, &field == data);
  };
  Packet first = packets.empty() ? Packet() : packets.front();
  if (items_message_ == 0) {
    write_one(first, fields);
    return writer.bytes();
  }
  first.stamp_ns = header_ns.value_or(first.stamp_ns);
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (i != items_field_) {
      write_packet_field(writer, layout_, fields[i], first, frame, false);
      continue;
    }
    writer.number(static_cast<std::uint32_t>(packets.size()));
    for (const Packet& packet : packets) write_one(packet, layout_.messages[items_message_]);
  }
  return writer.bytes();
}

PacketLayout packet_layout(std::string_view type) { return known_layouts(type).front(); }

PacketLayout packet_layout(const BagFile& bag, const BagTopic& topic) {
  if (auto own = parse_message_layout(topic.definition, topic.type))
    if (auto packets = PacketLayout::of(std::move(*own))) return std::move(*packets);
  std::vector<PacketLayout> known = known_layouts(topic.type);
  for (PacketLayout& layout : known) try {
      if (known.size() == 1 || topic.entries.empty()) break;
      const std::string bytes = bag.message(topic.entries.front());
      MessageReader reader(bytes, topic.encoding, bag.files().front().string() + ": " + topic.name);
      if (layout.fits(reader)) return std::move(layout);
    } catch (const Error& error) {
      if (error.code() == ErrorCode::Io) throw;
    }
  return std::move(known.front());
}

MessageDefinition packet_definition(std::string_view type, MessageEncoding encoding) {
  const auto known = std::ranges::find(kTypes, type, &PacketType::type);
  if (known == std::end(kTypes))
    throw Error(ErrorCode::Contract, std::string(type), Message::verbatim("no message of packets is called so"));
  // The checksums of ROS 1 are not known here: "*" fits any.
  return {std::string(type), "*", definition_of(*known, encoding)};
}

}  // namespace remount::bags
