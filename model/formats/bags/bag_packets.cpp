#include "model/formats/bags/bag_packets.h"

#include <algorithm>
#include <set>
#include <utility>

#include "algorithms/core/error.h"
#include "messages/bags.h"
#include "model/formats/bags/topic_roles.h"
#include "model/formats/files/input_file.h"
#include "model/formats/packets/capture_scans.h"

namespace remount::bags {
namespace {

/// A packet's place in a bag: the message of its topic, and the byte in it.
constexpr unsigned kMessageBits = 32;
std::uint64_t place_of_packet(std::size_t message, std::size_t offset) {
  return std::uint64_t{message} << kMessageBits | offset;
}

std::string place_of_message(const BagFile& bag, const BagTopic& topic, std::size_t index) {
  return bag.files().front().string() + ": " + topic.name + ", message " + std::to_string(index + 1);
}

formats::Datagram datagram_of(const MessagePacket& packet, const BagTopic& topic, const BagEntry& entry,
                              std::size_t index) {
  formats::Datagram datagram;
  datagram.route.topic = topic.name;
  datagram.time_ns = packet.stamp_ns > 0 ? packet.stamp_ns : entry.log_time_ns;
  datagram.payload = packet.bytes;
  datagram.pieces = {{place_of_packet(index, packet.offset), static_cast<std::uint32_t>(packet.bytes.size())}};
  return datagram;
}

/// The first packets of a message, as far as they are whole.
std::string read_first_packets(const BagFile& bag, const BagTopic& topic, const PacketLayout& layout, std::size_t index,
                               std::vector<std::string>& packets) {
  constexpr std::size_t kLookedAt = std::size_t{64} << 10, kMostPackets = 8;
  const std::string bytes = bag.message(topic.entries[index], kLookedAt);
  MessageReader reader(bytes, topic.encoding, place_of_message(bag, topic, index));
  return layout.read(reader, [&](const MessagePacket& packet) {
    if (packets.size() < kMostPackets) packets.emplace_back(packet.bytes);
  });
}

/// Few of the first, of the middle and of the last: a sensor may begin by saying something of itself.
std::set<std::size_t> looked_at(std::size_t messages) {
  constexpr std::size_t kFirst = 8;
  std::set<std::size_t> places{messages / 2, messages - 1};
  for (std::size_t i = 0; i < std::min(kFirst, messages); ++i) places.insert(i);
  return places;
}

bool can_be_looked_at(const BagTopic& topic) {
  return holds_lidar_packets(topic.type) && topic.encoding != MessageEncoding::Other && !topic.entries.empty();
}

/// Whether another topic of packets comes from the same sensor, by its name.
bool of_same_sensor(const std::string& lidar, const std::string& other) {
  return of_one_device(lidar, other) || other.starts_with(lidar);
}

/// Reads packets by the messages that they lie in: those of a scan follow each other.
class BagPackets final : public formats::PacketFile {
 public:
  BagPackets(std::shared_ptr<const BagFile> bag, std::size_t topic)
      : bag_(std::move(bag)), topic_(bag_->topics()[topic]) {}
  std::filesystem::path name() const override { return bag_->files().front(); }
  void read(const formats::SensorPackets& sensor, std::size_t first, std::size_t last,
            const std::function<void(std::size_t packet, std::string payload)>& take) const override {
    std::string message;
    std::optional<std::size_t> held;
    for (std::size_t i = first; i <= last; ++i) {
      const formats::IndexedPacket& packet = sensor.packets[i];
      const std::size_t index = message_of(packet), offset = packet.offset & ((std::uint64_t{1} << kMessageBits) - 1U);
      if (held != index) message = bag_->message(topic_.entries.at(index)), held = index;
      if (offset + packet.bytes > message.size())  // the file has changed since it was indexed
        throw Error(ErrorCode::Format, place_of_message(*bag_, topic_, index),
                    say::bag_message_too_short(Bytes{message.size()}, packet.bytes, offset));
      take(i, message.substr(offset, packet.bytes));
    }
  }

 private:
  std::shared_ptr<const BagFile> bag_;
  const BagTopic& topic_;
};

}  // namespace

std::size_t message_of(const formats::IndexedPacket& packet) { return packet.offset >> kMessageBits; }

std::vector<formats::SaidOfSensors> said_of_sensors(const BagFile& bag) {
  constexpr std::size_t kMostTopics = 100, kLongestHead = 4096;
  std::vector<formats::SaidOfSensors> said;
  for (const BagTopic& topic : bag.topics()) try {
      const bool text = topic.type == "std_msgs/String", bytes = topic.type == "std_msgs/UInt8MultiArray";
      if (!(text || bytes) || topic.entries.empty() || topic.encoding == MessageEncoding::Other) continue;
      if (said.size() == kMostTopics) break;
      const std::string message = bag.message(topic.entries.front(), formats::kMaxManifestBytes + kLongestHead);
      MessageReader reader(message, topic.encoding, place_of_message(bag, topic, 0));
      if (bytes) {
        constexpr std::size_t kLeastDimension = 12;
        for (std::size_t left = reader.sequence(kLeastDimension); left > 0; --left)
          reader.string(), reader.number<std::uint32_t>(), reader.number<std::uint32_t>();
        reader.number<std::uint32_t>();
      }
      const std::string_view content = text ? reader.string() : reader.byte_sequence();
      const std::string device = topic.name.substr(0, topic.name.rfind('/') + 1);
      said.push_back({topic.name, std::string(content), device.size() > 1 ? device : std::string()});
    } catch (const Error& error) {
      if (error.code() == ErrorCode::Io) throw;  // what else is damaged is not used
    }
  return said;
}

PacketTopic examine_packets(const BagFile& bag, const BagTopic& topic,
                            const std::vector<formats::SaidOfSensors>& said) {
  PacketTopic found;
  const PacketLayout layout = packet_layout(bag, topic);
  const std::string where = bag.files().front().string() + ": " + topic.name;
  const formats::BesidePackets beside{bag.files().front(), {0, 0, topic.name}, said};
  std::size_t read = 0;
  for (const std::size_t index : looked_at(topic.entries.size())) {
    std::vector<std::string> packets;
    try {
      found.frame = read_first_packets(bag, topic, layout, index, packets);
      ++read;
    } catch (const Error& error) {
      if (error.code() == ErrorCode::Io) throw;
      read += packets.empty() ? 0 : 1;  // longer than what was looked at
    }
    for (const std::string& packet : packets) {
      const std::optional<formats::PacketMake> make = formats::make_of_packet(packet, beside, where);
      if (!make) continue;
      if (!make->model.empty()) {
        found.model = make->model;
        found.refused = make->refused;
        return found;
      }
      if (!found.refused) found.refused = make->refused;
    }
  }
  found.damaged = read == 0;
  return found;
}

PacketStream::PacketStream(const BagFile& bag, std::size_t lidar)
    : bag_(bag), lidar_(lidar), topics_{lidar}, said_(said_of_sensors(bag)), indexing_(bag.files().front(), said_) {
  std::vector<std::size_t> beside;
  for (std::size_t i = 0; i < bag.topics().size(); ++i) {
    if (i == lidar || !can_be_looked_at(bag.topics()[i])) continue;
    const bool lidar_too = examine_packets(bag, bag.topics()[i], said_).is_lidar();
    (lidar_too ? other_lidars_ : beside).push_back(i);
  }
  for (const std::size_t i : beside)
    if (other_lidars_.empty() || of_same_sensor(bag.topics()[lidar].name, bag.topics()[i].name)) topics_.push_back(i);
  for (const std::size_t topic : topics_) layouts_.push_back(packet_layout(bag, bag.topics()[topic]));
}

void PacketStream::take(std::size_t topic, const BagEntry& entry, std::size_t index, MessageReader& reader) {
  const auto place = static_cast<std::size_t>(std::ranges::find(topics_, topic) - topics_.begin());
  const std::string frame = layouts_.at(place).read(reader, [&](const MessagePacket& packet) {
    indexing_.take(datagram_of(packet, bag_.topics()[topic], entry, index));
  });
  if (topic == lidar_ && frame_.empty()) frame_ = frame;
}

formats::PacketIndex PacketStream::made(const std::shared_ptr<const BagFile>& bag) {
  const BagTopic& lidar = bag_.topics()[lidar_];
  formats::PacketIndex index = indexing_.made(true);
  std::erase_if(index.sensors, [&](const formats::SensorPackets& sensor) { return sensor.route.topic != lidar.name; });
  formats::choose_sensor(index, lidar.name, bag_.files().front().string() + ": " + lidar.name);
  // Chunks may lie in the file in another order than that of time.
  std::ranges::stable_sort(index.sensors.front().packets, {}, &formats::IndexedPacket::offset);
  for (const std::size_t topic : other_lidars_) try {
      const BagTopic& other = bag_.topics()[topic];
      formats::PacketIndexing indexing(bag_.files().front(), said_);
      std::vector<std::string> packets;
      read_first_packets(bag_, other, packet_layout(bag_, other), 0, packets);
      for (const std::string& packet : packets)
        indexing.take(datagram_of({0, 0, packet}, other, other.entries.front(), 0));
      for (formats::SensorPackets& sensor : indexing.made(false).sensors) index.sensors.push_back(std::move(sensor));
    } catch (const Error& error) {
      if (error.code() == ErrorCode::Io) throw;
    }
  index.file = std::make_shared<BagPackets>(bag, lidar_);
  return index;
}

}  // namespace remount::bags
