// What the reader and the writer of ROS 1's bags, version 2.0, share.
#pragma once

#include <cstdint>
#include <string_view>

namespace remount::bags::rosbag1 {

inline constexpr std::string_view kMagic = "#ROSBAG V2.0\n";

enum Op : std::uint8_t { kMessage = 2, kBagHeader = 3, kIndexData = 4, kChunk = 5, kChunkInfo = 6, kConnection = 7 };

}  // namespace remount::bags::rosbag1
