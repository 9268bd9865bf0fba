// What the reader and the writer of Cyber's records share: sections, each with a head of 16 bytes in front, whose
// contents are messages of Protocol Buffers (apollo.cyber.proto).
#pragma once

#include <cstdint>

namespace remount::bags::cyber {

inline constexpr std::uint64_t kSectionHead = 16;   ///< what it is (32 bits, 32 more without meaning), its length
inline constexpr std::uint64_t kHeaderRoom = 2048;  ///< the header is followed by zeros up to this length

enum Section : std::uint32_t { kHeader = 0, kChunkHeader = 1, kChunkBody = 2, kIndex = 3, kChannel = 4 };

// Numbers of fields.
enum HeaderField : std::uint32_t {
  kMajorVersion = 1,
  kMinorVersion = 2,
  kCompress = 3,
  kIndexPosition = 6,
  kChunkNumber = 7,
  kChannelNumber = 8,
  kBeginTime = 9,
  kEndTime = 10,
  kMessageNumber = 11,
  kSize = 12,
  kIsComplete = 13,
  kLastHeaderField = 17
};
enum ChannelField : std::uint32_t { kChannelName = 1, kMessageType = 2, kDescription = 3 };
enum ChunkHeaderField : std::uint32_t { kChunkBegin = 1, kChunkEnd = 2, kChunkMessages = 3, kChunkRawSize = 4 };
inline constexpr std::uint32_t kChunkMessage = 1;  ///< of a chunk's body, for each of its messages
enum FieldOfMessage : std::uint32_t { kMessageChannel = 1, kMessageTime = 2, kMessageContent = 3 };

enum Compress : std::uint64_t { kUncompressed = 0, kBzip2 = 1, kLz4 = 2 };

}  // namespace remount::bags::cyber
