#include "model/formats/bags/packed_message.h"

#include <zstd.h>

#include <algorithm>

#include "algorithms/core/error.h"
#include "messages/bags.h"
#include "model/formats/bags/chunk_codec.h"
#include "model/formats/bags/unpacked_file.h"

namespace remount::bags {
namespace {

constexpr std::uint64_t kMagicBytes = 4;
/// The largest block of a frame as it may lie there, with what stands before it.
constexpr std::uint64_t kFirstBlock = (std::uint64_t{128} << 10) + 64;
/// As large may a message of a small bag become; that of a larger one three times the file, but never beyond the
/// longest that a recorder keeps.
constexpr std::uint64_t kLargeUnpacked = std::uint64_t{64} << 20, kLargestMessage = std::uint64_t{1} << 30;

Error too_large(const std::string& where, std::uint64_t most) {
  return {ErrorCode::Format, where, say::bag_message_too_large(Bytes{most})};
}

}  // namespace

std::string message_content(const StoredMessage& message, std::uint64_t at_most) {
  std::string packed = message.read(std::min(message.bytes, std::max(at_most, kMagicBytes)));
  if (!is_zstd(packed)) return packed.substr(0, at_most);
  const std::uint64_t most = std::clamp(3 * message.file_bytes, kLargeUnpacked, kLargestMessage);
  const unsigned long long promised = ZSTD_getFrameContentSize(packed.data(), packed.size());
  if (promised != ZSTD_CONTENTSIZE_UNKNOWN && promised != ZSTD_CONTENTSIZE_ERROR && promised > most)
    throw too_large(message.where, most);
  if (at_most < kFirstBlock && message.bytes > kFirstBlock) {
    std::string beginning =
        unpack_chunk(ChunkCompression::Zstd, message.read(kFirstBlock), at_most, ChunkEnd::Cut, message.where);
    if (beginning.size() == at_most) return beginning;
  }
  if (packed.size() < message.bytes) packed = message.read(message.bytes);
  std::string content =
      unpack_chunk(ChunkCompression::Zstd, packed, std::min(at_most, most + 1), ChunkEnd::Early, message.where);
  if (content.size() > most) throw too_large(message.where, most);
  return content;
}

}  // namespace remount::bags
