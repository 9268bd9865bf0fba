#include "model/formats/packets/kept_index.h"

#include <sys/stat.h>

#include <limits>
#include <utility>

#include "messages/captures.h"
#include "model/formats/files/crc32.h"
#include "model/formats/files/number_bytes.h"
#include "model/formats/files/printable_text.h"
#include "model/formats/files/system_call.h"
#include "model/formats/packets/packed_numbers.h"
#include "model/formats/packets/packet_times.h"
#include "remount_version.h"

namespace remount::formats {

namespace {

constexpr std::string_view kIndexMark = "remount packets\n";
/// Another where the layout is. What packets are taken for may be another in each version of the program.
constexpr std::uint32_t kIndexLayout = 1;

std::string index_version() { return std::string(kVersion) + "/" + std::to_string(kIndexLayout); }

// ---- Packets. Most of them differ from the one before by the same step: what does not is said by a bit.

enum PacketBit : std::uint8_t {
  kOffsetStep = 1,
  kBytesBit = 2,
  kSpanBit = 4,
  kCutBit = 8,
  kFrameBit = 16,
  kPiecesBit = 32,
  kClockBit = 64,
};
constexpr std::uint64_t kMostKeptBytes = 0xffff;
constexpr std::size_t kLeastPacketBytes = 4, kLeastPieceBytes = 2, kLeastStateBytes = 2;

struct PacketBefore {
  IndexedPacket packet;
  std::uint64_t offset_step = 0;
};

std::uint32_t span_of(const IndexedPacket& packet) { return packet.last_place - packet.first_place; }
std::uint64_t unsigned_of(std::int64_t value) { return static_cast<std::uint64_t>(value); }

std::uint8_t what_differs(const IndexedPacket& packet, const PacketBefore& before) {
  const IndexedPacket& last = before.packet;
  std::uint8_t bits = 0;
  const auto differs = [&](bool it_does, PacketBit bit) {
    bits = static_cast<std::uint8_t>(bits | (it_does ? bit : 0));
  };
  differs(packet.offset - last.offset != before.offset_step, kOffsetStep);
  differs(packet.bytes != last.bytes, kBytesBit);
  differs(span_of(packet) != span_of(last), kSpanBit);
  differs(packet.cut_column != 0 || packet.cut_after_ns != 0, kCutBit);
  differs(packet.frame != last.frame, kFrameBit);
  differs(packet.pieces != last.pieces, kPiecesBit);
  differs(packet.clock_period_s != last.clock_period_s || packet.second_part != last.second_part, kClockBit);
  return bits;
}

void pack_packet(NumberPacker& packer, const IndexedPacket& packet, PacketBefore& before) {
  const IndexedPacket& last = before.packet;
  const std::uint8_t bits = what_differs(packet, before);
  packer.number(bits);
  packer.step(unsigned_of(last.host_ns), unsigned_of(packet.host_ns));
  packer.step(unsigned_of(last.time_ns), unsigned_of(packet.time_ns));
  packer.step(last.first_place, packet.first_place);
  if (bits & kOffsetStep) packer.step(before.offset_step, packet.offset - last.offset);
  if (bits & kBytesBit) packer.number(packet.bytes);
  if (bits & kSpanBit) packer.number(span_of(packet));
  if (bits & kCutBit) packer.number(packet.cut_column), packer.number(packet.cut_after_ns);
  if (bits & kFrameBit) packer.number(packet.frame);
  if (bits & kPiecesBit) packer.number(packet.pieces);
  if (bits & kClockBit)
    packer.number(packet.clock_period_s), packer.number(static_cast<std::uint64_t>(packet.second_part));
  before = {packet, packet.offset - last.offset};
}

/// Decoders and captures tell no others, so that times can be subtracted from each other.
std::int64_t unpack_time_ns(NumberUnpacker& unpacker, std::int64_t before_ns) {
  constexpr std::int64_t kMost_ns = std::numeric_limits<std::int64_t>::max() / 2, kLeast_ns = -1'000'000'000'000'000;
  const auto time_ns = static_cast<std::int64_t>(unpacker.step(unsigned_of(before_ns)));
  if (time_ns < kLeast_ns || time_ns > kMost_ns) unpacker.fail();
  return time_ns;
}

IndexedPacket unpack_packet(NumberUnpacker& unpacker, PacketBefore& before) {
  const IndexedPacket& last = before.packet;
  IndexedPacket packet = last;
  const auto bits = static_cast<std::uint8_t>(unpacker.number(0x7f));
  packet.host_ns = unpack_time_ns(unpacker, last.host_ns);
  packet.time_ns = unpack_time_ns(unpacker, last.time_ns);
  packet.first_place = static_cast<std::uint32_t>(unpacker.step(last.first_place));
  packet.cut_column = 0, packet.cut_after_ns = 0;
  std::uint64_t offset_step = before.offset_step;
  if (bits & kOffsetStep) offset_step = unpacker.step(before.offset_step);
  packet.offset = last.offset + offset_step;
  if (bits & kBytesBit) packet.bytes = unpacker.number_of<std::uint32_t>();
  const std::uint32_t span = bits & kSpanBit ? unpacker.number_of<std::uint32_t>() : span_of(last);
  packet.last_place = packet.first_place + span;
  if (bits & kCutBit) {
    packet.cut_column = static_cast<std::uint16_t>(unpacker.number(0xffff));
    packet.cut_after_ns = unpacker.number_of<std::uint32_t>();
  }
  if (bits & kFrameBit) packet.frame = unpacker.number_of<std::uint32_t>();
  if (bits & kPiecesBit) packet.pieces = static_cast<std::uint16_t>(unpacker.number(0xffff));
  if (bits & kClockBit) {
    packet.clock_period_s = static_cast<std::uint16_t>(unpacker.number(0xffff));
    packet.second_part = static_cast<SecondPart>(unpacker.number(static_cast<std::uint64_t>(SecondPart::Nanoseconds)));
  }
  before = {packet, offset_step};
  return packet;
}

void pack_pieces(NumberPacker& packer, const std::vector<DatagramPiece>& pieces) {
  packer.number(pieces.size());
  std::uint64_t last = 0;
  for (const DatagramPiece& piece : pieces) {
    packer.step(last, piece.offset), packer.number(piece.bytes);
    last = piece.offset;
  }
}

std::vector<DatagramPiece> unpack_pieces(NumberUnpacker& unpacker, std::uint64_t capture_bytes) {
  std::vector<DatagramPiece> pieces(unpacker.count(kLeastPieceBytes));
  std::uint64_t last = 0;
  for (DatagramPiece& piece : pieces) {
    piece.offset = last = unpacker.step(last);
    piece.bytes = unpacker.number_of<std::uint32_t>();
    if (piece.offset > capture_bytes || piece.bytes > capture_bytes - piece.offset) unpacker.fail();
  }
  return pieces;
}

/// How many bytes the first of the pieces have together, of none to all.
std::vector<std::uint64_t> sums_of(const std::vector<DatagramPiece>& pieces) {
  std::vector<std::uint64_t> sums{0};
  for (const DatagramPiece& piece : pieces) sums.push_back(sums.back() + piece.bytes);
  return sums;
}

/// Where it stands is looked at, not what it is: a place in the turn may be any, for its decoder knows the turn.
/// @param of_pieces as sums_of gives it
void check_packet(const NumberUnpacker& unpacker, const IndexedPacket& packet,
                  const std::vector<std::uint64_t>& of_pieces, std::uint64_t capture_bytes) {
  const std::uint64_t all = packet.pieces == 1 ? capture_bytes : of_pieces.size() - 1;
  const std::uint64_t its = packet.pieces == 1 ? packet.bytes : packet.pieces;
  if (packet.pieces == 0 || packet.offset > all || its > all - packet.offset) unpacker.fail();
  const std::uint64_t bytes =
      packet.pieces == 1 ? packet.bytes : of_pieces[packet.offset + packet.pieces] - of_pieces[packet.offset];
  if (bytes > kMostKeptBytes) unpacker.fail();
}

void pack_sensor(NumberPacker& packer, const SensorPackets& sensor) {
  packer.number(sensor.foreign), packer.number(sensor.of_others);
  pack_pieces(packer, sensor.pieces);
  packer.number(sensor.packets.size());
  PacketBefore before;
  for (const IndexedPacket& packet : sensor.packets) pack_packet(packer, packet, before);
}

void unpack_sensor(NumberUnpacker& unpacker, std::uint64_t capture_bytes, SensorPackets& sensor) {
  sensor.foreign = unpacker.number(), sensor.of_others = unpacker.number();
  sensor.pieces = unpack_pieces(unpacker, capture_bytes);
  const std::size_t count = unpacker.count(kLeastPacketBytes);
  sensor.packets.reserve(count);
  const std::vector<std::uint64_t> of_pieces = sums_of(sensor.pieces);
  PacketBefore before;
  for (std::size_t i = 0; i < count; ++i) {
    sensor.packets.push_back(unpack_packet(unpacker, before));
    check_packet(unpacker, sensor.packets.back(), of_pieces, capture_bytes);
  }
}

// ---- The rest

void pack_file(NumberPacker& packer, const FileState& file) {
  packer.text(file.path.string()), packer.number(file.bytes), packer.number(unsigned_of(file.changed_ns));
}

FileState unpack_file(NumberUnpacker& unpacker) {
  FileState file;
  file.path = unpacker.text();
  file.bytes = unpacker.number();
  file.changed_ns = static_cast<std::int64_t>(unpacker.number());
  return file;
}

/// The numbers of a capture, in the order in which they are kept.
template <class Counts, class Visit>
void visit_counts(Counts& counts, const Visit& visit) {
  visit(counts.frames), visit(counts.datagrams), visit(counts.truncated), visit(counts.incomplete);
  visit(counts.unknown_link), visit(counts.broken_frames), visit(counts.unread_bytes);
}

void pack_route(NumberPacker& packer, const DatagramRoute& key, const RoutePackets& route, const KeptSensor& known) {
  packer.number(key.address), packer.number(key.port), packer.text(key.topic);
  packer.text(known.model);
  packer.number(known.beside.size());
  for (const FileState& file : known.beside) pack_file(packer, file);
  pack_pieces(packer, route.told_by);
  packer.number(route.others), packer.number(route.positions ? 1 : 0);
  pack_sensor(packer, route.sensor);
}

/// What is said twice is damaged: places of one would be looked up among the pieces of the other.
template <class Map>
auto& added(const NumberUnpacker& unpacker, Map& map, const typename Map::key_type& key) {
  const auto [place, is_new] = map.try_emplace(key);
  if (!is_new) unpacker.fail();
  return place->second;
}

void unpack_route(NumberUnpacker& unpacker, KeptIndex& index) {
  DatagramRoute key;
  key.address = unpacker.number_of<std::uint32_t>();
  key.port = static_cast<std::uint16_t>(unpacker.number(0xffff));
  key.topic = unpacker.text();
  KeptSensor known;
  known.model = unpacker.text();
  for (std::size_t left = unpacker.count(3); left > 0; --left) known.beside.push_back(unpack_file(unpacker));
  RoutePackets& route = added(unpacker, index.passed.routes, key);
  route.told_by = unpack_pieces(unpacker, index.capture.bytes);
  if (sums_of(route.told_by).back() > kMostKeptBytes) unpacker.fail();
  route.others = unpacker.number(), route.positions = unpacker.number(1) == 1;
  unpack_sensor(unpacker, index.capture.bytes, route.sensor);
  if (route.told_by.empty() && !(known.model.empty() && route.sensor.packets.empty())) unpacker.fail();
  if (!route.told_by.empty()) index.sensors[key] = std::move(known);
}

void pack_receiver(NumberPacker& packer, const SensorReceiver& receiver) {
  packer.text(receiver.sentences);
  packer.number(receiver.states.size());
  std::uint64_t last = 0;
  for (const SensorReceiver::State& state : receiver.states) {
    packer.step(last, unsigned_of(state.host_ns)), packer.number(state.clock_locked ? 1 : 0);
    last = unsigned_of(state.host_ns);
  }
}

SensorReceiver unpack_receiver(NumberUnpacker& unpacker) {
  SensorReceiver receiver;
  receiver.sentences = unpacker.text();
  receiver.states.resize(unpacker.count(kLeastStateBytes));
  std::int64_t last_ns = 0;
  for (SensorReceiver::State& state : receiver.states) {
    last_ns = unpack_time_ns(unpacker, last_ns);
    state = {last_ns, unpacker.number(1) == 1};
  }
  return receiver;
}

void unpack_descriptions(NumberUnpacker& unpacker, std::vector<PositionPacket>& descriptions) {
  for (std::size_t left = unpacker.count(2); left > 0; --left) {
    PositionPacket packet;
    packet.description = unpacker.text(), packet.lasting = unpacker.text();
    descriptions.push_back(std::move(packet));
  }
}

}  // namespace

FileState state_of(const std::filesystem::path& path) {
  const auto status = status_of(path);
  if (!status) throw Error(ErrorCode::Io, path.string(), say::kept_index_no_file());
  return {std::filesystem::absolute(path).lexically_normal(), static_cast<std::uint64_t>(status->st_size),
          status->st_mtim.tv_sec * kSecond_ns + status->st_mtim.tv_nsec};
}

std::map<DatagramRoute, KeptSensor> known_sensors(const PassedPackets& passed) {
  std::map<DatagramRoute, KeptSensor> sensors;
  for (const auto& [key, route] : passed.routes) {
    if (route.told_by.empty()) continue;
    KeptSensor& known = sensors[key];
    if (!route.sensor.decoder) continue;
    known.model = route.sensor.decoder->model();
    for (const SourceBeside& source : route.sensor.decoder->sources_beside())
      if (!source.said) known.beside.push_back(state_of(source.name));
  }
  return sensors;
}

std::string pack_index(const FileState& capture, const CaptureCounts& counts, const PassedPackets& passed,
                       const std::map<DatagramRoute, KeptSensor>& sensors) {
  NumberPacker packer;
  pack_file(packer, capture);
  visit_counts(counts, [&](std::uint64_t count) { packer.number(count); });
  packer.number(counts.cut ? 1 : 0);
  packer.number(passed.routes.size());
  for (const auto& [key, route] : passed.routes) {
    const auto known = sensors.find(key);
    pack_route(packer, key, route, known == sensors.end() ? KeptSensor{} : known->second);
  }
  packer.number(passed.receivers.size());
  for (const auto& [address, receiver] : passed.receivers) packer.number(address), pack_receiver(packer, receiver);
  packer.number(passed.descriptions.size());
  for (const auto& [address, packets] : passed.descriptions) {
    packer.number(address), packer.number(packets.size());
    for (const PositionPacket& packet : packets) packer.text(packet.description), packer.text(packet.lasting);
  }
  return packer.take();
}

KeptIndex unpack_index(std::string_view body, const std::string& where) {
  NumberUnpacker unpacker(body, where, say::kept_index_damaged);
  KeptIndex index;
  index.capture = unpack_file(unpacker);
  visit_counts(index.counts, [&](std::uint64_t& count) { count = unpacker.number(); });
  index.counts.cut = unpacker.number(1) == 1;
  for (std::size_t left = unpacker.count(10); left > 0; --left) unpack_route(unpacker, index);
  for (std::size_t left = unpacker.count(3); left > 0; --left) {
    const auto address = unpacker.number_of<std::uint32_t>();
    added(unpacker, index.passed.receivers, address) = unpack_receiver(unpacker);
  }
  for (std::size_t left = unpacker.count(2); left > 0; --left) {
    const auto address = unpacker.number_of<std::uint32_t>();
    unpack_descriptions(unpacker, added(unpacker, index.passed.descriptions, address));
  }
  if (!unpacker.at_end()) unpacker.fail();
  return index;
}

std::string kept_index_bytes(const FileState& capture, const CaptureCounts& counts, const PassedPackets& passed) {
  NumberPacker head;
  head.text(index_version());
  const std::string body = pack_index(capture, counts, passed, known_sensors(passed)), version = head.take();
  std::string bytes;
  bytes.reserve(kIndexMark.size() + version.size() + sizeof(std::uint32_t) + body.size());
  bytes.append(kIndexMark).append(version);
  const std::uint32_t sum = crc32(body);
  bytes.append(reinterpret_cast<const char*>(&sum), sizeof sum).append(body);
  return bytes;
}

KeptIndex read_kept_index(std::string_view bytes, const std::string& where) {
  if (!bytes.starts_with(kIndexMark)) throw Error(ErrorCode::Format, where, say::kept_index_none());
  bytes.remove_prefix(kIndexMark.size());
  NumberUnpacker head(bytes, where, say::kept_index_damaged);
  const std::string version = head.text();
  if (version != index_version())
    throw Error(ErrorCode::Format, where, say::kept_index_version(printable(version, LineBreaks::Escaped)));
  bytes.remove_prefix(1 + version.size());  // its length is a byte
  if (bytes.size() < sizeof(std::uint32_t) || little_number<std::uint32_t>(bytes, 0) != crc32(bytes.substr(4)))
    throw Error(ErrorCode::Format, where, say::kept_index_damaged());
  return unpack_index(bytes.substr(4), where);
}

}  // namespace remount::formats
