#include "model/formats/packets/packet_decoder.h"

namespace remount::formats {

PacketFormat livox_packets();
PacketFormat robosense_packets();
PacketFormat velodyne_packets();

const std::vector<PacketFormat>& packet_formats() {
  static const std::vector<PacketFormat> formats{velodyne_packets(), livox_packets(), robosense_packets()};
  return formats;
}

}  // namespace remount::formats
