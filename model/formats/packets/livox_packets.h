// Livox: packets of both SDKs, and as its viewer keeps them in files.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "model/formats/packets/packet_decoder.h"

namespace remount::formats {

/// What stands in front of the points.
enum class LivoxHead {
  Sdk1,  ///< 18 bytes; a packet has as many shots as its layout says
  Sdk2,  ///< 36 bytes, with their number and the time that they took
  Lvx,   ///< that of Sdk1 in front of points of 32-bit floats: files of version 1.0
  Lvx2,  ///< 27 bytes: a package of a file of version 2
};

/// How many bytes a packet has by its head; nothing where the head is not whole, or says what is not known. Of packets
/// without points (of an IMU) as well.
std::optional<std::size_t> livox_packet_bytes(LivoxHead head, std::string_view bytes);

/// For the sensor that sent this packet; null where it is none of points.
/// @param model as users know the sensor
std::unique_ptr<PacketDecoder> livox_decoder(LivoxHead head, std::string_view packet, std::string model);

}  // namespace remount::formats
