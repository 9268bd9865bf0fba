#include "model/formats/packets/packet_index.h"

#include <algorithm>

#include "messages/captures.h"

namespace remount::formats {

namespace {

/// More are no sensors: somebody captured a whole network.
constexpr std::size_t kMostRoutes = 1000;
/// A sensor that has not been recognised by then is none.
constexpr std::size_t kMostTries = 1000;

}  // namespace

bool take_description(const PositionPacket& position, std::vector<PositionPacket>& descriptions) {
  constexpr std::size_t kMostDescriptions = 16;  // more are not needed to tell that there are several
  const auto same = [&](const PositionPacket& other) { return other.lasting == position.lasting; };
  if (descriptions.size() < kMostDescriptions && !position.description.empty() &&
      std::ranges::none_of(descriptions, same))
    descriptions.push_back(position);
  return descriptions.size() < kMostDescriptions;
}

std::vector<std::string> texts_of(const std::vector<PositionPacket>& descriptions) {
  std::vector<std::string> texts;
  for (const PositionPacket& packet : descriptions) texts.push_back(packet.description);
  return texts;
}

IndexedPacket indexed_packet(const PacketGlance& glance, std::size_t bytes) {
  IndexedPacket packet;
  packet.time_ns = glance.sensor_time_ns;
  packet.second_part = glance.second_part;
  packet.bytes = static_cast<std::uint32_t>(bytes);
  packet.first_place = glance.first_place;
  packet.last_place = glance.last_place;
  packet.cut_column = static_cast<std::uint16_t>(glance.cut_column);
  packet.cut_after_ns = glance.cut_after_ns;
  packet.frame = glance.frame;
  packet.clock_period_s = glance.clock_period_s;
  return packet;
}

void count_unused(SensorPackets& sensor, std::string_view payload) {
  if (sensor.decoder->has_no_points(payload)) return;
  ++(sensor.decoder->is_of_another(payload) ? sensor.of_others : sensor.foreign);
}

std::string name_of(const SensorPackets& sensor) { return sensor.name.empty() ? to_string(sensor.route) : sensor.name; }

std::optional<PacketMake> make_of_packet(std::string_view payload, const BesidePackets& beside,
                                         const std::string& where) {
  std::optional<PacketMake> refused;
  for (const PacketFormat& format : packet_formats()) {
    std::string model;
    try {
      std::shared_ptr<PacketDecoder> decoder = format.recognise(payload, where);
      if (!decoder) continue;
      model = decoder->model();
      decoder->look_beside(beside, payload, where);
      return PacketMake{decoder->model(), std::nullopt, decoder};
    } catch (const Error& error) {
      if (!refused) refused = PacketMake{model, error, nullptr};
    }
  }
  return refused;
}

PacketIndexing::PacketIndexing(std::filesystem::path recording, SaidInRecording said)
    : recording_(std::move(recording)), name_(recording_.string()), said_(std::move(said)) {}

void PacketIndexing::take(const Datagram& datagram) {
  const auto found = passed_.routes.find(datagram.route);
  if (found == passed_.routes.end() && passed_.routes.size() == kMostRoutes) return;
  RoutePackets& route = found == passed_.routes.end() ? passed_.routes[datagram.route] : found->second;
  if (!route.sensor.decoder) {
    const bool tried = route.given_up || route.others >= kMostTries;
    if (take_position(datagram, route) || tried || !recognise(datagram, route)) {
      ++route.others;
      return;
    }
  }
  add_packet(datagram, route);
}

PacketIndex PacketIndexing::made(bool whole) {
  PacketIndex index;
  for (auto& [key, route] : passed_.routes) {
    if (whole && route.sensor.decoder) describe(key, route);
    if (route.sensor.decoder && !route.sensor.packets.empty())
      index.sensors.push_back(std::move(route.sensor));
    else if (route.sensor.decoder)
      index.refused.emplace_back(ErrorCode::Unsupported, name_ + ": " + to_string(key),
                                 say::capture_no_points(route.sensor.foreign, route.sensor.decoder->model()));
    else if (route.refused)
      index.refused.push_back(std::move(*route.refused));
    else if (route.others > 0 || route.positions)
      index.others.emplace_back(key, route.others);
  }
  index.receivers = std::move(passed_.receivers);
  return index;
}

void PacketIndexing::describe(const DatagramRoute& key, RoutePackets& route) {
  try {
    route.sensor.decoder->describe(texts_of(passed_.descriptions[key.address]), name_ + ": " + to_string(key));
  } catch (const Error& error) {
    route.refused = error;
    route.sensor = {};
  }
}

void PacketIndexing::take_up(PassedPackets passed,
                             const std::function<std::string(const RoutePackets& route)>& payload_of) {
  passed_ = std::move(passed);
  for (auto& [key, route] : passed_.routes) {
    if (route.told_by.empty()) continue;
    const std::string payload = payload_of(route);
    Datagram datagram;
    datagram.route = key, datagram.payload = payload, datagram.pieces = route.told_by;
    route.given_up = false;
    recognise(datagram, route);
  }
}

bool PacketIndexing::recognise(const Datagram& datagram, RoutePackets& route) {
  const std::string where = name_ + ": " + to_string(datagram.route);
  for (const PacketFormat& format : packet_formats()) try {
      std::unique_ptr<PacketDecoder> decoder = format.recognise(datagram.payload, where);
      if (!decoder) continue;
      route.given_up = true;
      route.told_by = datagram.pieces;
      const std::span<const SaidOfSensors> said = said_ ? std::span(*said_) : std::span<const SaidOfSensors>();
      decoder->look_beside({recording_, datagram.route, said}, datagram.payload, where);
      route.sensor.decoder = std::move(decoder);
      route.sensor.route = datagram.route;
      return true;
    } catch (const Error& error) {
      if (!route.refused) route.refused = error, route.told_by = datagram.pieces;
    }
  return false;
}

bool PacketIndexing::take_position(const Datagram& datagram, RoutePackets& route) {
  const auto position = read_position(datagram.payload);
  if (!position) return false;
  SensorReceiver& receiver = passed_.receivers[datagram.route.address];
  receiver.states.push_back({datagram.time_ns, position->clock_locked});
  if (!position->sentences.empty() && position->sentences != last_sentences_[datagram.route.address]) {
    receiver.sentences += position->sentences;
    last_sentences_[datagram.route.address] = position->sentences;
  }
  take_description(*position, passed_.descriptions[datagram.route.address]);
  route.positions = true;
  return true;
}

/// Where packets of points say themselves whether the clock is set by another: as position packets do, once a second,
/// and where that changes.
void PacketIndexing::take_clock(const Datagram& datagram, bool follows) {
  constexpr std::int64_t kApart_ns = 1'000'000'000;
  std::vector<SensorReceiver::State>& states = passed_.receivers[datagram.route.address].states;
  if (states.empty() || states.back().clock_locked != follows ||
      std::abs(datagram.time_ns - states.back().host_ns) >= kApart_ns)
    states.push_back({datagram.time_ns, follows});
}

void PacketIndexing::add_packet(const Datagram& datagram, RoutePackets& route) {
  SensorPackets& sensor = route.sensor;
  const std::optional<PacketGlance> glance = sensor.decoder->glance(datagram.payload);
  if (!glance) {
    // A topic of a bag may have all that the sensor sends, to whatever port.
    if (!take_position(datagram, route)) count_unused(sensor, datagram.payload);
    return;
  }
  if (glance->clock_follows) take_clock(datagram, *glance->clock_follows);
  IndexedPacket packet = indexed_packet(*glance, datagram.payload.size());
  packet.host_ns = datagram.time_ns;
  packet.pieces = static_cast<std::uint16_t>(datagram.pieces.size());
  packet.offset = datagram.pieces.front().offset;
  if (packet.pieces > 1) {
    packet.offset = sensor.pieces.size();
    sensor.pieces.insert(sensor.pieces.end(), datagram.pieces.begin(), datagram.pieces.end());
  }
  sensor.packets.push_back(packet);
}

}  // namespace remount::formats
