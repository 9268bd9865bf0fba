#include "model/formats/bags/bag_packets.h"

#include <algorithm>
#include <set>
#include <utility>

#include "algorithms/core/error.h"
#include "messages/bags.h"
#include "model/formats/bags/topic_names.h"
#include "model/formats/files/input_file.h"
#include "model/formats/packets/capture_scans.h"
#include "model/formats/packets/packet_times.h"

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

/// The first packets of a message, as far as they are whole.
void read_first_packets(const BagFile& bag, const BagTopic& topic, const PacketLayout& layout, std::size_t index,
                        std::string& frame, std::vector<std::string>& packets) {
  constexpr std::size_t kLookedAt = std::size_t{64} << 10, kMostPackets = 8;
  const std::string bytes = bag.message(topic.entries[index], kLookedAt);
  MessageReader reader(bytes, topic.encoding, place_of_message(bag, topic, index));
  layout.read(
      reader,
      [&](const MessagePacket& packet) {
        if (packets.size() < kMostPackets) packets.emplace_back(packet.bytes);
      },
      &frame);
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
      const std::string space = topic.name.substr(0, topic.name.rfind('/') + 1);
      const std::string device = space.size() > 1 ? space : std::string();
      const bool of_sensor = !device.empty() && std::ranges::any_of(bag.topics(), [&](const BagTopic& other) {
        return holds_lidar_packets(other.type) && other.name.starts_with(device);
      });
      said.push_back({topic.name, std::string(content), device, of_sensor});
    } catch (const Error& error) {
      if (error.code() == ErrorCode::Io) throw;  // what else is damaged is not used
    }
  return said;
}

namespace {

PacketTopic examine_topic(const BagFile& bag, const BagTopic& topic, const formats::SaidInRecording& said) {
  PacketTopic found;
  const PacketLayout layout = packet_layout(bag, topic);
  const std::string where = bag.files().front().string() + ": " + topic.name;
  const formats::BesidePackets beside{bag.files().front(), {0, 0, topic.name}, *said};
  std::size_t read = 0;
  for (const std::size_t index : looked_at(topic.entries.size())) {
    std::vector<std::string> packets;
    try {
      read_first_packets(bag, topic, layout, index, found.frame, packets);
      ++read;
    } catch (const Error& error) {
      if (error.code() == ErrorCode::Io) throw;
      read += packets.empty() ? 0 : 1;  // longer than what was looked at
    }
    for (const std::string& packet : packets) {
      std::optional<formats::PacketMake> make = formats::make_of_packet(packet, beside, where);
      if (!make) continue;
      if (!make->model.empty()) {
        found.model = make->model;
        found.refused = make->refused;
        found.decoder = std::move(make->decoder);
        return found;
      }
      if (!found.refused) found.refused = make->refused;
    }
  }
  found.damaged = read == 0;
  return found;
}

/// The messages of some seconds from one on.
std::size_t seconds_behind(const std::vector<BagEntry>& entries, std::size_t first) {
  constexpr std::int64_t kLookedAt_ns = 3'000'000'000;  // sensors describe themselves once a second, or more often
  constexpr std::size_t kMost = 50'000;
  std::size_t end = first;
  while (end < std::min(entries.size(), first + kMost) &&
         entries[end].log_time_ns - entries[first].log_time_ns <= kLookedAt_ns)
    ++end;
  return end;
}

/// A message that may hold a description.
struct PlaceOfDescription {
  std::int64_t time_ns = 0;
  std::size_t topic = 0, message = 0;
};

/// At the begin of topics and in the middle, in the order of the recorder: a sensor that has just started may not know
/// yet, and of descriptions the first counts.
std::vector<PlaceOfDescription> places_of_descriptions(const BagFile& bag, const std::vector<std::size_t>& topics) {
  std::vector<PlaceOfDescription> places;
  for (const std::size_t topic : topics) {
    const std::vector<BagEntry>& entries = bag.topics()[topic].entries;
    std::size_t taken = 0;
    for (const std::size_t first : {std::size_t{0}, entries.size() / 2})
      for (const std::size_t end = seconds_behind(entries, first); taken < end; ++taken) {
        taken = std::max(taken, first);
        places.push_back({entries[taken].log_time_ns, topic, taken});
      }
  }
  std::ranges::stable_sort(places, {}, &PlaceOfDescription::time_ns);
  return places;
}

std::vector<std::string> descriptions_on(const BagFile& bag, const std::vector<std::size_t>& topics,
                                         const Progress& progress) {
  std::map<std::size_t, PacketLayout> layouts;
  for (const std::size_t topic : topics) layouts.emplace(topic, packet_layout(bag, bag.topics()[topic]));
  std::vector<formats::PositionPacket> found;
  bool more = true;
  for (const PlaceOfDescription& place : places_of_descriptions(bag, topics)) try {
      if (!more || progress.cancelled()) break;
      const BagTopic& topic = bag.topics()[place.topic];
      const std::string bytes = bag.message(topic.entries[place.message]);
      MessageReader reader(bytes, topic.encoding, place_of_message(bag, topic, place.message));
      layouts.at(place.topic).read(reader, [&](const MessagePacket& packet) {
        if (const auto position = formats::read_position(packet.bytes))
          more = formats::take_description(*position, found);
      });
    } catch (const Error& error) {
      if (error.code() == ErrorCode::Io) throw;  // what is damaged is told when it is used
    }
  return formats::texts_of(found);
}

}  // namespace

std::vector<std::size_t> PacketTopics::of_lidar(const BagFile& bag, std::size_t lidar) const {
  std::vector<std::size_t> own{lidar};
  if (lidars.size() > kMostPacketLidars) return own;
  for (const auto& [place, topic] : found) {
    if (place == lidar || topic.is_lidar()) continue;
    const auto alike = [&, beside = place](std::size_t to) {
      return words_alike(bag.topics()[to].name, bag.topics()[beside].name);
    };
    const std::size_t its = alike(lidar);
    const bool nearest = std::ranges::all_of(lidars, [&](std::size_t to) { return to == lidar || alike(to) < its; });
    if (lidars.size() == 1 || (its > 0 && nearest)) own.push_back(place);
  }
  return own;
}

PacketTopics examine_packets(const BagFile& bag, const Progress& progress) {
  PacketTopics topics;
  if (std::ranges::none_of(bag.topics(), can_be_looked_at)) return topics;
  topics.said = std::make_shared<const std::vector<formats::SaidOfSensors>>(said_of_sensors(bag));
  for (std::size_t i = 0; i < bag.topics().size() && !progress.cancelled(); ++i) try {
      if (can_be_looked_at(bag.topics()[i])) topics.found[i] = examine_topic(bag, bag.topics()[i], topics.said);
    } catch (const Error& error) {
      if (error.code() == ErrorCode::Io) throw;
      topics.found[i].damaged = true;
    }
  for (const auto& [place, topic] : topics.found)
    if (topic.is_lidar()) topics.lidars.push_back(place);
  for (auto& [place, topic] : topics.found) try {
      if (topic.decoder && topic.decoder->needs_description())
        topic.decoder->describe(descriptions_on(bag, topics.of_lidar(bag, place), progress),
                                bag.files().front().string() + ": " + bag.topics()[place].name);
    } catch (const Error& error) {
      if (error.code() == ErrorCode::Io) throw;
      topic.refused = error;
    }
  return topics;
}

PacketStream::PacketStream(const BagFile& bag, const PacketTopics& topics, std::size_t lidar)
    : bag_(bag),
      all_(topics),
      lidar_(lidar),
      topics_(topics.of_lidar(bag, lidar)),
      indexing_(bag.files().front(), topics.said) {
  for (const std::size_t topic : topics_) {
    Source source{packet_layout(bag, bag.topics()[topic]), {}};
    source.datagram.route.topic = bag.topics()[topic].name;
    source.datagram.pieces.resize(1);
    sources_.push_back(std::move(source));
  }
}

void PacketStream::take(std::size_t topic, const BagEntry& entry, std::size_t index, MessageReader& reader) {
  Source& source = sources_.at(static_cast<std::size_t>(std::ranges::find(topics_, topic) - topics_.begin()));
  const auto take_packet = [&](const MessagePacket& packet) {
    // A stamp that is no date is of a sensor's clock that nobody has set; the recorder has taken it down all the same.
    source.datagram.time_ns = formats::has_date(packet.stamp_ns) ? packet.stamp_ns : entry.log_time_ns;
    source.datagram.payload = packet.bytes;
    source.datagram.pieces.front() = {place_of_packet(index, packet.offset),
                                      static_cast<std::uint32_t>(packet.bytes.size())};
    indexing_.take(source.datagram);
  };
  source.layout.read(reader, take_packet, topic == lidar_ && frame_.empty() ? &frame_ : nullptr);
}

formats::PacketIndex PacketStream::made(const std::shared_ptr<const BagFile>& bag) {
  const BagTopic& lidar = bag_.topics()[lidar_];
  formats::PacketIndex index = indexing_.made(true);
  std::erase_if(index.sensors, [&](const formats::SensorPackets& sensor) { return sensor.route.topic != lidar.name; });
  formats::choose_sensor(index, lidar.name, bag_.files().front().string() + ": " + lidar.name);
  // Chunks may lie in the file in another order than that of time.
  std::ranges::stable_sort(index.sensors.front().packets, {}, &formats::IndexedPacket::offset);
  for (const std::size_t topic : all_.lidars) {
    if (topic == lidar_) continue;
    formats::SensorPackets other;
    other.route.topic = bag_.topics()[topic].name;
    other.decoder = all_.found.at(topic).decoder;
    if (other.decoder) index.sensors.push_back(std::move(other));
  }
  index.file = std::make_shared<BagPackets>(bag, lidar_);
  return index;
}

}  // namespace remount::bags
