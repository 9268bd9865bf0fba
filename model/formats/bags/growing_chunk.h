// A compressed chunk of a large bag, unpacked as far as it is read.
#pragma once

#include <functional>
#include <optional>

#include "model/formats/bags/chunk_store.h"

namespace remount::bags {

/// Most of a bag's bytes are points, which nobody asks for when it is opened: small messages and headers lie before
/// them. Thread-safe. What is packed is read and unpacked piece by piece; the checksum is compared with the last.
class GrowingChunk final : public ByteSource {
 public:
  /// @param on_damage is told once why nothing more of the chunk can be read
  GrowingChunk(std::shared_ptr<const formats::RandomAccessFile> file, const BagChunk& chunk,
               std::function<void(const Error&)> on_damage);
  std::uint64_t size() const override { return chunk_.bytes; }
  std::string read(std::uint64_t offset, std::uint64_t count) const override;
  std::string place(std::uint64_t offset) const override;

 private:
  void grow(std::uint64_t needed) const;
  void unpack_piece() const;
  [[noreturn]] void fail(Message what) const;

  std::shared_ptr<const formats::RandomAccessFile> file_;
  BagChunk chunk_;
  std::function<void(const Error&)> on_damage_;
  mutable std::mutex mutex_;
  mutable std::unique_ptr<Unpacker> unpacker_;  // null when all is unpacked
  mutable std::string packed_;                  // a piece of the file, of which `left_` is not unpacked yet
  mutable std::string_view left_;
  mutable std::uint64_t packed_read_ = 0;
  mutable std::string bytes_;
  mutable std::optional<Error> damage_;
};

}  // namespace remount::bags
