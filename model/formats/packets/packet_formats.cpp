#include "model/formats/packets/packet_decoder.h"

namespace remount::formats {

PacketFormat velodyne_packets();

const std::vector<PacketFormat>& packet_formats() {
  static const std::vector<PacketFormat> formats{velodyne_packets()};
  return formats;
}

}  // namespace remount::formats
