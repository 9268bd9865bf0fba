// RoboSense's sensors whose mirrors swing: packets that have the direction of each point.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "model/formats/packets/packet_decoder.h"

namespace remount::formats {

/// As PacketFormat::recognise.
std::unique_ptr<PacketDecoder> recognise_robosense_mems(std::string_view payload, const std::string& where);

}  // namespace remount::formats
