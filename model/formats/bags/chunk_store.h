// The chunks of a bag, read and unpacked when they are asked for.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "algorithms/core/error.h"
#include "model/formats/bags/chunk_codec.h"
#include "model/formats/files/random_access_file.h"

namespace remount::bags {

/// A range of bytes: a part of the file, or an unpacked chunk.
class ByteSource {
 public:
  virtual ~ByteSource() = default;
  virtual std::uint64_t size() const = 0;
  /// Throws Error(Format) where the range does not hold so many bytes from `offset` on.
  virtual std::string read(std::uint64_t offset, std::uint64_t count) const = 0;
  /// For messages.
  virtual std::string place(std::uint64_t offset) const = 0;
};

/// CRC-32 of a part of a file, which is read in pieces.
std::uint32_t file_checksum(const formats::RandomAccessFile& file, std::uint64_t offset, std::uint64_t count);

struct BagChunk {
  std::uint64_t offset = 0;        ///< of the packed data in the file
  std::uint64_t packed_bytes = 0;  ///< as many as the file holds of them, where it was cut
  std::uint64_t bytes = 0;         ///< unpacked, as the bag promises
  ChunkCompression compression = ChunkCompression::None;
  bool cut = false;            ///< the file ends within the chunk
  std::uint32_t checksum = 0;  ///< CRC-32 of the unpacked bytes; 0: not known
};

/// Up to this size a bag is small: its chunks are unpacked and checked whole whatever is read of them. Of a larger one
/// a chunk is unpacked as far as it is read, since opening must not take as long as reading all of its points.
inline constexpr std::uint64_t kSmallBag = std::uint64_t{256} << 20;

/// Thread-safe once all chunks are added. Keeps the chunk that was unpacked last, and of damaged ones the reason.
class ChunkStore {
 public:
  explicit ChunkStore(const std::filesystem::path& path) : ChunkStore(path, path) {}
  /// @param name the file is called in messages
  /// @param small_bag up to this size of the file chunks are unpacked whole
  ChunkStore(const std::filesystem::path& path, const std::filesystem::path& name, std::uint64_t small_bag = kSmallBag)
      : file_(std::make_shared<formats::RandomAccessFile>(path, name)), whole_(file_->size() <= small_bag) {}

  const formats::RandomAccessFile& file() const { return *file_; }
  std::size_t size() const { return chunks_.size(); }
  void clear();

  /// Its number. Throws Error(Format) where it does not lie within the file or promises more than could be in it.
  std::uint32_t add(const BagChunk& chunk);

  /// What a chunk holds unpacked; the whole file for kNoChunk. Throws Error where it cannot be read.
  std::shared_ptr<const ByteSource> source(std::uint32_t chunk) const;

  bool is_compressed(std::uint32_t chunk) const {
    return chunk < chunks_.size() && chunks_[chunk].compression != ChunkCompression::None;
  }

  /// Reads a chunk whole and compares its checksum; one that is not compressed, once. Throws Error(Format) where it is
  /// wrong or the chunk cannot be unpacked.
  void check(std::uint32_t chunk) const;
  /// The same where its source is at hand: another thread may have had another chunk unpacked meanwhile.
  void check(std::uint32_t chunk, const ByteSource& source) const;

 private:
  std::shared_ptr<const ByteSource> unpack(const BagChunk& chunk) const;
  void rethrow_if_damaged(std::uint32_t chunk) const;

  void note_damage(std::uint32_t chunk, const Error& error) const;

  std::shared_ptr<const formats::RandomAccessFile> file_;
  bool whole_;
  std::vector<BagChunk> chunks_;
  mutable std::mutex mutex_;
  mutable std::uint32_t kept_ = 0xffffffffU;
  mutable std::shared_ptr<const ByteSource> kept_source_;
  mutable std::map<std::uint32_t, Error> damaged_;  // so that a chunk is unpacked in vain only once
  mutable std::vector<bool> checked_;               // those that are not compressed
};

}  // namespace remount::bags
