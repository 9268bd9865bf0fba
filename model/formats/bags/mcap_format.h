// What the reader and the writer of MCAP, version 0, share.
#pragma once

#include <cstdint>
#include <string_view>

namespace remount::bags::mcap {

inline constexpr std::string_view kMagic("\x89MCAP0\r\n", 8);
inline constexpr std::uint64_t kRecordHead = 9;  ///< what it is, and the length of what follows

enum Op : std::uint8_t {
  kHeader = 1,
  kFooter = 2,
  kSchema = 3,
  kChannel = 4,
  kMessage = 5,
  kChunk = 6,
  kMessageIndex = 7,
  kChunkIndex = 8,
  kAttachment = 9,
  kStatistics = 11,
  kSummaryOffset = 14,
  kDataEnd = 15
};

}  // namespace remount::bags::mcap
