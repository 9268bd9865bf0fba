#include "model/io/bag/chunk_store.h"

#include <algorithm>

#include "algorithms/core/error.h"
#include "model/io/bag/bag_file.h"

namespace remount {
namespace {

/// A chunk of a small bag may be so large; of a large one, four times the file.
constexpr std::uint64_t kLargeChunk = std::uint64_t{64} << 20;

class FileRange final : public ByteSource {
 public:
  FileRange(std::shared_ptr<const RandomAccessFile> file, std::uint64_t offset, std::uint64_t bytes)
      : file_(std::move(file)), offset_(offset), bytes_(bytes) {}
  std::uint64_t size() const override { return bytes_; }
  std::string read(std::uint64_t offset, std::uint64_t count) const override {
    if (offset > bytes_ || count > bytes_ - offset)
      throw Error(ErrorCode::Format, place(std::min(offset, bytes_)),
                  std::to_string(count) + " bytes are expected here, the part of the file that holds them has " +
                      std::to_string(bytes_) + " bytes in all");
    return file_->read(offset_ + offset, count);
  }
  std::string place(std::uint64_t offset) const override { return file_->place(offset_ + offset); }

 private:
  std::shared_ptr<const RandomAccessFile> file_;
  std::uint64_t offset_, bytes_;
};

class UnpackedChunk final : public ByteSource {
 public:
  UnpackedChunk(std::string bytes, std::string where) : bytes_(std::move(bytes)), where_(std::move(where)) {}
  std::uint64_t size() const override { return bytes_.size(); }
  std::string read(std::uint64_t offset, std::uint64_t count) const override {
    if (offset > bytes_.size() || count > bytes_.size() - offset)
      throw Error(ErrorCode::Format, place(offset),
                  std::to_string(count) + " bytes are expected here, the chunk holds " + std::to_string(bytes_.size()) +
                      " bytes in all");
    return bytes_.substr(offset, count);
  }
  std::string place(std::uint64_t offset) const override {
    return where_ + " (unpacked chunk: byte " + std::to_string(offset) + ")";
  }

 private:
  std::string bytes_, where_;
};

}  // namespace

void ChunkStore::clear() {
  const std::scoped_lock lock(mutex_);
  chunks_.clear();
  kept_ = kNoChunk;
  kept_source_.reset();
}

std::uint32_t ChunkStore::add(const BagChunk& chunk) {
  const std::string where = file_->place(chunk.offset);
  if (chunk.offset > file_->size() || chunk.packed_bytes > file_->size() - chunk.offset)
    throw Error(ErrorCode::Format, where,
                "a chunk of " + std::to_string(chunk.packed_bytes) + " bytes does not fit a file of " +
                    std::to_string(file_->size()));
  if (chunk.compression == ChunkCompression::None && chunk.bytes != chunk.packed_bytes && !chunk.cut)
    throw Error(ErrorCode::Format, where,
                "a chunk that is not compressed promises " + std::to_string(chunk.bytes) + " bytes and has " +
                    std::to_string(chunk.packed_bytes));
  const std::uint64_t most = std::max(kLargeChunk, 4 * file_->size());
  if (chunk.bytes > most)
    throw Error(ErrorCode::Format, where,
                "a chunk promises " + std::to_string(chunk.bytes) + " bytes, at most " + std::to_string(most) +
                    " are taken from a file of this size");
  if (chunks_.size() >= kNoChunk) throw Error(ErrorCode::Unsupported, where, "the bag has too many chunks");
  chunks_.push_back(chunk);
  return static_cast<std::uint32_t>(chunks_.size() - 1);
}

std::shared_ptr<const ByteSource> ChunkStore::source(std::uint32_t number) const {
  if (number == kNoChunk) return std::make_shared<FileRange>(file_, 0, file_->size());
  if (number >= chunks_.size()) throw Error(ErrorCode::Contract, file_->path().string(), "there is no such chunk");
  const BagChunk& chunk = chunks_[number];
  if (chunk.compression == ChunkCompression::None)
    return std::make_shared<FileRange>(file_, chunk.offset, chunk.packed_bytes);
  {
    const std::scoped_lock lock(mutex_);
    if (kept_ == number) return kept_source_;
  }
  const std::string where = file_->place(chunk.offset);
  auto source = std::make_shared<const UnpackedChunk>(
      unpack_chunk(chunk.compression, file_->read(chunk.offset, chunk.packed_bytes), chunk.bytes,
                   chunk.cut ? ChunkEnd::Cut : ChunkEnd::Whole, where),
      where);
  const std::scoped_lock lock(mutex_);
  kept_ = number;
  kept_source_ = source;
  return source;
}

}  // namespace remount
