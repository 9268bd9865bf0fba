#include "model/formats/bags/chunk_store.h"

#include <algorithm>

#include "algorithms/core/error.h"
#include "messages/bags.h"
#include "model/formats/bags/bag_file.h"
#include "model/formats/bags/growing_chunk.h"
#include "model/formats/files/crc32.h"

namespace remount::bags {
namespace {

/// A chunk of a small bag may be so large; of a large one, three times the file: with what it is packed in, four times.
constexpr std::uint64_t kLargeChunk = std::uint64_t{64} << 20;

class FileRange final : public ByteSource {
 public:
  FileRange(std::shared_ptr<const formats::RandomAccessFile> file, std::uint64_t offset, std::uint64_t bytes)
      : file_(std::move(file)), offset_(offset), bytes_(bytes) {}
  std::uint64_t size() const override { return bytes_; }
  std::string read(std::uint64_t offset, std::uint64_t count) const override {
    if (offset > bytes_ || count > bytes_ - offset)
      throw Error(ErrorCode::Format, place(std::min(offset, bytes_)),
                  say::bag_beyond_part(Bytes{count}, Bytes{bytes_}));
    return file_->read(offset_ + offset, count);
  }
  std::string place(std::uint64_t offset) const override { return file_->place(offset_ + offset); }

 private:
  std::shared_ptr<const formats::RandomAccessFile> file_;
  std::uint64_t offset_, bytes_;
};

class UnpackedChunk final : public ByteSource {
 public:
  UnpackedChunk(std::string bytes, std::string where) : bytes_(std::move(bytes)), where_(std::move(where)) {}
  std::uint64_t size() const override { return bytes_.size(); }
  std::string read(std::uint64_t offset, std::uint64_t count) const override {
    if (offset > bytes_.size() || count > bytes_.size() - offset)
      throw Error(ErrorCode::Format, place(offset), say::bag_beyond_chunk(Bytes{count}, Bytes{bytes_.size()}));
    return bytes_.substr(offset, count);
  }
  std::string place(std::uint64_t offset) const override {
    return where_ + " (unpacked chunk: byte " + std::to_string(offset) + ")";
  }

 private:
  std::string bytes_, where_;
};

Error wrong_checksum(const std::string& where) { return {ErrorCode::Format, where, say::bag_chunk_checksum()}; }

}  // namespace

std::uint32_t file_checksum(const formats::RandomAccessFile& file, std::uint64_t offset, std::uint64_t count) {
  constexpr std::uint64_t kPiece = std::uint64_t{1} << 20;
  std::uint32_t checksum = 0;
  for (std::uint64_t done = 0; done < count; done += kPiece)
    checksum = formats::crc32(file.read(offset + done, std::min(kPiece, count - done)), checksum);
  return checksum;
}

void ChunkStore::clear() {
  const std::scoped_lock lock(mutex_);
  chunks_.clear();
  kept_ = kNoChunk;
  kept_source_.reset();
  damaged_.clear();
  checked_.clear();
}

std::uint32_t ChunkStore::add(const BagChunk& chunk) {
  const std::string where = file_->place(chunk.offset);
  if (chunk.offset > file_->size() || chunk.packed_bytes > file_->size() - chunk.offset)
    throw Error(ErrorCode::Format, where, say::bag_chunk_beyond_file(Bytes{chunk.packed_bytes}, file_->size()));
  if (chunk.compression == ChunkCompression::None && chunk.bytes != chunk.packed_bytes && !chunk.cut)
    throw Error(ErrorCode::Format, where, say::bag_chunk_of_other_size(Bytes{chunk.bytes}, chunk.packed_bytes));
  const std::uint64_t most = std::max(kLargeChunk, 3 * file_->size());
  if (chunk.bytes > most) throw Error(ErrorCode::Format, where, say::bag_chunk_too_large(Bytes{chunk.bytes}, most));
  if (chunks_.size() >= kNoChunk) throw Error(ErrorCode::Unsupported, where, say::bag_too_many_chunks());
  chunks_.push_back(chunk);
  checked_.push_back(chunk.compression != ChunkCompression::None || chunk.cut || chunk.checksum == 0);
  return static_cast<std::uint32_t>(chunks_.size() - 1);
}

std::shared_ptr<const ByteSource> ChunkStore::source(std::uint32_t number) const {
  if (number == kNoChunk) return std::make_shared<FileRange>(file_, 0, file_->size());
  if (number >= chunks_.size())
    throw Error(ErrorCode::Contract, file_->name().string(), Message::verbatim("there is no such chunk"));
  const BagChunk& chunk = chunks_[number];
  if (chunk.compression == ChunkCompression::None)
    return std::make_shared<FileRange>(file_, chunk.offset, chunk.packed_bytes);
  {
    const std::scoped_lock lock(mutex_);
    if (kept_ == number) return kept_source_;
    rethrow_if_damaged(number);
    kept_ = kNoChunk;
    kept_source_.reset();  // before the memory for the next one is taken
  }
  try {
    std::shared_ptr<const ByteSource> source;
    if (whole_ || chunk.cut)
      source = unpack(chunk);
    else
      source = std::make_shared<const GrowingChunk>(file_, chunk,
                                                    [this, number](const Error& error) { note_damage(number, error); });
    const std::scoped_lock lock(mutex_);
    kept_ = number;
    kept_source_ = source;
    return source;
  } catch (const Error& error) {
    if (error.code() == ErrorCode::Format) note_damage(number, error);
    throw;
  }
}

void ChunkStore::note_damage(std::uint32_t number, const Error& error) const {
  const std::scoped_lock lock(mutex_);
  damaged_.emplace(number, error);
  if (kept_ == number) kept_ = kNoChunk;
}

std::shared_ptr<const ByteSource> ChunkStore::unpack(const BagChunk& chunk) const {
  const std::string where = file_->place(chunk.offset);
  std::string bytes = unpack_chunk(chunk.compression, file_->read(chunk.offset, chunk.packed_bytes), chunk.bytes,
                                   chunk.cut ? ChunkEnd::Cut : ChunkEnd::Whole, where);
  if (!chunk.cut && chunk.checksum != 0 && formats::crc32(bytes) != chunk.checksum) throw wrong_checksum(where);
  return std::make_shared<const UnpackedChunk>(std::move(bytes), where);
}

/// Under the lock.
void ChunkStore::rethrow_if_damaged(std::uint32_t number) const {
  if (const auto found = damaged_.find(number); found != damaged_.end()) throw Error(found->second);
}

void ChunkStore::check(std::uint32_t number) const {
  if (number < chunks_.size()) check(number, *source(number));
}

void ChunkStore::check(std::uint32_t number, const ByteSource& source) const {
  if (number >= chunks_.size()) return;
  if (is_compressed(number)) {
    source.read(source.size(), 0);
    return;
  }
  {
    const std::scoped_lock lock(mutex_);
    rethrow_if_damaged(number);
    if (checked_[number]) return;
  }
  const BagChunk& chunk = chunks_[number];
  const bool right = file_checksum(*file_, chunk.offset, chunk.packed_bytes) == chunk.checksum;
  const std::scoped_lock lock(mutex_);
  checked_[number] = true;
  if (right) return;
  damaged_.emplace(number, wrong_checksum(file_->place(chunk.offset)));
  rethrow_if_damaged(number);
}

}  // namespace remount::bags
