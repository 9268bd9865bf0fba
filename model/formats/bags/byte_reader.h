// Little-endian numbers and strings one after the other, each checked against what is there.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "algorithms/core/error.h"
#include "messages/bags.h"

namespace remount::bags {

/// Walks bytes of a container. Throws Error(Format) at `where` where they end too early.
class ByteReader {
 public:
  ByteReader(std::string_view bytes, std::string where) : bytes_(bytes), where_(std::move(where)) {}

  std::size_t position() const { return position_; }
  std::size_t left() const { return bytes_.size() - position_; }

  std::string_view bytes(std::uint64_t count) {
    if (count > left()) throw Error(ErrorCode::Format, where_, say::bag_bytes_promised(Bytes{count}, left()));
    const std::string_view found = bytes_.substr(position_, count);
    position_ += count;
    return found;
  }

  template <class T>
  T number() {
    static_assert(std::endian::native == std::endian::little, "swap bytes here");
    T value{};
    std::memcpy(&value, bytes(sizeof(T)).data(), sizeof(T));
    return value;
  }

  /// With its length before it, in 32 bits.
  std::string_view string() { return bytes(number<std::uint32_t>()); }

 private:
  std::string_view bytes_;
  std::string where_;
  std::size_t position_ = 0;
};

}  // namespace remount::bags
