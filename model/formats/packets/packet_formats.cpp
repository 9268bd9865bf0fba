#include "model/formats/packets/packet_decoder.h"

namespace remount::formats {

PacketFormat hesai_packets();
PacketFormat livox_packets();
PacketFormat ouster_packets();
PacketFormat robosense_packets();
PacketFormat velodyne_packets();

const std::vector<PacketFormat>& packet_formats() {
  static const std::vector<PacketFormat> formats{velodyne_packets(), ouster_packets(), hesai_packets(), livox_packets(),
                                                 robosense_packets()};
  return formats;
}

}  // namespace remount::formats
