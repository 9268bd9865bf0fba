#include "model/formats/bags/growing_chunk.h"

#include <algorithm>

#include "messages/bags.h"
#include "model/formats/files/crc32.h"

namespace remount::bags {
namespace {

constexpr std::uint64_t kGrowthBytes = std::uint64_t{64} << 10;

}  // namespace

GrowingChunk::GrowingChunk(std::shared_ptr<const formats::RandomAccessFile> file, const BagChunk& chunk,
                           std::function<void(const Error&)> on_damage)
    : file_(std::move(file)),
      chunk_(chunk),
      on_damage_(std::move(on_damage)),
      unpacker_(make_unpacker(chunk.compression)) {}

std::string GrowingChunk::place(std::uint64_t offset) const {
  return file_->place(chunk_.offset) + " (unpacked chunk: byte " + std::to_string(offset) + ")";
}

void GrowingChunk::fail(Message what) const {
  damage_.emplace(ErrorCode::Format, file_->place(chunk_.offset), std::move(what));
  bytes_ = {};
  on_damage_(*damage_);
  throw Error(*damage_);
}

std::string GrowingChunk::read(std::uint64_t offset, std::uint64_t count) const {
  if (offset > size() || count > size() - offset)
    throw Error(ErrorCode::Format, place(offset), say::bag_beyond_chunk(Bytes{count}, Bytes{size()}));
  const std::scoped_lock lock(mutex_);
  if (damage_) throw Error(*damage_);
  grow(offset + count);
  return bytes_.substr(offset, count);
}

void GrowingChunk::grow(std::uint64_t needed) const {
  // The rest of a chunk of which much is wanted at once is not unpacked into memory that moves.
  if (needed > bytes_.capacity()) bytes_.reserve(std::min(size(), std::max(needed, 4 * bytes_.size())));
  while (bytes_.size() < needed) unpack_piece();
  if (bytes_.size() < size() || !unpacker_) return;
  unpacker_.reset();
  packed_ = {};
  if (chunk_.checksum != 0 && formats::crc32(bytes_) != chunk_.checksum) fail(say::bag_chunk_checksum());
}

void GrowingChunk::unpack_piece() const {
  if (left_.empty() && packed_read_ < chunk_.packed_bytes) {
    packed_ = file_->read(chunk_.offset + packed_read_, std::min(kGrowthBytes, chunk_.packed_bytes - packed_read_));
    packed_read_ += packed_.size();
    left_ = packed_;
  }
  const std::size_t before = bytes_.size(), left = left_.size();
  std::size_t room = static_cast<std::size_t>(std::min(kGrowthBytes, size() - before));
  bytes_.resize(before + room);
  const UnpackStep outcome = unpacker_->step(left_, bytes_.data() + before, room);
  bytes_.resize(before + room);
  // A frame of Zstandard may end with a piece, and another follow.
  const bool ended = outcome == UnpackStep::Done &&
                     (chunk_.compression != ChunkCompression::Zstd || packed_read_ == chunk_.packed_bytes);
  const bool starved = room == 0 && left_.size() == left && packed_read_ == chunk_.packed_bytes;
  if (outcome == UnpackStep::Broken || ((ended || starved) && bytes_.size() < size()))
    fail(say::bag_packed_chunk_damaged(bytes_.size(), Bytes{size()}));
}

}  // namespace remount::bags
