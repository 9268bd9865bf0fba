#include "model/formats/packets/packet_decoder.h"

namespace remount::formats {

PacketFormat hesai_packets();
PacketFormat livox_packets();
PacketFormat ouster_packets();
PacketFormat robosense_packets();
PacketFormat velodyne_packets();

std::string position_sentence(std::string_view text) {
  if (!text.starts_with('$')) return {};
  return std::string(text.substr(0, text.find_first_of(std::string_view("\r\n\0", 3)))) + "\r\n";
}

const SaidOfSensors* BesidePackets::said_on(const std::filesystem::path& topic) const {
  for (const SaidOfSensors& one : said)
    if (topic == one.topic) return &one;
  return nullptr;
}

std::optional<PositionPacket> read_position(std::string_view payload) {
  for (const PacketFormat& format : packet_formats())
    if (format.position != nullptr)
      if (auto position = format.position(payload)) return position;
  return std::nullopt;
}

const std::vector<PacketFormat>& packet_formats() {
  static const std::vector<PacketFormat> formats{velodyne_packets(), ouster_packets(), hesai_packets(), livox_packets(),
                                                 robosense_packets()};
  return formats;
}

}  // namespace remount::formats
